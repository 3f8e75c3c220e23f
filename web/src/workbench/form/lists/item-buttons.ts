// The buttons that copy and remove an item of a list.

import { iconButton } from "../../controls/icons";
import { duplicateItem } from "../../model/changes/new-items";
import { removeItem } from "../../model/changes/references";
import type { Path } from "../../model/paths";
import type { FormContext } from "../context";

export function itemButtons(ctx: FormContext, path: Path): HTMLElement[] {
  const position = Number(path.at(-1)) + 1;
  const duplicate = () => {
    const addition = duplicateItem(ctx.data(), path, [0, 0], position);
    if (addition) ctx.change(addition.change);
  };
  return [
    iconButton("copy", "duplicate", `duplicate item ${position}`, duplicate),
    iconButton("remove", "remove", `remove item ${position}`, () => ctx.change(removeItem(ctx.data(), path))),
  ];
}

// The buttons that copy and remove an item of a list.

import { say } from "../../../viewer/shared/language";
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
    iconButton("copy", "duplicate", say("duplicate item {number}", { number: position }), duplicate),
    iconButton("remove", "remove", say("remove item {number}", { number: position }), () =>
      ctx.change(removeItem(ctx.data(), path)),
    ),
  ];
}

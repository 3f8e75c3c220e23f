// A list of points in plan as a table of x and y.

import { button, fill, h, setText } from "../../../viewer/shared/dom";
import { counted, say } from "../../../viewer/shared/language";
import { iconButton } from "../../controls/icons";
import { type Json, listAt, type Path } from "../../model/paths";
import { formatLike, parsePoint } from "../../model/quantities";
import type { Node } from "../../model/schema";
import { type FormContext, setValue } from "../context";
import { type Input, tupleInput } from "./inputs";

const FEW = 4; // points that are shown at once

/** One row for each point, to be changed, added and removed. */
export function pointsInput(ctx: FormContext, path: Path, each: Node): Input {
  const rows = h("div", { class: "place-rows" });
  const count = h("summary", {});
  const add = button("Add point", "", () => insert(listAt(ctx.data(), path).length), "small");
  const fold = h("details", { class: "place-fold" }, count, rows, add);
  const element = h("div", { class: "places" }, fold);
  let inputs: Input[] = [];

  const insert = (n: number) => {
    const list = listAt(ctx.data(), path);
    setValue(ctx, path, list.toSpliced(n, 0, midpoint(list[n - 1], list[n] ?? list[0])));
    inputs[n]?.focus.focus();
  };
  const remove = (n: number) => {
    const list = listAt(ctx.data(), path).toSpliced(n, 1);
    setValue(ctx, path, list.length > 0 ? list : undefined);
    (inputs[Math.min(n, inputs.length - 1)]?.focus ?? add).focus();
  };
  const build = (length: number) => {
    // few points are shown at once, many when the user unfolds them
    if (inputs.length === 0) fold.open = length <= FEW;
    setText(count, counted(length, "1 point", "{count} points"));
    inputs = Array.from({ length }, (_, n) => tupleInput(ctx, [...path, n], each, 2, ["x", "y"], undefined));
    const makeRow = (input: Input, n: number) => {
      const add = iconButton("add", "insert after", say("insert a point after {number}", { number: n + 1 }), () =>
        insert(n + 1),
      );
      const drop = iconButton("remove", "remove", say("remove point {number}", { number: n + 1 }), () => remove(n));
      const number = h("span", { class: "number-of" }, String(n + 1));
      return h("div", { class: "place-row" }, number, input.element, add, drop);
    };
    fill(rows, ...inputs.map(makeRow));
  };
  const update = () => {
    const { length } = listAt(ctx.data(), path);
    if (length !== inputs.length) build(length);
    for (const input of inputs) input.update();
  };
  return {
    element,
    get focus() {
      return fold.open ? (inputs[0]?.focus ?? add) : count;
    },
    update,
  };
}

/** Return a point half-way between two, in their units; 0, 0 if there are none. */
function midpoint(a: Json | undefined, b: Json | undefined): Json {
  const [from, to] = [parsePoint(a), parsePoint(b)];
  if (!from || !to) return ["0 m", "0 m"];
  return formatLike(a, [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
}

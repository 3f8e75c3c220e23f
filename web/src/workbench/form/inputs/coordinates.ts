// A list of places in plan as a table of x and y.

import { type Json, listAt, type Path } from "../../model/paths";
import { place, writtenLike } from "../../model/quantities";
import type { Node } from "../../model/schema";
import { fill, h, icon } from "../../shell/elements";
import { type FormContext, setValue } from "../context";
import { type Input, tupleInput } from "./inputs";

const FEW = 4; // places that are shown without being asked for

/** One row for each place, to be changed, added and removed. */
export function placesInput(ctx: FormContext, path: Path, each: Node): Input {
  const rows = h("div", { class: "place-rows" });
  const count = h("summary", {});
  const add = h(
    "button",
    { type: "button", class: "small", onclick: () => insert(listAt(ctx.data(), path).length) },
    "Add place",
  );
  const fold = h("details", { class: "place-fold" }, count, rows, add);
  const element = h("div", { class: "places" }, fold);
  let inputs: Input[] = [];

  const insert = (n: number) => {
    const list = listAt(ctx.data(), path);
    setValue(ctx, path, list.toSpliced(n, 0, between(list[n - 1], list[n] ?? list[0])));
  };
  const take = (n: number) => {
    const list = listAt(ctx.data(), path).toSpliced(n, 1);
    setValue(ctx, path, list.length > 0 ? list : undefined);
  };
  const build = (length: number) => {
    // few places are shown at once, many when they are asked for
    if (inputs.length === 0) fold.open = length <= FEW;
    count.textContent = length === 1 ? "1 place" : `${length} places`;
    inputs = Array.from({ length }, (_, n) => tupleInput(ctx, [...path, n], each, 2, ["x", "y"], undefined));
    fill(
      rows,
      ...inputs.map((input, n) =>
        h(
          "div",
          { class: "place-row" },
          h("span", { class: "number-of" }, String(n + 1)),
          input.element,
          h(
            "button",
            {
              type: "button",
              class: "icon",
              "aria-label": `insert a place after ${n + 1}`,
              title: "insert after",
              onclick: () => insert(n + 1),
            },
            icon("add"),
          ),
          h(
            "button",
            {
              type: "button",
              class: "icon",
              "aria-label": `remove place ${n + 1}`,
              title: "remove",
              onclick: () => take(n),
            },
            icon("remove"),
          ),
        ),
      ),
    );
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

/** A place half-way between two, in their units; 0, 0 if there are none. */
function between(a: Json | undefined, b: Json | undefined): Json {
  const [from, to] = [place(a), place(b)];
  if (!from || !to) return ["0 m", "0 m"];
  return writtenLike(a, [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
}

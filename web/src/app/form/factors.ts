// The factors of a combination: one for each load case that takes part.

import { fill, h } from "../dom";
import { listAt, type Path, tableAt } from "../paths";
import { namesIn } from "../store";
import { type FormContext, setValue } from "./context";
import { type Input, textInput } from "./inputs";

/** One number for each load case; empty where the case does not take part. */
export function factorsInput(ctx: FormContext, path: Path): Input {
  const element = h("span", { class: "factors" });
  let names: string[] = [];
  let cells: Input[] = [];
  const build = () => {
    cells = names.map((name) => textInput(ctx, [...path, name], { is: "number", words: [] }, {
      label: `factor of ${name}`,
      placeholder: "–",
      write: (value, typing) => {
        const left = Object.keys(tableAt(ctx.data(), path)).filter((each) => each !== name);
        if (value === undefined && left.length === 0) setValue(ctx, path, undefined, typing);
        else setValue(ctx, [...path, name], value, typing);
      },
    }));
    fill(element, ...cells.map((cell, n) => h("label", {}, h("span", {}, names[n] ?? ""), cell.element)));
    if (names.length === 0) fill(element, h("span", { class: "quiet" }, "Add load cases first."));
  };
  const update = () => {
    const own = Object.keys(tableAt(ctx.data(), path));
    const now = [...new Set([...namesIn(listAt(ctx.data(), ["cases"])), ...own])];
    if (cells.length === 0 || now.join("\n") !== names.join("\n")) {
      names = now;
      build();
    }
    for (const cell of cells) cell.update();
  };
  return { element, get focus() { return cells[0]?.focus ?? element; }, update };
}

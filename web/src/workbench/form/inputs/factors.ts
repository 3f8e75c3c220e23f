// The factors of a combination: one for each load case that takes part.

import { fill, h } from "../../../viewer/shared/dom";
import { say, verbatim } from "../../../viewer/shared/language";
import { namesIn } from "../../model/names";
import { type Json, listAt, type Path, tableAt } from "../../model/paths";
import { type FormContext, setValue, type Widget } from "../context";
import { type Input, inputCell, textInput } from "./inputs";

/** The factor of one load case. */
function factorInput(ctx: FormContext, path: Path, name: string, label: string): Input {
  const write = (value: Json | undefined, typing: boolean) => {
    const left = Object.keys(tableAt(ctx.data(), path)).filter((each) => each !== name);
    if (value === undefined && left.length === 0) setValue(ctx, path, undefined, typing);
    else setValue(ctx, [...path, name], value, typing);
  };
  return textInput(ctx, [...path, name], { is: "number", options: [] }, { label, placeholder: () => "–", write });
}

/** The factor of one load case as a cell of a table. */
export function factorCell(ctx: FormContext, path: Path, name: string, label: string): Widget {
  return inputCell(ctx, [...path, name], factorInput(ctx, path, name, label));
}

/** One number for each load case; empty where the case does not take part. */
export function factorsInput(ctx: FormContext, path: Path): Input {
  const element = h("span", { class: "factors" });
  let names: string[] = [];
  let cells: Input[] = [];
  const build = () => {
    cells = names.map((name) => factorInput(ctx, path, name, say("factor of {name}", { name: verbatim(name) })));
    fill(element, ...cells.map((cell, n) => h("label", {}, h("span", {}, verbatim(names[n] ?? "")), cell.element)));
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
  return {
    element,
    get focus() {
      return cells[0]?.focus ?? element;
    },
    update,
  };
}

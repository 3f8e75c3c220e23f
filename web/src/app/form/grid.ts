// A list of flat tables as a grid: one row for each table, one column for each key.

import { fill, h } from "../dom";
import { listAt, type Path, startsWith } from "../paths";
import type { FormContext, Widget } from "./context";
import { faultsOfPart, faultWords } from "./faults";
import { itemButtons, type Rows } from "./list";
import type { Part } from "./schema";
import { cellField, hintOf, labelParts } from "./value-field";

interface Row {
  element: HTMLElement;
  cells: Widget[];
  update(): void;
}

/** The rows of a list whose tables hold single values only. */
export function gridRows(ctx: FormContext, path: Path, part: Part): Rows {
  const heads = part.fields.map((field) => h("th", { scope: "col", title: hintOf(field), class: field.needed ? "needed" : null }, ...labelParts(field)));
  const body = h("tbody", {});
  const table = h("table", { class: "grid" }, h("thead", {}, h("tr", {}, h("th", { class: "number-of", scope: "col" }, "#"), ...heads, h("th", { class: "acts" }))), body);
  const element = h("div", { class: "grid-box" }, table);
  let rows: Row[] = [];
  const update = () => {
    const count = listAt(ctx.data(), path).length;
    table.hidden = count === 0;
    if (count !== rows.length) {
      const focus = document.activeElement;
      rows = rows.slice(0, count);
      while (rows.length < count) rows.push(gridRow(ctx, [...path, rows.length], part));
      fill(body, ...rows.map((row) => row.element));
      if (focus instanceof HTMLElement && body.contains(focus)) focus.focus();
    }
    for (const row of rows) row.update();
  };
  const reveal = (target: Path) => {
    const n = target[path.length];
    const row = typeof n === "number" ? rows[n] : undefined;
    if (!row) return false;
    if (row.cells.some((cell) => cell.reveal(target))) return true;
    row.element.querySelector<HTMLElement>("input, select")?.focus();
    return startsWith(target, path);
  };
  return { element, update, reveal };
}

function gridRow(ctx: FormContext, path: Path, part: Part): Row {
  const position = Number(path.at(-1)) + 1;
  const cells = part.fields.map((field) => cellField(ctx, [...path, field.name], field, `${field.name} of item ${position}`));
  const messages = h("div", { class: "messages" });
  const element = h(
    "tr",
    {},
    h("td", { class: "number-of" }, String(position)),
    ...cells.map((cell) => h("td", {}, cell.element)),
    h("td", { class: "acts" }, ...itemButtons(ctx, path), messages),
  );
  const update = () => {
    for (const cell of cells) cell.update();
    const words = faultsOfPart(ctx.faults(), path, part).map(faultWords);
    fill(messages, ...words.map((each) => h("p", {}, each)));
  };
  return { element, cells, update };
}

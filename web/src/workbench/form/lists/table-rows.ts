// A list of flat tables as a grid: one row for each table, one column for each key.

import { namesIn } from "../../client/store";
import { listAt, type Path, startsWith, tableAt } from "../../model/paths";
import type { Field, Part } from "../../model/schema";
import { fill, h } from "../../shell/elements";
import type { FormContext, Widget } from "../context";
import { faultsAt, faultsOfPart, faultWords } from "../errors";
import { factorCell } from "../inputs/factors";
import { cellField, hintOf, labelParts } from "../inputs/value-field";
import { itemButtons, type Rows } from "./list";

interface Row {
  element: HTMLElement;
  cells: Widget[];
  update(): void;
}

/** A column of the grid: its head, and the cell of a row. */
interface Column {
  head: HTMLElement;
  cell(path: Path, position: number): Widget;
}

/** The rows of a list whose tables hold single values only. */
export function gridRows(ctx: FormContext, path: Path, part: Part): Rows {
  const head = h("thead", {});
  const body = h("tbody", {});
  const table = h("table", { class: "grid" }, head, body);
  const element = h("div", { class: "grid-box" }, table);
  let rows: Row[] = [];
  let columns: Column[] = [];
  let cases = "";
  const build = () => {
    columns = part.fields.flatMap((field) =>
      field.node.is === "factors" ? factorColumns(ctx, path, field) : [valueColumn(ctx, field)],
    );
    fill(
      head,
      h(
        "tr",
        {},
        h("th", { class: "number-of", scope: "col" }, "#"),
        ...columns.map((column) => column.head),
        h("th", { class: "acts" }),
      ),
    );
    rows = [];
    fill(body);
  };
  const update = () => {
    const items = listAt(ctx.data(), path);
    const now = part.fields.some((field) => field.node.is === "factors") ? caseNames(ctx, path).join("\n") : "";
    if (columns.length === 0 || now !== cases) {
      cases = now;
      build();
    }
    table.hidden = items.length === 0;
    while (rows.length > items.length) rows.pop()?.element.remove();
    while (rows.length < items.length) {
      const row = gridRow(ctx, [...path, rows.length], part, columns);
      rows.push(row);
      body.append(row.element);
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

function valueColumn(ctx: FormContext, field: Field): Column {
  return {
    head: h("th", { scope: "col", title: hintOf(field), class: field.needed ? "needed" : null }, ...labelParts(field)),
    cell: (path, position) => cellField(ctx, [...path, field.name], field, `${field.name} of item ${position}`),
  };
}

/** The load cases, and what else the factors of a list name. */
function caseNames(ctx: FormContext, path: Path): string[] {
  const named = listAt(ctx.data(), path).flatMap((_, n) => Object.keys(tableAt(ctx.data(), [...path, n, "factors"])));
  return [...new Set([...namesIn(listAt(ctx.data(), ["cases"])), ...named])];
}

/** One column for each load case. */
function factorColumns(ctx: FormContext, path: Path, field: Field): Column[] {
  return caseNames(ctx, path).map((name) => ({
    head: h("th", { scope: "col", class: "factor", title: `${field.hint}: ${name}` }, name),
    cell: (row, position) => factorCell(ctx, [...row, field.name], name, `factor of ${name} in item ${position}`),
  }));
}

function gridRow(ctx: FormContext, path: Path, part: Part, columns: readonly Column[]): Row {
  const position = Number(path.at(-1)) + 1;
  const cells = columns.map((column) => column.cell(path, position));
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
    const factors = faultsAt(ctx.faults(), [...path, "factors"]).filter(
      (fault) => fault.path.length === path.length + 1,
    );
    const words = [...faultsOfPart(ctx.faults(), path, part), ...factors].map(faultWords);
    fill(messages, ...words.map((each) => h("p", {}, each)));
  };
  return { element, cells, update };
}

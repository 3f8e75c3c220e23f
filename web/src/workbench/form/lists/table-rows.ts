// A list of flat tables as rows: one row for each table, one column for each key.
import { fill, h } from "../../../viewer/shared/dom";
import { keep, say, translate, verbatim } from "../../../viewer/shared/language";
import { issuesAt, issuesOfPart } from "../../model/issues";
import { namesIn } from "../../model/names";
import { listAt, type Path, startsWith, tableAt } from "../../model/paths";
import type { Field, Part } from "../../model/schema";
import type { FormContext, Widget } from "../context";
import { showIssues } from "../errors";
import { factorCell } from "../inputs/factors";
import { cellField } from "../inputs/value-field";
import { hintOf, labelParts } from "../labels";
import { itemButtons } from "./item-buttons";

/** A column: its head, and its cell of a row. */
interface Column {
  head: HTMLElement;
  makeCell(path: Path, position: number): Widget;
}

/** The rows of a list whose tables hold single values only. */
export function tableRows(ctx: FormContext, path: Path, part: Part): Widget {
  const head = h("thead");
  const body = h("tbody");
  const table = h("table", { class: "grid" }, head, body);
  const element = h("div", { class: "grid-box" }, table);
  const hasFactors = part.fields.some((field) => field.node.is === "factors");
  let rows: Widget[] = [];
  let columns: Column[] = [];
  let cases = "";
  const build = () => {
    columns = part.fields.flatMap((field) =>
      field.node.is === "factors" ? factorColumns(ctx, path, field) : [valueColumn(ctx, field)],
    );
    const number = h("th", { class: "number-of", scope: "col" }, "#");
    fill(head, h("tr", {}, number, ...columns.map((column) => column.head), h("th", { class: "acts" })));
    rows = [];
    fill(body);
  };
  const update = () => {
    const items = listAt(ctx.data(), path);
    const now = hasFactors ? caseNames(ctx, path).join("\n") : "";
    if (columns.length === 0 || now !== cases) {
      cases = now;
      build();
    }
    table.hidden = items.length === 0;
    while (rows.length > items.length) rows.pop()?.element.remove();
    while (rows.length < items.length) {
      const row = tableRow(ctx, [...path, rows.length], part, columns);
      rows.push(row);
      body.append(row.element);
    }
    for (const row of rows) row.update();
  };
  const reveal = (target: Path) => rows[Number(target[path.length])]?.reveal(target) ?? false;
  return { element, update, reveal };
}

function valueColumn(ctx: FormContext, field: Field): Column {
  const attributes = { scope: "col", title: hintOf(field), class: field.needed ? "needed" : null };
  return {
    head: h("th", attributes, ...labelParts(field)),
    makeCell: (path, position) =>
      cellField(
        ctx,
        [...path, field.name],
        field,
        say("{field} of item {number}", { field: field.name, number: position }),
      ),
  };
}

/** Return the load cases, and what else the factors of a list name. */
function caseNames(ctx: FormContext, path: Path): string[] {
  const named = listAt(ctx.data(), path).flatMap((_, n) => Object.keys(tableAt(ctx.data(), [...path, n, "factors"])));
  return [...new Set([...namesIn(listAt(ctx.data(), ["cases"])), ...named])];
}

/** Return one column for each load case. */
function factorColumns(ctx: FormContext, path: Path, field: Field): Column[] {
  return caseNames(ctx, path).map((name) => ({
    head: h("th", { scope: "col", class: "factor", title: keep(`${translate(field.hint)}: ${name}`) }, verbatim(name)),
    makeCell: (row, position) =>
      factorCell(
        ctx,
        [...row, field.name],
        name,
        say("factor of {name} in item {number}", { name: verbatim(name), number: position }),
      ),
  }));
}

function tableRow(ctx: FormContext, path: Path, part: Part, columns: readonly Column[]): Widget {
  const position = Number(path.at(-1)) + 1;
  const cells = columns.map((column) => column.makeCell(path, position));
  const messages = h("div", { class: "messages" });
  const number = h("td", { class: "number-of" }, String(position));
  const buttons = h("td", { class: "acts" }, ...itemButtons(ctx, path), messages);
  const element = h("tr", {}, number, ...cells.map((cell) => h("td", {}, cell.element)), buttons);
  const update = () => {
    for (const cell of cells) cell.update();
    const factors = issuesAt(ctx.issues(), [...path, "factors"]).filter(
      (issue) => issue.path.length === path.length + 1,
    );
    showIssues(messages, [...issuesOfPart(ctx.issues(), path, part), ...factors], ctx.change);
  };
  const reveal = (target: Path) => {
    if (cells.some((cell) => cell.reveal(target))) return true;
    element.querySelector<HTMLElement>("input, select")?.focus();
    return startsWith(target, path);
  };
  return { element, update, reveal };
}

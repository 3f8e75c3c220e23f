// The columns of a table: one for each single value that an item may have, from the fields of the schema.
import { keep, translate } from "../../viewer/shared/language";
import { defaultElement, tupleLabels } from "../form/inputs/inputs";
import { labelOf } from "../form/labels";
import { namesIn } from "../model/names";
import { type Json, listAt, type Path, type Table, tableAt } from "../model/paths";
import type { Field, Node, Schema } from "../model/schema";
import type { Sheet } from "./sheets";

export interface Column {
  /** The place of its values within an item. */
  readonly path: Path;
  readonly field: Field;
  /** What its values are. */
  readonly node: Node;
  /** Its head: words, and a symbol where there is one. */
  readonly words: string;
  readonly symbol: string;
  /** Other words by which pasted text may call it. */
  readonly aliases: readonly string[];
  readonly needed: boolean;
  /** Whether it is hidden while no item uses it. */
  readonly rare: boolean;
  /** The other values of a list of fixed length, where they are missing. */
  readonly blanks: readonly Json[];
}

const MOST_POINTS = 12; // of a line that have columns; the number of points of longer ones stands beside them
const SINGLE: ReadonlySet<Node["is"]> = new Set([
  "quantity",
  "number",
  "integer",
  "choice",
  "boolean",
  "text",
  "values",
]);

/** Return the columns of a table whose items are `rows`. */
export function columnsOf(schema: Schema, data: Table, { list, part }: Sheet, rows: readonly Table[]): Column[] {
  const columns = part.fields.flatMap((field) => fieldColumns(schema, data, field, rows));
  const one = list.replace(/s$/, "");
  const isFree = columns.every((column) => column.field.name !== one);
  return columns.map((column) =>
    column.field.name === "name" && isFree ? { ...column, aliases: [...column.aliases, one] } : column,
  );
}

/** Whether the cells of a column can be edited; what has parts of its own is edited in plan and form. */
export function isEditable({ node }: Column): boolean {
  return SINGLE.has(node.is);
}

/** Return the head of a column as text. */
export function headText({ words, symbol }: Column): string {
  return [words, symbol].filter(Boolean).join(" ");
}

/** Return what a column is called in a sentence. */
export function nameOf(column: Column): string {
  return column.path.length === 1 ? column.words || column.symbol : headText(column);
}

function fieldColumns(schema: Schema, data: Table, field: Field, rows: readonly Table[]): Column[] {
  const { node, name } = field;
  const longest = (least: number) => rows.reduce((most, row) => Math.max(most, listAt(row, [name]).length), least);
  switch (node.is) {
    case "tag":
      return [];
    case "tuple":
      return tupleColumns(field, node);
    case "points":
      return [
        ...countTo(Math.min(longest(2), MOST_POINTS)).flatMap((n) => pointColumns(field, node.each, n)),
        ...(longest(2) > MOST_POINTS ? [singleColumn(field)] : []),
      ];
    case "factors":
      return caseNames(data, rows, name).map((word) => factorColumn(field, word));
    case "list": {
      const part = node.of.is === "part" ? schema.part(node.of.part) : null;
      if (!part?.fields.every((each) => SINGLE.has(each.node.is))) return [singleColumn(field)];
      const count = longest(Math.max(1, listAt(data, ["ground", name]).length));
      return countTo(count).flatMap((n) => part.fields.map((each) => nestedColumn(field, each, n)));
    }
    default:
      return [singleColumn(field)];
  }
}

function countTo(count: number): number[] {
  return Array.from({ length: count }, (_, n) => n);
}

function singleColumn(field: Field): Column {
  const label = labelOf(field);
  const symbol = field.symbol === label || field.symbol.includes(",") ? "" : field.symbol;
  const words = label || (symbol ? "" : field.name);
  const aliases = [field.name, words, symbol, field.hint.split(/[,;:]/)[0] ?? ""];
  const { name, node, needed } = field;
  return { path: [name], field, node, words, symbol, aliases, needed, rare: false, blanks: [] };
}

/** Return one column for each value of a list of fixed length. */
function tupleColumns(field: Field, node: Extract<Node, { is: "tuple" }>): Column[] {
  const { each, length } = node;
  const single = singleColumn(field);
  const labels = tupleLabels(field, node);
  const blanks = countTo(length).map((n) => defaultElement(field.default, n));
  return countTo(length).map((n): Column => {
    const label = labels[n] ?? String(n + 1);
    const name = labelOf(field) || field.name;
    const words = keep(`${translate(name)} ${translate(label)}`);
    const aliases = [words, `${name} ${label}`, `${field.name} ${label}`, `${field.name} ${n + 1}`];
    return { ...single, path: [field.name, n], node: each, words, symbol: "", aliases, blanks, rare: !field.needed };
  });
}

/** Return the columns of one point of a line. */
function pointColumns(field: Field, point: Node, n: number): Column[] {
  const each: Node = point.is === "tuple" ? point.each : point;
  return ["x", "y"].map((axis, k): Column => {
    const symbol = `${axis}_${n + 1}`;
    const aliases = [symbol, `point ${n + 1} ${axis}`];
    const place = { path: [field.name, n, k], field, node: each, words: "", symbol, aliases };
    return { ...place, needed: field.needed && n < 2, rare: false, blanks: ["", ""] };
  });
}

/** Return the load cases, and what else the factors of a list name. */
function caseNames(data: Table, rows: readonly Table[], key: string): string[] {
  const named = rows.flatMap((row) => Object.keys(tableAt(row, [key])));
  return [...new Set([...namesIn(listAt(data, ["cases"])), ...named])];
}

function factorColumn(field: Field, name: string): Column {
  const node: Node = { is: "number", options: [] };
  const aliases = [name, `factor of ${name}`, `factor ${name}`];
  return {
    path: [field.name, name],
    field: { ...field, default: undefined, hint: keep(`${translate(field.hint)}: ${name}`) },
    node,
    words: name,
    symbol: "",
    aliases,
    needed: false,
    rare: false,
    blanks: [],
  };
}

/** Return the column of a field within the n-th table of a list, such as a layer of a borehole. */
function nestedColumn(field: Field, inner: Field, n: number): Column {
  const single = singleColumn(inner);
  const prefix = `${field.name.replace(/s$/, "")} ${n + 1}`;
  const shown = `${translate(field.name.replace(/s$/, ""))} ${n + 1}`;
  const words = keep(single.words && single.symbol ? shown : `${shown} ${translate(single.words)}`.trim());
  const aliases = single.aliases.filter(Boolean).flatMap((word) => [`${prefix} ${word}`, `${word} ${n + 1}`]);
  return { ...single, path: [field.name, n, inner.name], words, aliases, rare: !inner.needed };
}

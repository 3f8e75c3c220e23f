// The rows of a table: sorted, filtered, as text. No elements here.
import { ALL_LOADS, translate } from "../../viewer/shared/language";
import type { ResultTable, TableCell, TableHead } from "../client/api";
import { headWidth } from "../controls/virtual-rows";

export interface Sorting {
  column: number;
  descending: boolean;
}

export function textOf(cell: TableCell | undefined): string {
  return (typeof cell === "string" ? cell : cell?.[0]) ?? "";
}

/** Return what is shown of a cell: a number with a decimal comma, the words of the server as they are. */
export function shownText(cell: TableCell | undefined, head: TableHead | undefined): string {
  const text = textOf(cell);
  return head?.number || text === ALL_LOADS ? translate(text) : text;
}

/** Return the number that a cell shows, NaN if it shows none. */
export function numberOf(cell: TableCell | undefined): number {
  const text = textOf(cell).trim();
  if (text === "inf") return Infinity;
  return text === "" ? NaN : Number(text);
}

/** Return the positions of the rows that hold all words of a filter, in the order of a column; empty cells come last. */
export function arrangeRows({ rows, heads }: ResultTable, filter: string, sorting: Sorting | null): number[] {
  const words = filter.toLowerCase().split(/\s+/).filter(Boolean);
  const holds = (row: readonly TableCell[]) => {
    const text = [...row.map(textOf), ...row.map((cell, n) => shownText(cell, heads[n]))].join("\n").toLowerCase();
    return words.every((word) => text.includes(word));
  };
  const positions = rows.flatMap((row, n) => (words.length === 0 || holds(row) ? [n] : []));
  if (!sorting) return positions;
  const { column, descending } = sorting;
  const compare = heads[column]?.number ? compareNumbers : compareTexts;
  const sign = descending ? -1 : 1;
  return positions.sort((a, b) => {
    const [first, second] = [rows[a]?.[column], rows[b]?.[column]];
    const empty = Number(textOf(first) === "") - Number(textOf(second) === "");
    return empty || sign * compare(first, second) || a - b;
  });
}

function compareNumbers(a: TableCell | undefined, b: TableCell | undefined): number {
  const [first, second] = [numberOf(a), numberOf(b)];
  if (Number.isNaN(first) || Number.isNaN(second)) return compareTexts(a, b);
  return first === second ? 0 : first - second;
}

function compareTexts(a: TableCell | undefined, b: TableCell | undefined): number {
  return textOf(a).localeCompare(textOf(b), "en", { numeric: true });
}

/** Return a head as the files of tables have it: `settlement w [mm]`. */
export function headText({ text, symbol, unit }: TableHead): string {
  const name = [text, symbol].filter(Boolean).join(" ");
  return unit ? `${name} [${unit}]` : name;
}

/** Return rows under their heads as tab-separated text, as spreadsheets take it. */
export function toTabSeparated({ heads, rows }: ResultTable, positions: readonly number[]): string {
  const clean = (text: string) => text.replace(/[\t\r\n]+/g, " ");
  const lines = positions.map((n) => (rows[n] ?? []).map((cell) => clean(textOf(cell))).join("\t"));
  return [heads.map((head) => clean(headText(head))).join("\t"), ...lines].join("\n");
}

/** What a cell leads to: a place, a combination, a field, the name of an item. */
export interface Target {
  place: [number, number] | null;
  combination: string | null;
  field: string | null;
  item: { list: string; name: string } | null;
}

/** Return what a cell leads to. */
export function targetOf(table: ResultTable, row: number, column: number): Target {
  const cells = table.rows[row] ?? [];
  const { place, combination, field } = table.heads[column] ?? { place: null, combination: null, field: null };
  const at = place?.map((n) => numberOf(cells[n])) ?? [];
  const { item } = table;
  return {
    place: at.length === 2 && at.every(Number.isFinite) ? (at as [number, number]) : null,
    combination: combination === null ? null : textOf(cells[combination]) || null,
    field: field ?? table.fields?.[row] ?? null,
    item: item && { list: item.list, name: textOf(cells[item.column]) },
  };
}

/** Return the widths of the columns in letters of the language shown, so that no row that comes into view later changes them. */
export function columnWidths({ heads, rows }: ResultTable): number[] {
  return heads.map((head, n) => {
    const widest = rows.reduce((most, row) => Math.max(most, lengthOf(row[n], head)), headWidth(headText(head)));
    return Math.min(Math.max(widest, 4), 44) + 2;
  });
}

/** Return the length of a text in digits, than which some letters are wider. */
function lettersOf(text: string): number {
  return text.length + 0.4 * (text.match(/[MNWmw]/g)?.length ?? 0);
}

function lengthOf(cell: TableCell | undefined, head: TableHead): number {
  const under = typeof cell === "object" ? cell[1] : "";
  return lettersOf(shownText(cell, head)) + (under ? under.length + 1 : 0);
}

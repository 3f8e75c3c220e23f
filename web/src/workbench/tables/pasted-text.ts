// Text from a spreadsheet: its cells, and a head that names the columns.
import { NUMBER_START } from "../model/quantities";
import { type Column, headText } from "./columns";

const UNIT = /^\[?\(?([A-Za-zµ°%][A-Za-z0-9µ°%/^*·.²³ -]*|1\/[A-Za-z°]+)\)?\]?$/;
const PLAIN_NUMBER = /^[+-]?[\d.,]+$/;

/** Return the cells of a text with tabs or semicolons between them; quoted cells may hold both, and line ends. */
export function splitCells(text: string): string[][] {
  const separator = text.includes("\t") ? "\t" : ";";
  const rows: string[][] = [[]];
  const pattern = new RegExp(
    `(?:"((?:[^"]|"")*)"(?=${separator}|\\r?\\n|$)|([^${separator}\\r\\n]*))(${separator}|\\r?\\n|$)`,
    "y",
  );
  while (pattern.lastIndex <= text.length) {
    const match = pattern.exec(text);
    if (!match) break;
    const [all, quoted, plain = "", end] = match;
    rows.at(-1)!.push((quoted?.replaceAll('""', '"') ?? plain).trim());
    if (end === "" || all === "") break;
    if (end !== separator) rows.push([]);
  }
  while (rows.length > 0 && rows.at(-1)!.every((cell) => cell === "")) rows.pop();
  return rows;
}

/** A pasted block: the column of each of its cells, by its position in a row, and the units that its head names. */
export interface PastedBlock {
  readonly columns: readonly (Column | null)[];
  readonly units: readonly string[];
  readonly rows: readonly (readonly string[])[];
  /** The heads that are no column of the table. */
  readonly unknown: readonly string[];
}

/** Return a pasted block; one without a head fills the columns shown from the n-th on, a head may name any of `all`. */
export function readBlock(
  cells: readonly (readonly string[])[],
  columns: readonly Column[],
  n: number,
  all: readonly Column[] = columns,
): PastedBlock {
  const width = Math.max(0, ...cells.map((row) => row.length));
  return (
    readHead(cells, all) ?? {
      columns: Array.from({ length: width }, (_, k) => columns[n + k] ?? null),
      units: [],
      rows: cells,
      unknown: [],
    }
  );
}

/** Return a block whose first line names its columns, null if it does not; a line of units may follow. */
function readHead(cells: readonly (readonly string[])[], columns: readonly Column[]): PastedBlock | null {
  const [first, ...others] = cells;
  if (!first || others.length === 0) return null;
  const heads = first.map(splitHead);
  const called = heads.map(({ name }) => findColumn(name, columns));
  // a load case may be called "1 snow"; what is nothing but a number is a value
  if (first.some((cell, k) => NUMBER_START.test(cell) && (!called[k] || PLAIN_NUMBER.test(cell)))) return null;
  const found = called.map((column, k) => (called.indexOf(column) === k ? column : null));
  const named = found.filter((column) => column !== null).length;
  const words = heads.filter(({ name }) => name !== "").length;
  if (named === 0 || named * 2 < words || (named === 1 && words > 1)) return null;
  const hasUnits = isUnitLine(others[0]!, found) && others.length > 1;
  const units = heads.map(({ unit }, k) => unit || (hasUnits ? readUnit(others[0]![k] ?? "") : ""));
  const unknown = heads.flatMap(({ name }, k) => (name && !found[k] ? [name] : []));
  return { columns: found, units, rows: hasUnits ? others.slice(1) : others, unknown };
}

/** Return the name and the unit of a head: `P [kN]`, `P (kN)`, `P in kN`, `P / kN`. */
export function splitHead(text: string): { name: string; unit: string } {
  const match =
    /^(.*?)\s*[[(]([^\])]*)[\])]$/.exec(text) ??
    /^(.*\S)\s+in\s+(\S+)$/.exec(text) ??
    /^(.*?\S)\s*\/\s*(\S+)$/.exec(text);
  return match ? { name: match[1]!.trim(), unit: match[2]!.trim() } : { name: text, unit: "" };
}

/** Return the column that a head names, null if it names none or several. */
function findColumn(name: string, columns: readonly Column[]): Column | null {
  if (plain(name) === "") return null;
  const exact = columns.filter((column) => [column.words, headText(column), column.symbol].includes(name));
  if (exact.length === 1) return exact[0]!;
  const keys = columns.filter(
    (column) => plain(String(column.path.at(-1))) === plain(name) && column.path.length === 1,
  );
  if (keys.length === 1) return keys[0]!;
  const alike = columns.filter((column) =>
    [headText(column), ...column.aliases].some((each) => plain(each) === plain(name)),
  );
  return alike.length === 1 ? alike[0]! : null;
}

/** Return a name without what people write in different ways. */
function plain(name: string): string {
  return name.toLowerCase().replace(/[^\p{L}\p{N}]/gu, "");
}

/** Whether a line below the head holds units: words where there are quantities, nothing elsewhere. */
function isUnitLine(cells: readonly string[], columns: readonly (Column | null)[]): boolean {
  const isQuantity = (k: number) => columns[k]?.node.is === "quantity";
  const fits = cells.every((cell, k) =>
    isQuantity(k) ? cell === "" || UNIT.test(cell) : readUnit(cell) === "" || !columns[k],
  );
  return fits && cells.some((cell, k) => isQuantity(k) && cell !== "");
}

function readUnit(cell: string): string {
  const unit = UNIT.exec(cell)?.[1]?.trim() ?? "";
  return unit === "-" ? "" : unit;
}

/** Return cells as text with tabs between them, as spreadsheets take it. */
export function joinCells(rows: readonly (readonly string[])[]): string {
  const clean = (cell: string) => cell.replace(/[\t\r\n]+/g, " ");
  return rows.map((row) => row.map(clean).join("\t")).join("\n");
}

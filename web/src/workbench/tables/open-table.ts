// The table that is open: its columns, its rows, what is wrong with them. No elements here.
import type { FormContext } from "../form/context";
import type { Change } from "../model/edits";
import { type Issue, issueSentence } from "../model/issues";
import { type Json, listAt, type Path, pathKey, type Table, tableAt, valueAt } from "../model/paths";
import { unitIn } from "../model/quantities";
import { type Field, whyIdle } from "../model/schema";
import { cellText, commonUnit, parseCell } from "./cells";
import { type Write, writeCells } from "./changes";
import { type Column, columnsOf, headText, isEditable } from "./columns";
import { joinCells, readBlock, splitCells } from "./pasted-text";
import type { Bounds, Cell } from "./selection";
import { positionsIn, type Sheet } from "./sheets";

/** What a paste does: its change, the block that it fills, what was not taken. */
export interface Paste {
  change: Change | null;
  block: Bounds;
  left: string[];
}

export class OpenTable {
  readonly positions: readonly number[];
  readonly rows: readonly Table[];
  /** The columns that are shown, and all of them. */
  readonly columns: readonly Column[];
  private readonly all: readonly Column[];
  private readonly issues: Map<string, Issue[]>;
  private readonly units = new Map<Field, string>();

  constructor(
    private readonly ctx: FormContext,
    readonly sheet: Sheet,
    readonly showsAll: boolean,
  ) {
    const data = ctx.data();
    this.positions = positionsIn(data, sheet);
    this.rows = this.positions.map((n) => tableAt(data, [sheet.list, n]));
    this.all = columnsOf(ctx.schema, data, sheet, this.rows);
    this.columns = this.all.filter((column) => showsAll || !column.rare || this.isUsed(column));
    this.issues = indexIssues(ctx.issues(), sheet.list);
  }

  get hasHidden(): boolean {
    return this.all.some((column) => column.rare && !this.isUsed(column));
  }

  /** Return the path of a row's item, null for the row below the last one. */
  pathOf(row: number): Path | null {
    const position = this.positions[row];
    return position === undefined ? null : [this.sheet.list, position];
  }

  /** Return the number of a row: that of its item in the list. */
  numberOf(row: number): number {
    return (this.positions[row] ?? listAt(this.ctx.data(), [this.sheet.list]).length) + 1;
  }

  textAt({ row, column }: Cell): string {
    const shown = this.columns[column];
    return shown ? cellText(this.ctx.schema, shown, this.rows[row] ?? {}) : "";
  }

  /** Return why a cell without a value would mean nothing, empty if it would or has one. */
  whyIdle(cell: Cell): string {
    const shown = this.columns[cell.column];
    const row = this.rows[cell.row];
    return shown && row && this.textAt(cell) === "" ? whyIdle(this.sheet.part, shown.field, row) : "";
  }

  /** Return what is wrong with a cell: with its value, or with the list or table that the value is part of. */
  issuesAt({ row, column }: Cell): string[] {
    const [path, shown] = [this.pathOf(row), this.columns[column]];
    if (!path || !shown || this.issues.size === 0) return [];
    const above = shown.path.slice(0, -1).flatMap((_, n) => {
      const key = pathKey([...path, ...shown.path.slice(0, n + 1)]);
      return (this.issues.get(key) ?? []).filter((issue) => pathKey(issue.path) === key);
    });
    return [...above, ...(this.issues.get(pathKey([...path, ...shown.path])) ?? [])].map(issueSentence);
  }

  /** Return what is wrong with an item, anywhere in it. */
  issuesOf(row: number): Issue[] {
    const path = this.issues.size > 0 ? this.pathOf(row) : null;
    return path ? (this.issues.get(pathKey(path)) ?? []) : [];
  }

  /** Return the first row with an issue, -1 if there is none. */
  get firstFaulty(): number {
    return this.issues.size === 0 ? -1 : this.rows.findIndex((_, row) => this.issuesOf(row).length > 0);
  }

  /** Return how many issues the rows have. */
  get issueTotal(): number {
    return this.issues.size === 0 ? 0 : this.rows.reduce((sum, _, row) => sum + this.issuesOf(row).length, 0);
  }

  /** Return the change that writes what was typed into a cell, null if that changes nothing. */
  type({ row, column }: Cell, text: string): Change | null {
    const shown = this.columns[column];
    if (!shown || !isEditable(shown) || text.trim() === this.textAt({ row, column })) return null;
    return this.write([{ row, column: shown, value: this.parse(shown, row, text) }]);
  }

  /** Return what pasting a text at a block does; a single value fills the block. */
  paste(text: string, at: Bounds): Paste {
    const cells = splitCells(text);
    const isSingle = cells.length === 1 && cells[0]?.length === 1;
    const [height, width] = isSingle ? [at.bottom - at.top + 1, at.right - at.left + 1] : [1, 1];
    const filled = isSingle ? Array.from({ length: height }, () => Array<string>(width).fill(cells[0]![0]!)) : cells;
    // a head may name columns that are hidden
    const { columns, units, rows, unknown } = readBlock(filled, this.columns, at.left, this.all);
    const writes = rows.flatMap((row, n) =>
      columns.flatMap((column, k): Write[] => {
        if (!column || !isEditable(column)) return [];
        const value = this.parse(column, at.top + n, row[k] ?? "", units[k]);
        return [{ row: at.top + n, column, value }];
      }),
    );
    const refused = columns.flatMap((column) => (column && !isEditable(column) ? [headText(column)] : []));
    const isTooWide = units.length === 0 && columns.includes(null);
    const left = [...unknown, ...refused, ...(isTooWide ? ["cells beyond the last column"] : [])];
    const ends = columns.flatMap((column) => (column ? [this.columns.indexOf(column)] : [])).filter((n) => n >= 0);
    const block = {
      top: at.top,
      bottom: at.top + Math.max(0, rows.length - 1),
      left: Math.min(...ends, this.columns.length - 1),
      right: Math.max(...ends, 0),
    };
    return { change: this.write(writes), block, left };
  }

  /** Return a block as text for a spreadsheet. */
  copy({ top, bottom, left, right }: Bounds): string {
    const range = (from: number, to: number) => Array.from({ length: to - from + 1 }, (_, n) => from + n);
    const rows = range(top, Math.min(bottom, this.rows.length - 1));
    return joinCells(rows.map((row) => range(left, right).map((column) => this.textAt({ row, column }))));
  }

  /** Return all rows below their heads as text for a spreadsheet. */
  copyAll(): string {
    const block = { top: 0, bottom: this.rows.length - 1, left: 0, right: this.columns.length - 1 };
    return [joinCells([this.columns.map(headText)]), this.copy(block)].filter(Boolean).join("\n");
  }

  /** Return the value of a text; a bare number takes the head's unit, else that of the old value, else the column's. */
  private parse(column: Column, row: number, text: string, unit = ""): Json | undefined {
    return parseCell(column, text, unit || unitIn(valueAt(this.rows[row], column.path)) || this.unitOf(column));
  }

  private unitOf({ field }: Column): string {
    const known = this.units.get(field);
    if (known !== undefined) return known;
    const unit = commonUnit(
      this.all.filter((each) => each.field === field && each.node.is === "quantity"),
      this.rows,
    );
    this.units.set(field, unit);
    return unit;
  }

  private write(writes: readonly Write[]): Change | null {
    return writeCells(this.ctx.data(), this.sheet, this.positions, writes);
  }

  private isUsed(column: Column): boolean {
    return this.rows.some((row) => cellText(this.ctx.schema, column, row) !== "");
  }
}

/** Return the issues of a list by all paths that lead to them, from the item on. */
function indexIssues(issues: readonly Issue[], list: string): Map<string, Issue[]> {
  const index = new Map<string, Issue[]>();
  for (const issue of issues) {
    if (issue.path[0] !== list) continue;
    for (let length = 2; length <= issue.path.length; length += 1) {
      const key = pathKey(issue.path.slice(0, length));
      index.set(key, [...(index.get(key) ?? []), issue]);
    }
  }
  return index;
}

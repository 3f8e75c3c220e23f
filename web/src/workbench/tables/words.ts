// What the line below a table says. No elements here.
import { counted, say, together } from "../../viewer/shared/language";
import { issueCount, issueLine } from "../model/issues";
import type { OpenTable, Paste } from "./open-table";
import type { Cell } from "./selection";

const NO_ROWS = "No rows yet. Paste rows, preferably with headers such as “x [m]”, or type in the last row.";

/** Return what is wrong with a cell, else with its row, else with the table; empty if nothing is. */
export function issueText(open: OpenTable, cell: Cell): string {
  return open.issuesAt(cell).join(" ") || open.issuesOf(cell.row).map(issueLine).join("; ") || firstIssue(open);
}

/** Return how many issues a table has, and where the first is; empty if there is none. */
export function firstIssue(open: OpenTable): string {
  const total = open.issueTotal;
  if (total === 0) return "";
  const values = { issues: issueCount(total), row: open.numberOf(open.firstFaulty) };
  return say(total > 1 ? "{issues}, the first in row {row}." : "{issues} in row {row}.", values);
}

/** Return how many rows a table has. */
export function countText({ rows }: OpenTable): string {
  return rows.length === 0 ? NO_ROWS : countRows(rows.length);
}

/** Return what a paste did to a table that had so many rows before it, and has so many now. */
export function pasteText({ block, left }: Paste, before: number, now: number): string {
  const changed = Math.max(0, Math.min(block.bottom + 1, before) - block.top);
  const added = now - before;
  const parts = [
    changed > 0 ? say("{rows} changed", { rows: countRows(changed) }) : "",
    added > 0 ? say("{rows} added", { rows: countRows(added) }) : "",
  ];
  const done = say("{done}.", { done: together(parts, ", ") || "Nothing pasted" });
  return together([done, left.length > 0 ? say("Skipped: {cells}.", { cells: left.join(", ") }) : ""]);
}

function countRows(count: number): string {
  return counted(count, "{count} row", "{count} rows");
}

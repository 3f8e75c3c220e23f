// What the line below a table says. No elements here.
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
  return `${issueCount(total)}${total > 1 ? ", the first" : ""} in row ${open.numberOf(open.firstFaulty)}.`;
}

/** Return how many rows a table has. */
export function countText({ rows }: OpenTable): string {
  return rows.length === 0 ? NO_ROWS : countRows(rows.length);
}

/** Return what a paste did to a table that had so many rows before it, and has so many now. */
export function pasteText({ block, left }: Paste, before: number, now: number): string {
  const changed = Math.max(0, Math.min(block.bottom + 1, before) - block.top);
  const added = now - before;
  const done = [changed > 0 ? `${countRows(changed)} changed` : "", added > 0 ? `${countRows(added)} added` : ""];
  const rest = left.length > 0 ? ` Skipped: ${left.join(", ")}.` : "";
  return `${done.filter(Boolean).join(", ") || "Nothing pasted"}.${rest}`;
}

function countRows(count: number): string {
  return `${count} ${count === 1 ? "row" : "rows"}`;
}

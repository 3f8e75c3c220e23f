// The keys of a table.
import { type Block, moveBlock, nextCell, stepOfKey } from "./selection";

/** What keys act on, and what they do. */
export interface KeyTarget {
  readonly block: Block;
  readonly rows: number;
  readonly columns: number;
  /** How many rows are in view. */
  readonly page: number;
  choose(block: Block): void;
  /** Edit the active cell; `typing`: what is typed replaces its value. */
  edit(typing: boolean): void;
  empty(): void;
  add(): void;
  duplicate(): void;
  remove(): void;
}

/** Return what handles the keys of a table: whether a key means something here. After Escape, Tab leaves the table. */
export function keyHandler(target: () => KeyTarget): (event: KeyboardEvent) => boolean {
  let leaves = false;
  return (event) => {
    const isTab = event.key === "Tab";
    if (isTab && leaves) return false;
    if (event.key !== "Shift") leaves = event.key === "Escape";
    if (isTab) return tab(target(), event.shiftKey ? -1 : 1);
    return event.ctrlKey || event.metaKey ? command(target(), event) : plain(target(), event);
  };
}

/** Go to the next cell; from the last one and the first one Tab leaves the table. */
function tab(target: KeyTarget, by: 1 | -1): boolean {
  const next = nextCell(target.block.active, by, target.rows, target.columns);
  if (next) target.choose({ anchor: next, active: next });
  return next !== null;
}

function command(target: KeyTarget, event: KeyboardEvent): boolean {
  const { rows, columns } = target;
  switch (event.key.toLowerCase()) {
    case "a":
      target.choose({ anchor: { row: 0, column: 0 }, active: { row: Math.max(0, rows - 2), column: columns - 1 } });
      return true;
    case "d":
      target.duplicate();
      return true;
    case "-":
    case "_":
      target.remove();
      return true;
    case "+":
    case "=":
      target.add();
      return true;
    default:
      return move(target, event, true);
  }
}

function plain(target: KeyTarget, event: KeyboardEvent): boolean {
  switch (event.key) {
    case "Enter":
    case "F2":
      target.edit(false);
      return true;
    case "Delete":
    case "Backspace":
      target.empty();
      return true;
    case " ":
      if (!event.shiftKey) break;
      return chooseRows(target);
  }
  // "?" lists the keys, here as elsewhere
  if (event.key.length === 1 && event.key !== "?" && !event.altKey) {
    target.edit(true);
    return false; // the key itself goes into the field
  }
  return move(target, event, false);
}

/** Choose the entire rows of the block. */
function chooseRows(target: KeyTarget): boolean {
  const { anchor, active } = target.block;
  target.choose({ anchor: { row: anchor.row, column: 0 }, active: { row: active.row, column: target.columns - 1 } });
  return true;
}

function move(target: KeyTarget, event: KeyboardEvent, far: boolean): boolean {
  const step = stepOfKey(event.key, far, target.page, target.rows, target.columns);
  if (!step || event.altKey) return false;
  target.choose(moveBlock(target.block, step[0], step[1], event.shiftKey));
  return true;
}

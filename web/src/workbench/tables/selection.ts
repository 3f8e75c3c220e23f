// The block of cells that is selected, and how keys move it.
export interface Cell {
  readonly row: number;
  readonly column: number;
}

/** From where to where; `active` is the cell that keys act on. */
export interface Block {
  readonly anchor: Cell;
  readonly active: Cell;
}

export interface Bounds {
  readonly top: number;
  readonly bottom: number;
  readonly left: number;
  readonly right: number;
}

export function boundsOfBlock({ anchor, active }: Block): Bounds {
  return {
    top: Math.min(anchor.row, active.row),
    bottom: Math.max(anchor.row, active.row),
    left: Math.min(anchor.column, active.column),
    right: Math.max(anchor.column, active.column),
  };
}

/** Return the block of one cell. */
export function blockAt(row: number, column: number): Block {
  return { anchor: { row, column }, active: { row, column } };
}

/** Return a block within a table of so many rows and columns. */
export function clampBlock({ anchor, active }: Block, rows: number, columns: number): Block {
  const clamp = ({ row, column }: Cell): Cell => ({
    row: Math.max(0, Math.min(row, rows - 1)),
    column: Math.max(0, Math.min(column, columns - 1)),
  });
  return { anchor: clamp(anchor), active: clamp(active) };
}

/** Return a block moved by so many rows and columns; one that is extended keeps its anchor. */
export function moveBlock({ anchor, active }: Block, rows: number, columns: number, extend: boolean): Block {
  const moved = { row: active.row + rows, column: active.column + columns };
  return { anchor: extend ? anchor : moved, active: moved };
}

/** Return the next cell in reading order, null beyond the last one and before the first. */
export function nextCell({ row, column }: Cell, by: 1 | -1, rows: number, columns: number): Cell | null {
  const at = row * columns + column + by;
  return at < 0 || at >= rows * columns ? null : { row: Math.floor(at / columns), column: at % columns };
}

/** How far the keys move: rows and columns; Home and End to the ends of the row, with Ctrl also of the table. */
export function stepOfKey(
  key: string,
  command: boolean,
  page: number,
  rows: number,
  columns: number,
): readonly [number, number] | null {
  const far = command ? [rows, columns] : [1, 1];
  switch (key) {
    case "ArrowUp":
      return [-far[0]!, 0];
    case "ArrowDown":
      return [far[0]!, 0];
    case "ArrowLeft":
      return [0, -far[1]!];
    case "ArrowRight":
      return [0, far[1]!];
    case "PageUp":
      return [-page, 0];
    case "PageDown":
      return [page, 0];
    case "Home":
      return [command ? -rows : 0, -columns];
    case "End":
      return [command ? rows : 0, columns];
    default:
      return null;
  }
}

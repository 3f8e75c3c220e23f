// Tables of which only the rows in view are in the page: which these are, and the space that stands for the others.
import { h } from "../../viewer/shared/dom";

export interface RowBox {
  /** What scrolls. */
  readonly scroller: HTMLElement;
  /** The table's head, which stays in view. */
  readonly head: HTMLElement;
  /** The height of a row [px], as the style sheet has it. */
  readonly height: number;
  /** How many rows beyond the view are in the page, too. */
  readonly margin: number;
}

/** Return the first of the rows to have in the page and the one after the last; it moves in steps as the table scrolls. */
export function rangeInView({ scroller, height, margin }: RowBox, count: number): [first: number, last: number] {
  const step = margin / 2; // a row that is pressed is still there when it is let go, but after a step
  const first = Math.max(0, (Math.floor(scroller.scrollTop / height / step) - 2) * step);
  return [first, Math.min(count, first + Math.ceil(scroller.clientHeight / height) + 2 * margin)];
}

/** Return the rows of a table in view between spaces for those above and below; `make` makes a row. */
export function rowsInView(box: RowBox, count: number, make: (row: number) => HTMLElement): (HTMLElement | null)[] {
  const [first, last] = rangeInView(box, count);
  const space = (rows: number) =>
    rows > 0 ? h("tr", { class: "space", style: `height:${rows * box.height}px`, "aria-hidden": "true" }) : null;
  const rows = Array.from({ length: Math.max(0, last - first) }, (_, n) => make(first + n));
  return [space(first), ...rows, space(count - last)];
}

/** Scroll as little as brings a row into view. */
export function revealRow({ scroller, head, height }: RowBox, row: number): void {
  const top = row * height;
  const room = scroller.clientHeight - head.offsetHeight - height;
  scroller.scrollTop = Math.max(top - room, Math.min(scroller.scrollTop, top));
}

/** Return the letters that a head needs, broken between words into two lines. */
export function headWidth(text: string): number {
  return Math.max(...text.split(" ").map(({ length }) => length), text.length / 2);
}

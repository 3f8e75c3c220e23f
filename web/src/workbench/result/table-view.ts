// A table of results: only the rows in view are in the page; sorted, filtered, copied.

import { button, fill, h, setRead, setText } from "../../viewer/shared/dom";
import { counted, say, verbatim } from "../../viewer/shared/language";
import { plainSymbols, symbolElement } from "../../viewer/shared/symbols";
import type { ResultTable, TableCell, TableHead } from "../client/api";
import { type RowBox, rangeInView, revealRow, rowsInView } from "../controls/virtual-rows";
import {
  arrangeRows,
  columnWidths,
  type Sorting,
  shownText,
  type Target,
  targetOf,
  toTabSeparated,
} from "./table-rows";
import "./table-view.css";

const ROW_HEIGHT = 22; // px, as in table-view.css

export class TableView {
  readonly element: HTMLElement;
  private readonly filter = h("input", { type: "text", placeholder: "Filter rows", "aria-label": "Filter rows" });
  private readonly count = h("span", { class: "table-count", role: "status" });
  private readonly body = h("tbody", {});
  private readonly head = h("thead", {});
  private readonly columns = h("colgroup", {});
  private readonly grid: HTMLTableElement;
  private readonly scroller: HTMLElement;
  private readonly box: RowBox;
  private readonly ofRows: readonly HTMLElement[];
  private readonly notes = h("div", { class: "table-notes" });
  private table: ResultTable | null = null;
  private order: number[] = [];
  private sorting: Sorting | null = null;
  private chosen: [first: number, last: number] | null = null; // positions in the order
  private column = 0;
  private drawn = ""; // the range of the rows in the page

  /** `choice`: what stands before the filter; `onTarget` is called with what a clicked cell leads to. */
  constructor(
    choice: HTMLElement,
    private readonly onTarget: (target: Target) => void,
  ) {
    const copy = button("Copy table", "Copy the visible rows for pasting into a spreadsheet", () =>
      this.copy(this.order),
    );
    copy.classList.add("small");
    this.grid = h("table", { class: "result-table" }, this.columns, this.head, this.body);
    this.scroller = h("div", { class: "table-scroller", tabindex: 0, role: "group" }, this.grid, this.notes);
    this.box = { scroller: this.scroller, head: this.head, height: ROW_HEIGHT, margin: 12 };
    this.ofRows = [this.filter, this.count, copy, this.scroller];
    this.element = h(
      "div",
      { class: "table-view" },
      h("div", { class: "table-bar" }, choice, this.filter, this.count, copy),
      this.scroller,
    );
    this.filter.addEventListener("input", () => this.arrange());
    this.scroller.addEventListener("scroll", () => this.follow());
    this.scroller.addEventListener("keydown", (event) => this.handleKey(event));
    this.body.addEventListener("click", (event) => this.click(event));
    new ResizeObserver(() => this.follow()).observe(this.scroller);
  }

  /** Hide what belongs to one table, while another one is being made. */
  hideRows(hidden: boolean): void {
    for (const part of this.ofRows) part.hidden = hidden;
  }

  /** Show a table; of another name it is neither sorted nor filtered at first. */
  show(table: ResultTable): void {
    if (table.name !== this.table?.name) {
      this.sorting = null;
      this.filter.value = "";
      this.scroller.scrollTop = 0;
    }
    this.table = table;
    setRead(this.scroller, "aria-label", verbatim(table.title));
    const widths = columnWidths(table);
    fill(this.columns, ...widths.map((width) => h("col", { style: `width:${width}ch` })));
    this.grid.style.width = `${widths.reduce((sum, width) => sum + width, 0)}ch`;
    this.grid.setAttribute("aria-rowcount", String(table.rows.length + 1));
    fill(this.notes, ...table.notes.map((note) => h("p", {}, verbatim(plainSymbols(note)))));
    this.arrange();
  }

  private arrange(): void {
    const { table, sorting } = this;
    if (!table) return;
    this.order = arrangeRows(table, this.filter.value, sorting);
    this.chosen = null;
    const [all, some] = [table.rows.length, this.order.length];
    setText(
      this.count,
      some === all ? counted(all, "{count} row", "{count} rows") : say("{some} of {all} rows", { some, all }),
    );
    fill(this.head, h("tr", {}, ...table.heads.map((head, n) => this.makeHead(head, n))));
    this.draw();
  }

  private makeHead(head: TableHead, n: number): HTMLElement {
    const { sorting } = this;
    const direction = sorting?.column !== n ? "none" : sorting.descending ? "descending" : "ascending";
    const label = button("", "Sort by this column", () => this.sortBy(n), "link");
    const symbol = head.symbol ? [" ", symbolElement(head.symbol)] : [];
    const unit = head.unit ? [" ", h("span", { class: "unit" }, `[${head.unit}]`)] : [];
    label.append(plainSymbols(head.text), ...symbol, ...unit);
    const arrow = direction === "none" ? null : h("span", { class: "sorted" }, direction === "ascending" ? " ▴" : " ▾");
    return h("th", { scope: "col", "aria-sort": direction, class: head.number ? "number" : null }, label, arrow);
  }

  /** Sort by a column: upwards, downwards, then as the table came. */
  private sortBy(column: number): void {
    const { sorting } = this;
    if (sorting?.column !== column) this.sorting = { column, descending: false };
    else this.sorting = sorting.descending ? null : { column, descending: true };
    this.arrange();
    this.head.querySelectorAll("button")[column]?.focus();
  }

  /** Put the rows in view into the page, and space for the others above and below them. */
  private draw(): void {
    const { table, order } = this;
    if (table) fill(this.body, ...rowsInView(this.box, order.length, (n) => this.makeRow(table, order[n]!, n)));
    this.drawn = String(rangeInView(this.box, order.length));
  }

  /** Draw again where other rows have come into view; else the rows stay, or a click that has begun on one gets lost. */
  private follow(): void {
    if (String(rangeInView(this.box, this.order.length)) !== this.drawn) this.draw();
  }

  private makeRow({ rows, heads }: ResultTable, position: number, place: number): HTMLElement {
    const { chosen } = this;
    const isChosen = chosen !== null && place >= Math.min(...chosen) && place <= Math.max(...chosen);
    const attributes = { "data-place": place, "aria-rowindex": place + 2, "aria-selected": isChosen };
    const cells = (rows[position] ?? []).map((cell, n) => makeCell(cell, heads[n]));
    return h("tr", { ...attributes, "aria-selected": isChosen ? "true" : "false" }, ...cells);
  }

  private click(event: MouseEvent): void {
    const cell = event.target instanceof Element ? event.target.closest("td") : null;
    const place = Number(cell?.parentElement?.dataset.place ?? Number.NaN);
    if (!cell || Number.isNaN(place)) return;
    this.column = cell.cellIndex;
    this.choose(place, event.shiftKey);
  }

  private choose(place: number, extends_: boolean): void {
    const { table, order } = this;
    const position = order[place];
    if (!table || position === undefined) return;
    this.chosen = [extends_ && this.chosen ? this.chosen[0] : place, place];
    this.draw();
    if (!extends_) this.onTarget(targetOf(table, position, this.column));
  }

  private handleKey(event: KeyboardEvent): void {
    const { chosen, order } = this;
    const step = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "c" && chosen) {
      if (String(getSelection() ?? "")) return; // a text that was marked
      event.preventDefault();
      this.copy(order.slice(Math.min(...chosen), Math.max(...chosen) + 1));
    } else if (step !== 0) {
      event.preventDefault();
      const next = Math.min(Math.max((chosen?.[1] ?? -1) + step, 0), order.length - 1);
      revealRow(this.box, next);
      this.choose(next, event.shiftKey);
    }
  }

  private copy(positions: readonly number[]): void {
    if (!this.table) return;
    const text = toTabSeparated(this.table, positions);
    const { length } = positions;
    const said = (words: string) => () => setText(this.count, words);
    const done = said(counted(length, "{count} row copied", "{count} rows copied"));
    navigator.clipboard.writeText(text).then(done, said("The browser blocked copying."));
  }
}

function makeCell(cell: TableCell, head: TableHead | undefined): HTMLElement {
  const [text, under, kind] = typeof cell === "string" ? [cell, "", ""] : cell;
  const ours = kind === "words" || kind === "symbol";
  const shown = verbatim(ours ? plainSymbols(text) : shownText(cell, head));
  const names = [head?.number ? "number" : "", kind === "good" || kind === "bad" ? kind : ""].filter(Boolean).join(" ");
  const more = under ? h("small", {}, verbatim(` ${under}`)) : null;
  return h("td", { class: names || null, title: text.length > 24 ? shown : null }, shown, more);
}

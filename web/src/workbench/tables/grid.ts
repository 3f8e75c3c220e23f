// A table as a grid: only the rows in view are in the page.
import { fill, h, setRead } from "../../viewer/shared/dom";
import { verbatim } from "../../viewer/shared/language";
import { symbolElement } from "../../viewer/shared/symbols";
import { headWidth, type RowBox, revealRow, rowsInView } from "../controls/virtual-rows";
import { defaultText, hintOf } from "../form/labels";
import type { Path } from "../model/paths";
import { type Column, headText, isEditable } from "./columns";
import type { OpenTable } from "./open-table";
import { type Block, blockAt, boundsOfBlock, type Cell, clampBlock } from "./selection";

const ROW_HEIGHT = 25; // px, as in tables.css
const WIDEST = 28; // letters of a column

/** What shows the rows; `onChoose` is called when another block is chosen here. */
export class Grid {
  readonly element: HTMLElement;
  readonly table: HTMLTableElement;
  /** What lies over the cells, such as the field that edits one. */
  readonly layer: HTMLElement;
  block: Block = blockAt(0, 0);
  private readonly columns = h("colgroup", {});
  private readonly head = h("thead", {});
  private readonly body = h("tbody", {});
  private readonly box: RowBox;
  private open: OpenTable | null = null;

  constructor(
    private readonly isSelected: (path: Path) => boolean,
    private readonly onChoose: () => void,
    private readonly onDoubleClick: () => void,
  ) {
    this.table = h(
      "table",
      { class: "sheet", role: "grid", tabindex: 0, "aria-multiselectable": "true" },
      this.columns,
      this.head,
      this.body,
    );
    this.layer = h("div", { class: "sheet-layer" }, this.table);
    this.element = h("div", { class: "sheet-box" }, this.layer);
    this.box = { scroller: this.element, head: this.head, height: ROW_HEIGHT, margin: 10 };
    this.element.addEventListener("scroll", () => this.draw());
    this.body.addEventListener("mousedown", (event) => this.press(event));
    this.head.addEventListener("mousedown", (event) => this.pressHead(event));
    this.element.addEventListener("click", ({ target }) => {
      if (target === this.element || target === this.layer) this.table.focus({ preventScroll: true });
    });
    new ResizeObserver(() => this.draw()).observe(this.element);
  }

  /** Show a table; the block stays where it is. */
  show(open: OpenTable): void {
    const isOther = open.sheet.id !== this.open?.sheet.id;
    this.open = open;
    if (isOther) {
      this.block = blockAt(0, 0);
      this.element.scrollTo(0, 0);
    }
    this.block = clampBlock(this.block, this.rowCount, open.columns.length);
    setRead(this.table, "aria-label", open.sheet.title);
    this.table.setAttribute("aria-rowcount", String(this.rowCount + 1));
    this.table.setAttribute("aria-colcount", String(open.columns.length + 1));
    const widths = [5, ...open.columns.map((column, n) => widthOf(open, column, n))];
    fill(this.columns, ...widths.map((width) => h("col", { style: `width:${width}ch` })));
    this.table.style.width = `${widths.reduce((sum, width) => sum + width, 0)}ch`;
    const corner = h("th", { scope: "col", class: "number-of", title: "Select all rows" }, "#");
    fill(this.head, h("tr", { "aria-rowindex": 1 }, corner, ...open.columns.map(makeHead)));
    this.draw();
  }

  /** The number of rows, with the empty one below the last. */
  get rowCount(): number {
    return (this.open?.rows.length ?? 0) + 1;
  }

  /** Choose a block, and bring its active cell into view unless the view is to stay. */
  choose(block: Block, stays = false): void {
    this.block = clampBlock(block, this.rowCount, this.open?.columns.length ?? 1);
    if (!stays) this.reveal(this.block.active);
    this.onChoose();
    this.draw();
  }

  /** Return the element of a cell, null where it is out of view. */
  cellAt({ row, column }: Cell): HTMLTableCellElement | null {
    return this.body.querySelector<HTMLTableRowElement>(`[data-row="${row}"]`)?.cells[column + 1] ?? null;
  }

  /** How many rows are in view. */
  get page(): number {
    return Math.max(1, Math.floor((this.element.clientHeight - this.head.offsetHeight) / ROW_HEIGHT) - 1);
  }

  /** Bring a cell into view. */
  reveal({ row, column }: Cell): void {
    const { element, head } = this;
    revealRow(this.box, row);
    const [first, over] = [head.querySelector("th"), head.querySelectorAll("th")[column + 1]];
    if (!first || !over) return;
    const left = over.offsetLeft - first.offsetWidth;
    const right = over.offsetLeft + over.offsetWidth - element.clientWidth;
    element.scrollLeft = Math.max(right, Math.min(element.scrollLeft, left));
  }

  /** Put the rows in view into the page, and space for the others above and below them. */
  draw(): void {
    const { open, element } = this;
    if (!open || element.closest("[hidden]")) return;
    fill(this.body, ...rowsInView(this.box, this.rowCount, (row) => this.makeRow(open, row)));
    const active = this.cellAt(this.block.active);
    if (active) this.table.setAttribute("aria-activedescendant", active.id);
    else this.table.removeAttribute("aria-activedescendant");
  }

  private makeRow(open: OpenTable, row: number): HTMLElement {
    const path = open.pathOf(row);
    const issues = open.issuesOf(row).length;
    const selected = path !== null && this.isSelected(path);
    const names = [path ? "" : "new", selected ? "selected" : "", issues > 0 ? "faulty" : ""];
    const title = path ? null : "Type or paste here to add rows";
    const number = h("th", { scope: "row", class: "number-of", title }, path ? String(open.numberOf(row)) : "+");
    const cells = open.columns.map((column, n) => this.makeCell(open, column, { row, column: n }));
    const attributes = { "data-row": row, "aria-rowindex": row + 2, class: names.filter(Boolean).join(" ") || null };
    return h("tr", { ...attributes, "aria-selected": selected ? "true" : "false" }, number, ...cells);
  }

  private makeCell(open: OpenTable, column: Column, cell: Cell): HTMLElement {
    const { top, bottom, left, right } = boundsOfBlock(this.block);
    const { active } = this.block;
    const inBlock = cell.row >= top && cell.row <= bottom && cell.column >= left && cell.column <= right;
    const isActive = cell.row === active.row && cell.column === active.column;
    const text = open.textAt(cell);
    const issues = open.issuesAt(cell);
    const idle = open.whyIdle(cell);
    const standard = text === "" && !idle && open.pathOf(cell.row) ? defaultText(column.field.default) : "";
    const isNumber = ["quantity", "number", "integer"].includes(column.node.is);
    const names = [
      inBlock ? "chosen" : "",
      isActive ? "active" : "",
      issues.length > 0 ? "faulty" : "",
      isNumber ? "number" : "",
      idle ? "idle" : isEditable(column) ? "" : "fixed",
    ];
    return h(
      "td",
      {
        id: `cell-${cell.row}-${cell.column}`,
        class: names.filter(Boolean).join(" ") || null,
        title: issues.join(" ") || idle || (text.length > WIDEST ? verbatim(text) : null),
        "aria-selected": inBlock ? "true" : "false",
        "aria-invalid": issues.length > 0 ? "true" : null,
        "aria-readonly": isEditable(column) && !idle ? null : "true",
      },
      text ? verbatim(text) : standard && h("span", { class: "standard" }, verbatim(standard)),
    );
  }

  /** Choose what is pressed and dragged over: cells, or entire rows by their numbers. */
  private press(event: MouseEvent): void {
    const start = this.find(event);
    if (!start || event.button !== 0) return;
    event.preventDefault(); // no text is marked
    this.table.focus({ preventScroll: true });
    const isRow = start.column < 0;
    this.extend(start, isRow, event.shiftKey);
    // the cells were drawn again, so that the event of a double click would get lost
    if (event.detail === 2 && !isRow) return this.onDoubleClick();
    const drag = (moved: MouseEvent) => {
      const to = this.find(moved);
      const { active } = this.block;
      if (to && (to.row !== active.row || (!isRow && to.column !== active.column))) this.extend(to, isRow, true);
    };
    this.body.addEventListener("mouseover", drag);
    addEventListener("mouseup", () => this.body.removeEventListener("mouseover", drag), { once: true });
  }

  /** Choose a column by its head, all of them by the corner. */
  private pressHead(event: MouseEvent): void {
    const head = event.target instanceof Element ? event.target.closest("th") : null;
    if (!head || event.button !== 0) return;
    event.preventDefault();
    this.table.focus({ preventScroll: true });
    const bottom = Math.max(0, this.rowCount - 2);
    const column = Math.max(0, head.cellIndex - 1);
    const end = head.cellIndex === 0 ? (this.open?.columns.length ?? 1) - 1 : column;
    this.choose({ anchor: { row: bottom, column: end }, active: { row: 0, column } }, true);
  }

  /** Choose the block up to a cell, or the rows up to its own. */
  private extend(to: Cell, isRow: boolean, keepsAnchor: boolean): void {
    const { anchor } = this.block;
    const last = (this.open?.columns.length ?? 1) - 1;
    const active = { row: to.row, column: isRow ? last : Math.max(0, to.column) };
    const first = isRow ? { row: to.row, column: 0 } : active;
    this.choose({ anchor: keepsAnchor ? { ...anchor, ...(isRow ? { column: 0 } : {}) } : first, active });
  }

  /** Return the cell below the pointer, null if there is none; its column is -1 for a row's number. */
  private find(event: Event): Cell | null {
    const cell = event.target instanceof Element ? event.target.closest<HTMLTableCellElement>("td, th") : null;
    const row = cell?.parentElement?.dataset.row;
    return cell && row !== undefined ? { row: Number(row), column: cell.cellIndex - 1 } : null;
  }
}

function makeHead(column: Column): HTMLElement {
  const symbol = column.symbol ? symbolElement(column.symbol) : null;
  const parts = [column.words, column.words && symbol ? " " : "", symbol];
  return h("th", { scope: "col", class: column.needed ? "needed" : null, title: hintOf(column.field) }, ...parts);
}

/** Return the width of a column in letters, from all rows, so that none that comes into view later changes it. */
function widthOf(open: OpenTable, column: Column, n: number): number {
  const longest = Math.max(headWidth(headText(column)), 6);
  const widest = open.rows.reduce((most, _, row) => Math.max(most, open.textAt({ row, column: n }).length), longest);
  return Math.min(widest, WIDEST) + 3;
}

// Lists of the model as tables, edited as in a spreadsheet.

import { allow, button, fill, h, newId, setText } from "../../viewer/shared/dom";
import { counted, keep, say, together, translate } from "../../viewer/shared/language";
import type { Store } from "../client/store";
import type { FormContext } from "../form/context";
import { newItem } from "../form/lists/list";
import { joinEdits } from "../model/changes/batches";
import { removeItems } from "../model/changes/references";
import type { Change } from "../model/edits";
import type { Path } from "../model/paths";
import { type After, cellEditor, optionsFor } from "./cell-editor";
import { duplicateRows, emptyCells } from "./changes";
import { isEditable, nameOf } from "./columns";
import { Grid } from "./grid";
import { type KeyTarget, keyHandler } from "./keys";
import { OpenTable } from "./open-table";
import { blockAt, boundsOfBlock, moveBlock, nextCell } from "./selection";
import { positionsIn, type Sheet, sheetAt, sheetsOf } from "./sheets";
import { countText, firstIssue, issueText, pasteText } from "./words";
import "./tables.css";

export class TablesPanel {
  readonly element: HTMLElement;
  private readonly sheets: readonly Sheet[];
  private readonly choice = h("select", { "aria-label": "table" });
  private readonly allColumns = button("All columns", "Also show columns that no row uses", () => this.toggleColumns());
  /** The buttons that need rows. */
  private readonly ofRows = [
    button("Duplicate", "Duplicate the selected rows (Ctrl+D)", () => this.duplicate()),
    button("Remove", "Remove the selected rows (Ctrl and -)", () => this.remove()),
    button("Copy table", "Copy all rows with headers for pasting into a spreadsheet", () => this.copyTable()),
  ];
  private readonly status = h("p", { class: "sheet-status", role: "status" });
  private readonly grid: Grid;
  private sheet: Sheet;
  private open: OpenTable;
  private editor: HTMLInputElement | null = null;
  private said = ""; // what the last action has to tell
  private isChoosing = false;

  constructor(
    private readonly store: Store,
    private readonly ctx: FormContext,
  ) {
    this.sheets = sheetsOf(ctx.schema);
    this.sheet = this.sheets[0]!;
    this.open = new OpenTable(ctx, this.sheet, false);
    this.grid = new Grid(
      (path) => store.isSelected(path),
      () => this.selectItems(),
      () => this.edit(false),
    );
    const way = h("p", { class: "unseen", id: newId("hint") }, "Press Escape, then Tab to leave the table.");
    this.grid.table.setAttribute("aria-describedby", way.id);
    this.element = h("div", { class: "tables" }, this.makeBar(), this.grid.element, this.status, way);
    this.choice.addEventListener("change", () => this.choose(this.choice.value));
    this.listen();
    store.on(["selection"], () => this.followSelection());
  }

  /** Make the choice of the table, and the buttons that change its rows. */
  private makeBar(): HTMLElement {
    this.allColumns.setAttribute("aria-pressed", "false");
    const [duplicate, remove, copy] = this.ofRows;
    const buttons = [
      button("Add row", "Add a row with default values (Ctrl and +)", () => this.add()),
      duplicate!,
      remove!,
      this.allColumns,
      copy!,
    ];
    for (const one of buttons) one.classList.add("small");
    return h("div", { class: "sheet-bar", role: "toolbar", "aria-label": "rows" }, this.choice, ...buttons);
  }

  /** Show the present data, if the panel is visible. */
  update(): void {
    if (this.element.closest("[hidden]")) return;
    this.open = new OpenTable(this.ctx, this.sheet, this.showsAll);
    allow(this.allColumns, this.open.hasHidden ? "" : "All columns are shown.");
    const why = this.open.positions.length === 0 ? "The table has no rows." : "";
    for (const each of this.ofRows) allow(each, why);
    this.fillChoice();
    this.grid.show(this.open);
    this.tell();
  }

  /** Show the table of the item that is selected, else the one before. */
  show(): void {
    const [first] = this.store.selected;
    this.sheet = (first && sheetAt(this.sheets, this.ctx.data(), first)) ?? this.sheet;
    this.update();
    this.followSelection();
  }

  /** Go to the cell of a path; returns whether it can be edited here. */
  reveal(path: Path): boolean {
    const sheet = sheetAt(this.sheets, this.ctx.data(), path);
    if (!sheet) return false;
    const open = new OpenTable(this.ctx, sheet, this.showsAll);
    const inner = path.slice(2);
    const fits = (length: number) =>
      open.columns.findIndex((column) => column.path.slice(0, length).join() === inner.slice(0, length).join());
    const column = inner.length > 0 ? Math.max(fits(inner.length), fits(1)) : 0;
    if (column < 0 || !isEditable(open.columns[column]!)) return false;
    this.sheet = sheet;
    this.update();
    this.grid.table.focus();
    this.grid.choose(blockAt(open.positions.indexOf(Number(path[1])), column));
    return true;
  }

  private get showsAll(): boolean {
    return this.allColumns.getAttribute("aria-pressed") === "true";
  }

  private listen(): void {
    const { table } = this.grid;
    const target = (): KeyTarget => ({
      block: this.grid.block,
      rows: this.grid.rowCount,
      columns: this.open.columns.length,
      page: this.grid.page,
      choose: (block) => this.grid.choose(block),
      edit: (typing) => this.edit(typing),
      empty: () => this.empty(),
      add: () => this.add(),
      duplicate: () => this.duplicate(),
      remove: () => this.remove(),
    });
    const handle = keyHandler(target);
    table.addEventListener("keydown", (event) => {
      if (handle(event)) event.preventDefault();
    });
    // browsers send these to where text is marked, wherever the focus is
    for (const type of ["copy", "cut", "paste"] as const)
      document.addEventListener(type, (event) => this.exchange(event));
  }

  /** Copy, cut and paste while the table or one of its buttons has the focus, and no cell is edited. */
  private exchange(event: ClipboardEvent): void {
    const { clipboardData: clipboard, type } = event;
    if (!this.element.contains(document.activeElement) || this.editor || !clipboard) return;
    event.preventDefault();
    if (type === "paste") return this.paste(clipboard.getData("text/plain"));
    clipboard.setData("text/plain", this.open.copy(boundsOfBlock(this.grid.block)));
    if (type === "cut") this.empty();
  }

  private fillChoice(): void {
    const makeOption = (sheet: Sheet) => {
      const count = positionsIn(this.ctx.data(), sheet).length;
      return h("option", { value: sheet.id }, count > 0 ? keep(`${translate(sheet.title)} (${count})`) : sheet.title);
    };
    const groups = [...new Set(this.sheets.map(({ group }) => group))].map((group) => {
      const options = this.sheets.filter((sheet) => sheet.group === group).map(makeOption);
      return options.length === 1 ? options[0] : h("optgroup", { label: group }, ...options);
    });
    fill(this.choice, ...groups);
    this.choice.value = this.sheet.id;
  }

  private choose(id: string): void {
    this.sheet = this.sheets.find((sheet) => sheet.id === id) ?? this.sheet;
    this.said = "";
    this.update();
  }

  private toggleColumns(): void {
    this.allColumns.setAttribute("aria-pressed", String(!this.showsAll));
    this.update();
  }

  /** Select the items of the chosen rows. */
  private selectItems(): void {
    this.said = "";
    this.isChoosing = true;
    this.store.selectAll(this.chosenPaths());
    this.isChoosing = false;
    this.tell();
  }

  private chosenPaths(): Path[] {
    const { top, bottom } = boundsOfBlock(this.grid.block);
    const rows = Array.from({ length: bottom - top + 1 }, (_, n) => this.open.pathOf(top + n));
    return rows.filter((path) => path !== null);
  }

  /** Go to the row of what is selected elsewhere. */
  private followSelection(): void {
    const { selection } = this.store;
    if (this.isChoosing || this.element.closest("[hidden]")) return;
    const row = selection?.[0] === this.sheet.list ? this.open.positions.indexOf(Number(selection[1])) : -1;
    if (row >= 0) {
      this.grid.block = blockAt(row, this.grid.block.active.column);
      this.grid.reveal(this.grid.block.active);
    }
    this.grid.draw();
    this.tell();
  }

  /** Say what the last action did, and what is wrong with the active cell, else with its row, else with the table. */
  private tell(): void {
    const { open, grid, said } = this;
    const problem = said ? firstIssue(open) : issueText(open, grid.block.active);
    this.status.classList.toggle("bad", problem !== "");
    setText(this.status, together([said, problem]) || countText(open));
  }

  private push(change: Change | null): void {
    if (change && !this.store.broken) this.ctx.change(change);
  }

  private edit(typing: boolean): void {
    const { active } = this.grid.block;
    const column = this.open.columns[active.column];
    this.grid.choose(blockAt(active.row, active.column));
    const cell = this.grid.cellAt(active);
    if (!column || !cell || this.editor || this.store.broken) return;
    if (!isEditable(column)) {
      this.said = say("The {field} can be edited in the plan or the form.", { field: nameOf(column) });
      return this.tell();
    }
    this.said = this.open.whyIdle(active);
    if (this.said) return this.tell();
    const item = this.open.pathOf(active.row) ?? [this.sheet.list, this.open.positions.length];
    const options = optionsFor(this.ctx.data(), column, item);
    const label = say("{field} of row {number}", { field: nameOf(column), number: this.open.numberOf(active.row) });
    const hooks = {
      commit: (text: string, after: After) => this.finish(text, after),
      close: (stays: boolean) => {
        this.editor = null;
        if (stays) this.grid.table.focus({ preventScroll: true });
      },
    };
    this.editor = cellEditor(cell, label, this.open.textAt(active), options, typing, hooks);
    this.grid.layer.append(this.editor);
    this.editor.focus({ preventScroll: true });
    if (!typing) this.editor.select();
  }

  /** Take what was typed into the active cell, and go on to another one. */
  private finish(text: string, after: After): void {
    const { block, rowCount } = this.grid;
    this.push(this.open.type(block.active, text));
    const steps = { down: [1, 0], up: [-1, 0], left: [0, -1], right: [0, 1] } as const;
    if (after === "next" || after === "previous") {
      const next = nextCell(block.active, after === "next" ? 1 : -1, rowCount + 1, this.open.columns.length);
      if (next) this.grid.choose(blockAt(next.row, next.column));
    } else if (after !== "stay") this.grid.choose(moveBlock(block, steps[after][0], steps[after][1], false));
  }

  private empty(): void {
    const { top, bottom, left, right } = boundsOfBlock(this.grid.block);
    const columns = this.open.columns.slice(left, right + 1);
    const rows = Array.from({ length: bottom - top + 1 }, (_, n) => top + n);
    const cells = rows.flatMap((row) => columns.map((column) => ({ row, column })));
    const { change, kept } = emptyCells(this.ctx.data(), this.sheet, this.open.positions, cells);
    this.push(change);
    this.said = kept > 0 ? counted(kept, "{count} required value kept.", "{count} required values kept.") : "";
    this.tell();
  }

  private add(): void {
    const { list, part, title } = this.sheet;
    const value = newItem(this.ctx.data(), [list], part);
    this.push({ edits: [{ op: "add", path: [list], value }], text: say("add a row to {items}", { items: title }) });
    this.grid.choose(blockAt(this.open.rows.length - 1, 0));
    this.grid.table.focus();
  }

  private duplicate(): void {
    const positions = this.chosenPaths().map((path) => Number(path[1]));
    if (positions.length === 0) return;
    const first = this.open.rows.length;
    this.push(duplicateRows(this.ctx.data(), this.sheet, positions));
    const { left, right } = boundsOfBlock(this.grid.block);
    this.grid.choose({
      anchor: { row: first, column: left },
      active: { row: first + positions.length - 1, column: right },
    });
  }

  private remove(): void {
    const paths = this.chosenPaths();
    if (paths.length === 0) return;
    const data = this.ctx.data();
    this.push(joinEdits(data, removeItems(data, paths)));
    const { top, left } = boundsOfBlock(this.grid.block);
    this.grid.choose(blockAt(top, left));
  }

  private copyTable(): void {
    const tell = (words: string) => () => {
      this.said = words;
      this.tell();
    };
    const done = tell(say("{count} rows copied.", { count: this.open.rows.length }));
    navigator.clipboard.writeText(this.open.copyAll()).then(done, tell("The browser blocked copying."));
  }

  private paste(text: string): void {
    if (text.trim() === "" || this.store.broken) return;
    const before = this.open.rows.length;
    const paste = this.open.paste(text, boundsOfBlock(this.grid.block));
    const { block } = paste;
    this.push(paste.change);
    this.grid.choose({
      anchor: { row: block.bottom, column: block.right },
      active: { row: block.top, column: block.left },
    });
    this.said = pasteText(paste, before, this.open.rows.length);
    this.tell();
  }
}

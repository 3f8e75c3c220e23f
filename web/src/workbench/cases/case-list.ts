// The load cases as rows: name, type, group, self-weight, sums, order, and what does not act.
import { allow, button, fillOptions, h, setRead, setText } from "../../viewer/shared/dom";
import { say, translate, verbatim } from "../../viewer/shared/language";
import { symbolElement } from "../../viewer/shared/symbols";
import type { Store } from "../client/store";
import { ask } from "../controls/dialogs";
import { type FormContext, setValue } from "../form/context";
import { caseColor } from "../model/case-colors";
import {
  CASE_TYPES,
  type CaseNote,
  type CaseSums,
  combinationsOfOnly,
  hasSelfWeight,
  loadsIn,
  meaningOf,
  moveCase,
  notesOn,
  removeCase,
  retypeCase,
  setSelfWeight,
  typeOf,
} from "../model/changes/load-cases";
import { namesIn } from "../model/names";
import { listAt, type Path, type Table, tableAt } from "../model/paths";
import { duringChange, isTyping, refill } from "./refill";

const COLUMNS = 10;

/** Return a number of at most four digits that matter. */
export function shortNumber(value: number): string {
  const rounded = Math.abs(value) >= 1000 ? Math.round(value) : Number(value.toPrecision(4));
  return String(rounded === 0 ? 0 : rounded).replace("-", "\u2212");
}

/** The list of load cases; `update` shows the present data with the sums that are known. */
export class CaseList {
  private readonly body = h("tbody", {});
  private readonly head = h("thead", {});
  private readonly names = h("datalist", { id: "groups-of-cases" });
  readonly element = h(
    "div",
    { class: "case-list-box" },
    h("table", { class: "case-list", "aria-label": "load cases" }, this.head, this.body),
    this.names,
  );
  private sums: CaseSums | null = null;
  private dragged: number | null = null;
  private readonly isChanging: () => boolean;

  constructor(
    private readonly store: Store,
    private readonly ctx: FormContext,
    /** Called when an update that was put off may be due. */
    private readonly changed: () => void,
  ) {
    this.element.addEventListener("focusout", () => setTimeout(this.changed));
    this.isChanging = duringChange(this.element, this.changed);
    this.body.addEventListener("keydown", (event) => this.press(event));
  }

  update(sums: CaseSums | null): void {
    this.sums = sums;
    if (isTyping(this.element) || this.isChanging()) return;
    const { data } = this.store;
    const groups = new Set(listAt(data, ["cases"]).flatMap((_, n) => String(tableAt(data, ["cases", n]).group ?? "")));
    groups.delete("");
    refill(
      this.names,
      [...groups].map((value) => h("option", { value })),
    );
    refill(this.head, [this.makeHead()]);
    refill(
      this.body,
      listAt(data, ["cases"]).flatMap((_, n) => this.makeRows(n)),
    );
  }

  private makeHead(): HTMLElement {
    const { sums } = this;
    const about = sums?.about.map((value) => shortNumber(value)).join("; ") ?? "";
    const middle = say(
      "Moment about the middle of the plan ({about}) {unit}; forces at larger coordinates are positive",
      { about, unit: sums?.length ?? "m" },
    );
    const sum = (symbol: string, unit: string, title: string) =>
      h("th", { scope: "col", class: "number", title }, symbolElement(symbol), verbatim(unit ? ` [${unit}]` : ""));
    return h(
      "tr",
      {},
      h("th", { scope: "col" }, h("span", { class: "unseen" }, "order")),
      h("th", { scope: "col" }, "case"),
      h("th", { scope: "col" }, "type"),
      h("th", { scope: "col", title: "Variable cases of one group never act together" }, "group"),
      h("th", { scope: "col", title: "Whether the weight of the slab acts in this case" }, "self-weight"),
      h("th", { scope: "col", class: "number" }, "loads"),
      sum("F_z", sums?.force ?? "", "Sum of the vertical loads on the plates without factors, downwards positive"),
      sum("M_x", sums?.moment ?? "", middle),
      sum("M_y", sums?.moment ?? "", middle),
      h("th", { scope: "col" }, h("span", { class: "unseen" }, "remove")),
    );
  }

  private makeRows(n: number): HTMLElement[] {
    const { store, ctx } = this;
    const own = tableAt(store.data, ["cases", n]);
    const name = String(own.name ?? "");
    const notes = notesOn(store.data, n, this.sums, store.doc?.issues ?? [], store.doc?.remarks ?? []);
    const row = h(
      "tr",
      { class: noteClass(notes), "data-case": n },
      h("td", {}, this.makeHandle(n, name)),
      h("td", {}, this.makeText(["cases", n, "name"], say("name of case {number}", { number: n + 1 }), name)),
      h("td", {}, this.makeType(n, own)),
      h("td", {}, this.makeGroup(n, own)),
      h("td", { class: "middle" }, this.makeSwitch(n, name)),
      h("td", { class: "number" }, verbatim(String(loadsIn(store.data, name).length))),
      ...this.makeSums(name),
      h("td", {}, this.makeRemove(n, name)),
    );
    row.addEventListener("dragover", (event) => {
      if (this.dragged !== null) event.preventDefault();
    });
    row.addEventListener("drop", () => {
      const change = this.dragged === null ? null : moveCase(store.data, this.dragged, n);
      if (change) ctx.change(change);
    });
    return notes.length === 0 ? [row] : [row, noteRow(notes)];
  }

  private makeHandle(n: number, name: string): HTMLElement {
    const handle = h(
      "button",
      {
        type: "button",
        class: "case-handle",
        draggable: "true",
        "data-key": `handle-${n}`,
        title: "Drag, or press Alt with an arrow key, to move the case",
        "aria-label": say("move case {name}", { name: verbatim(name || String(n + 1)) }),
        style: `--case-color:${caseColor(n)}`,
      },
      h("span", { class: "swatch", "aria-hidden": "true" }),
    );
    handle.addEventListener("dragstart", () => {
      this.dragged = n;
    });
    handle.addEventListener("dragend", () => {
      this.dragged = null;
    });
    return handle;
  }

  private makeText(path: Path, label: string, value: string): HTMLInputElement {
    const input = h("input", {
      type: "text",
      "data-key": path.join("-"),
      "aria-label": label,
      value,
      spellcheck: "false",
    });
    input.addEventListener("change", () => {
      const typed = input.value.trim();
      if (typed === value) return;
      input.defaultValue = input.value;
      setValue(this.ctx, path, typed || undefined);
    });
    input.addEventListener("keydown", ({ key }) => {
      if (key === "Escape") input.value = value;
    });
    return input;
  }

  private makeType(n: number, own: Table): HTMLSelectElement {
    const type = typeOf(own);
    const title = verbatim(translate(meaningOf(type, this.store.data, this.store.doc?.factors, own)));
    const select = h("select", {
      "data-key": `type-${n}`,
      "aria-label": say("type of case {number}", { number: n + 1 }),
      title,
    });
    const known = CASE_TYPES.some(({ id }) => id === type);
    fillOptions(select, [
      ...CASE_TYPES.map(({ id, label }) => [id, label] as const),
      ...(known ? [] : [[type, verbatim(type)] as const]),
    ]);
    select.value = type;
    select.dataset.value = type; // by which rows are compared
    select.addEventListener("change", () => this.ctx.change(retypeCase(this.store.data, n, select.value)));
    return select;
  }

  private makeGroup(n: number, own: Table): HTMLInputElement {
    const input = this.makeText(
      ["cases", n, "group"],
      say("group of case {number}", { number: n + 1 }),
      String(own.group ?? ""),
    );
    input.setAttribute("list", this.names.id);
    const isVariable = (own.action ?? "permanent") === "variable";
    allow(input, isVariable || own.group ? "" : "Variable cases alone exclude each other");
    return input;
  }

  private makeSwitch(n: number, name: string): HTMLInputElement {
    const box = h("input", {
      type: "checkbox",
      "data-key": `weight-${n}`,
      "aria-label": say("self-weight in case {number}", { number: n + 1 }),
    });
    box.checked = hasSelfWeight(this.store.data, name);
    box.dataset.value = String(box.checked);
    allow(box, name === "" ? "Give the case a name first." : "");
    box.addEventListener("change", () => this.ctx.change(setSelfWeight(this.store.data, name, box.checked)));
    return box;
  }

  private makeSums(name: string): HTMLElement[] {
    const found = this.sums?.cases.find((each) => each.name === name);
    const values = found ? [found.F, found.M_x, found.M_y] : [null, null, null];
    return values.map((value) =>
      h("td", { class: "number" }, verbatim(value === null ? "\u2013" : shortNumber(value))),
    );
  }

  private makeRemove(n: number, name: string): HTMLElement {
    const remove = button("×", "Remove this load case", () => void this.remove(n, name), "icon");
    remove.dataset.key = `remove-${n}`;
    setRead(remove, "aria-label", say("remove case {name}", { name: verbatim(name || String(n + 1)) }));
    return remove;
  }

  /** Remove a case; of one with loads, or with combinations that name no other, ask what becomes of them. */
  private async remove(n: number, name: string): Promise<void> {
    const { data } = this.store;
    const count = loadsIn(data, name).length;
    const alone = combinationsOfOnly(data, name).length;
    const isLast = listAt(data, ["cases"]).length === 1;
    const others = namesIn(listAt(data, ["cases"])).filter((each) => each !== name);
    if (count === 0 && alone === 0) return this.ctx.change(removeCase(data, n, null));
    const texts = [
      ...(count > 0 ? [say("Loads in the case: {count}.", { count })] : []),
      ...(alone > 0
        ? [say("Combinations that name no other case, which are removed: {count}.", { count: alone })]
        : []),
    ];
    const keep = isLast
      ? [{ label: "Keep its loads without a case", value: "keep " }]
      : others
          .slice(0, 4)
          .map((each) => ({ label: say("Move its loads to {name}", { name: verbatim(each) }), value: `keep ${each}` }));
    const answer = await ask(
      say("Remove load case {name}?", { name: verbatim(name) }),
      texts,
      [
        ...(count > 0 ? keep : []),
        { label: count > 0 ? "Remove its loads, too" : "Remove", value: "remove" },
        { label: "Cancel", value: "", main: true },
      ],
      "",
    );
    if (answer) this.ctx.change(removeCase(this.store.data, n, answer === "remove" ? null : answer.slice(5)));
  }

  /** Move a case by Alt with an arrow key; the focus goes with it. */
  private press(event: KeyboardEvent): void {
    const step = event.key === "ArrowUp" ? -1 : event.key === "ArrowDown" ? 1 : 0;
    const row = event.target instanceof Element ? event.target.closest<HTMLElement>("[data-case]") : null;
    if (!event.altKey || step === 0 || !row) return;
    event.preventDefault();
    const n = Number(row.dataset.case);
    const change = moveCase(this.store.data, n, n + step);
    if (!change) return;
    this.ctx.change(change);
    this.body.querySelector<HTMLElement>(`[data-key="handle-${n + step}"]`)?.focus();
  }
}

/** Return the class of the gravest note, null if there is none but an invitation. */
function noteClass(notes: readonly CaseNote[]): string | null {
  const kinds = notes.map(({ kind }) => kind);
  return kinds.includes("bad") ? "flagged" : kinds.includes("remark") ? "remarked" : null;
}

function noteRow(notes: readonly CaseNote[]): HTMLElement {
  const words = notes.map(({ words, own, kind }) => {
    const line = h("p", { class: kind });
    setText(line, own ? words : verbatim(words));
    return line;
  });
  return h(
    "tr",
    { class: ["case-notes", noteClass(notes)].filter(Boolean).join(" ") },
    h("td", { colspan: COLUMNS }, ...words),
  );
}

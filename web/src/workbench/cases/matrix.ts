// Combinations as a matrix of factors: a row for each, a column for each load case; only the rows in view are in the page.
import { allow, button, fillOptions, h, setRead, setText } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import type { Store } from "../client/store";
import { type RowBox, rowsInView } from "../controls/virtual-rows";
import { type FormContext, setValue } from "../form/context";
import { partWidget } from "../form/section";
import { caseColor } from "../model/case-colors";
import {
  addCombination,
  type CaseSums,
  type Combination,
  listedCombinations,
  positionsOf,
  setExpression,
  setFactor,
} from "../model/changes/load-cases";
import { issueSentence, issuesAt } from "../model/issues";
import { namesIn } from "../model/names";
import { listAt, type Path, tableAt } from "../model/paths";
import { duringChange, isTyping, refill } from "./refill";

const ROW_HEIGHT = 27; // px, as in cases.css
const STATES = [
  "ultimate",
  "accidental",
  "seismic",
  "equilibrium",
  "uplift",
  "characteristic",
  "frequent",
  "quasi-permanent",
];
const EXPRESSIONS = [
  ["", "by hand only"],
  ["6.10", "by EN 1990, 6.10"],
  ["6.10a and 6.10b", "by EN 1990, 6.10a and 6.10b"],
  ["ACI 318", "by ACI 318 and ASCE 7"],
] as const;

/** A combination with its position in the file, null if the program makes it. */
interface Row extends Combination {
  at: number | null;
}

/** The matrix with its bar; `update` shows the present data with the combinations that are made. */
export class Matrix {
  private readonly filter = h("select", { "aria-label": "limit state shown", onchange: () => this.draw() });
  private readonly made = h("select", { "aria-label": "how combinations are made" });
  private readonly count = h("span", { class: "quiet", role: "status" });
  private readonly head = h("thead", {});
  private readonly body = h("tbody", {});
  private readonly table = h(
    "table",
    { class: "matrix", "aria-label": "factors of combinations" },
    this.head,
    this.body,
  );
  private readonly scroller = h(
    "div",
    { class: "matrix-box", tabindex: 0, role: "region", "aria-label": "combinations" },
    this.table,
  );
  private readonly rules: ReturnType<typeof partWidget>;
  private readonly rulesFold: HTMLDetailsElement;
  private readonly add: HTMLButtonElement;
  private readonly box: RowBox = { scroller: this.scroller, head: this.head, height: ROW_HEIGHT, margin: 10 };
  private sums: CaseSums | null = null;
  private rows: Row[] = [];
  private readonly isChanging: () => boolean;
  private cases: string[] = [];
  readonly element: HTMLElement;

  constructor(
    private readonly store: Store,
    private readonly ctx: FormContext,
    changed: () => void,
  ) {
    const title = "Add a combination with factors of your own";
    this.add = button("+ combination", title, () => this.addRow(), "small");
    fillOptions(this.filter, [["", "all limit states"], ...STATES.map((each) => [each, each] as const)]);
    fillOptions(this.made, EXPRESSIONS);
    this.made.addEventListener("change", () => ctx.change(setExpression(store.data, this.made.value)));
    const bar = h(
      "div",
      { class: "cases-bar" },
      h("h3", {}, "Combinations"),
      this.made,
      this.filter,
      this.add,
      this.count,
    );
    this.rules = partWidget(ctx, ["combine"], ctx.schema.nodeAt(["combine"], { combine: {} })!.node, ["expression"]);
    this.rulesFold = h("details", { class: "rules" }, h("summary", {}, "Limit states and factors"), this.rules.element);
    this.element = h("section", { class: "matrix-part" }, bar, this.rulesFold, this.scroller);
    this.scroller.addEventListener("scroll", () => this.draw());
    this.scroller.addEventListener("focusout", () => setTimeout(changed));
    this.isChanging = duringChange(this.scroller, changed);
    new ResizeObserver(() => this.draw()).observe(this.scroller);
  }

  update(sums: CaseSums | null): void {
    this.sums = sums;
    const { data } = this.store;
    const expression = tableAt(data, ["combine"]).expression ?? "6.10";
    this.made.value = "combine" in data ? String(expression) : "";
    this.cases = namesIn(listAt(data, ["cases"]));
    const why = this.cases.length === 0 ? "Add a load case first." : "";
    for (const control of [this.made, this.add]) allow(control, why);
    this.rulesFold.hidden = !("combine" in data);
    if (!this.rulesFold.hidden) this.rules.update();
    this.draw();
  }

  /** Put the rows in view into the page. */
  private draw(): void {
    if (this.element.closest("[hidden]") || isTyping(this.element) || this.isChanging()) return;
    const listed = listedCombinations(this.store.data).map((each, at): Row => ({ ...each, at }));
    const made = (this.sums?.made ?? []).map((each): Row => ({ ...each, at: null }));
    const all = [...listed, ...made];
    this.rows = all.filter(({ limit_state }) => !this.filter.value || limit_state === this.filter.value);
    setText(this.count, say("{count} of {all} shown", { count: this.rows.length, all: all.length }));
    refill(this.head, [this.makeHead()]);
    this.table.setAttribute("aria-rowcount", String(this.rows.length + 1));
    refill(
      this.body,
      rowsInView(this.box, this.rows.length, (n) => this.makeRow(this.rows[n]!, n)),
    );
  }

  private makeHead(): HTMLElement {
    const cases = this.cases.map((name, n) => {
      const positions = positionsOf(this.sums, name);
      const title = verbatim([name, ...positions].join("\n"));
      return h(
        "th",
        {
          scope: "col",
          class: "number",
          title,
          style: `--case-color:${caseColor(n)}`,
        },
        h("span", { class: "swatch", "aria-hidden": "true" }),
        verbatim(name),
        positions.length > 0 ? positionsNote(positions) : null,
      );
    });
    return h(
      "tr",
      { "aria-rowindex": 1 },
      h("th", { scope: "col" }, "combination"),
      h("th", { scope: "col" }, "limit state"),
      ...cases,
      h("th", { scope: "col" }, "rule"),
    );
  }

  private makeRow(row: Row, n: number): HTMLElement {
    const issues = row.at === null ? [] : issuesAt(this.store.doc?.issues ?? [], ["combinations", row.at]);
    const attributes = {
      "aria-rowindex": n + 2,
      class: [row.at === null ? "made" : "", issues.length > 0 ? "flagged" : ""].join(" ").trim() || null,
      title: issues.length > 0 ? verbatim(issues.map(issueSentence).join(" ")) : null,
    };
    return h("tr", attributes, ...(row.at === null ? this.madeCells(row) : this.listedCells(row, row.at)));
  }

  private madeCells(row: Row): HTMLElement[] {
    const factors = this.cases.map((name) => h("td", { class: "number" }, verbatim(factorText(row.factors[name]))));
    return [
      h("th", { scope: "row" }, verbatim(row.name)),
      h("td", {}, row.limit_state),
      ...factors,
      h("td", {}, row.rule ? verbatim(row.rule) : "each case by itself"),
    ];
  }

  private listedCells(row: Row, at: number): HTMLElement[] {
    const state = h("select", {
      "data-key": `state-${at}`,
      "aria-label": say("limit state of combination {number}", { number: at + 1 }),
    });
    fillOptions(
      state,
      STATES.map((each) => [each, each] as const),
    );
    state.value = row.limit_state;
    state.dataset.value = row.limit_state; // by which rows are compared
    state.addEventListener("change", () => setValue(this.ctx, ["combinations", at, "limit_state"], state.value));
    const remove = button("×", "Remove this combination", () => this.remove(at), "icon");
    remove.dataset.key = `remove-${at}`;
    setRead(remove, "aria-label", say("remove combination {name}", { name: verbatim(row.name || String(at + 1)) }));
    const name = textField(`name-${at}`, say("name of combination {number}", { number: at + 1 }), row.name, (typed) =>
      setValue(this.ctx, ["combinations", at, "name"], typed || undefined),
    );
    const unknown = Object.keys(row.factors).filter((each) => !this.cases.includes(each));
    const rule = unknown.length > 0 ? verbatim(unknown.join(", ")) : verbatim(row.rule);
    return [
      h("td", {}, name),
      h("td", {}, state),
      ...this.cases.map((each, n) => h("td", { class: "number" }, this.factorField(row, at, each, n))),
      h("td", { class: unknown.length > 0 ? "unknown" : null }, rule, remove),
    ];
  }

  private factorField(row: Row, at: number, name: string, n: number): HTMLInputElement {
    const label = say("factor of {name} in {combination}", {
      name: verbatim(name),
      combination: verbatim(row.name || String(at + 1)),
    });
    const write = (typed: string, input: HTMLInputElement) => {
      const factor = Number(typed.replace(",", ".").replace("\u2212", "-"));
      if (Number.isFinite(factor)) this.ctx.change(setFactor(this.store.data, at, name, factor));
      else input.value = factorText(row.factors[name]);
    };
    return textField(`factor-${at}-${n}`, label, factorText(row.factors[name]), write);
  }

  private addRow(): void {
    const taken = [...listedCombinations(this.store.data), ...(this.sums?.made ?? [])].map(({ name }) => name);
    const at = listAt(this.store.data, ["combinations"]).length;
    this.ctx.change(addCombination(this.store.data, taken, this.filter.value || "ultimate"));
    this.draw();
    this.scroller.scrollTop = this.rows.findIndex((row) => row.at === at) * ROW_HEIGHT;
    this.draw();
    this.body.querySelector<HTMLElement>(`[data-key="name-${at}"]`)?.focus();
  }

  private remove(at: number): void {
    const name = String(tableAt(this.store.data, ["combinations", at]).name ?? at + 1);
    const isOnly = listAt(this.store.data, ["combinations"]).length === 1;
    const path: Path = isOnly ? ["combinations"] : ["combinations", at];
    this.ctx.change({
      edits: [{ op: "remove", path }],
      text: say("remove combination {name}", { name: verbatim(name) }),
    });
  }
}

/** Return how many positions a case has, at each of which combinations are solved, with the first and the last one. */
function positionsNote(positions: readonly string[]): HTMLElement {
  const ends = verbatim(`${positions[0]} … ${positions.at(-1)}`);
  return h("span", { class: "positions" }, say("{count} positions", { count: positions.length }), h("span", {}, ends));
}

function factorText(factor: number | undefined): string {
  return factor ? String(factor).replace("-", "\u2212") : "";
}

/** Return a field that is taken when its text is complete. */
function textField(
  key: string,
  label: string,
  value: string,
  write: (typed: string, input: HTMLInputElement) => void,
): HTMLInputElement {
  const input = h("input", { type: "text", "data-key": key, "aria-label": label, value, spellcheck: "false" });
  input.addEventListener("change", () => {
    if (input.value.trim() === value) return;
    write(input.value.trim(), input);
    input.defaultValue = input.value;
  });
  input.addEventListener("keydown", (event) => {
    if (event.key === "Escape") input.value = value;
  });
  return input;
}

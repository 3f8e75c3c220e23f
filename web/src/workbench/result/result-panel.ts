// The right half of the page: the result as a picture, as figures, as values at places and along lines.

import {
  type Choice,
  decode,
  fieldOf,
  isEnvelope,
  number,
  onTheme,
  type Point,
  SceneError,
  SectionChart,
  symbolText,
  ValuePanel,
} from "../../viewer";
import { type Api, Refused, Stranger, type Summary, Unreachable } from "../client/api";
import type { Store } from "../client/store";
import { fill, h } from "../shell/elements";
import { splitter } from "../shell/splitter";
import { tabs } from "../shell/tabs";
import { emptyResult, freshness, statusLine } from "./status";
import { showCertificates, showSummary, verdictOf } from "./summary";
import { Stage } from "./view-switcher";

export interface ResultPanel {
  readonly element: HTMLElement;
}

/** The panel of results, kept the same as the store's `solved`. */
export function resultPanel(
  store: Store,
  api: Pick<Api, "scene" | "summary">,
  solve: () => void,
  lost: (error: Unreachable | Stranger) => void,
): ResultPanel {
  const element = h("section", { class: "result", "aria-label": "result" });
  return new Panel(element, store, api, solve, lost);
}

class Panel implements ResultPanel {
  private readonly stage: Stage;
  private readonly values: ValuePanel;
  private readonly chart: SectionChart;
  private readonly chartOf = h("select", { "aria-label": "combinations in the section" });
  private readonly chartTitle = h("span", { class: "chart-title" });
  private readonly lines = h("select", { "aria-label": "section line" });
  private readonly summaryBox = h("div", { class: "lower-panel summary-box" });
  private readonly certificateBox = h("div", { class: "lower-panel" });
  private readonly refusedBox = h("div", { class: "refused-over", role: "alert", hidden: true });
  private readonly lower;
  private readonly empty;
  private readonly full: HTMLElement;
  private summary: Summary | null = null;
  private pick: Point | null = null;
  private section: { start: Point; end: Point; name: string } | null = null;
  private fetching = 0;
  private shownRun: number | null = null;

  constructor(
    readonly element: HTMLElement,
    private readonly store: Store,
    private readonly api: Pick<Api, "scene" | "summary">,
    solve: () => void,
    private readonly lost: (error: Unreachable | Stranger) => void,
  ) {
    this.stage = new Stage({
      picked: (at) => this.picked(at),
      cut: (start, end) => this.cut({ start, end, name: "" }),
      shown: () => this.refresh(),
    });
    const valueBox = h("div", { class: "lower-panel value-box" });
    const chartPlace = h("div", { class: "chart-place" });
    const sectionBox = h(
      "div",
      { class: "lower-panel section-box" },
      h("div", { class: "chart-bar" }, this.chartTitle, this.lines, this.chartOf),
      chartPlace,
    );
    this.values = new ValuePanel(valueBox);
    this.values.onField = (field) => this.stage.show(this.stage.choice, field);
    this.chart = new SectionChart(chartPlace);
    this.chart.onPlace = (at) => this.stage.plan.markPlace(at);
    onTheme((theme) => this.chart.setTheme(theme));
    this.lower = tabs(
      [
        { name: "summary", label: "Summary", panel: this.summaryBox, scrolls: true },
        { name: "certificate", label: "Certificate", panel: this.certificateBox, scrolls: true },
        { name: "values", label: "Values", panel: valueBox },
        { name: "section", label: "Section", panel: sectionBox },
      ],
      "about the result",
    );
    const panels = h(
      "div",
      { class: "lower" },
      this.lower.bar,
      this.summaryBox,
      this.certificateBox,
      valueBox,
      sectionBox,
    );
    this.empty = emptyResult(store, solve);
    this.full = h("div", { class: "result-full", hidden: true });
    this.full.append(
      this.stage.bar,
      h("div", { class: "stage-place" }, this.stage.element, this.refusedBox),
      splitter(this.full, "--stage-share", "y", 0.62, [0.25, 0.85], "height of the picture"),
      panels,
    );
    element.append(h("h2", { class: "unseen" }, "Result"), statusLine(store), this.empty.element, this.full);
    this.chartOf.addEventListener("change", () => this.drawChart());
    this.lines.addEventListener("change", () => this.chooseLine());
    store.on(["solved"], () => void this.fetch());
    store.on(["doc", "waiting", "solved"], () => {
      element.classList.toggle("stale", freshness(store.solved, store.doc?.version, store.waitingCount) === "stale");
    });
    this.empty.update();
    this.refresh();
  }

  /** Get the result that the store names, unless a newer one is on its way. */
  private async fetch(): Promise<void> {
    const { solved } = this.store;
    const turn = (this.fetching += 1);
    if (!solved) return this.clear();
    if (solved.run === this.shownRun) return;
    try {
      const [buffer, summary] = await Promise.all([this.api.scene(solved.run), this.api.summary(solved.run)]);
      if (turn !== this.fetching) return;
      this.summary = summary;
      this.full.hidden = false;
      this.empty.element.hidden = true;
      this.stage.take(decode(buffer));
      this.shownRun = solved.run;
      this.refresh();
    } catch (error) {
      if (turn !== this.fetching) return;
      if (error instanceof Unreachable || error instanceof Stranger) this.lost(error);
      else if (error instanceof Refused || error instanceof SceneError)
        this.store.say({ kind: "bad", text: `The result cannot be shown: ${error.message}` });
      else throw error;
    }
  }

  private clear(): void {
    this.shownRun = null;
    this.summary = null;
    this.pick = null;
    this.section = null;
    this.full.hidden = true;
    this.empty.element.hidden = false;
    this.empty.update();
    this.stage.clear();
  }

  /** Show all that depends on the field and the combination. */
  private refresh(): void {
    const { stage, summary } = this;
    const { choice } = stage;
    const one = typeof choice === "number" ? (summary?.combinations[choice] ?? null) : null;
    showSummary(this.summaryBox, one, summary);
    showCertificates(this.certificateBox, summary, (n) => this.choose(n));
    const bad = summary?.combinations.filter((each) => verdictOf(each) !== "certified").length ?? 0;
    this.lower.mark("certificate", summary ? (bad > 0 ? String(bad) : "✓") : "", bad > 0);
    this.refusedBox.hidden = one?.refused === null || one === null;
    fill(this.refusedBox, h("h3", {}, `${one?.name ?? ""} has no solution`), h("p", {}, one?.refused ?? ""));
    this.values.show(stage.scene, stage.locator, choice, this.pick, stage.field);
    this.fillLines();
    this.fillChartOf();
    this.drawChart();
  }

  private choose(n: number): void {
    this.stage.show(n, this.stage.field);
  }

  private picked(at: Point): void {
    this.pick = at;
    this.stage.plan.markPick(at);
    this.lower.show("values");
    this.values.show(this.stage.scene, this.stage.locator, this.stage.choice, at, this.stage.field);
  }

  private cut(section: { start: Point; end: Point; name: string } | null): void {
    this.section = section;
    this.stage.plan.markSection(section ? [section.start, section.end] : null);
    if (section) this.lower.show("section");
    if (!section?.name) this.lines.value = "";
    this.drawChart();
  }

  private fillLines(): void {
    const named = this.stage.scene?.head.plan.lines ?? [];
    const before = this.lines.value;
    fill(
      this.lines,
      h("option", { value: "" }, "section line …"),
      ...named.map((line, n) => h("option", { value: String(n) }, line.name || `line ${n + 1}`)),
    );
    this.lines.hidden = named.length === 0;
    if (named[Number(before)]) this.lines.value = before;
  }

  private chooseLine(): void {
    const line = this.stage.scene?.head.plan.lines[Number(this.lines.value || NaN)];
    this.cut(line ? { start: line.start, end: line.end, name: line.name } : null);
  }

  private fillChartOf(): void {
    const solved = this.stage.scene?.head.combinations.filter((each) => each.values !== null) ?? [];
    const states = [...new Set(solved.map((each) => each.limit_state))];
    const before = this.chartOf.value;
    fill(
      this.chartOf,
      h("option", { value: "this" }, "combination shown"),
      solved.length > 1 ? h("option", { value: "all" }, "all combinations") : null,
      ...(states.length > 1
        ? states.map((state) => h("option", { value: `state:${state}` }, `all ${state} combinations`))
        : []),
    );
    this.chartOf.hidden = solved.length < 2;
    if ([...this.chartOf.options].some((option) => option.value === before)) this.chartOf.value = before;
  }

  private drawChart(): void {
    const { section } = this;
    const { scene, locator, field, choice } = this.stage;
    if (!section || !scene || !locator) {
      this.chartTitle.textContent = "Choose “Section” and click two places, or choose a section line of the model.";
      return this.chart.show(null);
    }
    const wanted = this.chartOf.value;
    const several = scene.head.combinations.flatMap((each, n): Choice[] =>
      each.values !== null && (wanted === "all" || wanted === `state:${each.limit_state}`) ? [n] : [],
    );
    const shown = isEnvelope(choice) || scene.head.combinations[choice]?.values ? [choice] : [];
    const info = fieldOf(scene, field);
    const place = ([x, y]: Point) => `(${number(x)}, ${number(y)})`;
    this.chartTitle.textContent = `${symbolText(info.symbol)} [${info.unit}] along ${section.name ? `${section.name}: ` : ""}${place(section.start)} to ${place(section.end)} m`;
    this.chart.show({ scene, locator, field, choices: several.length > 0 ? several : shown, ...section });
  }
}

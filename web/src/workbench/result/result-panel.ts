// The right half of the page: the result as a picture, its summary, values at points and along lines.
import { isEnvelope } from "../../viewer/data/fields";
import { decodeScene, type Point, SceneError } from "../../viewer/data/scene";
import { ResultView } from "../../viewer/panels/result-view";
import { SectionPanel } from "../../viewer/panels/section-panel";
import { ValuePanel } from "../../viewer/panels/value-panel";
import { fill, h } from "../../viewer/shared/dom";
import { type Api, Lost, Refused, type Summary } from "../client/api";
import type { Store } from "../client/store";
import { splitter } from "../shell/splitter";
import { tabs } from "../shell/tabs";
import { emptyResult, freshness, statusLine } from "./status";
import { showCertificates, showSummary, verdictOf } from "./summary";
import "./result.css";

const SECTION_HINT = "Choose “Section” and click two points, or choose a section line of the model.";

/** The panel of results, kept in step with the store's `solved`. */
export class ResultPanel {
  readonly element = h("section", { class: "result", "aria-label": "result" });
  private readonly view: ResultView;
  private readonly values: ValuePanel;
  private readonly section: SectionPanel;
  private readonly summaryBox = h("div", { class: "lower-panel summary-box" });
  private readonly certificateBox = h("div", { class: "lower-panel" });
  private readonly refusedBox = h("div", { class: "refused-over", role: "alert", hidden: true });
  private readonly lower;
  private readonly empty;
  private readonly full = h("div", { class: "result-full", hidden: true });
  private summary: Summary | null = null;
  private pick: Point | null = null;
  private fetching = 0;
  private shownRun: number | null = null;

  constructor(
    private readonly store: Store,
    private readonly api: Pick<Api, "scene" | "summary">,
    solve: (() => void) | null,
    private readonly onLost: (error: Lost) => void,
  ) {
    const valueBox = h("div", { class: "lower-panel value-box" });
    const chartPlace = h("div", { class: "chart-place" });
    this.view = new ResultView(
      {
        onPick: (at) => this.setPick(at),
        onSection: (start, end) => this.section.cut({ start, end, name: "" }),
        onShow: () => this.update(),
      },
      true,
    );
    const { view } = this;
    this.section = new SectionPanel(view, chartPlace, SECTION_HINT, (section) => {
      if (section) this.lower.show("section");
    });
    const { title, lines, combinations } = this.section;
    const chartBar = h("div", { class: "chart-bar" }, title, lines, combinations);
    const sectionBox = h("div", { class: "lower-panel section-box" }, chartBar, chartPlace);
    this.values = new ValuePanel(valueBox);
    this.values.onField = (field) => view.show(view.choice, field);
    this.lower = tabs(
      [
        { name: "summary", label: "Summary", panel: this.summaryBox, scrolls: true },
        { name: "certificate", label: "Certificate", panel: this.certificateBox, scrolls: true },
        { name: "values", label: "Values", panel: valueBox },
        { name: "section", label: "Section", panel: sectionBox },
      ],
      "about the result",
    );
    this.empty = emptyResult(store, solve);
    this.full.append(
      h(
        "div",
        { class: "stage-bar", role: "toolbar", "aria-label": "result" },
        view.combinations,
        view.fields,
        view.toolGroup,
        view.modeGroup,
        view.fitButton,
        view.meshButton,
      ),
      h("div", { class: "stage-place" }, view.element, view.scaleBox, this.refusedBox),
      splitter(this.full, "--stage-share", "y", 0.62, [0.25, 0.85], "height of the picture"),
      h("div", { class: "lower" }, this.lower.bar, this.summaryBox, this.certificateBox, valueBox, sectionBox),
    );
    this.element.append(h("h2", { class: "unseen" }, "Result"), statusLine(store), this.empty.element, this.full);
    store.on(["solved"], () => void this.fetch());
    store.on(["doc", "waiting", "solved"], () => {
      const isStale = freshness(store.solved, store.doc?.version, store.waitingCount) === "stale";
      this.element.classList.toggle("stale", isStale);
    });
    this.empty.update();
    this.update();
  }

  /** Get the result that the store names, unless a newer one is on its way. */
  private async fetch(): Promise<void> {
    const { solved } = this.store;
    this.fetching += 1;
    const turn = this.fetching;
    this.element.setAttribute("aria-busy", String(solved !== null && solved.run !== this.shownRun));
    if (!solved) return this.clear();
    if (solved.run === this.shownRun) return;
    try {
      const [buffer, summary] = await Promise.all([this.api.scene(solved.run), this.api.summary(solved.run)]);
      if (turn !== this.fetching) return;
      this.summary = summary;
      this.full.hidden = false;
      this.empty.element.hidden = true;
      this.view.setScene(decodeScene(buffer), this.view.field || "settlement");
      this.shownRun = solved.run;
    } catch (error) {
      if (turn !== this.fetching) return;
      if (error instanceof Lost) this.onLost(error);
      else if (error instanceof Refused || error instanceof SceneError)
        this.store.set("notice", { kind: "bad", text: `The result cannot be shown: ${error.message}` });
      else throw error;
    } finally {
      if (turn === this.fetching) this.element.setAttribute("aria-busy", "false");
    }
  }

  private clear(): void {
    this.shownRun = this.summary = this.pick = null;
    this.full.hidden = true;
    this.empty.element.hidden = false;
    this.empty.update();
    this.view.clear();
    this.section.cut(null);
  }

  /** Show all that depends on the field and the combination. */
  private update(): void {
    const { view, summary } = this;
    const one = isEnvelope(view.choice) ? null : (summary?.combinations[view.choice] ?? null);
    showSummary(this.summaryBox, one, summary);
    showCertificates(this.certificateBox, summary, (n) => view.show(n, view.field));
    const bad = summary?.combinations.filter((each) => verdictOf(each) !== "certified").length ?? 0;
    this.lower.mark("certificate", summary ? (bad > 0 ? String(bad) : "✓") : "", bad > 0);
    this.refusedBox.hidden = one === null || one.refused === null;
    fill(this.refusedBox, h("h3", {}, `${one?.name ?? ""} has no solution`), h("p", {}, one?.refused ?? ""));
    this.values.show(view.scene, view.locator, view.choice, this.pick, view.field);
    this.section.update();
  }

  private setPick(at: Point): void {
    this.pick = at;
    this.lower.show("values");
    this.update();
  }
}

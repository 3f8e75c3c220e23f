// The right half of the page: the result as a picture, its summary, values at points and along lines.
import { fieldsOf, isEnvelope } from "../../viewer/data/fields";
import { decodeScene, type Point, type Scene, SceneError } from "../../viewer/data/scene";
import { ResultView } from "../../viewer/panels/result-view";
import { SectionPanel } from "../../viewer/panels/section-panel";
import { ValuePanel } from "../../viewer/panels/value-panel";
import { fill, h } from "../../viewer/shared/dom";
import { type Api, Lost, Refused, type Summary } from "../client/api";
import type { Store } from "../client/store";
import { splitter } from "../controls/splitter";
import { type Tabs, tabs } from "../controls/tabs";
import type { Change } from "../model/edits";
import { formatPath, parsePath } from "../model/paths";
import { comparisonBar } from "./comparison-bar";
import { keepSection } from "./keep-section";
import { itemAt, itemOf, itemsIn, middleOf } from "./plan-items";
import { Preview } from "./preview";
import { Reference } from "./reference";
import { ResultTables } from "./result-tables";
import { emptyResult, freshness, statusLine } from "./status";
import { showCertificates, showSummary, verdictOf } from "./summary";
import type { Target } from "./table-rows";
import "./result.css";

/** A click so near to a point or a line of the model selects it [px]. */
const REACH = 8;
const SECTION_HINT = "Choose “Section” and click two points, or choose a section line of the model.";

/** What the panel can do with the model. */
export interface ModelActions {
  solve(): void;
  push(change: Change): void;
}

/** The panel of results, kept in step with the store's `solved`; without a model it only shows. */
export class ResultPanel {
  readonly element = h("section", { class: "result", "aria-label": "result" });
  private readonly view: ResultView;
  private readonly values: ValuePanel;
  private readonly section: SectionPanel;
  private readonly summaryBox = h("div", { class: "lower-panel summary-box" });
  private readonly certificateBox = h("div", { class: "lower-panel" });
  private readonly refusedBox = h("div", { class: "refused-over", role: "alert", hidden: true });
  private readonly tables: ResultTables;
  private readonly reference = new Reference({
    onKeep: () => {
      this.lower.offer("reference", true);
      this.lower.show("reference");
      return this.result;
    },
    onPicture: (scene) => this.showReference(scene),
  });
  private readonly referenceLabel = h("p", { class: "preview-over", hidden: true }, "Reference");
  private result: Scene | null = null;
  private readonly lower: Tabs;
  private readonly empty;
  private readonly full = h("div", { class: "result-full", hidden: true });
  private summary: Summary | null = null;
  private readonly canCompare: boolean;
  private pick: Point | null = null;
  private readonly preview: Preview;
  private shownName: string | null = "";
  private fetching = 0;
  private shownRun: number | null = null;

  constructor(
    private readonly store: Store,
    private readonly api: Pick<
      Api,
      "scene" | "summary" | "tables" | "table" | "preview" | "setShown" | "compareGrounds" | "cancelComparison"
    >,
    private readonly onLost: (error: Lost) => void,
    model: ModelActions | null,
  ) {
    this.canCompare = model !== null;
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
    const keep = model && keepSection(store, model.push);
    this.section = new SectionPanel(view, chartPlace, SECTION_HINT, (section) => {
      keep?.set(section);
      if (section) this.lower.show("section");
    });
    const { title, lines, combinations } = this.section;
    const chartBar = h("div", { class: "chart-bar" }, title, keep?.element, lines, combinations);
    const sectionBox = h("div", { class: "lower-panel section-box" }, chartBar, chartPlace);
    this.values = new ValuePanel(valueBox);
    this.values.onField = (field) => view.show(view.choice, field);
    this.tables = new ResultTables(
      api,
      (target) => this.follow(target),
      (error) => {
        // a newer result is on its way, whose tables follow it
        if (error instanceof Lost || store.solved?.run === this.shownRun) this.handleError(error);
      },
    );
    this.lower = this.makeTabs(valueBox, sectionBox);
    this.preview = this.makePreview();
    this.empty = emptyResult(store, model?.solve ?? null);
    this.full.append(
      this.makeToolbar(),
      h(
        "div",
        { class: "stage-place" },
        view.element,
        view.scaleBox,
        this.preview.label,
        this.referenceLabel,
        this.refusedBox,
      ),
      splitter(this.full, "--stage-share", "y", 0.62, [0.25, 0.85], "height of the picture"),
      h(
        "div",
        { class: "lower" },
        this.lower.bar,
        this.summaryBox,
        valueBox,
        sectionBox,
        this.reference.panel,
        ...this.tables.panels,
        this.certificateBox,
      ),
    );
    this.element.append(h("h2", { class: "unseen" }, "Result"), statusLine(store), this.empty.element, this.full);
    store.on(["solved"], () => void this.fetch());
    store.on(["selection"], () => this.markSelected());
    store.on(["doc", "waiting", "solved"], () => {
      const isStale = freshness(store.solved, store.doc?.version, store.waitingCount) === "stale";
      this.element.classList.toggle("stale", isStale);
    });
    this.empty.update();
    this.lower.offer("reference", false);
    this.update();
  }

  /** Make the choices and tools above the picture. */
  private makeToolbar(): HTMLElement {
    const { combinations, fields, toolGroup, modeGroup, fitButton, meshButton } = this.view;
    const about = { class: "stage-bar", role: "toolbar", "aria-label": "result" };
    return h("div", about, combinations, fields, toolGroup, modeGroup, fitButton, meshButton);
  }

  /** Make what shows previews in place of the last result. */
  private makePreview(): Preview {
    return new Preview(this.store, this.api, this.view, {
      onShow: () => {
        this.fetching += 1; // the last result, if it is on its way, comes too late
        this.shownRun = null;
        this.referenceLabel.hidden = true;
        this.reference.pictureButton.setAttribute("aria-pressed", "false");
        this.full.hidden = false;
        this.empty.element.hidden = true;
      },
      onEnd: () => void this.fetch(),
      onLost: this.onLost,
    });
  }

  /** Make the tabs below the picture. */
  private makeTabs(valueBox: HTMLElement, sectionBox: HTMLElement): Tabs {
    const { tables, store, api } = this;
    if (this.canCompare)
      tables.addTo(
        "ground",
        comparisonBar(store, api, (error) => this.handleError(error)),
      );
    store.on(["comparison"], () => void this.takeComparison());
    return tabs(
      [
        { name: "summary", label: "Summary", panel: this.summaryBox, scrolls: true },
        { name: "values", label: "Values", panel: valueBox },
        { name: "section", label: "Section", panel: sectionBox },
        { name: "reference", label: "Reference", panel: this.reference.panel, scrolls: true },
        ...tables.tabs,
        { name: "certificate", label: "Certificate", panel: this.certificateBox, scrolls: true },
      ],
      "about the result",
      (name) => void tables.see(name),
    );
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
      const { run } = solved;
      const [buffer, summary, names] = await Promise.all([
        this.api.scene(run),
        this.api.summary(run),
        this.api.tables(run),
      ]);
      if (turn !== this.fetching) return;
      this.summary = summary;
      this.full.hidden = false;
      this.empty.element.hidden = true;
      this.preview.end();
      this.reference.setPicture(false);
      this.result = decodeScene(buffer);
      this.view.setScene(this.result, this.view.field || "settlement");
      this.markSelected();
      this.shownRun = run;
      this.offerTables(run, names);
      void this.tables.see(this.lower.current());
    } catch (error) {
      if (turn === this.fetching) this.handleError(error);
    } finally {
      if (turn === this.fetching) this.element.setAttribute("aria-busy", "false");
    }
  }

  /** Offer the tabs that have a table; grounds can always be compared. */
  private offerTables(run: number | null, names: readonly string[]): void {
    this.tables.set(run, names, (tab, offered) =>
      this.lower.offer(tab, offered || (tab === "ground" && this.canCompare && run !== null)),
    );
  }

  /** Show the comparison of grounds that has been made for the run shown. */
  private async takeComparison(): Promise<void> {
    const { comparison } = this.store;
    if (comparison?.state !== "done" || comparison.run !== this.shownRun) return;
    try {
      const names = await this.api.tables(comparison.run);
      if (comparison.run !== this.shownRun) return;
      this.offerTables(comparison.run, names);
      this.tables.choose("ground", "comparison");
    } catch (error) {
      this.handleError(error);
    }
  }

  private handleError(error: unknown): void {
    if (error instanceof Lost) this.onLost(error);
    else if (error instanceof Refused || error instanceof SceneError)
      this.store.set("notice", { kind: "bad", text: `The result cannot be shown: ${error.message}` });
    else throw error;
  }

  /** Show what a cell of a table leads to: its field, its combination, its place; the item it names is selected. */
  private follow({ place, combination, field, item }: Target): void {
    const { view } = this;
    if (!view.scene) return;
    const { combinations, plan } = view.scene.head;
    const found = combinations.findIndex((each) => each.name === combination);
    const shown = fieldsOf(view.scene).some((each) => each.name === field);
    view.show(found < 0 ? view.choice : found, shown && field !== null ? field : view.field);
    const named = item && itemsIn(plan, item.list).find((each) => each.name === item.name);
    if (named) this.store.select(parsePath(named.path));
    const at = place ?? (named && middleOf(named));
    if (at) view.reveal(at);
  }

  private clear(): void {
    this.preview.end();
    this.reference.setPicture(false);
    this.result = null;
    this.shownRun = this.summary = this.pick = null;
    this.full.hidden = true;
    this.empty.element.hidden = false;
    this.empty.update();
    this.view.clear();
    this.section.cut(null);
    this.offerTables(null, []);
    this.reference.forget();
    this.lower.offer("reference", false);
  }

  /** Show all that depends on the field and the combination. */
  private update(): void {
    const { view, summary } = this;
    const shown = isEnvelope(view.choice) ? null : (view.scene?.head.combinations[view.choice]?.name ?? "");
    this.tellShown(shown);
    // of a preview there may be no summary yet, or that of the result before
    const one = summary?.combinations.find((each) => each.name === shown) ?? null;
    showSummary(this.summaryBox, one, summary);
    if (!summary && this.preview.isShown)
      fill(this.summaryBox, h("p", { class: "empty" }, "The figures follow with the result."));
    if (one && one.refused === null) this.summaryBox.prepend(this.reference.keepButton);
    this.reference.show(summary, one?.name ?? "");
    showCertificates(this.certificateBox, summary, (n) => view.show(n, view.field));
    const bad = summary?.combinations.filter((each) => verdictOf(each) !== "certified").length ?? 0;
    this.lower.mark("certificate", summary ? (bad > 0 ? String(bad) : "✓") : "", bad > 0);
    this.refusedBox.hidden = one === null || one.refused === null;
    fill(this.refusedBox, h("h3", {}, `${one?.name ?? ""} has no solution`), h("p", {}, one?.refused ?? ""));
    this.values.show(view.scene, view.locator, view.choice, this.pick, view.field);
    this.section.update();
  }

  /** Tell the server which combination is looked at, of which a run shows a preview; null: several. */
  private tellShown(name: string | null): void {
    if (!this.canCompare || name === this.shownName) return;
    this.shownName = name;
    this.api.setShown(name).catch((error: unknown) => this.handleError(error));
  }

  /** Show the picture of the reference, null: that of the result again. */
  private showReference(scene: Scene | null): void {
    this.referenceLabel.hidden = !scene;
    const shown = scene ?? this.result;
    if (shown) this.view.setScene(shown);
  }

  /** Mark the item of the model that is selected. */
  private markSelected(): void {
    const { selection } = this.store;
    const { scene, plan } = this.view;
    const found = selection && scene && itemOf(scene.head.plan, formatPath(selection));
    plan.mark("selected", found ? { points: found.points, closed: found.shape === "area" } : null);
  }

  private setPick(at: Point): void {
    this.pick = at;
    const { scene, plan } = this.view;
    const found = scene && itemAt(scene.head.plan, at, plan.lengthOf(REACH));
    if (found) this.store.select(parsePath(found.path));
    this.lower.show("values");
    this.update();
  }
}

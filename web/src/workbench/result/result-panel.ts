// The right half of the page: the result as a picture, and below it summary, values and tables.

import { isEnvelope } from "../../viewer/data/fields";
import { decodeScene, type Point, SceneError } from "../../viewer/data/scene";
import { h } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import { type Api, Lost, Refused, type Summary } from "../client/api";
import type { Store } from "../client/store";
import { splitter } from "../controls/splitter";
import type { Change } from "../model/edits";
import { AlternativesBar } from "./alternatives-bar";
import { barsBar } from "./bars-bar";
import { comparisonBar, GROUNDS } from "./comparison-bar";
import { keepSection } from "./keep-section";
import { LowerPanels } from "./lower-panels";
import { Picture } from "./picture";
import { standingOf } from "./standing";
import { emptyResult, statusLine } from "./status";
import { wideButton } from "./wide";
import "./result.css";

/** What the panel can do with the model. */
export interface ModelActions {
  solve(): void;
  push(change: Change): void;
}

const BARS_HEIGHT = 77; // px, the bars above the picture and its tools
const TABLE_HEIGHT = 385; // px, tabs, filter, head, a dozen rows, a scroll bar

/** The tabs in which something can be compared before there is a table. */
const COMPARISON_TABS = ["ground", "alternatives"];

/** Return the share of the picture with its tools above a table, of which a dozen rows are enough. */
function shareAboveTable(): number {
  return Math.max(0.45, 1 - TABLE_HEIGHT / (innerHeight - BARS_HEIGHT));
}

/** The panel of results, kept in step with the store's `solved`; without a model it only shows. */
export class ResultPanel {
  readonly element = h("section", { class: "result", "aria-label": "result" });
  private readonly full = h("div", { class: "result-full", hidden: true });
  private readonly empty;
  private readonly picture: Picture;
  private readonly lower: LowerPanels;
  private alternatives: AlternativesBar | null = null;
  private readonly canCompare: boolean;
  private summary: Summary | null = null;
  private shownName = "";
  private fetching = 0;
  private shownRun: number | null = null;
  private shownUpdate = 0;

  constructor(
    private readonly store: Store,
    private readonly api: Pick<
      Api,
      | "scene"
      | "summary"
      | "tables"
      | "table"
      | "preview"
      | "difference"
      | "keepReference"
      | "setShown"
      | "compare"
      | "alternatives"
      | "cancelComparison"
      | "proposeBars"
    >,
    private readonly onLost: (error: Lost) => void,
    model: ModelActions | null,
  ) {
    this.canCompare = model !== null;
    this.picture = this.makePicture();
    this.lower = this.makeLower(model);
    this.empty = emptyResult(store, model?.solve ?? null);
    const share = splitter(this.full, "--stage-share", "y", 0.55, [0.25, 0.85], "plot height");
    const tableShare = splitter(this.full, "--table-share", "y", shareAboveTable, [0.25, 0.85], "plot height");
    tableShare.classList.add("of-tables");
    const toolbar = this.picture.makeToolbar();
    if (model) toolbar.append(wideButton(this.element));
    this.full.append(toolbar, this.picture.element, share, tableShare, this.lower.element);
    this.element.append(h("h2", { class: "unseen" }, "Result"), statusLine(store), this.empty.element, this.full);
    store.on(["solved"], () => void this.fetch());
    store.on(["comparison"], () => void this.takeComparison());
    store.on(["doc", "waiting", "solved", "preview", "drawn"], () => {
      this.element.dataset.standing = standingOf(store);
    });
    this.empty.update();
    this.update();
  }

  private makePicture(): Picture {
    const hooks = {
      onPick: () => {
        this.lower.tabs.show("values");
        this.update();
      },
      onSection: (start: Point, end: Point, width: number) => this.lower.section.cut({ start, end, name: "", width }),
      onShow: () => this.update(),
    };
    return new Picture(
      this.store,
      this.api,
      hooks,
      {
        onShow: () => {
          this.fetching += 1; // the last result, if it is on its way, comes too late
          this.shownRun = null;
          this.lower.reference.pictureButton.setAttribute("aria-pressed", "false");
          this.showFull(true);
        },
        onEnd: () => void this.fetch(),
        onLost: this.onLost,
      },
      (error) => this.handleError(error),
    );
  }

  private makeLower(model: ModelActions | null): LowerPanels {
    const { store, api } = this;
    const keep = model && keepSection(store, model.push);
    const onKeep = () => {
      if (model && this.shownRun !== null)
        this.picture.minus.keep(this.shownRun).catch((error: unknown) => this.handleError(error));
    };
    const lower = new LowerPanels(this.picture, api, keep, onKeep, (error) => {
      // a newer result is on its way, whose tables follow it
      if (error instanceof Lost || store.solved?.run === this.shownRun) this.handleError(error);
    });
    if (!model) return lower;
    const onError = (error: unknown) => this.handleError(error);
    this.alternatives = new AlternativesBar(store, api, model.push, onError);
    lower.tables.addTo("ground", comparisonBar(GROUNDS, store, api, onError));
    lower.tables.addTo("alternatives", this.alternatives.element);
    lower.tables.addTo("reinforcement", barsBar(store, api, model.push));
    return lower;
  }

  /** Show the result, or what stands in its place. */
  private showFull(on: boolean): void {
    this.full.hidden = !on;
    this.empty.element.hidden = on;
  }

  /** Get the result that the store names, unless a newer one is on its way. */
  private async fetch(): Promise<void> {
    const { solved } = this.store;
    this.fetching += 1;
    const turn = this.fetching;
    const isShown = solved?.run === this.shownRun && solved?.update === this.shownUpdate;
    this.element.setAttribute("aria-busy", String(solved !== null && !isShown));
    if (!solved) return this.clear();
    if (isShown) return;
    try {
      const { run, update } = solved;
      const [buffer, summary, names] = await Promise.all([
        this.api.scene(run),
        this.api.summary(run),
        this.api.tables(run),
      ]);
      if (turn !== this.fetching) return;
      this.summary = summary;
      this.showFull(true);
      this.picture.preview.end(solved.provisional);
      this.lower.reference.setPicture(false);
      this.store.set("drawn", { run, isPreview: false });
      this.picture.setResult(decodeScene(buffer), run);
      [this.shownRun, this.shownUpdate] = [run, update];
      if (!summary.design) return this.lower.tables.wait();
      this.offerTables(run, names);
      void this.lower.tables.see(this.lower.tabs.current());
    } catch (error) {
      if (turn === this.fetching) this.handleError(error);
    } finally {
      if (turn === this.fetching) this.element.setAttribute("aria-busy", "false");
    }
  }

  /** Offer the tabs that have a table; grounds and alternatives can always be compared. */
  private offerTables(run: number | null, names: readonly string[]): void {
    if (run !== null && names.includes("alternatives")) void this.alternatives?.offer(run);
    this.lower.tables.set(run, this.shownUpdate, names, (tab, offered) =>
      this.lower.tabs.offer(tab, offered || (COMPARISON_TABS.includes(tab) && this.canCompare && run !== null)),
    );
  }

  /** Show the comparison that has been made for the run shown. */
  private async takeComparison(): Promise<void> {
    const { comparison } = this.store;
    if (comparison?.state !== "done" || comparison.run !== this.shownRun) return;
    try {
      const names = await this.api.tables(comparison.run);
      if (comparison.run !== this.shownRun) return;
      this.offerTables(comparison.run, names);
      this.lower.tables.choose(comparison.kind === "alternatives" ? "alternatives" : "ground", comparison.kind);
    } catch (error) {
      this.handleError(error);
    }
  }

  private handleError(error: unknown): void {
    if (error instanceof Lost) this.onLost(error);
    else if (error instanceof Refused || error instanceof SceneError)
      this.store.set("notice", { kind: "bad", text: say("The result cannot be shown: {why}", { why: error.message }) });
    else throw error;
  }

  private clear(): void {
    this.store.set("drawn", null);
    this.picture.preview.end();
    this.lower.reference.setPicture(false);
    this.shownRun = null;
    this.summary = null;
    this.showFull(false);
    this.empty.update();
    this.picture.setResult(null);
    this.store.set("shown", null);
    this.lower.clear();
    this.offerTables(null, []);
  }

  /** Show all that depends on the field and the combination. */
  private update(): void {
    const { picture, summary } = this;
    const { choice, scene } = picture.view;
    const shown = isEnvelope(choice) ? null : (scene?.head.combinations[choice]?.name ?? "");
    // of several there is no preview, but of one of them
    this.tellShown(picture.view.wanted.name);
    this.store.set("shown", picture.shown);
    // with a preview there may be no summary yet, or that of the result before
    const one = picture.preview.figures ?? summary?.combinations.find(({ name }) => name === shown) ?? null;
    picture.tellRefused(one);
    this.lower.show(summary, one);
  }

  /** Tell the server which combination is looked at, of which a run shows a preview; "": any. */
  private tellShown(name: string): void {
    if (!this.canCompare || name === this.shownName) return;
    this.shownName = name;
    this.api.setShown(name).catch((error: unknown) => this.handleError(error));
  }
}

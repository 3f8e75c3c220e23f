// What stands below the picture, each behind its tab: summary, values, section, reference, tables, certificate.
import type { Scene } from "../../viewer/data/scene";
import { SectionPanel } from "../../viewer/panels/section-panel";
import { ValuePanel } from "../../viewer/panels/value-panel";
import { h } from "../../viewer/shared/dom";
import type { Api, CombinationSummary, Summary } from "../client/api";
import { type Tab, type Tabs, tabs } from "../controls/tabs";
import type { keepSection } from "./keep-section";
import type { Picture } from "./picture";
import { Reference } from "./reference";
import { ResultTables } from "./result-tables";
import { showCertificates, showSummary, verdictOf } from "./summary";

const SECTION_HINT = "Choose “Section” and drag from one point to another, or choose one of the model's section lines.";

export class LowerPanels {
  readonly element: HTMLElement;
  readonly section: SectionPanel;
  readonly tables: ResultTables;
  readonly reference: Reference;
  readonly tabs: Tabs;
  private readonly summaryBox = h("div", { class: "lower-panel summary-box" });
  private readonly valueBox = h("div", { class: "lower-panel value-box" });
  private readonly certificateBox = h("div", { class: "lower-panel" });
  private readonly values = new ValuePanel(this.valueBox);

  /** `keep`: what adds a section to the case, if there is one; `onKeep`: a reference has been kept; `onError` is called if a table cannot be read. */
  constructor(
    private readonly picture: Picture,
    api: Pick<Api, "table">,
    keep: ReturnType<typeof keepSection> | null,
    private readonly onKeep: () => void,
    onError: (error: unknown) => void,
  ) {
    const { view } = picture;
    this.values.onField = (field) => view.show(view.choice, field);
    const chartPlace = h("div", { class: "chart-place" });
    this.section = new SectionPanel(view, chartPlace, SECTION_HINT, (section) => {
      keep?.set(section);
      if (section) this.tabs.show("section");
    });
    this.tables = new ResultTables(api, (target) => picture.follow(target), onError);
    this.reference = new Reference({
      onKeep: () => this.offerReference(),
      onPicture: (scene) => picture.showReference(scene),
    });
    const { title, lines, combinations } = this.section;
    const chartBar = h("div", { class: "chart-bar" }, title, keep?.element, lines, combinations);
    const list = this.listTabs(h("div", { class: "lower-panel section-box" }, chartBar, chartPlace));
    this.tabs = tabs(list, "result details", (name) => void this.tables.see(name));
    this.element = h("div", { class: "lower" }, this.tabs.bar, ...list.map(({ panel }) => panel));
    this.tabs.offer("reference", false);
  }

  /** Show the summary of a result, with the figures of the combination shown, and what the picture has. */
  show(summary: Summary | null, one: CombinationSummary | null): void {
    const { view, pick, preview } = this.picture;
    showSummary(this.summaryBox, one, preview.figures ? null : summary);
    if (preview.figures) this.summaryBox.prepend(h("p", { class: "verdict doubtful" }, preview.words));
    else if (one && one.refused === null) this.summaryBox.prepend(this.reference.keepButton);
    this.reference.show(summary, one?.name ?? "");
    showCertificates(this.certificateBox, summary, (n) => view.show(n, view.field));
    const bad = summary?.combinations.filter((combination) => verdictOf(combination) !== "certified").length ?? 0;
    this.tabs.mark("certificate", summary ? (bad > 0 ? String(bad) : "✓") : "", bad > 0);
    this.values.show(view.scene, view.locator, view.choice, pick, view.field);
    this.section.update();
  }

  /** Forget what belongs to the result before. */
  clear(): void {
    this.section.cut(null);
    this.reference.forget();
    this.tabs.offer("reference", false);
  }

  private listTabs(sectionBox: HTMLElement): Tab[] {
    return [
      { name: "summary", label: "Summary", panel: this.summaryBox, scrolls: true },
      { name: "values", label: "Values", panel: this.valueBox },
      { name: "section", label: "Section", panel: sectionBox },
      { name: "reference", label: "Reference", panel: this.reference.panel, scrolls: true },
      ...this.tables.tabs,
      { name: "certificate", label: "Certificate", panel: this.certificateBox, scrolls: true },
    ];
  }

  private offerReference(): Scene | null {
    this.tabs.offer("reference", true);
    this.tabs.show("reference");
    this.onKeep();
    return this.picture.result;
  }
}

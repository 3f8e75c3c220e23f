// A section through the plate: the line it is cut along, and the chart of a field along it.

import { type Choice, fieldOf, isEnvelope } from "../data/fields";
import { lengthsOf } from "../data/lengths";
import { formatShort } from "../data/numbers";
import type { Line, Point, Scene } from "../data/scene";
import { fillOptions, h, setText } from "../shared/dom";
import { say, verbatim } from "../shared/language";
import { symbolText } from "../shared/symbols";
import { onThemeChange } from "../shared/theme";
import type { ResultView } from "./result-view";
import { SectionChart } from "./section-chart";

/** Where a section is cut; with a width it is a strip, over which fields are averaged. */
export type SectionLine = Pick<Line, "start" | "end" | "name"> & { width?: number };

const THIS = "this";

export class SectionPanel {
  section: SectionLine | null = null;
  readonly chart: SectionChart;
  readonly title = h("div", { class: "gs-chart-title" });
  readonly lines = h("select", { "aria-label": "Section line" });
  readonly combinations = h("select", { "aria-label": "Combinations in the section" });

  /** `hint`: what the title says while there is no section; `onCut` is called with every section that is chosen. */
  constructor(
    private readonly view: ResultView,
    place: HTMLElement,
    private readonly hint: string,
    private readonly onCut: (section: SectionLine | null) => void,
  ) {
    this.chart = new SectionChart(place);
    this.chart.onPlace = (at) => view.plan.mark("place", at);
    this.combinations.addEventListener("change", () => this.drawChart());
    this.lines.addEventListener("change", () => {
      const line = view.scene?.head.plan.lines[Number(this.lines.value || Number.NaN)];
      this.cut(line ?? null);
    });
    onThemeChange((theme) => this.chart.setTheme(theme));
  }

  /** Cut a section; null: remove it. */
  cut(section: SectionLine | null): void {
    this.section = section;
    this.view.plan.mark("section", section && [section.start, section.end]);
    this.view.plan.mark("width", section?.width ?? 0);
    if (!section?.name) this.lines.value = "";
    this.drawChart();
    this.onCut(section);
  }

  /** Show what the view shows now. */
  update(): void {
    const { scene } = this.view;
    const lines = scene?.head.plan.lines ?? [];
    fillOptions(this.lines, [
      ["", "Section along …"],
      ...lines.map(
        (line, i) => [String(i), line.name ? verbatim(line.name) : say("line {number}", { number: i + 1 })] as const,
      ),
    ]);
    this.lines.hidden = lines.length === 0;
    const solved = scene ? solvedCombinations(scene) : [];
    const states = [...new Set(solved.map((i) => scene!.head.combinations[i]!.limit_state))];
    fillOptions(this.combinations, [
      [THIS, "combination shown"],
      ...(solved.length > 1 ? [["all", "all combinations"] as const] : []),
      ...(states.length > 1 ? states.map((state) => [state, say("all {state} combinations", { state })] as const) : []),
    ]);
    this.combinations.hidden = solved.length < 2;
    this.drawChart();
  }

  private drawChart(): void {
    const { section } = this;
    const { scene, locator, field } = this.view;
    if (!section || !scene || !locator) {
      setText(this.title, this.hint);
      return this.chart.show(null);
    }
    const info = fieldOf(scene, field);
    const { unit, per_meter: per } = lengthsOf(scene.head.plan);
    const place = ([x, y]: Point) => `(${formatShort(x * per, 5)}, ${formatShort(y * per, 5)})`;
    const from = place(section.start);
    const values = {
      symbol: symbolText(info.symbol),
      unit: info.unit,
      start: section.name ? say("{name}: {place}", { name: verbatim(section.name), place: from }) : from,
      end: place(section.end),
      length: unit,
      width: formatShort((section.width ?? 0) * per, 4),
    };
    setText(
      this.title,
      section.width
        ? say("{symbol} [{unit}] along {start} to {end} {length}, mean over a width of {width} {length}", values)
        : say("{symbol} [{unit}] along {start} to {end} {length}", values),
    );
    this.chart.show({ scene, locator, field, choices: this.choices(scene), ...section });
  }

  private choices(scene: Scene): Choice[] {
    const { choice } = this.view;
    const { value } = this.combinations;
    if (value === THIS) return isEnvelope(choice) || scene.head.combinations[choice]?.values ? [choice] : [];
    return solvedCombinations(scene).filter(
      (i) => value === "all" || value === scene.head.combinations[i]!.limit_state,
    );
  }
}

function solvedCombinations(scene: Scene): number[] {
  return scene.head.combinations.flatMap((each, i) => (each.values === null ? [] : [i]));
}

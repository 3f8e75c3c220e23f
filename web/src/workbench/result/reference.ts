// A result that was kept as reference: its figures beside those of the result shown, with differences.
import { withMinus } from "../../viewer/data/numbers";
import { button, fill, h } from "../../viewer/shared/dom";
import { symbolElement } from "../../viewer/shared/symbols";
import type { CombinationSummary, Summary } from "../client/api";

export interface ComparedFigure {
  label: string;
  symbol: string;
  unit: string;
  before: string;
  now: string;
  /** In percent of the reference; null where that is zero or not a number. */
  change: number | null;
}

/** Return the difference of two figures in percent of the first one. */
export function changeOf(before: string, now: string): number | null {
  const [first, second] = [Number(before), Number(now)];
  if (before === "" || now === "" || !Number.isFinite(first) || !Number.isFinite(second)) return null;
  if (first === 0) return second === 0 ? 0 : null;
  return (100 * (second - first)) / Math.abs(first);
}

/** Return the figures that both results have in a combination, then the utilisations of their checks. */
export function compareFigures(reference: Summary, shown: Summary, combination: string): ComparedFigure[] {
  const [before, now] = [reference, shown].map((each) => figuresOf(each, combination));
  return [...now!].flatMap(([key, figure]) => {
    const other = before!.get(key);
    if (!other) return [];
    return [{ ...figure, before: other.value, now: figure.value, change: changeOf(other.value, figure.value) }];
  });
}

type Figure = Pick<ComparedFigure, "label" | "symbol" | "unit"> & { value: string };

function figuresOf({ combinations, design }: Summary, name: string): Map<string, Figure> {
  const one: CombinationSummary | undefined = combinations.find((each) => each.name === name);
  const found = new Map<string, Figure>();
  for (const section of one?.sections ?? [])
    for (const { label, symbol, unit, value } of section.rows)
      if (value !== null && value !== "" && Number.isFinite(Number(value)))
        found.set(`${section.title} ${label} ${symbol} ${unit}`, { label, symbol, unit, value: String(value) });
  for (const check of design?.checks ?? [])
    if (check.utilisation !== null)
      found.set(`check ${check.name}`, {
        label: `utilisation, ${check.name}`,
        symbol: "",
        unit: "",
        value: check.utilisation.toFixed(2),
      });
  return found;
}

/** The button that keeps a result as reference, and the table of both. */
export class Reference {
  readonly keepButton = button("Keep as reference", "Compare results of later changes with this one", () =>
    this.keep(),
  );
  readonly panel = h("div", { class: "lower-panel" });
  private summary: Summary | null = null;
  private shown: Summary | null = null;
  private combination = "";

  /** `onKeep` is called when a reference has been kept. */
  constructor(private readonly onKeep: () => void) {
    this.keepButton.classList.add("small");
  }

  /** Show a result of a combination beside the reference; null: none is shown. */
  show(shown: Summary | null, combination: string): void {
    this.shown = shown;
    this.combination = combination;
    const { summary } = this;
    if (!summary || !shown) return;
    const figures = compareFigures(summary, shown, combination);
    const heads = ["", "reference", "now", "unit", "difference"].map((text) => h("th", { scope: "col" }, text));
    const table = h(
      "table",
      { class: "certificates" },
      h("thead", {}, h("tr", {}, ...heads)),
      h("tbody", {}, ...figures.map(makeRow)),
    );
    const words = `Combination ${combination}: the reference has none of this name, or neither has figures.`;
    fill(this.panel, figures.length > 0 ? table : h("p", { class: "empty" }, words));
  }

  /** Forget the reference, which belongs to another document. */
  forget(): void {
    this.summary = this.shown = null;
  }

  private keep(): void {
    this.summary = this.shown;
    this.show(this.shown, this.combination);
    this.onKeep();
  }
}

function makeRow({ label, symbol, unit, before, now, change }: ComparedFigure): HTMLElement {
  const difference = change === null ? "" : withMinus(`${change > 0 ? "+" : ""}${change.toFixed(1)} %`);
  const name = h("th", { scope: "row" }, label, symbol ? " " : null, symbol ? symbolElement(symbol) : null);
  const cells = [before, now, unit, difference].map((text) => h("td", { class: "figure" }, text));
  return h("tr", {}, name, ...cells);
}

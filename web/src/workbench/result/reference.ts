// A result that was kept as reference: its figures beside those of the result shown, with differences.

import { withMinus } from "../../viewer/data/numbers";
import type { Scene } from "../../viewer/data/scene";
import { button, fill, h } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
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

/** Return the figures that both results have in a combination, then the utilizations of their checks. */
export function compareFigures(reference: Summary, shown: Summary, combination: string): ComparedFigure[] {
  const [before, now] = [reference, shown].map((summary) => figuresOf(summary, combination));
  return [...now!].flatMap(([key, figure]) => {
    const other = before!.get(key);
    if (!other) return [];
    return [{ ...figure, before: other.value, now: figure.value, change: changeOf(other.value, figure.value) }];
  });
}

type Figure = Pick<ComparedFigure, "label" | "symbol" | "unit"> & { value: string };

function figuresOf({ combinations, design }: Summary, name: string): Map<string, Figure> {
  const one: CombinationSummary | undefined = combinations.find((combination) => combination.name === name);
  const figures = new Map<string, Figure>();
  for (const section of one?.sections ?? [])
    for (const { label, symbol, unit, value } of section.rows)
      if (value !== null && value !== "" && Number.isFinite(Number(value)))
        figures.set(`${section.title} ${label} ${symbol} ${unit}`, { label, symbol, unit, value: String(value) });
  for (const check of design?.checks ?? [])
    if (check.utilization !== null)
      figures.set(say("check {check}", { check: check.name }), {
        label: say("utilization, {check}", { check: check.name }),
        symbol: "",
        unit: "",
        value: check.utilization.toFixed(2),
      });
  return figures;
}

export interface ReferenceHooks {
  /** A reference has been kept; returns its scene. */
  onKeep(): Scene | null;
  /** The picture of the reference is to be shown, null: that of the result. */
  onPicture(scene: Scene | null): void;
}

/** The button that keeps a result as reference, and the table of both. */
export class Reference {
  readonly keepButton = button("Keep as reference", "Compare later results with this one", () => this.keep());
  /** Shows the picture of the reference in place of that of the result, at the same zoom. */
  readonly pictureButton = button("Show reference", "Show the plot of the reference at the same zoom", () =>
    this.setPicture(this.pictureButton.getAttribute("aria-pressed") !== "true"),
  );
  readonly panel = h("div", { class: "lower-panel" });
  private scene: Scene | null = null;
  private summary: Summary | null = null;
  private shown: Summary | null = null;
  private combination = "";

  constructor(private readonly hooks: ReferenceHooks) {
    for (const control of [this.keepButton, this.pictureButton]) control.classList.add("small");
    this.setPicture(false);
  }

  /** Show the picture of the reference, or that of the result. */
  setPicture(on: boolean): void {
    const before = this.pictureButton.getAttribute("aria-pressed");
    this.pictureButton.setAttribute("aria-pressed", String(on));
    if (before === String(!on)) this.hooks.onPicture(on ? this.scene : null);
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
    const words = say(
      "Combination {combination}: nothing to compare. The reference has no combination of this name, or neither has figures.",
      { combination: verbatim(combination) },
    );
    fill(this.panel, this.pictureButton, figures.length > 0 ? table : h("p", { class: "empty" }, words));
  }

  /** Forget the reference, which belongs to another document. */
  forget(): void {
    this.scene = this.summary = this.shown = null;
  }

  private keep(): void {
    this.summary = this.shown;
    this.scene = this.hooks.onKeep();
    this.show(this.shown, this.combination);
  }
}

function makeRow({ label, symbol, unit, before, now, change }: ComparedFigure): HTMLElement {
  const difference = change === null ? "" : withMinus(`${change > 0 ? "+" : ""}${change.toFixed(1)} %`);
  const name = h("th", { scope: "row" }, label, symbol ? " " : null, symbol ? symbolElement(symbol) : null);
  const cells = [before, now, unit, difference].map((text) => h("td", { class: "figure" }, text));
  return h("tr", {}, name, ...cells);
}

// The color scale beside a picture, with unit and round ticks.
import { BEYOND, type ColorScale } from "../data/color-scale";
import { choiceName, isEnvelope, lineForceOf } from "../data/fields";
import { formatNumber, formatTicks } from "../data/numbers";
import type { Scene } from "../data/scene";
import type { ShownField } from "../data/shown-field";
import { type Child, fill, h } from "../shared/dom";
import { say, verbatim } from "../shared/language";
import type { Rgb } from "../shared/palette";
import { symbolElement } from "../shared/symbols";
import "./legend.css";

export class Legend {
  readonly element = h("div", { class: "gs-legend" });

  constructor(container: HTMLElement) {
    container.append(this.element);
  }

  /** Show the scale of what a view shows; null: nothing. */
  show(shown: ShownField | null, scene: Scene | null): void {
    this.element.hidden = !shown;
    if (!shown) return fill(this.element);
    const { field, scale, choice } = shown;
    const several = scene && scene.head.combinations.length > 1;
    const isAbove = scale.max > scale.levels.at(-1)! + BEYOND * scale.step;
    const isBelow = scale.min < scale.levels[0]! - BEYOND * scale.step;
    const edge = field.name === "pressure" && scene ? lineForceOf(scene, choice) : null;
    const edgeUnit = scene?.head.fields.find((each) => each.name === "line_force")?.unit ?? "";
    const hatch = h("span", { class: "gs-legend-hatch" });
    const notes: Child[][] = [
      [say("max {max}", { max: formatNumber(scale.max) })],
      [say("min {min}", { min: formatNumber(scale.min) })],
      edge ? [say("edge line force up to {force} {unit}", { force: formatNumber(edge[0]), unit: edgeUnit })] : [],
      isAbove ? [say("above the scale: up to {max} {unit}", { max: formatNumber(scale.max), unit: field.unit })] : [],
      isBelow ? [say("below the scale: down to {min} {unit}", { min: formatNumber(scale.min), unit: field.unit })] : [],
      shown.lifted ? [hatch, isEnvelope(choice) ? "no contact in some combination" : "no contact"] : [],
    ];
    fill(
      this.element,
      h("div", { class: "gs-legend-title", title: field.meaning }, symbolElement(field.symbol), ` [${field.unit}]`),
      several ? h("div", { class: "gs-legend-of" }, verbatim(choiceName(scene, choice))) : null,
      makeBar(scale, field.unit, isAbove, isBelow),
      h("div", { class: "gs-legend-notes" }, ...notes.map((note) => note.length > 0 && h("div", {}, ...note))),
    );
  }
}

/** Make the bar of bands, the highest on top. */
function makeBar(scale: ColorScale, unit: string, isAbove: boolean, isBelow: boolean): HTMLElement {
  const texts = levelTexts(scale);
  const count = scale.colors.length;
  const makeBand = (color: Rgb, ...texts: Child[]) =>
    h("div", { class: "gs-legend-band", style: `background:rgb(${color.join(" ")})` }, ...texts);
  const bands = scale.colors.map((color, i) =>
    makeBand(
      color,
      i < count - 1 || !isAbove ? h("span", {}, texts[i + 1]!) : null,
      i === 0 && !isBelow ? h("span", { class: "gs-legend-last" }, texts[0]!) : null,
    ),
  );
  const label = say("Colors from {min} to {max} {unit}", {
    min: formatNumber(scale.levels[0]!),
    max: formatNumber(scale.levels[count]!),
    unit,
  });
  return h(
    "div",
    { class: "gs-legend-bar", role: "img", "aria-label": label },
    isAbove ? makeBand(scale.over, h("span", {}, `> ${texts[count]!}`)) : null,
    ...bands.reverse(),
    isBelow ? makeBand(scale.under, h("span", {}, texts[0]!)) : null,
  );
}

/** Return the limits of the bands; ends that were cut are no round numbers and have decimals of their own. */
function levelTexts({ levels, origin, step }: ColorScale): string[] {
  const round = levels.map((_, i) => Number((origin + i * step).toPrecision(12)));
  return formatTicks(round).map((text, i) =>
    Math.abs(round[i]! - levels[i]!) > 1e-9 * step ? formatNumber(levels[i]!) : text,
  );
}

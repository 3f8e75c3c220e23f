// The colour scale beside a picture, with unit and round ticks.

import { BEYOND, css, number, type Scale, tickTexts } from "../data/color-scale";
import { choiceName, lineForceOf } from "../data/fields";
import type { Scene } from "../data/scene";
import type { Shown } from "../plan/plan-view";
import { make, symbol } from "../shared/dom";
import "./legend.css";

export class Legend {
  readonly element = make("div", { class: "gs-legend" });

  constructor(container: HTMLElement) {
    container.append(this.element);
  }

  /** Show the scale of what a view shows; null: nothing. */
  show(shown: Shown | null, scene: Scene | null): void {
    const { element } = this;
    element.replaceChildren();
    element.hidden = !shown;
    if (!shown) return;
    const { field, scale } = shown;
    element.append(
      make("div", { class: "gs-legend-title", title: field.meaning }, symbol(field.symbol), ` [${field.unit}]`),
    );
    if (scene && scene.head.combinations.length > 1)
      element.append(make("div", { class: "gs-legend-of" }, choiceName(scene, shown.choice)));
    const bar = make("div", {
      class: "gs-legend-bar",
      role: "img",
      "aria-label": `Colours from ${number(scale.levels[0]!)} to ${number(scale.levels[scale.levels.length - 1]!)} ${field.unit}`,
    });
    const count = scale.colours.length;
    const texts = levelTexts(scale);
    const [above, below] = [isAbove(shown), isBelow(shown)];
    if (above)
      bar.append(
        make(
          "div",
          { class: "gs-legend-band gs-legend-beyond", style: `background:${css(scale.over)}` },
          make("span", {}, `> ${texts[count]!}`),
        ),
      );
    for (let i = count - 1; i >= 0; i--) {
      const band = make("div", { class: "gs-legend-band", style: `background:${css(scale.colours[i]!)}` });
      if (i < count - 1 || !above) band.append(make("span", {}, texts[i + 1]!));
      if (i === 0 && !below) band.append(make("span", { class: "gs-legend-last" }, texts[0]!));
      bar.append(band);
    }
    if (below)
      bar.append(
        make(
          "div",
          { class: "gs-legend-band gs-legend-beyond", style: `background:${css(scale.under)}` },
          make("span", {}, texts[0]!),
        ),
      );
    element.append(bar);
    const notes = make("div", { class: "gs-legend-notes" });
    notes.append(make("div", {}, `largest ${number(scale.max)}`), make("div", {}, `smallest ${number(scale.min)}`));
    const edge = field.name === "pressure" && scene ? lineForceOf(scene, shown.choice) : null;
    if (edge) notes.append(make("div", {}, `edge line force up to ${number(edge[0])} kN/m`));
    if (above) notes.append(make("div", {}, `above the scale: up to ${number(scale.max)} ${field.unit}`));
    if (below) notes.append(make("div", {}, `below the scale: down to ${number(scale.min)} ${field.unit}`));
    if (shown.lifted)
      notes.append(
        make(
          "div",
          {},
          make("span", { class: "gs-legend-hatch" }),
          typeof shown.choice === "number" ? "no contact" : "no contact in some combination",
        ),
      );
    element.append(notes);
  }
}

/** Return the limits of the bands in words; ends that were cut are no round numbers and have decimals of their own. */
function levelTexts({ levels, origin, step }: Scale): string[] {
  const round = levels.map((_, i) => Number((origin + i * step).toPrecision(12)));
  return tickTexts(round).map((text, i) =>
    Math.abs(round[i]! - levels[i]!) > 1e-9 * step ? number(levels[i]!) : text,
  );
}

function isAbove({ scale }: Shown): boolean {
  return scale.max > scale.levels[scale.levels.length - 1]! + BEYOND * scale.step;
}

function isBelow({ scale }: Shown): boolean {
  return scale.min < scale.levels[0]! - BEYOND * scale.step;
}

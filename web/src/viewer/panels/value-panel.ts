// All values at a picked point.

import {
  type Choice,
  choiceName,
  fieldsOf,
  fieldValueAt,
  isDifference,
  isEnvelope,
  isInContact,
  principalDirection,
} from "../data/fields";
import { lengthsOf } from "../data/lengths";
import { formatNumber, withMinus } from "../data/numbers";
import type { LocalPoint, Locator } from "../data/point-location";
import type { Point, Scene } from "../data/scene";
import { thicknessText } from "../plan/symbols";
import { type Child, fill, h } from "../shared/dom";
import { say, verbatim } from "../shared/language";
import { symbolElement } from "../shared/symbols";
import "./value-panel.css";

export class ValuePanel {
  readonly element = h("div", { class: "gs-values", "aria-live": "polite" });
  /** A field's row was chosen. */
  onField?: (field: string) => void;

  constructor(container: HTMLElement) {
    container.append(this.element);
    this.showHint();
  }

  /** Show all values at a point; null: a hint how to pick one. `field` is the one that is drawn. */
  show(scene: Scene | null, locator: Locator | null, choice: Choice, point: Point | null, field?: string): void {
    if (!scene || !locator || !point) return this.showHint();
    const [x, y] = point;
    const { unit, per_meter } = lengthsOf(scene.head.plan);
    const lengthText = (value: number) => `${withMinus((value * per_meter).toFixed(3))} ${unit}`;
    const place = h("div", { class: "gs-values-at" }, `x ${lengthText(x)}, y ${lengthText(y)}`);
    const spot = locator.locate(x, y);
    if (!spot) return fill(this.element, place, h("p", {}, "This point is not on the plate."));
    const rows = fieldsOf(scene).map((info) => {
      const found = fieldValueAt(scene, locator, choice, info.name, spot);
      const row = makeRow(info.symbol, info.meaning, formatNumber(found.value), info.unit);
      const from = scene.head.combinations[found.from];
      if (isEnvelope(choice))
        row.append(h("td", { class: "gs-from", title: verbatim(from?.name ?? "") }, `(${from?.number ?? ""})`));
      row.classList.toggle("gs-chosen", info.name === field);
      this.listenOn(row, info.name);
      return row;
    });
    if (!isEnvelope(choice) && !isDifference(scene) && fieldsOf(scene).some((each) => each.name === "m_1")) {
      const [mx, my, mxy] = ["moment_x", "moment_y", "moment_xy"].map(
        (name) => fieldValueAt(scene, locator, choice, name, spot).value,
      ) as [number, number, number];
      const direction = formatNumber(principalDirection(mx, my, mxy), 3);
      rows.push(makeRow("phi_1", "direction of m_1, from x", direction, "°"));
    }
    fill(
      this.element,
      place,
      h("div", { class: "gs-values-of" }, verbatim(choiceName(scene, choice))),
      h("table", {}, h("tbody", {}, ...rows)),
      h("div", { class: "gs-values-notes" }, ...makeNotes(scene, locator, choice, spot)),
    );
  }

  /** Let a click or Enter on a row choose its field. */
  private listenOn(row: HTMLElement, name: string): void {
    const { onField } = this;
    if (!onField) return;
    row.tabIndex = 0;
    row.addEventListener("click", () => onField(name));
    row.addEventListener("keydown", (event) => {
      if (event.key === "Enter") onField(name);
    });
  }

  private showHint(): void {
    fill(this.element, h("p", { class: "gs-values-hint" }, "Click the plate to read all values at that point."));
  }
}

function makeRow(symbol: string, meaning: string, value: string, unit: string): HTMLTableRowElement {
  const name = h("th", { scope: "row" }, symbolElement(symbol));
  return h("tr", { title: meaning }, name, h("td", {}, value), h("td", { class: "gs-unit" }, unit));
}

function makeNotes(scene: Scene, locator: Locator, choice: Choice, spot: LocalPoint): Child[] {
  const contact = isInContact(scene, locator, choice, spot);
  const no = isEnvelope(choice) ? "not in every combination" : "no";
  const section = sectionText(scene, spot.element);
  const governing = "In parentheses: the number of the governing combination; hover over it for its name.";
  return [
    contact !== null && h("div", {}, say("contact: {contact}", { contact: contact ? "yes" : no })),
    section !== "" && h("div", {}, section),
    isEnvelope(choice) && h("div", { class: "gs-screen" }, governing),
  ];
}

/** Return which section of the plate an element belongs to. */
function sectionText({ head: { plan }, mesh }: Scene, element: number): string {
  const position = mesh.section?.[element];
  if (position === undefined) return "";
  // sections count from slab to slab: each one's own, then those of its zones
  const first = { name: "plate", thickness: plan.thickness, zones: plan.zones };
  const all = [first, ...(plan.plates ?? [])].flatMap((plate) => [
    { name: plate.name, thickness: plate.thickness },
    ...plate.zones.map((zone, n) => ({
      name: zone.name ?? say("zone {number}", { number: n + 1 }),
      thickness: zone.thickness,
    })),
  ]);
  const { name, thickness } = all[position] ?? { name: "plate", thickness: plan.thickness };
  if (thickness === undefined) return say("section: {name}", { name });
  return say("section: {name}, {thickness}", { name, thickness: thicknessText(thickness, lengthsOf(plan)) });
}

// All values at a picked point.

import { neat, number } from "../data/color-scale";
import { type Choice, choiceName, direction, fieldsOf, inContact, isEnvelope, valueAt } from "../data/fields";
import type { Locator } from "../data/point-location";
import type { Point, Scene } from "../data/scene";
import { make, symbol } from "../shared/dom";
import "./value-panel.css";

export class ValuePanel {
  readonly element = make("div", { class: "gs-values", "aria-live": "polite" });
  /** A field's row was chosen. */
  onField?: (field: string) => void;

  constructor(container: HTMLElement) {
    container.append(this.element);
    this.hint();
  }

  /** Show all values at a point; null: how to get them. `field` is the one that is drawn. */
  show(scene: Scene | null, locator: Locator | null, choice: Choice, point: Point | null, field?: string): void {
    const { element } = this;
    if (!scene || !locator || !point) return this.hint();
    element.replaceChildren();
    const [x, y] = point;
    element.append(make("div", { class: "gs-values-at" }, `x ${metres(x)} m, y ${metres(y)} m`));
    const spot = locator.at(x, y);
    if (!spot) {
      element.append(make("p", {}, "This point is not on the plate."));
      return;
    }
    const several = isEnvelope(choice);
    element.append(make("div", { class: "gs-values-of" }, choiceName(scene, choice)));
    const rows = make("tbody", {});
    for (const info of fieldsOf(scene)) {
      const found = valueAt(scene, locator, choice, info.name, spot);
      const row = make(
        "tr",
        { title: info.meaning },
        make("th", { scope: "row" }, symbol(info.symbol)),
        make("td", {}, number(found.value)),
        make("td", { class: "gs-unit" }, info.unit),
      );
      if (several)
        row.append(
          make(
            "td",
            { class: "gs-from", title: scene.head.combinations[found.from]?.name ?? "" },
            `(${scene.head.combinations[found.from]?.number ?? ""})`,
          ),
        );
      if (info.name === field) row.classList.add("gs-chosen");
      if (this.onField) {
        row.tabIndex = 0;
        row.addEventListener("click", () => this.onField?.(info.name));
        row.addEventListener("keydown", (event) => {
          if (event.key === "Enter") this.onField?.(info.name);
        });
      }
      rows.append(row);
    }
    if (!several) {
      const moment = (name: string) => valueAt(scene, locator, choice, name, spot).value;
      if (fieldsOf(scene).some((each) => each.name === "m_1"))
        rows.append(
          make(
            "tr",
            { title: "direction of the strips that m_1 bends, from x" },
            make("th", { scope: "row" }, symbol("phi_1")),
            make("td", {}, number(direction(moment("moment_x"), moment("moment_y"), moment("moment_xy")), 3)),
            make("td", { class: "gs-unit" }, "°"),
          ),
        );
    }
    element.append(make("table", {}, rows));
    const notes = make("div", { class: "gs-values-notes" });
    const contact = inContact(scene, locator, choice, spot);
    if (contact !== null)
      notes.append(make("div", {}, `contact: ${contact ? "yes" : several ? "not in every combination" : "no"}`));
    const section = sectionText(scene, spot.element);
    if (section) notes.append(make("div", {}, section));
    if (several)
      notes.append(
        make(
          "div",
          { class: "gs-screen" },
          "In brackets: the number of the combination that governs; hold the pointer over it for its name.",
        ),
      );
    element.append(notes);
  }

  private hint(): void {
    this.element.replaceChildren(
      make("p", { class: "gs-values-hint" }, "Click on the plate to read all values there."),
    );
  }
}

/** Return which section of the plate an element belongs to, in words. */
export function sectionText(scene: Scene, element: number): string {
  const { plan } = scene.head;
  const of = scene.mesh.section?.[element];
  if (of === undefined) return "";
  const zone = of > 0 ? plan.zones[of - 1] : undefined;
  const thickness = zone ? zone.thickness : plan.thickness;
  const name = zone ? (zone.name ?? `zone ${of}`) : "plate";
  return thickness === undefined ? `section: ${name}` : `section: ${name}, t = ${neat(thickness * 1000)} mm`;
}

function metres(value: number): string {
  return value.toFixed(3).replace(/-/, "\u2212");
}

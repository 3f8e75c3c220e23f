// The underlay's button in the corner of the plan: whether it is shown, its unit, and where it lies.

import { button, h, newId } from "../../../viewer/shared/dom";
import { verbatim } from "../../../viewer/shared/language";
import type { Store } from "../../client/store";
import { formatDecimals, parseTyped } from "../../model/quantities";
import { type Underlay, unitsFor } from "../../model/survey";
import "./underlay.css";

/** Return the button with its fields, hidden where there is no underlay; the canvas shows what they say. */
export function underlayBar(store: Store, canvas: { showUnderlay(underlay: Underlay | null): void }): HTMLElement {
  const fields = h("div", { class: "underlay-fields", id: newId("underlay"), role: "group", "aria-label": "underlay" });
  const toggle = button("Underlay", "The drawing under the plan", () => open(fields.hidden === true), "small");
  toggle.setAttribute("aria-controls", fields.id);
  const element = h("div", { class: "underlay-bar", hidden: true }, toggle, fields);
  const open = (isOpen: boolean) => {
    fields.hidden = !isOpen;
    toggle.setAttribute("aria-expanded", String(isOpen));
  };
  const change = (changes: Partial<Underlay>) => {
    if (store.underlay) store.set("underlay", { ...store.underlay, ...changes });
  };
  element.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || fields.hidden) return;
    open(false);
    toggle.focus();
  });
  let known: Underlay["survey"] | null = null;
  store.on(["underlay"], () => {
    const { underlay } = store;
    canvas.showUnderlay(underlay);
    element.hidden = underlay === null;
    // fields stay while their underlay does, so that none loses the focus
    if (underlay && underlay.survey !== known) fields.replaceChildren(...makeFields(store, underlay, change));
    known = underlay?.survey ?? null;
  });
  open(false);
  return element;
}

function makeFields(store: Store, underlay: Underlay, change: (changes: Partial<Underlay>) => void): HTMLElement[] {
  const shown = h("input", { type: "checkbox", checked: underlay.shown });
  shown.addEventListener("change", () => change({ shown: shown.checked }));
  const units = unitsFor(underlay.survey).map((name) =>
    h("option", { value: name, selected: name === underlay.unit }, verbatim(name)),
  );
  const unit = h("select", {}, ...units);
  unit.addEventListener("change", () => change({ unit: unit.value }));
  return [
    h("p", { class: "underlay-name", title: underlay.name }, underlay.name),
    h("label", {}, shown, "shown"),
    h("label", {}, "unit", unit),
    h("label", {}, "x", offsetInput(store, 0, change), "m"),
    h("label", {}, "y", offsetInput(store, 1, change), "m"),
    button("Remove", "Remove the drawing", () => store.set("underlay", null), "small"),
  ];
}

/** Return the field of a coordinate of the drawing's origin on the plan. */
function offsetInput(store: Store, axis: 0 | 1, change: (changes: Partial<Underlay>) => void): HTMLInputElement {
  const present = () => formatDecimals(store.underlay?.offset[axis] ?? 0, 6);
  const title = axis === 0 ? "x of the drawing's origin on the plan" : "y of the drawing's origin on the plan";
  const input = h("input", { type: "text", title, "aria-label": title, value: present(), spellcheck: "false" });
  input.addEventListener("change", () => {
    const value = parseTyped(input.value);
    const { underlay } = store;
    if (value !== null && underlay) {
      const [x, y] = underlay.offset;
      change({ offset: axis === 0 ? [value, y] : [x, value] });
    }
    input.value = present();
  });
  return input;
}

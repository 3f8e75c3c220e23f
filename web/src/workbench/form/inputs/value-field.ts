// One key of a part as a row: what it is called, its element, what it means, what is wrong with it.

import { type Path, pathKey } from "../../model/paths";
import type { Field } from "../../model/schema";
import { h, newId } from "../../shell/elements";
import type { FormContext, Widget } from "../context";
import { labelOf, symbolElement } from "../labels";
import { placesInput } from "./coordinates";
import { factorsInput } from "./factors";
import { type Input, inputFor, revealIn, showFaults } from "./inputs";

/** The row of a key that holds a value. */
export function valueField(ctx: FormContext, path: Path, field: Field): Widget {
  const input = elementFor(ctx, path, field);
  const messages = h("div", { class: "messages", id: newId("fault") });
  const hint = h("span", { class: "hint", id: newId("hint") }, furtherHint(field));
  const label = h("label", { class: field.needed ? "label needed" : "label" }, ...labelParts(field));
  name(input, label);
  input.focus.setAttribute("aria-describedby", `${hint.id} ${messages.id}`);
  const tall = field.node.is === "places" || field.node.is === "factors";
  const element = h(
    "div",
    { class: tall ? "field tall" : "field", "data-path": pathKey(path), title: hintOf(field) },
    label,
    input.element,
    hint,
    messages,
  );
  const update = () => {
    input.update();
    showFaults(ctx, path, element, input.focus, messages);
  };
  return { element, update, reveal: (target) => revealIn(input, path, target, element) };
}

/** A key's element alone, for a cell of a table; the message stands below the table's row. */
export function cellField(ctx: FormContext, path: Path, field: Field, label: string): Widget {
  const input = elementFor(ctx, path, field);
  input.focus.setAttribute("aria-label", label);
  const messages = h("div", { class: "messages", id: newId("fault") });
  input.focus.setAttribute("aria-describedby", messages.id);
  const element = h("div", { class: "cell", "data-path": pathKey(path) }, input.element, messages);
  const update = () => {
    input.update();
    showFaults(ctx, path, element, input.focus, messages);
  };
  return { element, update, reveal: (target) => revealIn(input, path, target, element) };
}

/** The words and the symbol of a key. */
export function labelParts(field: Field): (Node | string)[] {
  const words = labelOf(field);
  const symbol =
    field.symbol && field.symbol !== words && !field.symbol.includes(",") ? symbolElement(field.symbol) : null;
  const shown = words || (symbol ? "" : field.name);
  return [shown, ...(shown && symbol ? [" "] : []), ...(symbol ? [symbol] : [])];
}

/** What the label does not say yet. */
function furtherHint(field: Field): string {
  return labelOf(field).toLowerCase() === field.hint.toLowerCase() ? field.range : hintOf(field);
}

/** What a key means and what it may be. */
export function hintOf(field: Field): string {
  return field.range ? `${field.hint} (${field.range})` : field.hint;
}

function elementFor(ctx: FormContext, path: Path, field: Field): Input {
  if (field.node.is === "places") return placesInput(ctx, path, field.node.each);
  if (field.node.is === "factors") return factorsInput(ctx, path);
  return inputFor(ctx, path, field);
}

function name(input: Input, label: HTMLLabelElement): void {
  label.id = newId("label");
  if (input.focus.id === "") input.focus.id = newId("input");
  if (input.element.matches("input, select, .with-names")) label.htmlFor = input.focus.id;
  else {
    input.element.setAttribute("role", "group");
    input.element.setAttribute("aria-labelledby", label.id);
  }
}

// One key of a part as a row: label, input, hint, issues.

import { h, newId, setRead } from "../../../viewer/shared/dom";
import { type Path, pathKey } from "../../model/paths";
import type { Field } from "../../model/schema";
import type { FormContext, Widget } from "../context";
import { furtherHint, hintOf, labelParts } from "../labels";
import { pointsInput } from "./coordinates";
import { factorsInput } from "./factors";
import { type Input, inputCell, inputFor, inputWidget } from "./inputs";

/** The row of a key that holds a value. */
export function valueField(ctx: FormContext, path: Path, field: Field): Widget {
  const input = makeInput(ctx, path, field);
  const messages = h("div", { class: "messages", id: newId("issue") });
  const hint = h("span", { class: "hint", id: newId("hint") }, furtherHint(field));
  const label = h("label", { class: field.needed ? "label needed" : "label" }, ...labelParts(field));
  tieLabel(input, label);
  input.focus.setAttribute("aria-describedby", `${hint.id} ${messages.id}`);
  const tall = field.node.is === "points" || field.node.is === "factors";
  const attributes = { class: tall ? "field tall" : "field", "data-path": pathKey(path), title: hintOf(field) };
  const element = h("div", attributes, label, input.element, hint, messages);
  return inputWidget(ctx, path, input, element, messages);
}

/** A key's input alone, for a cell of a table; other messages stand at the end of the row. */
export function cellField(ctx: FormContext, path: Path, field: Field, label: string): Widget {
  const input = makeInput(ctx, path, field);
  setRead(input.focus, "aria-label", label);
  return inputCell(ctx, path, input);
}

function makeInput(ctx: FormContext, path: Path, field: Field): Input {
  if (field.node.is === "points") return pointsInput(ctx, path, field.node.each);
  if (field.node.is === "factors") return factorsInput(ctx, path);
  return inputFor(ctx, path, field);
}

function tieLabel(input: Input, label: HTMLLabelElement): void {
  label.id = newId("label");
  if (input.focus.id === "") input.focus.id = newId("input");
  if (input.element.matches("input, select, .with-names, .with-reset:not(:has([role=group]))"))
    label.htmlFor = input.focus.id;
  else {
    input.element.setAttribute("role", "group");
    input.element.setAttribute("aria-labelledby", label.id);
  }
}

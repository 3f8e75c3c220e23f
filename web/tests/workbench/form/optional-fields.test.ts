// @vitest-environment happy-dom
// Every optional key that the form can set, it can put back: the case is then as it was before.
import { beforeEach, describe, expect, it, vi } from "vitest";
import source from "../../../../docs/groundslab.schema.json?raw";
import type { FormContext } from "../../../src/workbench/form/context";
import { valueField } from "../../../src/workbench/form/inputs/value-field";
import { applyOptimistic } from "../../../src/workbench/model/changes/optimistic-edits";
import { type Path, type Table, valueAt } from "../../../src/workbench/model/paths";
import { exampleOf, type Field, type Node } from "../../../src/workbench/model/schema";
import { schema } from "../schema";

const { definitions } = JSON.parse(source) as { definitions: Record<string, unknown> };
const SINGLE: ReadonlySet<Node["is"]> = new Set([
  ...(["quantity", "number", "integer", "text", "choice", "boolean", "choices", "tuple", "values"] as const),
]);
const optional = Object.keys(definitions).flatMap((name) =>
  schema
    .part(name)
    .fields.flatMap((field): [string, Field][] =>
      !field.needed && SINGLE.has(field.node.is) ? [[`${name}.${field.name}`, field]] : [],
    ),
);

/** Return the field of a key in a table that has no keys, and its data. */
function show(field: Field) {
  const path: Path = ["table", field.name];
  const state: { data: Table } = { data: { table: {} } };
  const ctx: FormContext = {
    schema,
    memory: new Map(),
    data: () => state.data,
    issues: () => [],
    change: ({ edits }) => {
      state.data = edits.reduce(applyOptimistic, state.data);
      widget.update();
    },
  };
  const widget = valueField(ctx, path, field);
  document.body.replaceChildren(widget.element);
  widget.update();
  return { element: widget.element, value: () => valueAt(state.data, path) };
}

function type(input: HTMLInputElement, text: string): void {
  input.value = text;
  input.dispatchEvent(new Event("input"));
  vi.runAllTimers();
  input.dispatchEvent(new Event("change"));
  input.blur();
}

/** Set a field to something else than its default. */
function set(field: Field, element: HTMLElement): void {
  const { node } = field;
  const select = element.querySelector("select");
  const boxes = [...element.querySelectorAll<HTMLInputElement>("input[type=checkbox]")];
  if (select && node.is === "choice") {
    select.value = node.options.find((option) => option !== field.default)!;
    select.dispatchEvent(new Event("change"));
  } else if (boxes.length > 0) boxes.at(-1)!.click();
  else {
    const each = node.is === "tuple" || node.is === "values" ? node.each : node;
    const text = exampleOf(each, {}) || (each.is === "text" ? "a" : "0.37");
    for (const input of element.querySelectorAll("input")) type(input, text);
  }
}

/** Put a field back: by its button, or by emptying it. */
function putBack(element: HTMLElement): void {
  const reset = element.querySelector<HTMLButtonElement>("button.reset:not([hidden])");
  if (reset) reset.click();
  else for (const input of element.querySelectorAll("input")) type(input, "");
}

beforeEach(() => void vi.useFakeTimers());

describe("an optional key", () => {
  it("is one of many", () => {
    expect(optional.map(([name]) => name)).toEqual(
      expect.arrayContaining(["Reinforcement.size_effect", "LoadCase.category", "Mesh.accuracy"]),
    );
  });

  it.each(optional)("%s can be put back", (_, field) => {
    const { element, value } = show(field);
    expect(element.querySelector("button.reset:not([hidden])")).toBeNull();
    set(field, element);
    expect(value()).toBeDefined();
    putBack(element);
    expect(value()).toBeUndefined();
  });
});

// @vitest-environment happy-dom
// A new load case is asked for its action, and where loads belong that had no case.
import { beforeEach, expect, test, vi } from "vitest";
import { Store } from "../../../src/workbench/client/store";
import { addLoadCase } from "../../../src/workbench/model/changes/new-items";
import { applyOptimistic } from "../../../src/workbench/model/changes/optimistic-edits";
import type { Change } from "../../../src/workbench/model/edits";
import type { Table } from "../../../src/workbench/model/paths";
import { caseChoice } from "../../../src/workbench/plan/loads";

const WEIGHT = { kind: "self weight", unit_weight: "25 kN/m^3" };

function plan(data: Table) {
  const store = new Store();
  vi.spyOn(store, "data", "get").mockReturnValue(data);
  vi.spyOn(store, "broken", "get").mockReturnValue(false);
  const [push, onChoose] = [vi.fn<(change: Change) => void>(), vi.fn()];
  const choice = caseChoice(store, push, onChoose);
  document.body.replaceChildren(choice.element);
  choice.update();
  const field = <T extends HTMLElement>(label: string) => document.querySelector<T>(`[aria-label="${label}"]`)!;
  const type = (label: string, value: string, key = "") => {
    const element = field<HTMLInputElement>(label);
    element.value = value;
    element.dispatchEvent(key ? new KeyboardEvent("keydown", { key, bubbles: true }) : new Event("change"));
  };
  document.querySelector<HTMLButtonElement>("button")!.click();
  const after = () => push.mock.calls.flatMap(([change]) => change.edits).reduce(applyOptimistic, data);
  return { push, onChoose, field, type, after };
}

beforeEach(() => document.body.replaceChildren());

test("a case typed as Q is not made before its action is chosen", () => {
  const { push, field, type, after } = plan({});
  type("name of the new load case", "Q", "Enter");
  expect(push).not.toHaveBeenCalled();
  expect(document.activeElement).toBe(field("action of the new load case"));
  type("action of the new load case", "variable");
  expect(after()).toEqual({ cases: [{ name: "Q", action: "variable" }] });
});

test("loads that had no case go to a permanent one of their own, if that is chosen", () => {
  const { push, field, type, after } = plan({ loads: [WEIGHT] });
  type("name of the new load case", "Q", "Enter");
  type("action of the new load case", "variable");
  expect(push).not.toHaveBeenCalled();
  expect(document.activeElement).toBe(field("loads without a case"));
  type("loads without a case", "apart");
  expect(after()).toEqual({
    cases: [
      { name: "permanent", action: "permanent" },
      { name: "Q", action: "variable" },
    ],
    loads: [{ ...WEIGHT, case: "permanent" }],
  });
});

test("or to the new one", () => {
  const { type, after } = plan({ loads: [WEIGHT] });
  type("name of the new load case", "permanent", "Enter");
  type("action of the new load case", "permanent");
  type("loads without a case", "in it");
  const named = { name: "permanent", action: "permanent" };
  expect(after()).toEqual({ cases: [named], loads: [{ ...WEIGHT, case: "permanent" }] });
});

test("a case that is there is chosen, and Escape makes none", () => {
  const data = { cases: [{ name: "G" }] };
  const first = plan(data);
  first.type("name of the new load case", "G", "Enter");
  expect(first.onChoose).toHaveBeenLastCalledWith("G");
  const second = plan(data);
  second.type("name of the new load case", "Q", "Escape");
  expect(first.push.mock.calls.length + second.push.mock.calls.length).toBe(0);
  expect(second.field("name of the new load case").parentElement?.hidden).toBe(true);
});

test("without a name a case is called as is usual, and a permanent one takes the loads there are", () => {
  const { type, after } = plan({ loads: [WEIGHT] });
  type("action of the new load case", "permanent");
  expect(after()).toEqual({ cases: [{ name: "G", action: "permanent" }], loads: [{ ...WEIGHT, case: "G" }] });
  const second = plan({ cases: [{ name: "G" }, { name: "Q", action: "variable" }] });
  second.type("action of the new load case", "B");
  expect(second.after().cases).toContainEqual({ name: "Q 2", action: "variable", category: "B" });
});

test("a second case is asked again", () => {
  const { push, type } = plan({ cases: [{ name: "G" }] });
  type("name of the new load case", "Q", "Enter");
  type("action of the new load case", "variable");
  document.querySelector<HTMLButtonElement>(".case-choice > button")!.click();
  type("name of the new load case", "W", "Enter");
  expect(push).toHaveBeenCalledOnce();
});

test("beside other cases loads without one are left to the user", () => {
  const data = { cases: [{ name: "G" }], loads: [WEIGHT] };
  expect(addLoadCase(data, "Q", { action: "variable" }).edits).toEqual([
    { op: "add", path: ["cases"], value: { name: "Q", action: "variable" } },
  ]);
});

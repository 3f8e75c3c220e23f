// @vitest-environment happy-dom
// Buttons that repair: one change each, named after the repair; renamed keys are foreseen.
import { expect, test, vi } from "vitest";
import { repairButtons } from "../../../src/workbench/form/repairs";
import { applyOptimistic } from "../../../src/workbench/model/changes/optimistic-edits";
import type { Issue } from "../../../src/workbench/model/issues";

const issue: Issue = {
  location: "beyond.width",
  path: ["beyond", "width"],
  found: "2 m",
  expected: "no width",
  hint: "",
  repairs: [
    { label: "remove width", edits: [{ op: "remove", path: ["beyond", "width"] }] },
    { label: 'set kind to "margin"', edits: [{ op: "set", path: ["beyond", "kind"], value: "margin" }] },
  ],
};

test("a click makes one change with the edits of the repair", () => {
  const [push, done] = [vi.fn(), vi.fn()];
  const buttons = repairButtons(issue, push, done)?.querySelectorAll("button") ?? [];
  expect([...buttons].map((each) => each.textContent)).toEqual(["Remove width", 'Set kind to "margin"']);
  buttons[0]?.click();
  const edits = issue.repairs?.[0]?.edits;
  expect(push.mock.calls).toEqual([[{ edits, text: "remove width (beyond.width)" }]]);
  expect(done).toHaveBeenCalledOnce();
});

test("without repairs there are no buttons", () => {
  expect(repairButtons({ ...issue, repairs: [] }, vi.fn(), vi.fn())).toBeNull();
});

test("a quantity on a button keeps its letters", () => {
  const unit = { label: "200 kN", edits: [] };
  expect(repairButtons({ ...issue, repairs: [unit] }, vi.fn(), vi.fn())?.textContent).toBe("200 kN");
});

test("a key that is renamed is foreseen with what it holds", () => {
  const data = { plate: { thicknes: "250 mm", E: "30 GPa" } };
  const renamed = applyOptimistic(data, { op: "rename", path: ["plate", "thicknes"], value: "thickness" });
  expect(renamed).toEqual({ plate: { thickness: "250 mm", E: "30 GPa" } });
  expect(applyOptimistic(data, { op: "rename", path: ["plate", "nothing"], value: "x" })).toBe(data);
});

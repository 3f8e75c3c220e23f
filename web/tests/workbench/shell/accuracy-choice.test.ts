// @vitest-environment happy-dom
// The accuracy beside Solve: what each costs in words, and what is sent.
import { beforeEach, expect, test, vi } from "vitest";
import type { Costs } from "../../../src/workbench/client/api";
import { Store } from "../../../src/workbench/client/store";
import { AccuracyChoice, costText, timeText } from "../../../src/workbench/shell/accuracy-choice";
import { FakeApi } from "../fake-api";

const COSTS: Costs = {
  "": { unknowns: 39_684, meshes: 2, combinations: 12, seconds: 8.2 },
  draft: { unknowns: 25_000, meshes: 1, combinations: 12, seconds: 4 },
  normal: { unknowns: 39_684, meshes: 2, combinations: 12, seconds: 8.2 },
  strict: { unknowns: 61_000, meshes: 3, combinations: 12, seconds: 131 },
};

let store: Store;
const setAccuracy = vi.fn(async (_: string) => undefined);
const hooks = { settle: async () => {}, onLost: () => {} };

function choice(model: object): HTMLSelectElement {
  vi.useFakeTimers();
  const { element } = new AccuracyChoice(store, { costs: async () => COSTS, setAccuracy }, hooks);
  store.setDoc(new FakeApi(model as never).present());
  return element.querySelector("select")!;
}

beforeEach(() => {
  store = new Store();
  setAccuracy.mockClear();
});

test("estimates are told no more exactly than they are", () => {
  expect([0.5, 8.2, 43, 131, 1900].map(timeText)).toEqual([
    "about 1 s",
    "about 8 s",
    "about 45 s",
    "about 2 min",
    "about 30 min",
  ]);
  expect(costText(COSTS[""]!)).toBe("about 8 s, 40,000 unknowns, 12 combinations, 2 meshes");
});

test("each accuracy says how long it takes once that is known, and the one of the case is sent as none", async () => {
  const select = choice({ plate: {} });
  const labels = () => [...select.options].map((option) => option.textContent);
  expect(labels()).toEqual(["Draft (15 %)", "Normal (5 %)", "Strict (2 %)"]);
  await vi.advanceTimersByTimeAsync(600);
  expect(labels()).toEqual(["Draft (15 %): about 4 s", "Normal (5 %): about 8 s", "Strict (2 %): about 2 min"]);
  expect(select.parentElement?.querySelector(".cost")?.textContent).toBe("40,000 unknowns, 12 combinations");
  for (const value of ["draft", "normal"]) {
    select.value = value;
    select.dispatchEvent(new Event("change"));
    await vi.advanceTimersByTimeAsync(0);
  }
  expect(setAccuracy.mock.calls).toEqual([["draft"], [""]]);
});

test("a share of the case is one more choice, and a mesh of the case the only one", () => {
  expect([...choice({ mesh: { accuracy: "3 %" } }).options].map(({ value }) => value)).toEqual([
    "3 %",
    "draft",
    "normal",
    "strict",
  ]);
  const select = choice({ mesh: { size: "0.5 m" } });
  expect(select.disabled).toBe(true);
  expect(select.title).toMatch(/^The case gives the size/);
});

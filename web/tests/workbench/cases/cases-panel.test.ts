// @vitest-environment happy-dom
// The panel of load cases: rows, sums, faults, and the matrix, of which the rows in view are in the page.
import { beforeEach, expect, test, vi } from "vitest";
import { casesPanel } from "../../../src/workbench/cases/cases-panel";
import type { DocState } from "../../../src/workbench/client/api";
import { Store } from "../../../src/workbench/client/store";
import type { FormContext } from "../../../src/workbench/form/context";
import { applyOptimistic } from "../../../src/workbench/model/changes/optimistic-edits";
import type { Table } from "../../../src/workbench/model/paths";
import { schema } from "../schema";

vi.stubGlobal(
  "ResizeObserver",
  class {
    observe() {}
  },
);

function show(data: Table, more: Partial<DocState> = {}) {
  const store = new Store();
  store.setDoc({ version: 1, text: "", data, issues: [], plan: null, ...more } as DocState);
  const ctx: FormContext = {
    schema,
    memory: new Map(),
    data: () => store.data,
    issues: () => [],
    change: (change) => {
      store.setDoc({ ...store.doc!, data: change.edits.reduce(applyOptimistic, store.data) });
      panel.update();
    },
  };
  const panel = casesPanel(store, ctx);
  document.body.replaceChildren(panel.element);
  panel.update();
  const field = <T extends HTMLElement>(label: string) => document.querySelector<T>(`[aria-label="${label}"]`)!;
  const change = (label: string, value: string) => {
    const element = field<HTMLInputElement>(label);
    element.value = value;
    element.dispatchEvent(new Event("change"));
  };
  return { store, field, change };
}

/** After a change rows are drawn once the focus has moved. */
const drawn = () => new Promise((resolve) => setTimeout(resolve));

beforeEach(() => document.body.replaceChildren());

test("cases are made of a name and a type, renamed, retyped, and moved by keys", async () => {
  const { store, field, change } = show({ loads: [{ kind: "uniform", q: "1 kPa" }] });
  change("name of a new case", "dead");
  document.querySelector<HTMLButtonElement>(".case-add button")!.click();
  expect(store.data).toEqual({
    loads: [{ kind: "uniform", q: "1 kPa", case: "dead" }],
    cases: [{ name: "dead", action: "permanent" }],
  });
  expect(document.querySelector(".cases-warning")!.textContent).toContain("No case is variable");
  change("type of a new case", "snow");
  change("name of a new case", "S");
  document.querySelector<HTMLButtonElement>(".case-add button")!.click();
  expect(document.querySelector<HTMLElement>(".cases-warning")!.hidden).toBe(true);
  expect(document.querySelector(".case-notes")!.textContent).toContain("No loads yet");
  expect(document.querySelector(".flagged")).toBeNull(); // it has just been made
  change("name of case 1", "G");
  change("type of case 2", "wind");
  await drawn();
  const handle = field("move case S");
  handle.focus();
  handle.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowUp", altKey: true, bubbles: true }));
  expect(store.data).toEqual({
    loads: [{ kind: "uniform", q: "1 kPa", case: "G" }],
    cases: [
      { name: "S", action: "variable", category: "wind" },
      { name: "G", action: "permanent" },
    ],
  });
  expect(document.activeElement?.getAttribute("aria-label")).toBe("move case S");
});

test("a field that is typed into stays while the case changes elsewhere", () => {
  const { store, field } = show({ cases: [{ name: "G" }] });
  const name = field<HTMLInputElement>("name of case 1");
  name.focus();
  name.value = "de";
  store.setDoc({ ...store.doc!, data: { ...store.data, title: "x" } });
  expect(document.activeElement).toBe(name);
  expect(name.value).toBe("de");
});

test("of hundreds of combinations those in view are in the page; factors that are listed can be edited", async () => {
  const made = Array.from({ length: 500 }, (_, n) => ({
    name: `ULS ${n + 1}`,
    limit_state: n % 2 === 0 ? "ultimate" : "characteristic",
    rule: "EN 1990 6.10",
    factors: { G: 1.35 },
  }));
  const sums = { about: [0, 0], length: "m", force: "kN", moment: "kNm", cases: [], made } as DocState["cases"];
  const data: Table = { cases: [{ name: "G" }], combinations: [{ name: "mine", factors: { G: 2 } }] };
  const { store, field, change } = show(data, { cases: sums! });
  expect(document.querySelectorAll(".matrix tbody tr:not(.space)").length).toBeLessThan(60);
  expect(document.querySelector(".matrix-part [role=status]")!.textContent).toBe("501 of 501 shown");
  change("factor of G in mine", "1,2");
  expect(store.data.combinations).toEqual([{ name: "mine", factors: { G: 1.2 } }]);
  await drawn();
  change("limit state shown", "characteristic");
  expect(document.querySelector(".matrix-part [role=status]")!.textContent).toBe("250 of 501 shown");
  expect(field("factor of G in mine")).toBeNull();
});

test("a case that moves says at how many positions combinations are solved, the first and the last", () => {
  const moving = { name: "truck", F: 1, M_x: 0, M_y: 0, acts: true };
  const positions = ["truck at 0.00 m", "truck at 1.00 m", "truck at 1.50 m"];
  const cases = [
    { ...moving, positions },
    { ...moving, name: "G", positions: [] },
  ];
  const sums = { about: [0, 0], length: "m", force: "kN", moment: "kNm", cases, made: [] } as DocState["cases"];
  show({ cases: [{ name: "G" }, { name: "truck" }] }, { cases: sums! });
  const [, , own, other] = document.querySelectorAll<HTMLElement>(".matrix thead th");
  expect(own!.textContent).toBe("G");
  expect(other!.textContent).toBe("truck3 positionsat 0.00 m … at 1.50 m");
  expect(other!.title).toBe("truck\nat 0.00 m\nat 1.00 m\nat 1.50 m");
});

test("limit states and factors of made combinations are edited beside them", () => {
  const { store } = show({ cases: [{ name: "G" }], combine: { sets: ["ultimate"] } });
  const rules = document.querySelector<HTMLDetailsElement>(".rules")!;
  expect(rules.hidden).toBe(false);
  const box = rules.querySelector<HTMLInputElement>('input[value="frequent"]')!;
  box.checked = true;
  box.dispatchEvent(new Event("change", { bubbles: true }));
  expect(store.data.combine).toEqual({ sets: ["ultimate", "frequent"] });
  const unfavourable = rules.querySelector<HTMLInputElement>(`[data-path='["combine","permanent"]'] input`)!;
  unfavourable.focus();
  unfavourable.value = "1,2";
  unfavourable.dispatchEvent(new Event("input", { bubbles: true }));
  unfavourable.dispatchEvent(new Event("change", { bubbles: true }));
  expect(store.data.combine).toMatchObject({ permanent: [1.2, 1] });
  expect(rules.querySelector(`[data-path='["combine","expression"]']`)).toBeNull();
  store.setDoc({ ...store.doc!, data: { cases: [{ name: "G" }] } });
});

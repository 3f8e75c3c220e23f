// @vitest-environment happy-dom
// Alternatives to the design: tried for a run, one taken as one step of undo, none once the case has changed.
import { beforeEach, expect, test, vi } from "vitest";
import type { ComparisonKind } from "../../../src/workbench/client/api";
import { Store } from "../../../src/workbench/client/store";
import type { Change } from "../../../src/workbench/model/edits";
import { AlternativesBar } from "../../../src/workbench/result/alternatives-bar";
import { FakeApi } from "../fake-api";

const SOLVED = { run: 4, version: 1, seconds: 1, design: null, provisional: "", update: 0 };
const CASES = { "as drawn": "# drawn", "bars proposed": "# bars", "50 mm thicker": "# thicker" };

let store: Store;
let pushed: Change[];
let asked: [number, ComparisonKind][];
let bar: AlternativesBar;

const control = (name: string) =>
  [...bar.element.querySelectorAll("button")].find(({ textContent }) => textContent === name) as HTMLButtonElement;
const choice = () => bar.element.querySelector("select") as HTMLSelectElement;

beforeEach(() => {
  store = new Store();
  store.setDoc(new FakeApi({}).present());
  store.set("solved", SOLVED as never);
  pushed = [];
  asked = [];
  const api = {
    compare: async (run: number, kind: ComparisonKind) => void asked.push([run, kind]),
    cancelComparison: async () => undefined,
    alternatives: async () => CASES,
  };
  bar = new AlternativesBar(
    store,
    api,
    (change) => pushed.push(change),
    (error) => {
      throw error;
    },
  );
});

test("tries alternatives of the run shown, and tells how far that is", () => {
  expect(choice().hidden).toBe(true);
  control("Try alternatives").click();
  expect(asked).toEqual([[4, "alternatives"]]);
  store.set("comparison", { kind: "alternatives", run: 4, state: "running", text: "2 of 5, thicker", share: 0.2 });
  expect(bar.element.textContent).toContain("2 of 5, thicker");
  expect(control("Try alternatives").hidden).toBe(true);
  expect(control("Cancel").hidden).toBe(false);
});

test("is not told of the comparison of grounds", () => {
  store.set("comparison", { kind: "comparison", run: 4, state: "running", text: "vlasov", share: 0.2 });
  expect(bar.element.textContent).not.toContain("vlasov");
  expect(control("Try alternatives").hidden).toBe(false);
});

test("puts the case with the chosen one in place of its text", async () => {
  await bar.offer(4);
  expect([...choice().options].map(({ value }) => value)).toEqual(["bars proposed", "50 mm thicker"]);
  choice().value = "50 mm thicker";
  control("Take it").click();
  expect(pushed).toEqual([{ edits: [{ op: "text", value: "# thicker" }], text: "take the alternative 50 mm thicker" }]);
});

test("takes none once the case has changed, and hides them once another run is shown", async () => {
  await bar.offer(4);
  store.set("solved", { ...SOLVED, version: 0 } as never);
  await vi.waitFor(() => expect(control("Take it").disabled).toBe(true));
  control("Take it").click();
  expect(pushed).toEqual([]);
  store.set("solved", { ...SOLVED, run: 5 } as never);
  expect(choice().hidden).toBe(true);
});

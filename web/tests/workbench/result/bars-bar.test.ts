// @vitest-environment happy-dom
// Bars proposed: put into the case as one step of undo, unless the case has changed since it was solved.
import { beforeEach, expect, test, vi } from "vitest";
import { Refused } from "../../../src/workbench/client/api";
import { Store } from "../../../src/workbench/client/store";
import type { Change } from "../../../src/workbench/model/edits";
import { barsBar } from "../../../src/workbench/result/bars-bar";
import { FakeApi } from "../fake-api";

const SOLVED = { run: 4, version: 1, seconds: 1, design: null, provisional: "", update: 0 };

let store: Store;
let pushed: Change[];

beforeEach(() => {
  store = new Store();
  store.setDoc(new FakeApi({}).present());
  store.set("solved", SOLVED as never);
  pushed = [];
});

function make(proposeBars: (run: number) => Promise<string>): { bar: HTMLElement; start: HTMLButtonElement } {
  const bar = barsBar(store, { proposeBars }, (change) => pushed.push(change));
  return { bar, start: bar.querySelector("button") as HTMLButtonElement };
}

test("puts the case with bars in place of its text", async () => {
  const { start } = make(async (run) => `# run ${run}`);
  start.click();
  expect(start.disabled).toBe(true);
  await vi.waitFor(() => expect(pushed).toEqual([{ edits: [{ op: "text", value: "# run 4" }], text: "propose bars" }]));
  expect(start.disabled).toBe(false);
});

test("overwrites no edit that was made in the meantime", async () => {
  let finish = (_: string) => {};
  const { bar, start } = make(() => new Promise((resolve) => (finish = resolve)));
  start.click();
  store.set("solved", { ...SOLVED, version: 0 } as never);
  finish("# older");
  await vi.waitFor(() => expect(bar.textContent).toContain("Solve first"));
  expect(pushed).toEqual([]);
  expect(start.disabled).toBe(true);
});

test("says why there are none", async () => {
  const { bar, start } = make(async () => {
    throw new Refused("reinforcement: found nothing", 422, "", "");
  });
  start.click();
  await vi.waitFor(() => expect(bar.textContent).toContain("reinforcement: found nothing"));
  expect(bar.classList.contains("bad")).toBe(true);
});

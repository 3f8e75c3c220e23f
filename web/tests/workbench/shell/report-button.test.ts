// @vitest-environment happy-dom
// The report: made while one works on, with its share told; a changed case is asked about first.
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Refused } from "../../../src/workbench/client/api";
import { Store } from "../../../src/workbench/client/store";
import { reportButton } from "../../../src/workbench/shell/report-button";
import { FakeApi } from "../fake-api";

const SOLVED = { run: 4, version: 1, seconds: 1, design: null, provisional: "", update: 0 };

let store: Store;
let saved: string[];
const solve = vi.fn(async () => {});

beforeEach(() => {
  HTMLDialogElement.prototype.showModal = () => {};
  HTMLDialogElement.prototype.close = () => {};
  saved = [];
  URL.createObjectURL = () => "blob:report";
  vi.spyOn(HTMLAnchorElement.prototype, "click").mockImplementation(function (this: HTMLAnchorElement) {
    saved.push(this.download);
  });
  solve.mockClear();
  store = new Store();
  store.setDoc(new FakeApi({}).present());
  store.set("solved", SOLVED as never);
});

afterEach(() => {
  document.body.replaceChildren();
  vi.restoreAllMocks();
});

test("says how far it is, and saves the file under its name", async () => {
  let finish = () => {};
  const made = new Promise<{ name: string; content: Blob }>((resolve) => {
    finish = () => resolve({ name: "raft-report.html", content: new Blob() });
  });
  const element = reportButton(store, { report: () => made }, solve) as HTMLButtonElement;
  element.click();
  expect(element.getAttribute("aria-busy")).toBe("true");
  expect(element.disabled).toBe(true);
  store.set("report", { run: 4, text: "Pictures", share: 0.25 });
  expect([element.textContent, element.title]).toEqual(["Report 25 %", "The report is being made: Pictures"]);
  finish();
  await vi.waitFor(() => expect(saved).toEqual(["raft-report.html"]));
  await vi.waitFor(() => expect(element.textContent).toBe("Report"));
  expect(element.disabled).toBe(false);
});

test("says why it could not be made", async () => {
  const report = async () => {
    throw new Refused("the results of that run are not kept any more", 404, "", "");
  };
  const element = reportButton(store, { report }, solve) as HTMLButtonElement;
  element.click();
  await vi.waitFor(() => expect(store.notice?.text).toMatch(/could not be made: the results of that run/));
  expect(saved).toEqual([]);
  expect(element.disabled).toBe(false);
});

test("asks first where the case has changed, and can solve it before", async () => {
  const report = vi.fn(async (run: number) => ({ name: `${run}.html`, content: new Blob() }));
  const element = reportButton(store, { report }, solve) as HTMLButtonElement;
  store.set("solved", { ...SOLVED, version: 0 } as never);
  const answer = (label: string) =>
    [...document.querySelectorAll<HTMLButtonElement>("dialog button")].find((each) => each.textContent === label);
  element.click();
  answer("Cancel")?.click();
  await Promise.resolve();
  expect(report).not.toHaveBeenCalled();
  element.click();
  answer("Report on the last result")?.click();
  await vi.waitFor(() => expect(saved).toEqual(["4.html"]));
  await vi.waitFor(() => expect(element.disabled).toBe(false));
  element.click();
  answer("Solve first")?.click();
  await vi.waitFor(() => expect(solve).toHaveBeenCalledOnce());
  expect(saved).toEqual(["4.html"]);
  store.set("solved", { ...SOLVED, run: 5 } as never);
  await vi.waitFor(() => expect(saved).toEqual(["4.html", "5.html"]));
});

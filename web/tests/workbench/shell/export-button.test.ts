// @vitest-environment happy-dom
// The export: a file chosen in a dialog, made while one works on; a changed case is asked about first.
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { type MadeFile, Refused } from "../../../src/workbench/client/api";
import { type ShownResult, Store } from "../../../src/workbench/client/store";
import { type ExportApi, exportButton } from "../../../src/workbench/shell/export-button";
import { FakeApi } from "../fake-api";

const SOLVED = { run: 4, version: 1, seconds: 1, design: "", provisional: "", update: 0 };
const SHOWN: ShownResult = {
  field: "moment_x",
  meaning: "moment of strips along x",
  of: "2 ULS",
  combination: "ULS",
  envelope: "",
  isDrawable: true,
};

let store: Store;
let saved: string[];
const solve = vi.fn(async () => {});

const named = (name: string, notes: string[] = []): MadeFile => ({ name, content: new Blob(), notes });
const api = (more: Partial<ExportApi> = {}): ExportApi => ({
  report: async (run) => named(`${run}-report.html`),
  archive: async (run) => named(`${run}-results.zip`),
  exported: async (run, file, shown) => named(`${run} ${file} ${shown?.field} ${shown?.combination}`),
  saf: async () => named("slab-saf.xlsx"),
  ...more,
});

/** Return the button on a page of its own. */
function show(more: Partial<ExportApi> = {}): HTMLButtonElement {
  const element = exportButton(store, api(more), solve) as HTMLButtonElement;
  store.emitAll();
  return element;
}

/** Whether it takes no clicks; it keeps the focus. */
const isBlocked = (element: Element) => element.getAttribute("aria-disabled") === "true";
const rows = () => [...document.querySelectorAll<HTMLElement>(".export-offer")];
const row = (label: string) => rows().find((each) => each.querySelector("b")?.textContent === label)!;

/** Choose a file in the dialog and confirm. */
async function choose(element: HTMLButtonElement, file: string): Promise<void> {
  element.click();
  const select = [...document.querySelectorAll<HTMLSelectElement>(".export-dialog select")].find((each) =>
    [...each.options].some(({ value }) => value === file),
  )!;
  select.value = file;
  select.dispatchEvent(new Event("change"));
  document.querySelector("form")!.dispatchEvent(new Event("submit", { cancelable: true }));
  await Promise.resolve();
  await Promise.resolve();
}

beforeEach(() => {
  HTMLDialogElement.prototype.showModal = () => {};
  HTMLDialogElement.prototype.close = () => {};
  saved = [];
  URL.createObjectURL = () => "blob:file";
  vi.spyOn(HTMLAnchorElement.prototype, "click").mockImplementation(function (this: HTMLAnchorElement) {
    saved.push(this.download);
  });
  solve.mockClear();
  store = new Store();
  store.setDoc(new FakeApi({}).present());
  store.set("solved", SOLVED);
  store.set("shown", SHOWN);
});

afterEach(() => {
  document.body.replaceChildren();
  vi.restoreAllMocks();
});

test("says how far a report is, and saves the file under its name", async () => {
  let finish = () => {};
  const made = new Promise<MadeFile>((resolve) => {
    finish = () => resolve(named("raft-report.html"));
  });
  const element = show({ report: () => made });
  await choose(element, "report.html");
  expect([element.textContent, isBlocked(element)]).toEqual(["Exporting …", true]);
  expect(element.getAttribute("aria-busy")).toBe("true");
  store.set("report", { run: 4, text: "Pictures", share: 0.25 });
  expect([element.textContent, element.title]).toEqual(["Export 25 %", "The report is being made: Pictures"]);
  finish();
  await vi.waitFor(() => expect(saved).toEqual(["raft-report.html"]));
  await vi.waitFor(() => expect(element.textContent).toBe("Export …"));
  expect(isBlocked(element)).toBe(false);
});

test.each([
  ["plan.dxf", "4 plan.dxf moment_x ULS"],
  ["tables.zip", "4 tables.zip moment_x ULS"],
  ["archive.zip", "4-results.zip"],
  ["saf.xlsx", "slab-saf.xlsx"],
])("has %s made of what is shown", async (file, name) => {
  await choose(show(), file);
  await vi.waitFor(() => expect(saved).toEqual([name]));
});

test("offers again what was exported last, and says what a plan is of", async () => {
  const element = show();
  await choose(element, "plan.svg");
  await vi.waitFor(() => expect(isBlocked(element)).toBe(false));
  element.click();
  expect(row("Plan of the field shown").textContent).toContain("moment of strips along x; 2 ULS");
  expect(row("Plan of the field shown").querySelector<HTMLInputElement>("input")!.checked).toBe(true);
  expect(row("Plan of the field shown").querySelector("select")!.value).toBe("plan.svg");
});

test("shows what a file does not hold", async () => {
  await choose(
    show({ saf: async () => named("slab-saf.xlsx", ["contact: no place", "limits: no place"]) }),
    "saf.xlsx",
  );
  await vi.waitFor(() =>
    expect(document.querySelector("pre")?.textContent).toBe("contact: no place\nlimits: no place"),
  );
  expect(document.querySelector("h2")?.textContent).toBe("Saved as slab-saf.xlsx");
});

test("says why a file could not be made", async () => {
  const refuse = async () => {
    throw new Refused("reinforcement: no bars provided", 422);
  };
  const element = show({ exported: refuse });
  await choose(element, "bars.dxf");
  await vi.waitFor(() => expect(store.notice?.text).toMatch(/could not be made: reinforcement: no bars/));
  expect(saved).toEqual([]);
  expect(isBlocked(element)).toBe(false);
});

test("offers only what there is: without results the case, of an envelope over several states no plan", () => {
  const isOffered = () =>
    rows().map((each) => [each.querySelector("b")!.textContent, !each.querySelector("input")!.disabled]);
  store.set("shown", { ...SHOWN, isDrawable: false });
  const element = show();
  element.click();
  expect(isOffered().filter(([, offered]) => !offered)).toEqual([["Plan of the field shown", false]]);
  document.body.replaceChildren();
  store.set("solved", null);
  element.click();
  expect(isOffered().filter(([, offered]) => offered)).toEqual([["Model for structural programs (SAF)", true]]);
});

test("of results that are looked at the model is that of the results, and there is no archive", async () => {
  store.setDoc({ ...new FakeApi({}).present(), view: "slab-results" });
  const element = show();
  element.click();
  expect(rows().map((each) => each.querySelector("b")!.textContent)).not.toContain("Archive");
  document.body.replaceChildren();
  await choose(element, "saf.xlsx");
  await vi.waitFor(() => expect(saved).toEqual(["4 saf.xlsx moment_x ULS"]));
});

test("exports nothing that was waited for once solving is canceled, or another case is opened", async () => {
  const report = vi.fn(async (run: number) => named(`${run}.html`));
  const element = show({ report });
  const first = async () => {
    store.set("solved", { ...SOLVED, version: 0 });
    await choose(element, "report.html");
    const buttons = [...document.querySelectorAll<HTMLButtonElement>(".ask button")];
    buttons.find((each) => each.textContent === "Solve first")?.click();
    await vi.waitFor(() => expect(solve).toHaveBeenCalled());
  };
  await first();
  store.emit("opened");
  store.set("solved", { ...SOLVED, run: 5 });
  await first();
  store.autosolve = false;
  store.set("run", { kind: "cancelled" });
  store.set("run", { kind: "idle" });
  store.set("solved", { ...SOLVED, run: 6 });
  await Promise.resolve();
  expect(report).not.toHaveBeenCalled();
});

test("asks first where the case has changed, and can solve it before; not for the case itself", async () => {
  const report = vi.fn(async (run: number) => named(`${run}.html`));
  const element = show({ report });
  store.set("solved", { ...SOLVED, version: 0 });
  const answer = (label: string) =>
    [...document.querySelectorAll<HTMLButtonElement>(".ask button")].find((each) => each.textContent === label);
  await choose(element, "report.html");
  answer("Cancel")?.click();
  await Promise.resolve();
  expect(report).not.toHaveBeenCalled();
  await choose(element, "report.html");
  answer("Export the last result")?.click();
  await vi.waitFor(() => expect(saved).toEqual(["4.html"]));
  await vi.waitFor(() => expect(isBlocked(element)).toBe(false));
  await choose(element, "report.html");
  answer("Solve first")?.click();
  await vi.waitFor(() => expect(solve).toHaveBeenCalledOnce());
  expect(saved).toEqual(["4.html"]);
  store.set("solved", { ...SOLVED, run: 5 });
  await vi.waitFor(() => expect(saved).toEqual(["4.html", "5.html"]));
  store.set("solved", { ...SOLVED, version: 0 });
  await vi.waitFor(() => expect(isBlocked(element)).toBe(false));
  await choose(element, "saf.xlsx");
  await vi.waitFor(() => expect(saved.at(-1)).toBe("slab-saf.xlsx"));
});

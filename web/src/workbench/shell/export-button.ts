// The button that has a file made while one works on, says how far a report is, and saves the file.

import { allow, h, setRead, setText } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import { type Api, type MadeFile, Refused } from "../client/api";
import type { Store } from "../client/store";
import { ask } from "../controls/dialogs";
import { showNotes } from "../drawing/report";
import { freshness } from "../result/standing";
import { chooseExport } from "./export-dialog";

/** A browser begins to save a file from an address some time after it was asked to [ms]. */
const SAVING = 60_000;
/** The file that is of the case as it is now, solved or not. */
const OF_CASE = "saf.xlsx";
const LEFT = "What the file does not hold, or in another way than the case:";

export type ExportApi = Pick<Api, "report" | "archive" | "exported" | "saf">;

export function exportButton(store: Store, api: ExportApi, solve: () => Promise<unknown>): HTMLElement {
  const onclick = () => void start();
  const title = "Save the report, tables, figures, drawings or files for other programs";
  const element = h("button", { type: "button", class: "export", title, onclick }, "Export …");
  let awaited: string | null = null;

  const isStale = () => freshness(store.solved, store) === "stale";

  async function start(): Promise<void> {
    if (store.report) return;
    const file = await chooseExport(store);
    if (file === null || store.report) return;
    if (file !== OF_CASE && isStale()) {
      const answer = await askAboutChange();
      if (answer === "cancel") return;
      if (answer === "solve") {
        awaited = file;
        await solve();
        return;
      }
    }
    await make(file);
  }

  async function make(file: string): Promise<void> {
    store.set("report", { run: store.solved?.run ?? 0, text: "", share: 0 });
    try {
      const { name, content, notes } = await request(store, api, file);
      save(name, content);
      if (notes.length) showNotes(name, LEFT, notes.join("\n"));
    } catch (error) {
      const text = error instanceof Refused ? error.message : String(error);
      store.set("notice", { kind: "bad", text: say("The file could not be made: {why}", { why: text }) });
    } finally {
      store.set("report", null);
    }
  }

  store.on(["solved", "run", "doc", "waiting", "report"], () => {
    const { report, solved, run } = store;
    const share = Math.round(100 * (report?.share ?? 0));
    setText(element, report === null ? "Export …" : share > 0 ? say("Export {share} %", { share }) : "Exporting …");
    const made = report?.text
      ? say("The report is being made: {what}", { what: report.text })
      : "The file is being made.";
    const isEmpty = solved === null && (store.doc === null || store.doc.issues.length > 0);
    allow(element, report === null && isEmpty ? "There is nothing to export: fix the errors first." : "");
    // while a file is made it keeps the focus
    if (report !== null) setRead(element, "title", made);
    element.setAttribute("aria-disabled", String(report !== null));
    element.setAttribute("aria-busy", String(report !== null));
    if (awaited !== null && run.kind === "idle" && solved && !solved.provisional && !isStale()) {
      const file = awaited;
      awaited = null;
      void make(file);
    } else if (run.kind === "refused" || (run.kind === "cancelled" && !store.autosolve)) awaited = null;
  });
  store.on(["opened"], () => {
    awaited = null; // it was of another case
  });
  return element;
}

/** Have a file made: of the case as it is now, or of the last result. */
function request(store: Store, api: ExportApi, file: string): Promise<MadeFile> {
  if (file === OF_CASE && store.doc?.view === undefined) return api.saf();
  const run = store.solved?.run ?? 0;
  if (file === "report.html") return api.report(run);
  if (file === "archive.zip") return api.archive(run);
  return api.exported(run, file, store.shown);
}

type AboutChange = "cancel" | "last" | "solve";

function askAboutChange(): Promise<AboutChange> {
  const words =
    "The case has changed since it was solved. A file of the last result describes the case before the change; a report says so on its first page.";
  const answers = [
    { label: "Cancel", value: "cancel" as const },
    { label: "Export the last result", value: "last" as const },
    { label: "Solve first", value: "solve" as const, main: true },
  ];
  return ask<AboutChange>("Solve first?", [words], answers, "cancel");
}

/** Have the browser save a file. */
function save(name: string, content: Blob): void {
  const href = URL.createObjectURL(content);
  h("a", { href, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(href), SAVING);
}

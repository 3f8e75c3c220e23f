// The button that has a report made while one works on, says how far it is, and saves it.

import { h, setRead, setText } from "../../viewer/shared/dom";
import { type Api, Refused } from "../client/api";
import type { Store } from "../client/store";
import { ask } from "../controls/dialogs";
import { freshness } from "../result/status";

/** A browser begins to save a file from an address some time after it was asked to [ms]. */
const SAVING = 60_000;

export function reportButton(store: Store, api: Pick<Api, "report">, solve: () => Promise<unknown>): HTMLElement {
  const onclick = () => void start();
  const title = "Save the report for the last result as a single HTML file";
  const element = h("button", { type: "button", class: "report", title, onclick }, "Report");
  let isAwaitingResult = false;

  const isStale = () => freshness(store.solved, store.doc?.version, store.waitingCount) === "stale";

  async function start(): Promise<void> {
    if (!store.solved || store.report) return;
    if (isStale()) {
      const answer = await askAboutChange();
      if (answer === "cancel") return;
      if (answer === "solve") {
        isAwaitingResult = true;
        await solve();
        return;
      }
    }
    await make(store.solved.run);
  }

  async function make(run: number): Promise<void> {
    store.set("report", { run, text: "", share: 0 });
    try {
      const { name, content } = await api.report(run);
      save(name, content);
    } catch (error) {
      const text = error instanceof Refused ? error.message : String(error);
      store.set("notice", { kind: "bad", text: `The report could not be made: ${text}` });
    } finally {
      store.set("report", null);
    }
  }

  store.on(["solved", "run", "doc", "waiting", "report"], () => {
    const { report, solved, run } = store;
    setText(element, report ? `Report ${Math.round(100 * report.share)} %` : "Report");
    setRead(element, "title", report ? `The report is being made: ${report.text || "begun"}` : title);
    element.setAttribute("aria-busy", String(report !== null));
    element.disabled = solved === null || report !== null;
    if (isAwaitingResult && run.kind === "idle" && solved && !solved.provisional && !isStale()) {
      isAwaitingResult = false;
      void make(solved.run);
    } else if (run.kind === "refused") isAwaitingResult = false;
  });
  return element;
}

type AboutChange = "cancel" | "last" | "solve";

function askAboutChange(): Promise<AboutChange> {
  const words =
    "The case has changed since it was solved. A report on the last result says so on its first page; it describes the case before the change.";
  const answers = [
    { label: "Cancel", value: "cancel" as const },
    { label: "Report on the last result", value: "last" as const },
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

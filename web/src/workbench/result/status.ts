// The line above the result: what it is of, whether it is up to date, what the solver is doing.

import { type Child, fill, h, setText } from "../../viewer/shared/dom";
import { counted, keep, say, together, verbatim } from "../../viewer/shared/language";
import type { Run, Solved, Store } from "../client/store";
import { issueLine } from "../model/issues";
import { type Freshness, freshness } from "./standing";

/** What the line says. */
export function statusText(
  fresh: Freshness,
  run: Run,
  solved: Solved | null,
  autosolve: boolean,
  issues: number,
): string {
  const old = fresh === "stale" ? "These results are for an earlier version of the model." : "";
  switch (run.kind) {
    case "solving":
      return together([old, run.text ? say("Solving: {what}", { what: verbatim(run.text) }) : "Solving …"]);
    case "refused":
      return together([
        old,
        say("Not solved: {why}", { why: run.message ? verbatim(run.message) : "the model has errors" }),
      ]);
    case "cancelled":
      // by an edit, whose own run follows
      if (fresh === "stale" && autosolve) return old;
      return together([old, "Solving was canceled."]);
    default:
      if (fresh === "none") return "Not solved yet.";
      if (fresh === "stale" && issues > 0)
        return together([old, counted(issues, "Fix the error to update them.", "Fix the errors to update them.")]);
      if (fresh === "stale") return autosolve ? old : together([old, "Solve to update them."]);
      return together([keep(solved?.design ?? ""), originText(solved?.seconds ?? null)]);
  }
}

/** Where the result is from. */
function originText(seconds: number | null): string {
  return seconds === null ? "Saved results, read-only." : say("Solved in {time}.", { time: formatSeconds(seconds) });
}

function formatSeconds(value: number): string {
  return value < 10 ? `${value.toFixed(1)} s` : `${Math.round(value)} s`;
}

/** The line, with the progress of the solver below it. */
export function statusLine(store: Store): HTMLElement {
  const words = h("span", { class: "status-words" });
  const bar = h("progress", { max: 1, "aria-label": "solver progress" });
  const element = h("div", { class: "result-status", role: "status" }, words, bar);
  const update = () => {
    const { run, solved, doc } = store;
    const fresh = freshness(solved, store);
    setText(words, statusText(fresh, run, solved, store.autosolve, doc?.issues.length ?? 0));
    const details = run.kind === "solving" ? (run.details ?? "") : "";
    words.title = [words.textContent, details].filter(Boolean).join("\n");
    const failing = fresh === "fresh" && Boolean(solved?.design);
    element.dataset.state =
      run.kind === "solving" ? "solving" : run.kind === "refused" ? "refused" : failing ? "failing" : fresh;
    bar.hidden = run.kind !== "solving";
    if (run.kind === "solving" && run.share !== null) bar.value = run.share;
    else bar.removeAttribute("value");
  };
  store.on(["run", "solved", "doc", "waiting", "autosolve"], update);
  update();
  return element;
}

/** What is shown in place of a result while there is none; without `solve` one that was kept is on its way. */
export function emptyResult(store: Store, solve: (() => void) | null): { element: HTMLElement; update(): void } {
  const element = h("div", { class: "empty-result" });
  const show = (title: string, text: string, ...more: Child[]) =>
    fill(element, h("h3", {}, title), h("p", {}, text), ...more);
  const update = () => {
    const { run, doc, solved } = store;
    const count = doc?.issues.length ?? 0;
    if (!solve || (solved && run.kind === "idle")) return show("Loading the results …", "");
    if (run.kind === "solving") return show("Solving …", "The result will appear here.");
    if (run.kind === "refused")
      return show("Not solved", run.message, ...run.issues.map((one) => h("p", { class: "quiet" }, issueLine(one))));
    const errors = counted(count, "error", "{count} errors");
    if (count > 0) return show("No result yet", say("First fix the {errors} listed below the model.", { errors }));
    const how = "Solve the model to see settlement, contact pressure and moments here, or turn on Autosolve.";
    show("No result yet", how, h("button", { type: "button", class: "main", onclick: solve }, "Solve"));
  };
  store.on(["run", "doc", "solved"], update);
  return { element, update };
}

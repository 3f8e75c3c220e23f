// The report on a file that became a case, or that a case became: what was read or written, and what was left.

import { button, h } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import { closeDialog, openDialog } from "../controls/dialogs";
import "./drawing.css";

/** Show what was read of a file and what was left, below a sentence on what is still missing. */
export function showReport(name: string, missing: string, report: string): void {
  showLines(say("Imported from {name}", { name: verbatim(name) }), missing, report);
}

/** Show what is said of a file that was saved. */
export function showNotes(name: string, words: string, notes: string): void {
  showLines(say("Saved as {name}", { name: verbatim(name) }), words, notes);
}

function showLines(title: string, words: string, report: string): void {
  const close = () => closeDialog(dialog);
  const ok = button("Close", "", close, "main");
  const dialog = h(
    "dialog",
    { class: "drawing-report", "aria-label": title },
    h("h2", {}, title),
    h("p", {}, words),
    h("pre", { tabindex: 0 }, report),
    h("div", { class: "answers" }, ok),
  );
  openDialog(dialog, close);
  ok.focus();
}

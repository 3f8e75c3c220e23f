// Help: the keys of the page.

import { button, h, newId } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import { closeDialog, openDialog } from "../controls/dialogs";
import { FORMS } from "../plan/actions/forms";
import { GENERATORS } from "../plan/generators/generators";
import { openDocumentation } from "./documentation";
import { setFieldHelp, showsFieldHelp } from "./field-help";

type KeyRow = readonly [keys: string, meaning: string];

const EVERYWHERE: readonly KeyRow[] = [
  ["Ctrl+S, Ctrl+Shift+S", "save, save as"],
  ["Ctrl+O", "open a case file"],
  ["Ctrl+Z, Ctrl+Y", "undo, redo"],
  ["F6, Shift+F6", "go to the next or previous area: top bar, model, results"],
  ["F9", "solve"],
  ["F1", "documentation for the focused field"],
  ["?", "show this list"],
];

const DRAWING: readonly KeyRow[] = [
  ["N, Shift+N", "select the next or previous item"],
  ["Arrows, Shift+arrows", "move the selection by one step or by ten; with no selection, pan"],
  ["Ctrl+A, Shift+click", "select everything except the slab; add to the selection"],
  ["Ctrl+C, Ctrl+X, Ctrl+V, Ctrl+D", "copy, cut, paste, duplicate"],
  ...FORMS.map(
    ({ key, label }): KeyRow => [
      key,
      say("{label} the selected items by entering values", { label: label.toLowerCase() }),
    ],
  ),
  ["Delete", "delete the selected item or corner"],
  ["Enter, Escape", "finish the shape being drawn, discard it"],
  ["+, -, 0, Z", "zoom in, zoom out, show everything, toggle axes and dimensions"],
];

const RESULTS: readonly KeyRow[] = [
  ["F", "show the results alone, or beside the model"],
  ["Arrows, +, -, 0", "pan, zoom in, zoom out, show everything"],
  ["Shift", "with “Section”: along x or y"],
];

const TABLES: readonly KeyRow[] = [
  ["Arrows, Page Up, Page Down", "move between cells; with Ctrl, jump to the edge of the table"],
  ["Tab, Shift+Tab", "next cell, previous cell; press Escape first to leave the table with Tab"],
  ["Shift+arrows, Ctrl+A", "select a range, select all rows"],
  ["F2, Enter", "edit the value; typing replaces it"],
  ["Ctrl++, Ctrl+D, Ctrl+-", "add a row, duplicate or remove the selected rows"],
];

/** Show the keys and what else helps; `tools` are those of the drawing, `takeTour` starts the tour. */
export function showKeys(tools: readonly { key: string; label: string }[], takeTour: () => void): void {
  const id = newId("dialog");
  const close = () => closeDialog(dialog);
  const done = button("Close", "", close, "main");
  done.toggleAttribute("autofocus", true);
  const dialog = h(
    "dialog",
    { class: "ask keys", "aria-labelledby": id },
    h("h2", { id }, "Keyboard shortcuts"),
    helpLinks(() => {
      close();
      takeTour();
    }),
    h(
      "div",
      { class: "key-groups", tabindex: 0, role: "group", "aria-label": "keyboard shortcuts" },
      keyTable("Everywhere", EVERYWHERE),
      keyTable("Plan", DRAWING),
      keyTable(
        "Plan tools",
        [...tools, ...GENERATORS].map(({ key, label }) => [key, label] as const),
      ),
      keyTable("Results", RESULTS),
      keyTable("Tables", TABLES),
    ),
    h("div", { class: "answers" }, done),
  );
  openDialog(dialog, close);
}

/** Documentation and tour, and whether the meaning of fields is shown. */
function helpLinks(takeTour: () => void): HTMLElement {
  const onchange = () => setFieldHelp(shows.checked);
  const shows: HTMLInputElement = h("input", { type: "checkbox", checked: showsFieldHelp(), onchange });
  const documentation = button("Documentation", "Open in a new tab (F1)", () => openDocumentation());
  const tour = button("Tour", "From the slab to the report in five steps", takeTour);
  return h("div", { class: "help-links" }, documentation, tour, h("label", {}, shows, "Show field help"));
}

function keyTable(title: string, rows: readonly KeyRow[]): HTMLElement {
  const items = rows.flatMap(([keys, meaning]) => [h("dt", {}, h("kbd", {}, keys)), h("dd", {}, meaning)]);
  return h("section", {}, h("h3", {}, title), h("dl", {}, ...items));
}

/** Whether a key asks for help: not where "?" is text that is typed. */
export function asksForKeys(event: KeyboardEvent): boolean {
  const { target } = event;
  const isTyped =
    target instanceof HTMLTextAreaElement || (target instanceof HTMLInputElement && target.type === "text");
  return event.key === "?" && !isTyped && !event.ctrlKey && !event.metaKey && !event.altKey;
}

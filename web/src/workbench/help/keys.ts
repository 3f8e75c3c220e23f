// Help: the keys of the page.
import { button, h, newId } from "../../viewer/shared/dom";
import { closeDialog, openDialog } from "../controls/dialogs";
import { FORMS } from "../plan/actions/forms";
import { GENERATORS } from "../plan/generators/generators";
import { openDocumentation } from "./documentation";
import { setFieldHelp, showsFieldHelp } from "./field-help";

type KeyRow = readonly [keys: string, meaning: string];

const EVERYWHERE: readonly KeyRow[] = [
  ["Ctrl+S, Ctrl+Shift+S", "save, save under another name"],
  ["Ctrl+O", "open a case file"],
  ["Ctrl+Z, Ctrl+Y", "undo, redo"],
  ["F9", "solve"],
  ["F1", "documentation, of the field with the focus"],
  ["?", "this list"],
];

const DRAWING: readonly KeyRow[] = [
  ["N, Shift+N", "select the next or the previous item"],
  ["Arrows, with Shift", "move the selected item by a step, by ten; without one, the view"],
  ["Ctrl+A, Shift and click", "select everything but the slab, several items"],
  ["Ctrl+C, Ctrl+X, Ctrl+V, Ctrl+D", "copy, cut, paste, duplicate"],
  ...FORMS.map(({ key, label }): KeyRow => [key, `${label.toLowerCase()} the selected items by numbers`]),
  ["Delete", "remove the selected item or corner"],
  ["Enter, Escape", "close the shape that is drawn, drop it"],
  ["+, -, 0, Z", "zoom in, zoom out, show all, axes and dimensions"],
];

const TABLES: readonly KeyRow[] = [
  ["Arrows, Page Up, Page Down", "go to another cell; with Ctrl to the edge of the table"],
  ["Tab, Shift+Tab", "next cell, the one before; after Escape, Tab leaves the table"],
  ["Shift and arrows, Ctrl+A", "choose a block, all rows"],
  ["F2, Enter", "edit the value; letters and digits replace it"],
  ["Ctrl++, Ctrl+D, Ctrl+-", "add a row, duplicate and remove the chosen rows"],
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
    h("h2", { id }, "Keys"),
    helpLinks(() => {
      close();
      takeTour();
    }),
    h(
      "div",
      { class: "key-groups", tabindex: 0, role: "group", "aria-label": "keys" },
      keyTable("Everywhere", EVERYWHERE),
      keyTable("In the plan", DRAWING),
      keyTable(
        "Tools of the plan",
        [...tools, ...GENERATORS].map(({ key, label }) => [key, label] as const),
      ),
      keyTable("In tables", TABLES),
    ),
    h("div", { class: "answers" }, done),
  );
  openDialog(dialog, close);
}

/** Documentation and tour, and whether the meaning of fields is shown. */
function helpLinks(takeTour: () => void): HTMLElement {
  const onchange = () => setFieldHelp(shows.checked);
  const shows: HTMLInputElement = h("input", { type: "checkbox", checked: showsFieldHelp(), onchange });
  const documentation = button("Documentation", "In another tab (F1)", () => openDocumentation());
  const tour = button("Tour", "Five steps from the slab to the report", takeTour);
  return h("div", { class: "help-links" }, documentation, tour, h("label", {}, shows, "Show the meaning of fields"));
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

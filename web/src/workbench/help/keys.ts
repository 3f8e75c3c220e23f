// Help: the keys of the page.
import { button, h, newId } from "../../viewer/shared/dom";
import { closeDialog, openDialog } from "../shell/dialogs";

type KeyRow = readonly [keys: string, meaning: string];

const EVERYWHERE: readonly KeyRow[] = [
  ["Ctrl+S, Ctrl+Shift+S", "save, save under another name"],
  ["Ctrl+O", "open a case file"],
  ["Ctrl+Z, Ctrl+Y", "undo, redo"],
  ["F9", "solve"],
  ["?", "this list"],
];

const DRAWING: readonly KeyRow[] = [
  ["N, Shift+N", "select the next or the previous item"],
  ["Arrows, with Shift", "move the selected item by a step, by ten; without one, the view"],
  ["Ctrl+D", "duplicate the selected item"],
  ["Delete", "remove the selected item or corner"],
  ["Enter, Escape", "close the shape that is drawn, drop it"],
  ["+, -, 0", "zoom in, zoom out, show all"],
];

/** Show the keys; `tools` are those of the drawing. */
export function showKeys(tools: readonly { key: string; label: string }[]): void {
  const id = newId("dialog");
  const close = () => closeDialog(dialog);
  const done = button("Close", "", close, "main");
  done.toggleAttribute("autofocus", true);
  const dialog = h(
    "dialog",
    { class: "ask keys", "aria-labelledby": id },
    h("h2", { id }, "Keys"),
    h(
      "div",
      { class: "key-groups", tabindex: 0, role: "group", "aria-label": "keys" },
      keyTable("Everywhere", EVERYWHERE),
      keyTable("In the plan", DRAWING),
      keyTable(
        "Tools of the plan",
        tools.map(({ key, label }) => [key, label] as const),
      ),
    ),
    h("div", { class: "answers" }, done),
  );
  openDialog(dialog, close);
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

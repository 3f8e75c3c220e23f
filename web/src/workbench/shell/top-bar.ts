// The bar across the top: the file, undo and redo, solving, exporting, light and dark.

import { button, h, setRead, setText } from "../../viewer/shared/dom";
import { say, translate, verbatim } from "../../viewer/shared/language";
import { switchTheme } from "../../viewer/shared/theme";
import type { Api, Lost } from "../client/api";
import type { Store } from "../client/store";
import { icon } from "../controls/icons";
import { AccuracyChoice } from "./accuracy-choice";
import type { Commands } from "./commands";
import { type ExportApi, exportButton } from "./export-button";
import { languageSwitch } from "./language-switch";

export function topBar(
  store: Store,
  api: ExportApi & Pick<Api, "costs" | "setAccuracy">,
  commands: Commands,
  showKeys: () => void,
  onLost: (error: Lost) => void,
): HTMLElement {
  const file = [
    button("New", "Start a new case, empty or from an example", () => void commands.createCase()),
    button(
      "Open …",
      "Open a case file, a drawing, a building or a SAF file, or import reactions (Ctrl+O)",
      () => void commands.open(),
    ),
    button("Save", "Save the case file (Ctrl+S)", () => void commands.save()),
    button("Save as …", "Save under a different name (Ctrl+Shift+S)", () => void commands.saveAs()),
  ];
  return h(
    "header",
    { class: "top" },
    h("h1", { class: "brand" }, "groundslab"),
    h("div", { class: "gs-group", role: "group", "aria-label": "file" }, ...file),
    ...historyButtons(store, commands),
    fileTitle(store),
    new AccuracyChoice(store, api, { settle: commands.settle, onLost }).element,
    ...solveControls(store, commands),
    exportButton(store, api, commands.solve),
    themeButton(),
    languageSwitch(store, commands.settle),
    h(
      "button",
      { type: "button", title: "Keyboard shortcuts (?)", "aria-label": "keyboard shortcuts", onclick: showKeys },
      "?",
    ),
  );
}

/** The bar above results that are only looked at. */
export function viewBar(store: Store, api: ExportApi): HTMLElement {
  const name = h("h1", { class: "brand" }, "groundslab");
  const files = exportButton(store, api, async () => {}); // what is looked at does not change
  return h("header", { class: "top" }, name, fileTitle(store), files, themeButton(), languageSwitch(store));
}

function themeButton(): HTMLButtonElement {
  const theme = makeIconButton("theme", "light or dark", switchTheme);
  setRead(theme, "title", "Light or dark");
  return theme;
}

function makeIconButton(name: "undo" | "redo" | "theme", label: string, onclick: () => void): HTMLButtonElement {
  return h("button", { type: "button", class: "with-icon", "aria-label": label, onclick }, icon(name));
}

/** Undo and redo, and what would be undone. */
function historyButtons(store: Store, commands: Commands): HTMLElement[] {
  const undo = makeIconButton("undo", "undo", () => {
    if (store.doc?.can_undo) void commands.undo();
  });
  const redo = makeIconButton("redo", "redo", () => {
    if (store.doc?.can_redo) void commands.redo();
  });
  const last = h("span", { class: "last-edit", "aria-hidden": "true" });
  store.on(["doc"], () => {
    const { doc } = store;
    // they keep the focus where nothing is left
    undo.setAttribute("aria-disabled", String(doc?.can_undo !== true));
    redo.setAttribute("aria-disabled", String(doc?.can_redo !== true));
    setRead(
      undo,
      "title",
      doc?.can_undo ? say("Undo: {change} (Ctrl+Z)", { change: doc.undo_text }) : "Nothing to undo",
    );
    setRead(
      redo,
      "title",
      doc?.can_redo ? say("Redo: {change} (Ctrl+Y)", { change: doc.redo_text }) : "Nothing to redo",
    );
    setText(last, doc?.can_undo ? doc.undo_text : "");
  });
  return [h("div", { class: "gs-group", role: "group", "aria-label": "edits" }, undo, redo), last];
}

function fileTitle(store: Store): HTMLElement {
  const name = h("span", { class: "file-title" });
  const mark = h("span", { class: "unsaved" });
  store.on(["doc", "waiting"], () => {
    const { doc } = store;
    const file = doc?.file ?? null;
    const title = file === null ? translate("untitled") : (file.split(/[\\/]/).at(-1) ?? file);
    const isDirty = doc !== null && (doc.dirty || store.waitingCount > 0);
    setText(name, verbatim(title));
    setRead(name, "title", file === null ? "not saved yet" : verbatim(file));
    setText(mark, isDirty ? "● unsaved" : "");
    document.title = `${isDirty ? "● " : ""}${title} – groundslab`;
  });
  return h("div", { class: "file" }, name, mark);
}

/** The switch of autosolve, and the button that solves or cancels. */
function solveControls(store: Store, commands: Commands): HTMLElement[] {
  const onchange = () => void commands.autosolve(auto.checked);
  const auto: HTMLInputElement = h("input", { type: "checkbox", role: "switch", id: "autosolve", onchange });
  const onclick = () => void (store.run.kind === "solving" ? commands.cancel() : commands.solve());
  const solve = h("button", { type: "button", class: "main solve", onclick });
  store.on(["doc", "run", "autosolve"], () => {
    const isSolving = store.run.kind === "solving";
    const isFaulty = (store.doc?.issues.length ?? 0) > 0;
    setText(solve, isSolving ? "Cancel" : "Solve");
    solve.classList.toggle("solving", isSolving);
    setRead(
      solve,
      "title",
      isSolving ? "Stop solving" : isFaulty ? "Fix the errors first" : "Solve all combinations (F9)",
    );
    solve.setAttribute("aria-disabled", String(!isSolving && isFaulty));
    auto.checked = store.autosolve;
  });
  const attributes = { class: "switch", for: "autosolve", title: "Solve automatically after every edit" };
  return [h("label", attributes, auto, h("span", { class: "knob" }), "Autosolve"), solve];
}

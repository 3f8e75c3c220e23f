// The bar across the top: the file, undo and redo, solving, the report, light and dark.

import { setTheme, theme } from "../../viewer";
import type { Api } from "../client/api";
import type { Store } from "../client/store";
import type { Actions } from "./commands";
import { h, icon, setText } from "./elements";

/** The top bar. */
export function topBar(store: Store, api: Pick<Api, "reportAddress">, actions: Actions): HTMLElement {
  const button = (words: string, hint: string, run: () => void) =>
    h("button", { type: "button", title: hint, onclick: run }, words);
  const undo = h(
    "button",
    { type: "button", class: "with-icon", "aria-label": "undo", onclick: () => void actions.undo() },
    icon("undo"),
  );
  const redo = h(
    "button",
    { type: "button", class: "with-icon", "aria-label": "redo", onclick: () => void actions.redo() },
    icon("redo"),
  );
  const last = h("span", { class: "last-edit", "aria-hidden": "true" });
  const name = h("span", { class: "file-title" });
  const mark = h("span", { class: "unsaved" });
  const auto = h("input", { type: "checkbox", role: "switch", id: "autosolve" });
  const solve = h("button", {
    type: "button",
    class: "main solve",
    onclick: () => void (store.run.kind === "solving" ? actions.cancel() : actions.solve()),
  });
  const report = h(
    "a",
    { class: "button", role: "button", title: "Save the report of the last result as one HTML file", download: "" },
    "Report",
  );
  const turn = h(
    "button",
    {
      type: "button",
      class: "with-icon",
      title: "Light or dark",
      "aria-label": "light or dark",
      onclick: () => setTheme(theme() === "dark" ? "light" : "dark"),
    },
    icon("theme"),
  );
  auto.addEventListener("change", () => void actions.autosolve(auto.checked));

  const update = () => {
    const { doc, run } = store;
    const file = doc?.file ?? null;
    setText(name, file === null ? "untitled" : (file.split(/[\\/]/).at(-1) ?? file));
    name.title = file ?? "not saved yet";
    const dirty = doc !== null && (doc.dirty || store.waitingCount > 0);
    setText(mark, dirty ? "● unsaved" : "");
    document.title = `${dirty ? "● " : ""}${name.textContent ?? ""} – groundslab`;
    undo.disabled = doc?.can_undo !== true;
    redo.disabled = doc?.can_redo !== true;
    undo.title = doc?.can_undo ? `Undo: ${doc.undo_text} (Ctrl+Z)` : "Nothing to undo";
    redo.title = doc?.can_redo ? `Redo: ${doc.redo_text} (Ctrl+Y)` : "Nothing to redo";
    setText(last, doc?.can_undo ? doc.undo_text : "");
    const solving = run.kind === "solving";
    setText(solve, solving ? "Cancel" : "Solve");
    solve.classList.toggle("solving", solving);
    const faults = doc?.faults.length ?? 0;
    solve.title = solving
      ? "Stop solving"
      : faults > 0
        ? "There are faults to be mended first"
        : "Solve all combinations (F9)";
    solve.setAttribute("aria-disabled", String(!solving && faults > 0));
    auto.checked = store.autosolve;
    const { solved } = store;
    if (solved) report.href = api.reportAddress(solved.run);
    else report.removeAttribute("href");
    report.setAttribute("aria-disabled", String(solved === null));
  };
  store.on(["doc", "waiting", "run", "solved", "autosolve"], update);
  return h(
    "header",
    { class: "top" },
    h("h1", { class: "brand" }, "groundslab"),
    h(
      "div",
      { class: "group", role: "group", "aria-label": "file" },
      button("New", "Start a new case", () => void actions.fresh()),
      button("Open …", "Open a case file (Ctrl+O)", () => void actions.open()),
      button("Save", "Save the case file (Ctrl+S)", () => void actions.save()),
      button("Save as …", "Save under another name (Ctrl+Shift+S)", () => void actions.saveAs()),
    ),
    h("div", { class: "group", role: "group", "aria-label": "edits" }, undo, redo),
    last,
    h("div", { class: "file" }, name, mark),
    h(
      "label",
      { class: "switch", for: "autosolve", title: "Solve by itself after every edit" },
      auto,
      h("span", { class: "knob" }),
      "Autosolve",
    ),
    solve,
    report,
    turn,
  );
}

// A file that another program has changed: said in a banner, its difference shown, and which text counts settled.
import { button, fill, h } from "../../viewer/shared/dom";
import { verbatim } from "../../viewer/shared/language";
import { type Api, type FileChanges, Lost, Refused, type Which } from "../client/api";
import type { Store } from "../client/store";
import { closeDialog, openDialog } from "../controls/dialogs";

/** What a user decides about a file that has changed. */
export type Decision = Which | "as" | "cancel";

const WATCH = 2000; // ms between two looks at the file, while the page is seen

/** Show how the file differs from the page and ask which text counts; at a save it may also get another name. */
export function askAboutChanges(changes: FileChanges, isSaving: boolean): Promise<Decision> {
  return new Promise((resolve) => {
    const close = (decision: Decision) => {
      closeDialog(dialog);
      resolve(decision);
    };
    const answer = (label: string, title: string, decision: Decision, name = "") =>
      button(label, title, () => close(decision), name);
    const why = "They cannot be merged: both changed the same table, or lines next to each other.";
    const isMergeable = changes.merged !== null;
    const merge = answer("Merge", isMergeable ? "Take the changes of both; undo takes it back" : why, "merged", "main");
    merge.disabled = !isMergeable;
    const dialog = h(
      "dialog",
      { class: "changes", "aria-label": "The file has changed" },
      h("h2", {}, "The file has changed"),
      h(
        "p",
        {},
        "Another program has changed the file. Lines with − are those of this page, lines with + of the file.",
      ),
      h("pre", { class: "difference", tabindex: 0 }, ...changes.lines.map(makeLine)),
      h("p", { class: "quiet", hidden: isMergeable }, why),
      h(
        "div",
        { class: "answers" },
        answer("Cancel", "", "cancel"),
        isSaving ? answer("Save as …", "Save under a different name", "as") : null,
        answer("Reload", "Take the text of the file; undo brings this page's text back", "theirs"),
        answer(isSaving ? "Replace the file" : "Keep mine", "Keep this page's text", "mine"),
        merge,
      ),
    );
    openDialog(dialog, () => close("cancel"));
  });
}

function makeLine(line: string): HTMLElement {
  const kind = line.startsWith("+") ? "theirs" : line.startsWith("-") ? "mine" : "same";
  return h("span", { class: kind }, verbatim(`${line}\n`));
}

export interface ChangedFileHooks {
  /** Settle which text counts. */
  take(which: Which, digest: string): Promise<void>;
  onLost(error: Lost): void;
}

/** The banner; hidden while the file is as it was read. It looks at the file while the page is seen. */
export function changedFileBanner(
  store: Store,
  api: Pick<Api, "fileChanged" | "fileChanges">,
  { take, onLost }: ChangedFileHooks,
): HTMLElement {
  const element = h("div", { class: "banner changed-file", role: "alert", hidden: true });
  let isOutside = false;

  const attempt = async (run: () => Promise<void>) => {
    try {
      await run();
    } catch (error) {
      if (error instanceof Lost) onLost(error);
      else if (error instanceof Refused) store.set("notice", { kind: "bad", text: error.message });
      else throw error;
    }
  };
  const settle = (which: Which) => attempt(async () => take(which, (await api.fileChanges()).digest));
  const show = () =>
    attempt(async () => {
      const changes = await api.fileChanges();
      const decision = await askAboutChanges(changes, false);
      if (decision !== "cancel" && decision !== "as") await take(decision, changes.digest);
    });
  fill(
    element,
    h("strong", {}, "Another program has changed the file."),
    button(
      "Reload",
      "Take the text of the file; undo brings this page's text back",
      () => void settle("theirs"),
      "small",
    ),
    button("Keep mine", "Keep this page's text; saving replaces the file", () => void settle("mine"), "small"),
    button("Show difference", "", () => void show(), "small"),
  );

  const set = (outside: boolean) => {
    isOutside = outside;
    element.hidden = !outside || store.connection !== "ok";
  };
  const look = () =>
    attempt(async () => {
      const { doc, connection } = store;
      if (document.hidden || connection !== "ok" || !doc?.file || doc.view !== undefined) return;
      const { outside } = await api.fileChanged();
      if (store.doc?.file === doc.file && store.doc.version === doc.version) set(outside);
    });
  store.on(["doc"], () => set(store.doc?.outside ?? false));
  store.on(["connection"], () => set(isOutside));
  setInterval(() => void look(), WATCH);
  addEventListener("focus", () => void look());
  return element;
}

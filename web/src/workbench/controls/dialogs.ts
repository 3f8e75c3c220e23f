// Questions to the user.

import { button, h, newId } from "../../viewer/shared/dom";

export interface Answer<T> {
  label: string;
  value: T;
  /** The one that Enter takes. */
  main?: boolean;
}

/** Show a dialog; Escape calls `cancel`. */
export function openDialog(dialog: HTMLDialogElement, cancel: () => void): void {
  dialog.addEventListener("cancel", (event) => {
    event.preventDefault();
    cancel();
  });
  document.body.append(dialog);
  dialog.showModal();
}

/** Close a dialog and remove it from the page. */
export function closeDialog(dialog: HTMLDialogElement): void {
  dialog.close();
  dialog.remove();
}

/** Ask a question; resolves with the answer chosen, with `otherwise` on Escape (null: Escape does not close). */
export function ask<T>(
  title: string,
  text: readonly string[],
  answers: readonly Answer<T>[],
  otherwise: T | null,
): Promise<T> {
  return new Promise((resolve) => {
    const id = newId("dialog");
    const close = (value: T) => {
      closeDialog(dialog);
      resolve(value);
    };
    const buttons = answers.map(({ label, value, main = false }) => {
      const answer = button(label, "", () => close(value), main ? "main" : "");
      answer.toggleAttribute("autofocus", main);
      return answer;
    });
    const dialog = h(
      "dialog",
      { class: "ask", "aria-labelledby": id },
      h("h2", { id }, title),
      ...text.map((paragraph) => h("p", {}, paragraph)),
      h("div", { class: "answers" }, ...buttons),
    );
    openDialog(dialog, () => otherwise !== null && close(otherwise));
  });
}

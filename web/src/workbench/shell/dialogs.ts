// Questions to the user.

import { h, newId } from "../../viewer/shared/dom";

export interface Answer<T> {
  label: string;
  value: T;
  /** The one that Enter takes. */
  main?: boolean;
}

/** Ask a question; resolves with the answer chosen, with `otherwise` on Escape (null: Escape does not close). */
export function ask<T>(
  title: string,
  text: readonly (string | Node)[],
  answers: readonly Answer<T>[],
  otherwise: T | null,
): Promise<T> {
  return new Promise((resolve) => {
    const id = newId("dialog");
    const dialog = h("dialog", { class: "ask", "aria-labelledby": id });
    const close = (value: T) => {
      dialog.close();
      dialog.remove();
      resolve(value);
    };
    dialog.addEventListener("cancel", (event) => {
      event.preventDefault();
      if (otherwise !== null) close(otherwise);
    });
    const buttons = answers.map((answer) =>
      h(
        "button",
        {
          type: "button",
          class: answer.main ? "main" : "",
          autofocus: answer.main === true,
          onclick: () => close(answer.value),
        },
        answer.label,
      ),
    );
    dialog.append(
      h("h2", { id }, title),
      ...text.map((each) => (typeof each === "string" ? h("p", {}, each) : each)),
      h("div", { class: "answers" }, ...buttons),
    );
    document.body.append(dialog);
    dialog.showModal();
  });
}

// Buttons that repair an issue, where its repair is known.

import { button, h } from "../../viewer/shared/dom";
import { keep, say, translate } from "../../viewer/shared/language";
import type { Change } from "../model/edits";
import type { Issue } from "../model/issues";

/** The change that a repair makes: one step of undo. */
export type Push = (change: Change) => void;

/** Return a row of buttons that repair an issue, null if no repair is known; `done` is called after one is chosen. */
export function repairButtons(issue: Issue, push: Push, done: () => void): HTMLElement | null {
  const { repairs = [], location } = issue;
  if (repairs.length === 0) return null;
  const buttons = repairs.map(({ label, edits }) => {
    const choose = () => {
      push({ edits, text: keep(`${translate(label)}${location ? ` (${location})` : ""}`) });
      done();
    };
    return button(capitalize(label), say("Fix {location}: {label}", { location, label }), choose, "small");
  });
  return h(
    "span",
    { class: "repairs", role: "group", "aria-label": say("fixes for {location}", { location }) },
    ...buttons,
  );
}

/** Return a text with a capital, unless it starts with a number or a key. */
function capitalize(text: string): string {
  return /^[a-z]+ /.test(text) ? `${text.charAt(0).toUpperCase()}${text.slice(1)}` : text;
}

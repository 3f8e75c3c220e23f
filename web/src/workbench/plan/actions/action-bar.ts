// The buttons of the actions on what is selected.
import { button } from "../../../viewer/shared/dom";
import type { Path } from "../../model/paths";
import type { Actions } from "./actions";
import type { ActionDialog } from "./dialog";
import { FORMS } from "./forms";

/** Return buttons for the actions on the items at some paths; the slab is neither copied nor removed. */
export function actionButtons(actions: Actions, dialog: ActionDialog, paths: readonly Path[]): HTMLElement[] {
  const isSlab = paths.every((path) => path[0] === "plate" && path.length < 3);
  const forms = FORMS.filter((form) => !isSlab || form.name !== "array").map((form) => {
    const each = button(`${form.label} …`, `${form.hint} (${form.key})`, () => dialog.open(form), "small");
    each.setAttribute("aria-keyshortcuts", form.key);
    return each;
  });
  if (isSlab) return forms;
  return [
    ...forms,
    button("Duplicate", "Create a copy next to it (Ctrl+D)", () => actions.duplicate(), "small"),
    button("Remove", "Remove (Delete)", () => actions.remove(), "small"),
  ];
}

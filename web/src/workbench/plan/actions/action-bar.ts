// The buttons of the actions on what is selected.
import { button } from "../../../viewer/shared/dom";
import { allow } from "../../controls/allow";
import type { Actions } from "./actions";
import type { ActionDialog } from "./dialog";
import { FORMS } from "./forms";
import type { SelectionAction } from "./why-not";

/** Make the buttons; `update` lets those act that can, and the others say why they cannot. */
export function actionBar(actions: Actions, dialog: ActionDialog) {
  const acts: { name: SelectionAction; hint: string; button: HTMLButtonElement }[] = FORMS.map((form) => {
    const hint = `${form.hint} (${form.key})`;
    const each = button(`${form.label} …`, hint, () => dialog.open(form), "small");
    each.setAttribute("aria-keyshortcuts", form.key);
    return { name: form.name, hint, button: each };
  });
  const add = (name: SelectionAction, label: string, hint: string, act: () => void) =>
    acts.push({ name, hint, button: button(label, hint, act, "small") });
  add("duplicate", "Duplicate", "Create a copy next to it (Ctrl+D)", () => actions.duplicate());
  add("remove", "Remove", "Remove (Delete)", () => actions.remove());
  const update = () => {
    for (const { name, hint, button } of acts) allow(button, actions.whyNot(name), hint);
  };
  return { buttons: acts.map(({ button }) => button), update };
}

// The buttons of the actions on what is selected.

import { allow, button } from "../../../viewer/shared/dom";
import { keep, translate } from "../../../viewer/shared/language";
import type { Actions } from "./actions";
import type { ActionDialog } from "./dialog";
import { FORMS } from "./forms";
import type { SelectionAction } from "./why-not";

/** Make the buttons; `update` lets those act that can, and the others say why they cannot. */
export function actionBar(actions: Actions, dialog: ActionDialog) {
  const forms = FORMS.map((form) => {
    const each = button(
      keep(`${translate(form.label)} …`),
      keep(`${translate(form.hint)} (${form.key})`),
      () => dialog.open(form),
      "small",
    );
    each.setAttribute("aria-keyshortcuts", form.key);
    return [form.name, each] as const;
  });
  const acts: readonly (readonly [SelectionAction, HTMLButtonElement])[] = [
    ...forms,
    ["duplicate", button("Duplicate", "Create a copy next to it (Ctrl+D)", () => actions.duplicate(), "small")],
    ["remove", button("Remove", "Remove (Delete)", () => actions.remove(), "small")],
  ];
  const update = () => {
    for (const [name, each] of acts) allow(each, actions.whyNot(name));
  };
  return { buttons: acts.map(([, each]) => each), update };
}

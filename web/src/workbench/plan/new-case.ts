// What a new load case is asked for: its name, its action, and where loads belong that had no case before the first one.

import { fillOptions, h, setRead } from "../../viewer/shared/dom";
import { counted } from "../../viewer/shared/language";
import type { Store } from "../client/store";
import { CASE_TYPES, caseOf, meaningOf, usualName } from "../model/changes/load-cases";
import { addLoadCase, countUncased } from "../model/changes/new-items";
import type { Change } from "../model/edits";
import { freeName, namesIn } from "../model/names";
import { listAt } from "../model/paths";

export interface NewCase {
  readonly element: HTMLElement;
  /** Ask, or stop to. */
  show(isAsked: boolean): void;
}

/**
 * The fields of a new load case; it is made as soon as its action is chosen, without a name with a usual one. `done` is
 * called with its name, or without one.
 *
 * Loads that had no case go to a permanent one without a question; whoever wants them apart says so first.
 */
export function newCase(store: Store, push: (change: Change) => void, done: (name: string | null) => void): NewCase {
  const name = h("input", { "aria-label": "name of the new load case", placeholder: "name" });
  const action = h("select", { "aria-label": "action of the new load case" });
  const others = h("select", { "aria-label": "loads without a case" });
  const element = h("span", { class: "new-case", hidden: true }, name, action, others);
  const ownCase = () => freeName([name.value.trim()], "permanent");
  const show = (isAsked: boolean) => {
    element.hidden = !isAsked;
    name.value = "";
    fillOptions(action, [["", "action?"], ...CASE_TYPES.map(({ id, label }) => [id, label] as const)]);
    const count = countUncased(store.data);
    const words = counted(count, "the existing load?", "the {count} existing loads?");
    fillOptions(others, [
      ["", words],
      ["in it", "in this case"],
      ["apart", "in a separate permanent case"],
    ]);
    others.hidden = count === 0;
    for (const option of action.options)
      if (option.value) setRead(option, "title", meaningOf(option.value, store.data, store.doc?.factors));
    // options that are the same keep what was chosen for the case before
    action.value = "";
    others.value = "";
    if (isAsked) name.focus();
  };
  const isKnown = () => namesIn(listAt(store.data, ["cases"])).includes(name.value.trim());
  const goOn = () => {
    if (store.broken) return name.focus();
    const text = name.value.trim() || (action.value && usualName(store.data, action.value));
    if (!isKnown()) {
      if (!text || !action.value) return action.focus();
      if (!others.hidden && !others.value && action.value === "permanent") others.value = "in it";
      if (!others.hidden && !others.value) return others.focus();
      const owner = others.value === "apart" ? ownCase() : text;
      push(addLoadCase(store.data, text, caseOf(action.value), owner));
    }
    show(false);
    done(text);
  };
  action.addEventListener("change", goOn);
  others.addEventListener("change", goOn);
  element.addEventListener("keydown", (event) => {
    if (event.key === "Enter") goOn();
    if (event.key !== "Escape") return;
    show(false);
    done(null);
  });
  return { element, show };
}

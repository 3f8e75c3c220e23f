// Lists to choose a field and a combination from.

import { type Choice, choiceName, type Envelope, envelopesOf, fieldsOf, parseChoice } from "../data/fields";
import type { Scene } from "../data/scene";
import { make, symbolText } from "../shared/dom";

/** Fill a list with the fields of a scene; `chosen` stays chosen if it is there. Returns the one that is chosen then. */
export function fillFields(select: HTMLSelectElement, scene: Scene, chosen?: string): string {
  const fields = fieldsOf(scene);
  const option = (field: (typeof fields)[number]) =>
    make(
      "option",
      { value: field.name, title: field.meaning },
      `${symbolText(field.symbol)} \u2013 ${field.meaning.split(/[,(]/)[0]!.trim()}`,
    );
  select.replaceChildren(
    make("optgroup", { label: "Results" }, ...fields.filter((field) => !field.derived).map(option)),
    make("optgroup", { label: "Derived moments" }, ...fields.filter((field) => field.derived).map(option)),
  );
  const found = fields.find((field) => field.name === chosen) ?? fields[0];
  if (found) select.value = found.name;
  return found?.name ?? "";
}

/** Fill a list with the combinations and envelopes of a scene. Returns what is chosen then; null: nothing to show. */
export function fillCombinations(select: HTMLSelectElement, scene: Scene, chosen?: Choice): Choice | null {
  const { combinations, left_out: leftOut } = scene.head;
  const envelopes = envelopesOf(scene);
  const groups: HTMLElement[] = [];
  if (envelopes.length)
    groups.push(
      make(
        "optgroup",
        { label: "Envelopes" },
        ...envelopes.map((each: Envelope) => make("option", { value: each }, choiceName(scene, each))),
      ),
    );
  const options = combinations.map((each, i) => {
    const why =
      each.refused !== null
        ? " (no equilibrium)"
        : each.values === null
          ? leftOut.includes(each.name)
            ? " (left out)"
            : " (no values)"
          : each.certified
            ? ""
            : " (not certified)";
    return make(
      "option",
      { value: i, disabled: each.values === null, title: each.refused ?? "" },
      choiceName(scene, i) + why,
    );
  });
  groups.push(...(envelopes.length ? [make("optgroup", { label: "Combinations" }, ...options)] : options));
  select.replaceChildren(...groups);
  const wanted =
    chosen === undefined
      ? undefined
      : [...select.options].find((option) => option.value === String(chosen) && !option.disabled);
  const found = wanted ?? [...select.options].find((option) => !option.disabled && /^\d+$/.test(option.value));
  if (!found) return null;
  select.value = found.value;
  return parseChoice(found.value);
}

// What a generator of loads or columns asks for, and the load case that its loads are in.
import type { Additions } from "../../model/changes/copies";
import { addLoadCase } from "../../model/changes/new-items";
import type { Edit } from "../../model/edits";
import { freeName, namesIn } from "../../model/names";
import { isTable, listAt, type Table } from "../../model/paths";
import type { ActionField, Force, Values } from "../fields";

export type GeneratorName = "racks" | "vehicle" | "columns" | "axes";

export interface Generator {
  name: GeneratorName;
  label: string;
  key: string;
  hint: string;
  fields: readonly ActionField[];
  /** The fields of x and y of the places that can be picked in the plan. */
  places: readonly (readonly [string, string])[];
  /** Return what the values make, as one change; throws Impossible. */
  generate(data: Table, values: Values): Additions;
}

/** The choice of a load case that is made with the loads. */
export const NEW_CASE = "new load case";

export const CASE: ActionField = { key: "case", label: "load case", is: "case", initial: "" };

/** The case of traffic and of stored goods, which is never permanent. */
export const IMPOSED_CASE: ActionField = { ...CASE, imposed: true };

/** Return the load cases to choose from; imposed loads are in none that is permanent, as one without an action is. */
export function casesToChoose(data: Table, imposed = false): string[] {
  const cases = listAt(data, ["cases"]).filter(isTable);
  return [...namesIn(cases.filter(({ action }) => !imposed || (action ?? "permanent") !== "permanent")), NEW_CASE];
}

/** Return the edits that the chosen load case needs, and its name; loads that had none before get one of their own. */
export function chosenCase(
  data: Table,
  values: Values,
  name: string,
  imposed = false,
): { edits: Edit[]; case: string } {
  const cases = namesIn(listAt(data, ["cases"]));
  const chosen = values.case ?? "";
  if (casesToChoose(data, imposed).slice(0, -1).includes(chosen)) return { edits: [], case: chosen };
  const free = freeName(cases, name);
  const others = [...listAt(data, ["loads"]), ...listAt(data, ["moves"])].some(isTable);
  const before =
    cases.length === 0 && others ? addLoadCase(data, freeName([free], "permanent"), { action: "permanent" }).edits : [];
  return {
    edits: [...before, { op: "add", path: ["cases"], value: { name: free, action: "variable" } }],
    case: free,
  };
}

/** Return a force as the case file writes it. */
export function formatForce({ value, unit }: Force, factor = 1): string {
  return `${Number((value * factor).toPrecision(6))} ${unit}`;
}

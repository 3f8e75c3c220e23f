// What load cases can be, what that means, and the changes that are made in them and in combinations: each one step.
import { say, together, verbatim } from "../../../viewer/shared/language";
import { defaultsFor } from "../defaults";
import type { Change, Edit } from "../edits";
import { type Issue, issueSentence, type Remark } from "../issues";
import { freeName, namesIn } from "../names";
import { isTable, type Json, listAt, type Path, startsWith, type Table, tableAt } from "../paths";
import { joinEdits } from "./batches";

/** Factors of actions where a case gives none, as the server knows them. */
export interface UsualFactors {
  /** Partial factors, unfavorable and favorable. */
  permanent: readonly number[];
  variable: readonly number[];
  /** psi_0, psi_1 and psi_2 by category, and of other variable actions. */
  psi: Readonly<Record<string, readonly number[]>>;
}

const UNKNOWN: UsualFactors = { permanent: [], variable: [], psi: {} };

/** A combination: what factors cases have in it, and by which rule it is made. */
export interface Combination {
  name: string;
  limit_state: string;
  rule: string;
  factors: Readonly<Record<string, number>>;
}

/** The sums of load cases about a place, with their units, and the combinations that the program makes. */
export interface CaseSums {
  about: [number, number];
  length: string;
  force: string;
  moment: string;
  cases: readonly { name: string; F: number; M_x: number; M_y: number; acts: boolean; positions?: readonly string[] }[];
  made: readonly Combination[];
}

/** What a load case can be: an action, of a variable one its category. */
export const CASE_TYPES: readonly { id: string; label: string }[] = [
  { id: "permanent", label: "permanent" },
  { id: "A", label: "variable A: homes" },
  { id: "B", label: "variable B: offices" },
  { id: "C", label: "variable C: assembly" },
  { id: "D", label: "variable D: shops" },
  { id: "E", label: "variable E: storage" },
  { id: "F", label: "variable F: vehicles to 30 kN" },
  { id: "G", label: "variable G: vehicles to 160 kN" },
  { id: "H", label: "variable H: roofs" },
  { id: "snow", label: "snow to 1000 m" },
  { id: "snow above 1000 m", label: "snow above 1000 m" },
  { id: "wind", label: "wind actions" },
  { id: "temperature", label: "temperature changes" },
  { id: "settlement", label: "settlements of the ground" },
  { id: "variable", label: "variable, other" },
  { id: "accidental", label: "accidental" },
  { id: "seismic", label: "seismic" },
];
const ACTIONS = ["permanent", "variable", "accidental", "seismic"];
//: what load cases of a type are usually called, all others Q
const LETTERS: Readonly<Record<string, string>> = {
  permanent: "G",
  snow: "S",
  "snow above 1000 m": "S",
  wind: "W",
  temperature: "T",
  accidental: "A",
  seismic: "E",
};

/** Return the keys of a load case of a type. */
export function caseOf(type: string): Table {
  return ACTIONS.includes(type) ? { action: type } : { action: "variable", category: type };
}

/** Return a name for a new load case of a type that no other one has. */
export function usualName(data: Table, type: string): string {
  return freeName(namesIn(listAt(data, ["cases"])), LETTERS[type] ?? "Q");
}

/** Return the type of a load case. */
export function typeOf(loadCase: Table): string {
  const action = String(loadCase.action ?? "permanent");
  return action === "variable" && typeof loadCase.category === "string" ? loadCase.category : action;
}

/** Return what a type means in one line: its factors by the code in [combine], and its psi. */
export function meaningOf(type: string, data: Table, usual: UsualFactors = UNKNOWN, own: Table = {}): string {
  const combine = tableAt(data, ["combine"]);
  const { action } = caseOf(type);
  if (action === "seismic") return "Acts in seismic combinations alone, in both directions, factors 1 and -1.";
  if (action === "accidental") return "Acts in accidental combinations alone, with the factor 1.";
  if (combine.expression === "ACI 318") {
    if (action === "permanent") return "Dead load D by ASCE 7: always acts, with 1.4, 1.2 or 0.9.";
    if (type === "wind") return "Wind load W by ASCE 7: acts or is absent, with 1.0 or 0.5.";
    if (type === "H" || type.startsWith("snow"))
      return "Roof or snow load by ASCE 7: acts or is absent, with 1.6 or 0.5.";
    return "Live load L by ASCE 7: acts or is absent, with 1.6 or 1.0.";
  }
  if (action === "permanent") {
    const [most = "", least = ""] = factorsOf(combine.permanent ?? usual.permanent);
    return say("Always acts: factor {most} where unfavorable, {least} where favorable.", { most, least });
  }
  const [gamma = ""] = factorsOf(combine.variable ?? usual.variable);
  const psi = factorsOf(usual.psi[type] ?? usual.psi.variable);
  const [psi_0 = "", psi_1 = "", psi_2 = ""] = psi.map((value, n) => String(own[`psi_${n}`] ?? value));
  return say("Acts or is absent: factor {gamma}; ψ0 {psi_0}, ψ1 {psi_1}, ψ2 {psi_2}.", { gamma, psi_0, psi_1, psi_2 });
}

/** Return three factors of a list, those that are not known as a dash. */
function factorsOf(values: Json | readonly number[] | undefined): string[] {
  return [0, 1, 2].map((n) => String((Array.isArray(values) ? values[n] : undefined) ?? "–"));
}

/** Return the change that gives a case another type; psi of its own go, as they are those of the type before. */
export function retypeCase(data: Table, n: number, type: string): Change {
  const own = tableAt(data, ["cases", n]);
  const { action, category } = caseOf(type) as Record<string, Json | undefined>;
  const gone = ["category", "psi_0", "psi_1", "psi_2"].filter((key) => key in own && !(key === "category" && category));
  const edits: Edit[] = gone.map((key) => ({ op: "remove", path: ["cases", n, key] }));
  edits.push({ op: "set", path: ["cases", n, "action"], value: action! });
  if (category) edits.push({ op: "set", path: ["cases", n, "category"], value: category });
  return { edits, text: say("change the type of case {name}", { name: verbatim(String(own.name ?? n + 1)) }) };
}

/** Return the paths of the loads and moves in a case. */
export function loadsIn(data: Table, name: string): Path[] {
  return ["loads", "moves"].flatMap((list) =>
    listAt(data, [list]).flatMap((item, n): Path[] => (isTable(item) && item.case === name ? [[list, n]] : [])),
  );
}

/** Return the positions of the combinations that name no other case. */
export function combinationsOfOnly(data: Table, name: string): number[] {
  return listAt(data, ["combinations"]).flatMap((_, n) => {
    const names = Object.keys(tableAt(data, ["combinations", n, "factors"]));
    return names.includes(name) && names.length === 1 ? [n] : [];
  });
}

/** Return the change that removes a case and its factors; its loads go with it, or to another case, `""`: to none. */
export function removeCase(data: Table, n: number, owner: string | null): Change {
  const name = String(tableAt(data, ["cases", n]).name ?? "");
  const isLast = listAt(data, ["cases"]).length === 1;
  const backwards = loadsIn(data, name).toReversed();
  const edits: Edit[] = backwards.map((path): Edit => {
    if (owner === null) return { op: "remove", path };
    const place = [...path, "case"];
    return owner ? { op: "set", path: place, value: owner } : { op: "remove", path: place };
  });
  const alone = combinationsOfOnly(data, name);
  listAt(data, ["combinations"]).forEach((_, at) => {
    const named = name in tableAt(data, ["combinations", at, "factors"]);
    if (named && !alone.includes(at)) edits.push({ op: "remove", path: ["combinations", at, "factors", name] });
  });
  edits.push(...alone.toReversed().map((at): Edit => ({ op: "remove", path: ["combinations", at] })));
  const pairs = listAt(data, ["reactions", "cases"]);
  const called = pairs.flatMap((pair, at) => (isTable(pair) && pair.case === name ? [at] : [])).toReversed();
  edits.push(...called.map((at): Edit => ({ op: "remove", path: ["reactions", "cases", at] })));
  edits.push({ op: "remove", path: isLast ? ["cases"] : ["cases", n] });
  if (isLast && "combine" in data) edits.push({ op: "remove", path: ["combine"] });
  return joinEdits(data, { edits, text: say("remove load case {name}", { name: verbatim(name) }) });
}

/** Return the change that moves a case to another position, null if it is there or there is none. */
export function moveCase(data: Table, n: number, to: number): Change | null {
  const count = listAt(data, ["cases"]).length;
  if (to === n || to < 0 || to >= count) return null;
  const name = String(tableAt(data, ["cases", n]).name ?? n + 1);
  return {
    edits: [{ op: "reorder", path: ["cases", n], value: to }],
    text: say("move load case {name}", { name: verbatim(name) }),
  };
}

/** Whether the self-weight of the slab acts in a case. */
export function hasSelfWeight(data: Table, name: string): boolean {
  return selfWeights(data).some((path) => tableAt(data, path).case === name);
}

/** Return the change that lets the self-weight act in a case, and no longer in another one, or takes it away. */
export function setSelfWeight(data: Table, name: string, on: boolean): Change {
  const text = on
    ? say("self-weight in case {name}", { name: verbatim(name) })
    : say("no self-weight in case {name}", { name: verbatim(name) });
  const there = selfWeights(data);
  if (!on) {
    const own = there.filter((path) => tableAt(data, path).case === name).toReversed();
    return { edits: own.map((path) => ({ op: "remove", path })), text };
  }
  if (there.length > 0) {
    return { edits: there.map((path) => ({ op: "set", path: [...path, "case"], value: name })), text };
  }
  const value = { ...defaultsFor("SelfWeight", data), case: name };
  return { edits: [{ op: "add", path: ["loads"], value }], text };
}

function selfWeights(data: Table): Path[] {
  return listAt(data, ["loads"]).flatMap((load, n): Path[] =>
    isTable(load) && load.kind === "self weight" ? [["loads", n]] : [],
  );
}

/** Return the combinations that the file lists. */
export function listedCombinations(data: Table): Combination[] {
  return listAt(data, ["combinations"]).map((_, n) => {
    const { name = "", limit_state = "ultimate", rule = "", factors } = tableAt(data, ["combinations", n]);
    const numbers = Object.entries(isTable(factors) ? factors : {}).map(([key, value]) => [key, Number(value)]);
    return {
      name: String(name),
      limit_state: String(limit_state),
      rule: String(rule),
      factors: Object.fromEntries(numbers),
    };
  });
}

/** Return the names of the positions of a case that moves, without its own name; none of one that stands. */
export function positionsOf(sums: CaseSums | null, name: string): string[] {
  const positions = sums?.cases.find((each) => each.name === name)?.positions ?? [];
  return positions.map((each) => each.slice(name.length).trim());
}

/** Return the change that adds a combination, in which every case has the factor 1. */
export function addCombination(data: Table, taken: readonly string[], limitState: string): Change {
  const name = freeName([...namesIn(listAt(data, ["combinations"])), ...taken], "C1");
  const factors = Object.fromEntries(namesIn(listAt(data, ["cases"])).map((each) => [each, 1]));
  const value = { name, limit_state: limitState, factors };
  return {
    edits: [{ op: "add", path: ["combinations"], value }],
    text: say("add combination {name}", { name: verbatim(name) }),
  };
}

/** Return the change of one factor; 0 leaves the case out. */
export function setFactor(data: Table, n: number, name: string, factor: number): Change {
  const path: Path = ["combinations", n, "factors", name];
  const edit: Edit = factor === 0 ? { op: "remove", path } : { op: "set", path, value: factor };
  const of = String(tableAt(data, ["combinations", n]).name ?? n + 1);
  return {
    edits: [edit],
    text: say("factor of {name} in combination {combination}", { name: verbatim(name), combination: verbatim(of) }),
  };
}

/** Return the change that makes combinations by an expression, none of them without one. */
export function setExpression(data: Table, expression: string): Change {
  const text = "make combinations";
  if (!expression) return { edits: [{ op: "remove", path: ["combine"] }], text: "make no combinations" };
  if (!isTable(data.combine)) {
    const value = { sets: ["ultimate", "characteristic", "quasi-permanent"], expression };
    return { edits: [{ op: "set", path: ["combine"], value }], text };
  }
  const given = expression === "ACI 318" ? ["permanent", "variable", "xi", "separate"] : [];
  const gone = given.filter((key) => key in tableAt(data, ["combine"]));
  const edits: Edit[] = gone.map((key) => ({ op: "remove", path: ["combine", key] }));
  return { edits: [...edits, { op: "set", path: ["combine", "expression"], value: expression }], text };
}

const NO_LOADS = "No loads yet: choose the case in the plan and draw them, or check self-weight here.";

/** What is said of a case: in words of the program or, of issues and remarks, of the server. */
export interface CaseNote {
  words: string;
  /** Whether the words are a message of the page. */
  own: boolean;
  /** Bad: what is wrong or acts nowhere; a remark; an invitation to go on with what has just been made. */
  kind: "bad" | "remark" | "invitation";
}

/** Return what does not act as it may have been meant: a case without loads or in no combination, loads off the plate. */
export function notesOn(
  data: Table,
  n: number,
  sums: CaseSums | null,
  issues: readonly Issue[],
  remarks: readonly Remark[],
): CaseNote[] {
  const own = tableAt(data, ["cases", n]);
  const name = String(own.name ?? "");
  const loads = loadsIn(data, name);
  const isEmpty = loads.length === 0 && !own.H_x && !own.H_y;
  const notes: CaseNote[] = isEmpty ? [{ words: NO_LOADS, own: true, kind: "invitation" }] : [];
  const acts = sums?.cases.find((each) => each.name === name)?.acts ?? true;
  if (!acts && !isEmpty) notes.push({ words: "This case acts in no combination.", own: true, kind: "bad" });
  const places: Path[] = [["cases", n], ...loads];
  const isHere = ({ path }: { path: Path }) => places.some((place) => startsWith(path, place));
  for (const issue of issues.filter(isHere))
    notes.push({ words: together([issue.location, issueSentence(issue)], ": "), own: false, kind: "bad" });
  for (const { words } of remarks.filter((remark) => remark.path[0] !== "cases" && isHere(remark)))
    notes.push({ words, own: false, kind: "remark" });
  return notes;
}

/** Whether there are cases of which none is variable. */
export function lacksVariable(data: Table): boolean {
  const cases = listAt(data, ["cases"]);
  return cases.length > 0 && cases.every((each) => !isTable(each) || each.action !== "variable");
}

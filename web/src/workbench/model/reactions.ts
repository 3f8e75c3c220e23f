// What is said of a table of reactions before it is imported, as people type it and as the server takes it.

import { type Table, tableAt } from "./paths";

/** What the server has found: what changes, sums by case before and after, remarks; a line each. */
export interface ReactionChanges {
  changes: string[];
  sums: string[];
  remarks: string[];
}

/** What is said of the import: names, and keys of [reactions] that differ from those of the case. */
export interface ReactionChoice {
  new_cases: Record<string, string>;
  cases: Record<string, string>;
  supports: Record<string, string>;
  move_columns: boolean;
  reading: Table;
}

/** What is typed into the dialog; nothing means: as in the case. */
export interface TypedReactions {
  newCases: string;
  cases: string;
  supports: string;
  withoutCases: string;
  withoutSupports: string;
  positive: string;
  moments: string;
  mirrored: boolean;
  tolerance: string;
  widthX: string;
  widthY: string;
  force: string;
  moment: string;
  length: string;
  moveColumns: boolean;
  sheet: string;
  headings: string;
  decimals: string;
  onlyCase: string;
  originX: string;
  originY: string;
  horizontal: string;
}

export const POSITIVE = ["presses", "lifts"] as const;
export const MOMENTS = ["about axes", "about axes, left-handed", "as here"] as const;

export const HORIZONTAL = ["left out", "on the slab", "on the structure"] as const;
/** What stands before decimals; nothing where the numbers say it. */
export const DECIMALS = ["", "point", "comma"] as const;

/** Whether a file is a table by its name. */
export function isTableFile(file: string): boolean {
  return /\.(csv|xlsx)$/i.test(file);
}

/** The pairs in lines such as `LIVE = B`; a line without the sign is kept with nothing behind it, for the server to refuse. */
export function parsePairs(text: string): Record<string, string> {
  const pairs = linesOf(text).map((line) => {
    const at = line.lastIndexOf("=");
    return at < 0 ? [line, ""] : [line.slice(0, at).trim(), line.slice(at + 1).trim()];
  });
  return Object.fromEntries(pairs);
}

function linesOf(text: string): string[] {
  return text
    .split("\n")
    .map((line) => line.trim())
    .filter((line) => line !== "");
}

/** How the last table was read, for the dialog to begin with. */
export function lastReading(
  data: Table | null,
): Pick<TypedReactions, "positive" | "moments" | "mirrored" | "horizontal"> {
  const last = tableAt(data ?? {}, ["reactions"]);
  const word = (value: unknown, known: readonly string[]) => known.find((each) => each === value) ?? known[0]!;
  return {
    positive: word(last.positive, POSITIVE),
    moments: word(last.moments, MOMENTS),
    mirrored: last.mirrored === true,
    horizontal: word(last.horizontal, HORIZONTAL),
  };
}

/** What the server takes of what was typed. */
export function choiceOf(typed: TypedReactions): ReactionChoice {
  const { positive, moments, mirrored, horizontal } = typed;
  const reading: Table = { positive, moments, mirrored, horizontal };
  for (const key of ["tolerance", "force", "moment", "length", "sheet", "decimals"] as const)
    if (typed[key].trim() !== "") reading[key] = typed[key].trim();
  if (typed.onlyCase.trim() !== "") reading.case = typed.onlyCase.trim();
  const headings = parsePairs(typed.headings);
  if (Object.keys(headings).length > 0) reading.headings = headings;
  const origin = [typed.originX.trim(), typed.originY.trim()];
  if (origin.some((place) => place !== "")) reading.origin = origin.map((place) => place || "0 m");
  const widths = [typed.widthX.trim(), typed.widthY.trim()];
  if (widths.some((width) => width !== "")) reading.footprint = widths.map((width) => width || widths.join(""));
  const [cases, supports] = [linesOf(typed.withoutCases), linesOf(typed.withoutSupports)];
  if (cases.length > 0) reading.without_cases = cases;
  if (supports.length > 0) reading.without_supports = supports;
  return {
    new_cases: parsePairs(typed.newCases),
    cases: parsePairs(typed.cases),
    supports: parsePairs(typed.supports),
    move_columns: typed.moveColumns,
    reading,
  };
}

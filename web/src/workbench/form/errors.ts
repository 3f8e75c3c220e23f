// Which field a fault belongs to.

import type { Fault } from "../client/api";
import { type Path, startsWith } from "../model/paths";
import type { Part } from "../model/schema";

/** The faults of a value: at its path or below. */
export function faultsAt(faults: readonly Fault[], path: Path): Fault[] {
  return faults.filter((fault) => startsWith(fault.path, path));
}

/** The faults of a table that none of its fields shows: of the table as a whole, and of keys that it has not. */
export function faultsOfPart(faults: readonly Fault[], path: Path, part: Part | null): Fault[] {
  const names = new Set<string | number>(part?.fields.map((field) => field.name) ?? ["kind"]);
  return faultsAt(faults, path).filter((fault) => {
    const next = fault.path[path.length];
    return next === undefined || (typeof next === "string" && !names.has(next));
  });
}

/** The faults of a list as a whole. */
export function faultsOfList(faults: readonly Fault[], path: Path): Fault[] {
  return faultsAt(faults, path).filter((fault) => typeof fault.path[path.length] !== "number");
}

/** What is wrong, in one line below its field. */
export function faultWords(fault: Fault): string {
  const mend = fault.mend ? ` — ${fault.mend}` : "";
  return ended(`Got ${fault.got}, expected ${fault.expected}${mend}`);
}

/** A sentence with its mark at the end. */
function ended(words: string): string {
  return /[.?!]$/.test(words) ? words : `${words}.`;
}

// How results, and what is in the picture, stand to the model that is edited; no elements here.
import type { Drawn, Preview, Solved } from "../client/store";

/** Of the present model: a preview, provisional or last results; of an earlier one: outdated; nothing at all: empty. */
export type Standing = "empty" | "preview" | "provisional" | "current" | "outdated";

/** The model that is edited. */
interface Edited {
  doc: { version: number } | null;
  /** How many edits are still on their way to the server. */
  waitingCount: number;
}

/** What the server has told of results and of the model. */
export interface Known extends Edited {
  drawn: Drawn | null;
  preview: Preview | null;
  solved: Solved | null;
}

/** Whether there is a result, and whether it is of the present model. */
export type Freshness = "none" | "fresh" | "stale";

/** Return whether a result or a preview is of the present model. */
export function freshness(told: { version: number } | null, { doc, waitingCount }: Edited): Freshness {
  if (!told) return "none";
  return told.version === doc?.version && waitingCount === 0 ? "fresh" : "stale";
}

/** Return how what is drawn stands to the present model. */
export function standingOf(known: Known): Standing {
  const { drawn, preview, solved } = known;
  if (!drawn) return "empty";
  const told = drawn.isPreview ? preview : solved;
  if (told?.run !== drawn.run || freshness(told, known) !== "fresh") return "outdated";
  if (drawn.isPreview) return "preview";
  return solved?.provisional ? "provisional" : "current";
}

/** Return why nothing for the present model can be made of the last results, empty if it can. */
export function whyNotMade(known: Known): string {
  if (known.solved === null) return "Solve first: there are no results yet.";
  if (freshness(known.solved, known) === "stale") return "Solve first: the case has changed since.";
  return known.solved.provisional === "" ? "" : "The mesh is still being refined.";
}

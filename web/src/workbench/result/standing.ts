// How what is in the picture stands to the model that is edited; no elements here.
import type { Drawn, Preview, Solved } from "../client/store";

/** Of the present model: a preview, provisional or last results; of an earlier one: outdated; nothing at all: empty. */
export type Standing = "empty" | "preview" | "provisional" | "current" | "outdated";

/** What the server has told of results and of the model. */
export interface Known {
  drawn: Drawn | null;
  preview: Preview | null;
  solved: Solved | null;
  doc: { version: number } | null;
  /** How many edits are still on their way to the server. */
  waitingCount: number;
}

/** Return how what is drawn stands to the present model. */
export function standingOf({ drawn, preview, solved, doc, waitingCount }: Known): Standing {
  if (!drawn) return "empty";
  const told = drawn.isPreview ? preview : solved;
  if (told?.run !== drawn.run || told.version !== doc?.version || waitingCount > 0) return "outdated";
  if (drawn.isPreview) return "preview";
  return solved?.provisional ? "provisional" : "current";
}

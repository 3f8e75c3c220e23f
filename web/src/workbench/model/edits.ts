// Edits of the case file, as the server takes them.
import type { Json, Path } from "./paths";

export type Edit =
  | { op: "set"; path: Path; value: Json }
  | { op: "length"; path: Path; value: number | readonly unknown[] }
  | { op: "add"; path: Path; value: Json; at?: number }
  | { op: "remove"; path: Path }
  | { op: "rename"; path: Path; value: string }
  | { op: "reorder"; path: Path; value: number }
  | { op: "move"; path: Path; by: readonly [number, number] }
  | { op: "text"; value: string };

/** What the user did: one step of undo. */
export interface Change {
  edits: Edit[];
  text: string;
  /** Whether it continues the step before it. */
  merge?: boolean;
}

/** A change that adds something, and the path of what it adds. */
export interface Addition {
  change: Change;
  path: Path;
}

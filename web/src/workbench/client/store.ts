// The state of the page, and listeners to its changes. No elements here.

import { applyOptimistic } from "../model/changes/optimistic-edits";
import type { Change, Edit } from "../model/edits";
import type { Issue } from "../model/issues";
import { type Path, pathKey, samePath, type Table } from "../model/paths";
import type { Underlay } from "../model/survey";
import type { CombinationSummary, ComparisonKind, DocState, OfResult } from "./api";

/** The state of the connection. */
export type Connection = "ok" | "away" | "unauthorized";

/** What the solver is doing. */
export type Run =
  | { kind: "idle" }
  | { kind: "solving"; run: number; version: number; text: string; share: number | null; details?: string }
  | { kind: "refused"; version: number; message: string; issues: readonly Issue[] }
  | { kind: "cancelled" };

/** The result shown. */
export interface Solved {
  run: number;
  version: number;
  /** How long it took, null where the result was read from a file. */
  seconds: number | null;
  /** What fails in the design, empty if nothing was found to. */
  design: string;
  /** That the mesh is still to be refined, in words; empty where it is not. */
  provisional: string;
  /** How often results of this run have been replaced by such on a finer mesh, or with checks. */
  update: number;
}

/** The picture of a run that has not ended; what it is, in words; the figures of its combination. */
export interface Preview {
  run: number;
  version: number;
  words: string;
  figures: CombinationSummary;
}

/** What is in the picture: the preview of a run, or its result. */
export interface Drawn {
  run: number;
  isPreview: boolean;
}

/** The comparison made last: of what, of which run, how far it is; why there is none. */
export interface Comparison {
  kind: ComparisonKind;
  run: number;
  state: "running" | "done" | "failed";
  text: string;
  share: number;
}

/** What listeners can be called about. */
export type Topic =
  | "comparison"
  | "doc"
  | "data"
  | "drawn"
  | "connection"
  | "preview"
  | "run"
  | "solved"
  | "selection"
  | "waiting"
  | "autosolve"
  | "notice"
  | "opened"
  | "report"
  | "shown"
  | "underlay";

/** What of the store is one value that others set. */
type Settable =
  | "drawn"
  | "connection"
  | "comparison"
  | "preview"
  | "report"
  | "run"
  | "solved"
  | "autosolve"
  | "notice"
  | "shown"
  | "underlay";

/** What is shown of the result. */
export interface ShownResult extends OfResult {
  meaning: string;
  /** What the combination or the envelope is called. */
  of: string;
  /** Whether it can be drawn as a file: envelopes over several limit states cannot. */
  isDrawable: boolean;
}

/** A report or another file that is being made. */
export interface Making {
  run: number;
  text: string;
  share: number;
}

/** A short message to the user, with an action. */
export interface Notice {
  text: string;
  kind: "info" | "bad";
  action?: { label: string; run: () => void };
}

export class Store {
  doc: DocState | null = null;
  schema: Table | null = null;
  connection: Connection = "ok";
  run: Run = { kind: "idle" };
  solved: Solved | null = null;
  preview: Preview | null = null;
  drawn: Drawn | null = null;
  comparison: Comparison | null = null;
  shown: ShownResult | null = null;
  /** The file that is being made; of a report which chapter, and the share that is made. */
  report: Making | null = null;
  autosolve = false;
  /** The paths of the items that are selected, the latest last. */
  selected: readonly Path[] = [];
  notice: Notice | null = null;
  /** The drawing below the plan. */
  underlay: Underlay | null = null;
  /** The server's data with the edits that are still on their way. */
  data: Table = {};
  /** The server's data; those of the last text that could be read while this one is not. */
  private readable: Table = {};
  private waiting: readonly Change[] = [];
  private readonly listeners = new Map<Topic, Set<() => void>>();

  /** Call a function whenever one of the topics changes; returns how to stop that. */
  on(topics: readonly Topic[], listener: () => void): () => void {
    for (const topic of topics) {
      const all = this.listeners.get(topic) ?? new Set();
      this.listeners.set(topic, all.add(listener));
    }
    return () => {
      for (const topic of topics) this.listeners.get(topic)?.delete(listener);
    };
  }

  /** Call all listeners once, each topic in the order in which it was first listened to. */
  emitAll(): void {
    for (const topic of this.listeners.keys()) this.emit(topic);
  }

  /** Call all listeners of a topic. */
  emit(topic: Topic): void {
    for (const listener of [...(this.listeners.get(topic) ?? [])]) listener();
  }

  /** Take a state from the server, and the edits that are to follow it. */
  setDoc(doc: DocState, waiting: readonly Change[] = this.waiting): void {
    const fewer = waiting.length !== this.waiting.length;
    this.doc = doc;
    this.waiting = [...waiting];
    this.readable = doc.data ?? doc.readable ?? (doc.checking ? this.readable : {});
    this.set("autosolve", doc.autosolve ?? this.autosolve);
    this.applyWaiting();
    if (fewer) this.emit("waiting");
    this.emit("doc");
    this.emit("data");
  }

  /** Take the edits that wait. */
  setWaiting(waiting: readonly Change[]): void {
    this.waiting = [...waiting];
    this.applyWaiting();
    this.emit("waiting");
    this.emit("data");
  }

  get waitingCount(): number {
    return this.waiting.length;
  }

  /** The text that waits to be sent, null if none does. */
  get waitingText(): string | null {
    const edits: Edit[] = this.waiting.flatMap((change) => change.edits);
    const text = edits.findLast((edit) => edit.op === "text");
    return text?.op === "text" ? text.value : null;
  }

  /** Take another value of a topic. */
  set<K extends Settable>(topic: K, value: Store[K]): void {
    if (this[topic] === value) return;
    (this as Store)[topic] = value;
    this.emit(topic);
  }

  /** The path of the only item that is selected; null if none or several are. */
  get selection(): Path | null {
    return this.selected.length === 1 ? this.selected[0]! : null;
  }

  /** Forget what was solved, as it is of another document. */
  forgetResults(): void {
    this.set("preview", null);
    this.set("run", { kind: "idle" });
    // a preview of the other document may be shown although nothing was solved
    this.solved = null;
    this.emit("solved");
  }

  /** Select one item; null: none. */
  select(path: Path | null): void {
    this.selectAll(path ? [path] : []);
  }

  /** Select several items. */
  selectAll(paths: readonly Path[]): void {
    const unique = [...new Map(paths.map((path) => [pathKey(path), path])).values()];
    if (unique.length === this.selected.length && unique.every((path, n) => samePath(path, this.selected[n]!))) return;
    this.selected = unique;
    this.emit("selection");
  }

  /** Add an item to those selected, or take it away from them. */
  toggle(path: Path): void {
    const others = this.selected.filter((each) => !samePath(each, path));
    this.selectAll(others.length < this.selected.length ? others : [...others, path]);
  }

  isSelected(path: Path): boolean {
    return this.selected.some((each) => samePath(each, path));
  }

  /** Whether the text is broken, so that form and drawing cannot be edited. */
  get broken(): boolean {
    return this.doc !== null && this.doc.data === null && !this.doc.checking;
  }

  private applyWaiting(): void {
    let data: Table = this.readable;
    for (const change of this.waiting) for (const edit of change.edits) data = applyOptimistic(data, edit);
    this.data = data;
  }
}

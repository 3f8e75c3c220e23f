// Edits on their way to the server: one at a time, in order, none lost when the server is away.

import type { Change } from "../model/edits";
import { type Api, type DocState, Lost, Outdated, Refused } from "./api";

export interface QueueHooks {
  /** The version that the next edit builds on. */
  base(): number;
  /** The server has answered with a state; `waiting` is what is still to be sent on top of it. */
  adopt(state: DocState, waiting: readonly Change[]): void;
  /** The document changed elsewhere; returns whether the edit still makes sense on `state`. */
  fits(change: Change, state: DocState): boolean;
  /** An edit was dropped; `why` is for users. */
  onRefused(change: Change, why: string): void;
  /** The server does not answer, or does not know this page. */
  onLost(error: Lost): void;
  /** The list of waiting edits has changed. */
  onChange(): void;
}

/** Edits that wait, the first of them maybe under way. */
export class EditQueue {
  readonly waiting: Change[] = [];
  private busy: Promise<void> | null = null;
  private held = false;
  private repeated = false; // the first one may have arrived although no answer came

  constructor(
    private readonly api: Pick<Api, "edit">,
    private readonly hooks: QueueHooks,
  ) {}

  /** Add an edit and send it as soon as its turn comes. */
  push(change: Change): void {
    const last = this.waiting.at(-1);
    const underWay = this.busy !== null && this.waiting.length === 1;
    if (last && !underWay && canMerge(last, change))
      this.waiting[this.waiting.length - 1] = last.merge ? change : withoutMerge(change);
    else this.waiting.push(change);
    this.hooks.onChange();
    void this.run();
  }

  /** Send what waits; resolves when nothing waits any more or the server is away. */
  run(): Promise<void> {
    if (this.held) return Promise.resolve();
    this.busy ??= this.send().finally(() => {
      this.busy = null;
    });
    return this.busy;
  }

  /** Keep all edits here until `release`, while it is unclear what they apply to. */
  hold(): void {
    this.held = true;
  }

  /** Send again. */
  release(): Promise<void> {
    this.held = false;
    return this.run();
  }

  /** The server is at another state than the edits were made on: drop those that make no sense there. */
  rebase(state: DocState): void {
    const lost = this.waiting.filter((change) => !this.hooks.fits(change, state));
    if (lost.length === 0) return;
    const kept = this.waiting.filter((change) => !lost.includes(change));
    this.waiting.splice(0, this.waiting.length, ...kept);
    this.hooks.onChange();
    for (const change of lost) this.hooks.onRefused(change, "this part has been changed elsewhere in the meantime");
  }

  /** Drop what waits. */
  clear(): void {
    this.waiting.length = 0;
    this.hooks.onChange();
  }

  private async send(): Promise<void> {
    for (let change = this.waiting[0]; change && !this.held; change = this.waiting[0]) {
      try {
        const state = await this.api.edit(change, this.hooks.base());
        this.removeFirst(change);
        this.hooks.adopt(state, this.waiting);
      } catch (error) {
        if (error instanceof Lost) {
          this.held = true;
          this.repeated = true;
          this.hooks.onLost(error);
          return;
        }
        this.handleRejection(change, error);
      }
    }
  }

  private handleRejection(change: Change, error: unknown): void {
    if (error instanceof Outdated) {
      const arrived =
        this.repeated && error.state.undo_text === change.text && error.state.version === this.hooks.base() + 1;
      const fits = arrived || this.hooks.fits(change, error.state);
      if (arrived || !fits) this.removeFirst(change);
      this.hooks.adopt(error.state, this.waiting);
      if (!fits) this.hooks.onRefused(change, "this part has been changed elsewhere in the meantime");
      this.repeated = false;
      return;
    }
    this.removeFirst(change);
    this.hooks.onChange();
    this.hooks.onRefused(change, error instanceof Refused ? error.message : String(error));
  }

  private removeFirst(change: Change): void {
    if (this.waiting[0] === change) this.waiting.shift();
    this.repeated = false;
  }
}

/** Return a change that is a step of its own. */
function withoutMerge(change: Change): Change {
  return { edits: change.edits, text: change.text };
}

/** Whether a later change replaces an earlier one that waits as well: continued typing in a field or in the text. */
export function canMerge(earlier: Change, later: Change): boolean {
  if (!later.merge || earlier.text !== later.text) return false;
  const places = (change: Change) =>
    JSON.stringify(
      change.edits.map((edit) => [edit.op === "remove" ? "set" : edit.op, "path" in edit ? edit.path : null]),
    );
  const replaces = later.edits.every((edit) => ["set", "remove", "length", "text"].includes(edit.op));
  return replaces && places(earlier) === places(later);
}

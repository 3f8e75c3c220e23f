// A server in the page: keeps data as JSON, answers as the real one does, can be away.

import { type DocState, Outdated, Unreachable } from "../../src/workbench/client/api";
import { applyOptimistic } from "../../src/workbench/model/changes/optimistic-edits";
import type { Change } from "../../src/workbench/model/edits";
import type { Issue } from "../../src/workbench/model/issues";
import type { Table } from "../../src/workbench/model/paths";

export class FakeApi {
  version = 1;
  away = false;
  /** Answers get lost although the edit arrives. */
  deaf = false;
  issues: Issue[] = [];
  /** So many answers come before the text has been read. */
  unread = 0;
  readonly received: Change[] = [];
  private readonly steps: { data: Table; text: string }[] = [];

  constructor(public data: Table) {}

  present(): DocState {
    const last = this.steps.at(-1);
    return {
      version: this.version,
      text: JSON.stringify(this.data),
      data: this.unread > 0 ? null : this.data,
      checking: this.unread-- > 0,
      issues: this.issues,
      plan: null,
      file: "case.toml",
      dirty: this.version > 1,
      can_undo: last !== undefined,
      can_redo: false,
      undo_text: last?.text ?? "",
      redo_text: "",
      offer: null,
    };
  }

  async state(): Promise<DocState> {
    await Promise.resolve();
    if (this.away) throw new Unreachable("away");
    return this.present();
  }

  async edit(change: Change, base: number): Promise<DocState> {
    await Promise.resolve();
    if (this.away) throw new Unreachable("away");
    if (base !== this.version) throw new Outdated(this.present());
    this.received.push(change);
    this.steps.push({ data: this.data, text: change.text });
    for (const edit of change.edits) this.data = applyOptimistic(this.data, edit);
    this.version += 1;
    if (this.deaf) throw new Unreachable("the answer was lost");
    return this.present();
  }

  /** A change made by another page. */
  elsewhere(change: Change): void {
    for (const edit of change.edits) this.data = applyOptimistic(this.data, edit);
    this.version += 1;
  }
}

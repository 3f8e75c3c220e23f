// What the user can have done with the document as a whole.

import { type Api, type DocState, Refused, Stranger, Unreachable } from "./api";
import { ask } from "./dialogs";
import type { EditQueue } from "./edit-queue";
import { chooseFile } from "./file-dialog";
import type { Store } from "./store";

export class Actions {
  constructor(
    private readonly api: Api,
    private readonly store: Store,
    private readonly queue: EditQueue,
    private readonly lost: (error: Unreachable | Stranger) => void,
    /** Send what is being typed. */
    private readonly flush: () => void,
    private readonly showFaults: () => void,
  ) {}

  undo = () => this.change(() => this.api.undo());
  redo = () => this.change(() => this.api.redo());

  /** Save to the present file; under a name if there is none. */
  save = async (): Promise<boolean> => {
    const file = this.store.doc?.file ?? null;
    if (file === null) return this.saveAs();
    return this.change(() => this.api.save(null, false), "saved");
  };

  /** Save under a name that the user chooses. */
  saveAs = async (): Promise<boolean> => {
    const chosen = await chooseFile(this.api, "save", this.store.doc?.file ?? null);
    if (!chosen) return false;
    return this.change(() => this.api.save(chosen.file, chosen.over), "saved");
  };

  open = async (): Promise<void> => {
    const chosen = await chooseFile(this.api, "open", this.store.doc?.file ?? null);
    if (!chosen || !(await this.mayLeave())) return;
    if (await this.change(() => this.api.open(chosen.file))) this.another();
  };

  fresh = async (): Promise<void> => {
    if (!(await this.mayLeave())) return;
    if (await this.change(() => this.api.fresh())) this.another();
  };

  solve = async (): Promise<void> => {
    if ((this.store.doc?.faults.length ?? 0) > 0) return this.showFaults();
    await this.asking(async () => void (await this.api.solve()));
  };

  cancel = () => this.asking(() => this.api.cancel());

  autosolve = (on: boolean) =>
    this.asking(async () => {
      await this.api.autosolve(on);
      this.store.autosolve = on;
      this.store.tell("autosolve");
    });

  /** Another document: results and selection of the old one are gone. */
  private another(): void {
    this.store.setSolved(null);
    this.store.setRun({ kind: "idle" });
    this.store.select(null);
  }

  /** Ask what is to become of unsaved work before it is left. */
  private async mayLeave(): Promise<boolean> {
    this.flush();
    await this.queue.run();
    if (this.store.doc?.dirty !== true) return true;
    const answer = await ask(
      "Save the changes first?",
      ["The present case has changes that are not saved."],
      [{ label: "Stay", value: "stay" }, { label: "Leave without saving", value: "leave" }, { label: "Save", value: "save", main: true }],
      "stay",
    );
    return answer === "leave" || (answer === "save" && (await this.save()));
  }

  /** Change the document after all edits have been sent; returns whether it went well. */
  private async change(make: () => Promise<DocState>, done?: string): Promise<boolean> {
    return this.asking(async () => {
      this.store.setDoc(await make());
      if (done) this.store.say({ kind: "info", text: `${this.store.doc?.file ?? "The case"} is ${done}.` });
    });
  }

  private async asking(run: () => Promise<void>): Promise<boolean> {
    this.flush();
    await this.queue.run();
    try {
      await run();
      return true;
    } catch (error) {
      if (error instanceof Unreachable || error instanceof Stranger) this.lost(error);
      else this.store.say({ kind: "bad", text: error instanceof Refused ? error.message : String(error) });
      return false;
    }
  }
}

// What the user can have done with the document as a whole.

import { type Api, type DocState, Refused, Stranger, Unreachable } from "../client/api";
import type { EditQueue } from "../client/edit-queue";
import type { Store } from "../client/store";
import { ask } from "./dialogs";
import { chooseFile } from "./file-dialog";

export class Commands {
  constructor(
    private readonly api: Api,
    private readonly store: Store,
    private readonly queue: EditQueue,
    private readonly lost: (error: Unreachable | Stranger) => void,
    /** Send what is being typed. */
    private readonly flush: () => void,
    private readonly showFaults: () => void,
    /** Ask what is to become of unsaved work that was found, and return the state after the answer. */
    private readonly offered: (state: DocState) => Promise<DocState>,
  ) {}

  undo = () => this.change(() => this.api.undo());
  redo = () => this.change(() => this.api.redo());

  /** Save to the present file; under a name if there is none. */
  save = async (): Promise<boolean> => {
    const file = this.store.doc?.file ?? null;
    if (file === null) return this.saveAs();
    return this.saveTo(null, false);
  };

  /** Save under a name that the user chooses. */
  saveAs = async (): Promise<boolean> => {
    const chosen = await chooseFile(this.api, "save", this.store.doc?.file ?? null);
    if (!chosen) return false;
    return this.saveTo(chosen.file, chosen.over);
  };

  /** Save, after a question where something else would be overwritten. */
  private async saveTo(file: string | null, over: boolean): Promise<boolean> {
    const inTheWay = (error: Refused) => !over && (error.kind === "changed" || error.kind === "exists");
    let why = "";
    const done = await this.change(
      () => this.api.save(file, over),
      "saved",
      (error) => {
        if (inTheWay(error)) why = error.kind;
        return why !== "";
      },
    );
    if (done || why === "") return done;
    const words =
      why === "exists"
        ? "There is a file of this name already."
        : "Another program has changed the file since it was read here. Saving replaces what it has written.";
    const answers = [
      { label: "Do not save", value: "no" as const, main: true },
      { label: "Save as …", value: "as" as const },
      { label: "Replace it", value: "over" as const },
    ];
    const answer = await ask("Replace the file?", [words], answers, "no");
    return answer === "over" ? this.saveTo(file, true) : answer === "as" ? this.saveAs() : false;
  }

  open = async (): Promise<void> => {
    const chosen = await chooseFile(this.api, "open", this.store.doc?.file ?? null);
    if (chosen) await this.openFile(chosen.file);
  };

  /** Open a file in place of the present one. */
  openFile = async (file: string): Promise<void> => {
    if (!(await this.mayLeave())) return;
    if (await this.change(() => this.api.open(file))) this.another();
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
      this.store.emit("autosolve");
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
      [
        "The present case has changes that are not saved. If you leave it so, they stay kept, and are offered when it is opened again.",
      ],
      [
        { label: "Stay", value: "stay" },
        { label: "Leave", value: "leave" },
        { label: "Save", value: "save", main: true },
      ],
      "stay",
    );
    return answer === "leave" || (answer === "save" && (await this.save()));
  }

  /** Change the document after all edits have been sent; returns whether it went well. `known` takes a refusal itself. */
  private async change(
    make: () => Promise<DocState>,
    done?: string,
    known: (error: Refused) => boolean = () => false,
  ): Promise<boolean> {
    return this.asking(async () => {
      const state = await make();
      this.store.setDoc(state.offer ? await this.offered(state) : state);
      if (done) this.store.notify({ kind: "info", text: `${this.store.doc?.file ?? "The case"} is ${done}.` });
    }, known);
  }

  private async asking(run: () => Promise<void>, known: (error: Refused) => boolean = () => false): Promise<boolean> {
    this.flush();
    await this.queue.run();
    try {
      await run();
      return true;
    } catch (error) {
      if (error instanceof Unreachable || error instanceof Stranger) this.lost(error);
      else if (error instanceof Refused && known(error)) return false;
      else
        this.store.notify({
          kind: "bad",
          text: error instanceof Refused ? error.message : String(error),
          ...(error instanceof Refused ? elsewhere(error) : {}),
        });
      return false;
    }
  }
}

/** Where a file that another workbench has open can be edited. */
function elsewhere(error: Refused): { action?: { label: string; run: () => void } } {
  const { url } = error;
  // only a workbench on this machine is gone to
  if (!/^http:\/\/(127\.0\.0\.1|localhost):\d+\//.test(url)) return {};
  return { action: { label: "Go there", run: () => void window.open(url, "_blank", "noopener") } };
}

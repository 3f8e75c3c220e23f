// Commands on the document.

import { say, verbatim } from "../../viewer/shared/language";
import { type Api, type DocState, type FileChanges, Lost, Refused, type SlabInFile, type Which } from "../client/api";
import type { EditQueue } from "../client/edit-queue";
import type { Store } from "../client/store";
import { ask } from "../controls/dialogs";
import { isDrawing, openDrawing } from "../drawing/open-drawing";
import { isBuilding, openSlab } from "../drawing/open-slab";
import { chooseStart } from "../help/examples";
import { isTableFile } from "../model/reactions";
import { importReactions } from "../reactions/import-reactions";
import { askAboutChanges } from "./changed-file";
import { chooseFile } from "./file-dialog";

export class Commands {
  constructor(
    private readonly api: Api,
    private readonly store: Store,
    private readonly queue: EditQueue,
    private readonly onLost: (error: Lost) => void,
    /** Send what is being typed. */
    private readonly flush: () => void,
    private readonly openIssues: () => void,
    /** Ask what to do with unsaved work that was found, and return the state after the answer. */
    private readonly resolveOffer: (state: DocState) => Promise<DocState>,
  ) {}

  undo = () => this.change(() => this.api.undo());
  redo = () => this.change(() => this.api.redo());

  /** Save to the present file; under a name if there is none. */
  save = async (): Promise<boolean> => {
    return (this.store.doc?.file ?? null) === null ? this.saveAs() : this.saveTo(null, false);
  };

  /** Save under a name that the user chooses. */
  saveAs = async (): Promise<boolean> => {
    const chosen = await chooseFile(this.api, "save", this.store.doc?.file ?? null);
    return chosen !== null && this.saveTo(chosen.file, chosen.over);
  };

  /** Save; ask first where something else would be overwritten. */
  private async saveTo(file: string | null, over: boolean): Promise<boolean> {
    let why = "";
    const isInTheWay = ({ kind }: Refused) => {
      if (!over && ["changed", "exists"].includes(kind)) why = kind;
      return why !== "";
    };
    const done = await this.change(() => this.api.save(file, over), "saved", isInTheWay);
    if (done || why === "") return done;
    if (why === "changed") return this.settleConflict();
    const words = "A file with this name already exists.";
    const answers = [
      { label: "Don't save", value: "no" as const, main: true },
      { label: "Save as …", value: "as" as const },
      { label: "Replace", value: "over" as const },
    ];
    const answer = await ask("Replace file?", [words], answers, "no");
    return answer === "over" ? this.saveTo(file, true) : answer === "as" ? this.saveAs() : false;
  }

  /** Ask which text counts where the file has changed, and save that. */
  private async settleConflict(): Promise<boolean> {
    let changes: FileChanges | null = null;
    const isRead = await this.run(async () => {
      changes = await this.api.fileChanges();
    });
    if (!isRead || changes === null) return false;
    const decision = await askAboutChanges(changes, true);
    if (decision === "cancel") return false;
    if (decision === "as") return this.saveAs();
    const { digest } = changes as FileChanges;
    return (await this.takeFile(decision, digest)) && (decision === "theirs" || this.saveTo(null, false));
  }

  /** Let the text of a file that has changed, that of the page, or both merged count. */
  takeFile = (which: Which, digest: string): Promise<boolean> => this.change(() => this.api.takeFile(which, digest));

  open = async (): Promise<void> => {
    const chosen = await chooseFile(this.api, "open", this.store.doc?.file ?? null);
    if (!chosen) return;
    if (isTableFile(chosen.file) || isBuilding(chosen.file)) return this.openSlabs(chosen.file);
    await (isDrawing(chosen.file) ? this.openDrawing(chosen.file) : this.openFile(chosen.file));
  };

  /** Open a file in place of the present one. */
  openFile = async (file: string): Promise<void> => {
    if (!(await this.confirmLeaving())) return;
    if (await this.change(() => this.api.open(file))) this.resetResult();
  };

  /** Make a case of a slab of a building or a workbook; a workbook without slabs is a table of reactions. */
  private async openSlabs(file: string): Promise<void> {
    let slabs: SlabInFile[] = [];
    const look = async () => {
      this.store.set("notice", {
        kind: "info",
        text: say("Reading {file} …", { file: verbatim(file.replace(/^.*[\\/]/, "")) }),
      });
      slabs = (await this.api.slabs(file)).slabs;
      this.store.set("notice", null);
    };
    if (isBuilding(file)) {
      if (!(await this.run(look))) return;
    } else {
      // what cannot be read is explained by the import of reactions
      if (/\.xlsx$/i.test(file) && !(await this.run(look, () => true))) this.store.set("notice", null);
      if (slabs.length === 0) return this.importReactions(file);
    }
    await openSlab(file, slabs, {
      api: this.api,
      leave: () => this.confirmLeaving(),
      replace: (make, refused) => this.replace(make, refused),
    });
  }

  /** Make a case of a drawing, or show it below the plan. */
  private openDrawing(file: string): Promise<void> {
    return openDrawing(file, {
      api: this.api,
      store: this.store,
      push: (change) => this.queue.push(change),
      run: (run) => this.run(run),
      leave: () => this.confirmLeaving(),
      replace: (make, refused) => this.replace(make, refused),
    });
  }

  /** Replace the document by another one. */
  private async replace(make: () => Promise<DocState>, refused: (error: Refused) => boolean): Promise<boolean> {
    const isDone = await this.change(make, undefined, refused);
    if (isDone) this.resetResult();
    return isDone;
  }

  /** Take a table of reactions as loads of the present case. */
  private importReactions(file: string): Promise<void> {
    return importReactions(file, { api: this.api, store: this.store, run: (run, known) => this.run(run, known) });
  }

  /** Begin a new case, empty or from an example. */
  createCase = async (): Promise<void> => {
    const start = await chooseStart(this.api);
    if (!start || !(await this.confirmLeaving())) return;
    const { example } = start;
    const make = () => (example === null ? this.api.createCase() : this.api.openExample(example));
    if (await this.change(make)) this.resetResult();
  };

  /** Send what is being typed and what waits. */
  settle = async (): Promise<void> => {
    this.flush();
    await this.queue.run();
  };

  solve = async (): Promise<void> => {
    if ((this.store.doc?.issues.length ?? 0) > 0) return this.openIssues();
    await this.run(async () => void (await this.api.solve()));
  };

  cancel = () => this.run(() => this.api.cancel());

  autosolve = (on: boolean) =>
    this.run(async () => {
      await this.api.autosolve(on);
      this.store.set("autosolve", on);
    });

  /** Forget results, selection and what else belongs to the document before. */
  private resetResult(): void {
    this.store.forgetResults();
    this.store.select(null);
    this.store.set("underlay", null);
    this.store.emit("opened");
  }

  /** Ask what to do with unsaved work before another document is opened. */
  private async confirmLeaving(): Promise<boolean> {
    await this.settle();
    if (this.store.doc?.dirty !== true) return true;
    const words =
      this.store.doc.file === null
        ? "The current case has never been saved. If you don't save it now, it will not be offered again."
        : "The current case has unsaved changes. If you don't save them, you can restore them when you open the case again.";
    const answers = [
      { label: "Cancel", value: "stay" },
      { label: "Don't save", value: "leave" },
      { label: "Save", value: "save", main: true },
    ];
    const answer = await ask("Save changes?", [words], answers, "stay");
    return answer === "leave" || (answer === "save" && (await this.save()));
  }

  /** Change the document after all edits have been sent; returns whether it went well. `known` handles a refusal itself. */
  private async change(
    make: () => Promise<DocState>,
    done?: string,
    known: (error: Refused) => boolean = () => false,
  ): Promise<boolean> {
    return this.run(async () => {
      const state = await make();
      this.store.setDoc(state.offer ? await this.resolveOffer(state) : state);
      if (done)
        this.store.set("notice", {
          kind: "info",
          text: say("{file} is {done}.", { file: this.store.doc?.file ?? "The case", done }),
        });
    }, known);
  }

  private async run(run: () => Promise<void>, known: (error: Refused) => boolean = () => false): Promise<boolean> {
    await this.settle();
    try {
      await run();
      return true;
    } catch (error) {
      if (error instanceof Lost) this.onLost(error);
      else if (!(error instanceof Refused)) this.store.set("notice", { kind: "bad", text: String(error) });
      else if (!known(error)) this.store.set("notice", { kind: "bad", text: error.message, ...otherWorkbench(error) });
      return false;
    }
  }
}

/** Return the action that leads to the workbench that has a file open. */
function otherWorkbench(error: Refused): { action?: { label: string; run: () => void } } {
  const { url } = error;
  // only to a workbench on this machine
  if (!/^http:\/\/(127\.0\.0\.1|localhost):\d+\//.test(url)) return {};
  return { action: { label: "Go to workbench", run: () => void window.open(url, "_blank", "noopener") } };
}

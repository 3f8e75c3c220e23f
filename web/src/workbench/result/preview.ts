// Picture and figures of a run that has no results yet: of one combination on a coarser mesh, and marked as that; and the
// mark of provisional results.

import { decodeScene } from "../../viewer/data/scene";
import type { ResultView } from "../../viewer/panels/result-view";
import { h, setText } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import { type Api, type CombinationSummary, Lost, Refused } from "../client/api";
import type { Store } from "../client/store";

export interface PreviewHooks {
  /** A preview is shown in place of the last result. */
  onShow(): void;
  /** The run has ended without a result: the last one is to be shown again. */
  onEnd(): void;
  onLost(error: Lost): void;
}

/** Shows the previews that the store names, and says over the picture what they are. */
export class Preview {
  readonly label = h("p", { class: "preview-over", hidden: true });
  /** The figures of the preview that is shown, if one is. */
  figures: CombinationSummary | null = null;

  constructor(
    private readonly store: Store,
    private readonly api: Pick<Api, "preview">,
    private readonly view: ResultView,
    private readonly hooks: PreviewHooks,
  ) {
    store.on(["preview"], () => void this.fetch());
    store.on(["run"], () => {
      const { kind } = store.run;
      if (this.figures && kind === "refused") this.hooks.onEnd();
    });
  }

  /** Show no preview any more, but results; say that they are provisional, in words, if they are. */
  end(provisional = ""): void {
    this.figures = null;
    this.mark(provisional);
    this.label.classList.toggle("provisional", provisional !== "");
  }

  /** What is shown in place of results, in words. */
  get words(): string {
    return this.label.textContent ?? "";
  }

  private mark(words: string): void {
    setText(this.label, words);
    this.label.hidden = words === "";
  }

  private async fetch(): Promise<void> {
    const { preview } = this.store;
    if (!preview) return;
    try {
      const scene = decodeScene(await this.api.preview(preview.run));
      if (this.store.preview !== preview) return;
      this.mark(say("Preview {items}", { items: preview.words }));
      this.label.classList.remove("provisional");
      this.figures = preview.figures;
      this.store.set("drawn", { run: preview.run, isPreview: true });
      this.view.setScene(scene, true);
      this.hooks.onShow();
    } catch (error) {
      // a run that has ended meanwhile has no preview any more
      if (error instanceof Lost) this.hooks.onLost(error);
      else if (!(error instanceof Refused)) throw error;
    }
  }
}

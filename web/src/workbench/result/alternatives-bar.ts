// The line that tries alternatives to the design, and takes one of them into the case.

import { allow, button, fillOptions, h } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import { type Api, Refused } from "../client/api";
import type { Store } from "../client/store";
import type { Change } from "../model/edits";
import { ALTERNATIVES, comparisonBar } from "./comparison-bar";
import { freshness } from "./standing";

const HINT = "Puts the changes of this alternative, and its bars, into the case.";
const STALE = "The case has changed since: try alternatives again.";

export class AlternativesBar {
  readonly element: HTMLElement;
  private readonly choice = h("select", { "aria-label": "Alternative" });
  private readonly take: HTMLButtonElement;
  private cases: Readonly<Record<string, string>> = {};
  private run: number | null = null; // whose alternatives these are

  constructor(
    private readonly store: Store,
    private readonly api: Pick<Api, "compare" | "cancelComparison" | "alternatives">,
    private readonly push: (change: Change) => void,
    private readonly onError: (error: unknown) => void,
  ) {
    this.take = button("Take it", HINT, () => this.takeChosen());
    this.take.classList.add("small");
    this.element = comparisonBar(ALTERNATIVES, store, api, onError);
    this.element.append(this.choice, this.take);
    store.on(["solved", "doc", "waiting"], () => this.update());
    this.update();
  }

  /** Offer the alternatives that have been tried for a run. */
  async offer(run: number): Promise<void> {
    try {
      const cases = await this.api.alternatives(run);
      this.cases = cases;
      this.run = run;
      const names = Object.keys(cases).slice(1); // the first one is as drawn
      fillOptions(
        this.choice,
        names.map((name) => [name, name]),
      );
      this.update();
    } catch (error) {
      if (!(error instanceof Refused)) this.onError(error);
    }
  }

  private takeChosen(): void {
    const value = this.cases[this.choice.value];
    if (value !== undefined && this.isFresh()) {
      this.push({
        edits: [{ op: "text", value }],
        text: say("take the alternative {name}", { name: verbatim(this.choice.value) }),
      });
    }
  }

  /** Whether the case is the one whose alternatives these are. */
  private isFresh(): boolean {
    const { solved } = this.store;
    return this.run === solved?.run && freshness(solved, this.store) === "fresh";
  }

  private update(): void {
    const none = this.run === null || this.run !== this.store.solved?.run || this.choice.options.length === 0;
    this.choice.hidden = this.take.hidden = none;
    allow(this.take, this.isFresh() ? "" : STALE);
  }
}

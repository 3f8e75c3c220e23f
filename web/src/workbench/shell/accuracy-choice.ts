// The accuracy that runs ask for, beside the button that solves, and what each takes, told before it begins.
import { fill, h, setRead, setText } from "../../viewer/shared/dom";
import { counted, say, together, translate, verbatim } from "../../viewer/shared/language";
import { type Accuracy, type Api, type Cost, type Costs, Lost, Refused } from "../client/api";
import { debounce } from "../client/debounce";
import type { Store } from "../client/store";
import { valueAt } from "../model/paths";

const CHOICES = ["draft", "normal", "strict"] as const;
const LABELS = { draft: "Draft (15 %)", normal: "Normal (5 %)", strict: "Strict (2 %)" };
const COUNTS = new Intl.NumberFormat("en");
const PAUSE = 500; // ms without a change until the costs are asked for

/** Return a time in words, no more exact than an estimate is. */
export function timeText(seconds: number): string {
  if (seconds < 1.5) return translate("about 1 s");
  if (seconds < 100) return say("about {time} s", { time: roundTo(seconds, seconds < 10 ? 1 : 5) });
  return say("about {time} min", { time: roundTo(seconds / 60, seconds < 600 ? 1 : 5) });
}

/** Return what a run takes in words: time, unknowns, combinations, meshes. */
export function costText(cost: Cost): string {
  const { seconds, meshes } = cost;
  return together([timeText(seconds), workText(cost), counted(meshes, "1 mesh", "{count} meshes")], ", ");
}

/** Return in words how much there is to solve. */
export function workText({ unknowns, combinations }: Cost): string {
  const step = 10 ** Math.max(0, Math.floor(Math.log10(Math.max(1, unknowns))) - 1);
  const count = COUNTS.format(roundTo(unknowns, step));
  const all = counted(combinations, "1 combination", "{count} combinations");
  return together([say("{count} unknowns", { count }), all], ", ");
}

function roundTo(value: number, step: number): number {
  return Math.round(value / step) * step;
}

type Named = (typeof CHOICES)[number];
const isNamed = (name: string): name is Named => (CHOICES as readonly string[]).includes(name);

export interface AccuracyHooks {
  /** Send what is being typed and what waits. */
  settle(): Promise<void>;
  onLost(error: Lost): void;
}

/** The choice of an accuracy, with the cost of each; it is disabled where the case says what the mesh is. */
export class AccuracyChoice {
  readonly element: HTMLElement;
  private readonly select: HTMLSelectElement;
  private readonly told = h("output", { class: "cost", "aria-label": "What solving takes" });
  private costs: Costs = {};
  private version = -1; // of the document that these are of
  private readonly ask = debounce(PAUSE, () => void this.attempt(() => this.fetch()));

  constructor(
    private readonly store: Store,
    private readonly api: Pick<Api, "costs" | "setAccuracy">,
    private readonly hooks: AccuracyHooks,
  ) {
    this.select = h("select", { "aria-label": "Accuracy", onchange: () => void this.attempt(() => this.choose()) });
    this.element = h("div", { class: "accuracy" }, this.select, this.told);
    store.on(["doc", "data", "run", "solved", "waiting"], () => this.update());
  }

  /** The accuracy of the case: by its name, or in its own words. */
  private get own(): string {
    return String(valueAt(this.store.data, ["mesh", "accuracy"]) ?? "normal");
  }

  /** Whether the case says what the mesh is. */
  private get isFixed(): boolean {
    return ["size", "counts"].some((key) => valueAt(this.store.data, ["mesh", key]) !== undefined);
  }

  private async choose(): Promise<void> {
    const value = this.select.value as Accuracy;
    await this.hooks.settle();
    // that of the case follows it when it changes
    await this.api.setAccuracy(value === this.own ? "" : value);
  }

  private async fetch(): Promise<void> {
    const { doc, run, waitingCount } = this.store;
    if (!doc || doc.checking || doc.issues.length > 0 || waitingCount > 0 || run.kind === "solving") return;
    const costs = await this.api.costs();
    if (this.store.doc?.version !== doc.version) return;
    this.costs = costs;
    this.draw();
  }

  private async attempt(run: () => Promise<void>): Promise<void> {
    try {
      await run();
    } catch (error) {
      if (error instanceof Lost) this.hooks.onLost(error);
      else if (!(error instanceof Refused)) throw error;
    }
  }

  private update(): void {
    const { version = -1 } = this.store.doc ?? {};
    if (version !== this.version) this.costs = {};
    this.version = version;
    this.draw();
    this.ask();
  }

  private costOf(value: string): Cost | undefined {
    return this.costs[value === this.own ? "" : (value as Accuracy)]; // "" for that of the case
  }

  private makeOption(value: string, wanted: string): HTMLElement {
    const cost = this.costOf(value);
    const named = isNamed(value) ? LABELS[value] : say("Case ({value})", { value });
    const name = translate(value === "" ? "Mesh of the case" : named);
    const label = cost ? `${name}: ${timeText(cost.seconds)}` : name;
    return h("option", { value, selected: value === wanted }, verbatim(label));
  }

  private draw(): void {
    const { own, isFixed, select, told, store } = this;
    const wanted = store.doc?.accuracy || own;
    const values = isNamed(own) ? CHOICES : [own, ...CHOICES];
    const options = isFixed ? [this.makeOption("", "")] : values.map((value) => this.makeOption(value, wanted));
    fill(select, ...options);
    select.disabled = isFixed;
    const about = isFixed
      ? "The case gives the size or the counts of elements. Remove them under Mesh to choose an accuracy."
      : "Largest discretization error of the results that are solved for. The case itself keeps its accuracy.";
    setRead(select, "title", about);
    const cost = store.run.kind === "solving" ? undefined : this.costOf(isFixed ? "" : wanted);
    setText(told, verbatim(cost ? workText(cost) : ""));
    setRead(told, "title", verbatim(cost ? costText(cost) : ""));
  }
}

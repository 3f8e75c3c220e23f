// The line that starts and cancels a comparison: of ground models, or of alternatives to the design.
import { allow, button, h, setText } from "../../viewer/shared/dom";
import type { Api, ComparisonKind } from "../client/api";
import type { Store } from "../client/store";
import "./comparison-bar.css";

/** What is compared: its name, the words of the button, and what it does. */
export interface Compared {
  kind: ComparisonKind;
  label: string;
  hint: string;
}

export const GROUNDS: Compared = {
  kind: "comparison",
  label: "Compare ground models",
  hint: "Compares the slab on the elastic continuum with simpler models of the same soil layers.",
};

export const ALTERNATIVES: Compared = {
  kind: "alternatives",
  label: "Try alternatives",
  hint: "Tries other thicknesses, drop panels and bars, with utilizations and quantities side by side.",
};

export function comparisonBar(
  { kind, label, hint }: Compared,
  store: Store,
  api: Pick<Api, "compare" | "cancelComparison">,
  onError: (error: unknown) => void,
): HTMLElement {
  const start = button(label, hint, () => {
    if (store.solved) api.compare(store.solved.run, kind).catch(onError);
  });
  const cancel = button("Cancel", "Stop the comparison", () => void api.cancelComparison().catch(onError));
  for (const control of [start, cancel]) control.classList.add("small");
  const bar = h("progress", { max: 1, "aria-label": "comparison progress" });
  const words = h("span", { class: "comparison-words", role: "status" });
  const element = h("div", { class: "comparison-bar" }, start, cancel, bar, words);
  const update = () => {
    const comparison = store.comparison?.kind === kind ? store.comparison : null;
    const running = comparison?.state === "running";
    start.hidden = running;
    allow(start, store.solved ? "" : "Solve first: there are no results yet.");
    cancel.hidden = bar.hidden = !running;
    bar.value = comparison?.share ?? 0;
    element.classList.toggle("bad", comparison?.state === "failed" && comparison.text !== "");
    setText(words, running || comparison?.state === "failed" ? comparison.text : hint);
    words.title = words.textContent ?? "";
  };
  store.on(["comparison", "solved"], update);
  update();
  return element;
}

// The line that starts and cancels the comparison of ground models.
import { button, h, setText } from "../../viewer/shared/dom";
import type { Api } from "../client/api";
import type { Store } from "../client/store";
import "./comparison-bar.css";

const HINT = "Compares the slab on the elastic continuum with simpler models of the same soil layers.";

export function comparisonBar(
  store: Store,
  api: Pick<Api, "compareGrounds" | "cancelComparison">,
  onError: (error: unknown) => void,
): HTMLElement {
  const start = button("Compare ground models", HINT, () => {
    if (store.solved) api.compareGrounds(store.solved.run).catch(onError);
  });
  const cancel = button("Cancel", "Stop the comparison", () => void api.cancelComparison().catch(onError));
  for (const control of [start, cancel]) control.classList.add("small");
  const bar = h("progress", { max: 1, "aria-label": "comparison progress" });
  const words = h("span", { class: "comparison-words", role: "status" });
  const element = h("div", { class: "comparison-bar" }, start, cancel, bar, words);
  const update = () => {
    const { comparison } = store;
    const running = comparison?.state === "running";
    start.hidden = running;
    cancel.hidden = bar.hidden = !running;
    bar.value = comparison?.share ?? 0;
    element.classList.toggle("bad", comparison?.state === "failed" && comparison.text !== "");
    setText(words, running || comparison?.state === "failed" ? comparison.text : HINT);
    words.title = words.textContent ?? "";
  };
  store.on(["comparison"], update);
  update();
  return element;
}

// The line that has bars proposed for the slab and puts them into the case.
import { button, h, setRead, setText } from "../../viewer/shared/dom";
import { type Api, Refused } from "../client/api";
import type { Store } from "../client/store";
import type { Change } from "../model/edits";
import { freshness } from "./standing";
import "./comparison-bar.css";

const HINT = "Replaces the bars of the case by a base in each layer and zones that cover what is required.";
const STALE = "Solve first: the case has changed since.";

export function barsBar(store: Store, api: Pick<Api, "proposeBars">, push: (change: Change) => void): HTMLElement {
  const start = button("Propose bars", HINT, () => void propose());
  start.classList.add("small");
  const words = h("span", { class: "bars-words", role: "status" });
  const element = h("div", { class: "comparison-bar bars-bar" }, start, words);
  let isBusy = false;
  const isFresh = () => freshness(store.solved, store) === "fresh";

  async function propose(): Promise<void> {
    const { solved } = store;
    if (!solved || isBusy || !isFresh()) return;
    say(true, "Bars are chosen …");
    try {
      const value = await api.proposeBars(solved.run);
      // whoever has edited in the meantime keeps these edits
      if (isFresh()) push({ edits: [{ op: "text", value }], text: "propose bars" });
      say(false, isFresh() ? HINT : STALE);
    } catch (error) {
      say(false, error instanceof Refused ? error.message : String(error), true);
    }
  }

  function say(busy: boolean, text: string, bad = false): void {
    isBusy = busy;
    element.classList.toggle("bad", bad);
    setText(words, text);
    setRead(words, "title", text);
    update();
  }

  function update(): void {
    start.disabled = isBusy || !isFresh() || store.solved?.provisional !== "";
    setRead(start, "title", isFresh() ? HINT : STALE);
  }

  store.on(["solved", "doc", "waiting"], update);
  say(false, HINT);
  return element;
}

// The line that has bars proposed for the slab and puts them into the case.
import { allow, button, h, setRead, setText } from "../../viewer/shared/dom";
import { type Api, Refused } from "../client/api";
import type { Store } from "../client/store";
import type { Change } from "../model/edits";
import { whyNotMade } from "./standing";
import "./comparison-bar.css";

const HINT = "Replaces the bars of the case by a base in each layer and zones that cover what is required.";
const BUSY = "Bars are chosen …";

export function barsBar(store: Store, api: Pick<Api, "proposeBars">, push: (change: Change) => void): HTMLElement {
  const start = button("Propose bars", HINT, () => void propose());
  start.classList.add("small");
  const words = h("span", { class: "bars-words", role: "status" });
  const element = h("div", { class: "comparison-bar bars-bar" }, start, words);
  let isBusy = false;

  async function propose(): Promise<void> {
    const { solved } = store;
    if (!solved || isBusy || whyNotMade(store)) return;
    tell(true, BUSY);
    try {
      const value = await api.proposeBars(solved.run);
      // whoever has edited in the meantime keeps these edits
      const why = whyNotMade(store);
      if (!why) push({ edits: [{ op: "text", value }], text: "propose bars" });
      tell(false, why || HINT);
    } catch (error) {
      tell(false, error instanceof Refused ? error.message : String(error), true);
    }
  }

  function tell(busy: boolean, text: string, bad = false): void {
    isBusy = busy;
    element.classList.toggle("bad", bad);
    setText(words, text);
    setRead(words, "title", text);
    update();
  }

  function update(): void {
    allow(start, isBusy ? BUSY : whyNotMade(store));
  }

  store.on(["solved", "doc", "waiting"], update);
  tell(false, HINT);
  return element;
}

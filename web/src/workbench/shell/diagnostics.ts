// All faults of the case file below the model; each leads to its field.

import type { Fault } from "../client/api";
import type { Store } from "../client/store";
import { faultLine } from "../form/form-panel";
import { fill, h } from "./elements";

export interface FaultList {
  readonly element: HTMLElement;
  open(): void;
}

/** The line with the number of faults, and the list that it opens. */
export function faultList(store: Store, go: (fault: Fault) => void): FaultList {
  const count = h("span", { class: "fault-count" });
  const rows = h("ul", {});
  const first = h("span", { class: "first-fault" });
  const element = h("details", { class: "fault-list" }, h("summary", {}, count, first), rows);
  const update = () => {
    const faults = store.doc?.faults ?? [];
    element.classList.toggle("bad", faults.length > 0);
    count.textContent = store.doc?.checking
      ? "Being checked …"
      : faults.length === 0
        ? "No faults"
        : faults.length === 1
          ? "1 fault"
          : `${faults.length} faults`;
    first.textContent = faults[0] ? faultLine(faults[0]) : "";
    if (faults.length === 0) element.open = false;
    fill(
      rows,
      ...faults.map((fault) =>
        h("li", {}, h("button", { type: "button", onclick: () => go(fault) }, faultLine(fault))),
      ),
    );
  };
  element.addEventListener("click", (event) => {
    // nothing to open
    if (store.doc?.faults.length === 0 && event.target instanceof Node && !rows.contains(event.target))
      event.preventDefault();
  });
  store.on(["doc"], update);
  return { element, open: () => (element.open = true) };
}

// Loads beside the drawing: the load case that stands out, and loads without a place in plan.
import { button, fill, fillOptions, h } from "../../viewer/shared/dom";
import type { Store } from "../client/store";
import type { Change } from "../model/changes/edits";
import { defaultsFor } from "../model/defaults";
import { UNPLACED } from "../model/items";
import { namesIn } from "../model/names";
import { listAt, type Path, tableAt } from "../model/paths";

interface Part {
  readonly element: HTMLElement;
  update(): void;
}

/** The choice of the load case that stands out, and that new loads belong to. */
export function caseChoice(store: Store, onChoose: (name: string) => void): Part {
  const title = "Loads of this case stand out, and new loads belong to it";
  const select = h("select", { "aria-label": "load case shown", title, onchange: () => onChoose(select.value) });
  const update = () => {
    const names = namesIn(listAt(store.data, ["cases"]));
    const before = select.value;
    fillOptions(select, [["", "all load cases"], ...names.map((name) => [name, name] as const)]);
    select.hidden = names.length === 0;
    if (select.value !== before) onChoose(select.value);
  };
  return { element: select, update };
}

/** Loads on the entire slab, and buttons that add them. */
export function unplacedLoads(store: Store, push: (change: Change) => void): Part {
  const element = h("div", { class: "unplaced" });
  const makeChip = (path: Path) => {
    const load = tableAt(store.data, path);
    const value = String(load.q ?? load.unit_weight ?? load.difference ?? load.w ?? "");
    const text = `${String(load.name || load.kind)} ${value}${load.case ? ` (${String(load.case)})` : ""}`;
    const chip = button(text, "Load on the entire slab", () => store.select(path), "chip");
    chip.setAttribute("aria-pressed", String(store.isSelected(path)));
    return chip;
  };
  const makeAdd = (definition: string, text: string) => {
    const add = button(`+ ${text}`, `Add ${text}`, () => addLoad(store, push, definition, text), "chip add");
    add.disabled = store.broken;
    return add;
  };
  const update = () => {
    const chips = listAt(store.data, ["loads"]).flatMap((_, n) =>
      UNPLACED.has(String(tableAt(store.data, ["loads", n]).kind)) ? [makeChip(["loads", n])] : [],
    );
    fill(
      element,
      h("span", {}, "Entire slab:"),
      h("span", { class: "chips" }, ...(chips.length > 0 ? chips : [h("span", { class: "quiet" }, "no loads")])),
      h("span", { class: "chip-adds" }, makeAdd("UniformLoad", "uniform load"), makeAdd("SelfWeight", "self-weight")),
    );
  };
  return { element, update };
}

function addLoad(store: Store, push: (change: Change) => void, definition: string, text: string): void {
  const [first] = namesIn(listAt(store.data, ["cases"]));
  const value = { ...defaultsFor(definition, store.data), ...(first ? { case: first } : {}) };
  const path: Path = ["loads", listAt(store.data, ["loads"]).length];
  push({ edits: [{ op: "add", path: ["loads"], value }], text: `add ${text}` });
  store.select(path);
}

// Loads beside the drawing: the load case that stands out, and loads without a place in plan.
import { button, fill, fillOptions, h } from "../../viewer/shared/dom";
import type { Store } from "../client/store";
import type { Change } from "../model/changes/edits";
import { addLoadCase } from "../model/changes/new-items";
import { defaultsFor } from "../model/defaults";
import { UNPLACED } from "../model/items";
import { namesIn } from "../model/names";
import { listAt, type Path, tableAt } from "../model/paths";

interface Part {
  readonly element: HTMLElement;
  update(): void;
}

/** The choice of the load case that stands out and that new loads belong to, and a way to add one. */
export function caseChoice(store: Store, push: (change: Change) => void, onChoose: (name: string) => void): Part {
  const title = "Loads of this case stand out, and new loads belong to it";
  const select = h("select", { "aria-label": "load case shown", title, onchange: () => onChoose(select.value) });
  const input = h("input", { "aria-label": "name of the new load case", placeholder: "name, Enter", hidden: true });
  const add = button("+ case", "Add a load case, which new loads belong to", () => ask(true), "small");
  const ask = (isAsked: boolean) => {
    input.hidden = !isAsked;
    add.hidden = isAsked;
    if (isAsked) input.focus();
  };
  const update = () => {
    const names = namesIn(listAt(store.data, ["cases"]));
    const before = select.value;
    fillOptions(select, [["", "all load cases"], ...names.map((name) => [name, name] as const)]);
    select.hidden = names.length === 0;
    add.disabled = store.broken;
    if (select.value !== before) onChoose(select.value);
  };
  const finish = () => {
    const name = input.value.trim();
    if (!name || store.broken) return;
    const change = addLoadCase(store.data, name);
    if (change.edits.length > 0) push(change);
    update();
    select.value = name;
    onChoose(select.value);
    input.value = "";
    ask(false);
  };
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") finish();
    else if (event.key === "Escape") ask(false);
  });
  return { element: h("div", { class: "case-choice" }, select, input, add), update };
}

/** Loads on the entire slab, and buttons that add them. */
export function unplacedLoads(store: Store, push: (change: Change) => void, loadCase: () => string): Part {
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
    const add = button(
      `+ ${text}`,
      `Add ${text}`,
      () => addLoad(store, push, definition, text, loadCase()),
      "chip add",
    );
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

function addLoad(
  store: Store,
  push: (change: Change) => void,
  definition: string,
  text: string,
  loadCase: string,
): void {
  const name = loadCase || namesIn(listAt(store.data, ["cases"]))[0];
  const value = { ...defaultsFor(definition, store.data), ...(name ? { case: name } : {}) };
  const path: Path = ["loads", listAt(store.data, ["loads"]).length];
  push({ edits: [{ op: "add", path: ["loads"], value }], text: `add ${text}` });
  store.select(path);
}

// Loads beside the drawing: the load case that stands out, and loads without a place in plan.
import { allow, button, fillOptions, h, setText } from "../../viewer/shared/dom";
import { say, type Text, translate, verbatim } from "../../viewer/shared/language";
import type { Store } from "../client/store";
import { scrollingBar } from "../controls/scrolling-bar";
import { defaultsFor } from "../model/defaults";
import type { Change } from "../model/edits";
import { UNPLACED } from "../model/items";
import { namesIn } from "../model/names";
import { listAt, type Path, type Table, tableAt } from "../model/paths";
import { TEXT_FIRST } from "./actions/why-not";
import { newCase } from "./new-case";

interface Part {
  readonly element: HTMLElement;
  update(): void;
}

/** The choice of the load case that stands out and that new loads belong to, and a way to add one. */
export function caseChoice(store: Store, push: (change: Change) => void, onChoose: (name: string) => void): Part {
  const title = "Highlight the loads of this case and add new loads to it";
  const select = h("select", { "aria-label": "highlighted load case", title, onchange: () => onChoose(select.value) });
  const ask = () => {
    add.hidden = true;
    asked.show(true);
  };
  const add = button("+ case", "Add a load case for new loads", ask, "small");
  const asked = newCase(store, push, (name) => {
    add.hidden = false;
    if (name === null) return;
    update();
    select.value = name;
    onChoose(select.value);
  });
  const update = () => {
    const names = namesIn(listAt(store.data, ["cases"]));
    const before = select.value;
    fillOptions(select, [["", "all load cases"], ...names.map((name) => [name, verbatim(name)] as const)]);
    select.hidden = names.length === 0;
    allow(add, store.broken ? TEXT_FIRST : "");
    if (select.value !== before) onChoose(select.value);
  };
  return { element: h("div", { class: "case-choice" }, select, asked.element, add), update };
}

/** Where a new load belongs, and what removes the one that is selected. */
interface LoadHooks {
  loadCase(): string;
  remove(): void;
}

/** Loads on the entire slab, and buttons that add them. */
export function unplacedLoads(store: Store, push: (change: Change) => void, { loadCase, remove }: LoadHooks): Part {
  // buttons are kept, so that a press is not lost where leaving a field changes a load meanwhile
  const chips: { button: HTMLButtonElement; path: Path }[] = [];
  const none = h("span", { class: "quiet" }, "no loads");
  const box = h("span", { class: "chips" }, none);
  box.addEventListener("keydown", (event) => {
    const chip = chips.find(({ button }) => button === event.target);
    if (!chip || (event.key !== "Delete" && event.key !== "Backspace")) return;
    event.preventDefault();
    store.select(chip.path);
    remove();
  });
  const adds = [
    ["UniformLoad", "uniform load"],
    ["SelfWeight", "self-weight"],
    ["TemperatureLoad", "temperature"],
  ].map(([definition = "", text = ""]) =>
    button(
      verbatim(`+ ${translate(text)}`),
      say("Add {item}", { item: text }),
      () => addLoad(store, push, definition, text, loadCase()),
      "chip add",
    ),
  );
  const makeChip = () => {
    const chip = {
      button: button("", "Load on the entire slab", () => store.select(chip.path), "chip"),
      path: [] as Path,
    };
    box.append(chip.button);
    chips.push(chip);
  };
  const update = () => {
    const paths = listAt(store.data, ["loads"]).flatMap((_, n): Path[] =>
      UNPLACED.has(String(tableAt(store.data, ["loads", n]).kind)) ? [["loads", n]] : [],
    );
    while (chips.length < paths.length) makeChip();
    for (const chip of chips.splice(paths.length)) chip.button.remove();
    paths.forEach((path, n) => {
      const chip = chips[n]!;
      chip.path = path;
      setText(chip.button, chipText(tableAt(store.data, path)));
      chip.button.setAttribute("aria-pressed", String(store.isSelected(path)));
    });
    none.hidden = paths.length > 0;
    for (const add of adds) allow(add, store.broken ? TEXT_FIRST : "");
  };
  const element = h(
    "div",
    { class: "unplaced" },
    h("span", {}, "Entire slab:"),
    scrollingBar(box),
    h("span", { class: "chip-adds" }, ...adds),
  );
  return { element, update };
}

function chipText(load: Table): Text {
  const value = String(load.q ?? load.unit_weight ?? load.difference ?? load.w ?? "");
  return verbatim(`${String(load.name || load.kind)} ${value}${load.case ? ` (${String(load.case)})` : ""}`);
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
  push({ edits: [{ op: "add", path: ["loads"], value }], text: say("add {item}", { item: text }) });
  store.select(path);
}

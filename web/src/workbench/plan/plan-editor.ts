// The drawing with its tools, keys and properties.

import type { Change } from "../client/api";
import { namesIn, type Store } from "../client/store";
import type { FormContext } from "../form/context";
import { starter } from "../model/defaults";
import { editsBetween } from "../model/geometry";
import { EVERYWHERE, type Item } from "../model/items";
import { listAt, type Path, samePath, valueAt } from "../model/paths";
import { removal } from "../model/references";
import { fill, h } from "../shell/elements";
import { Canvas } from "./canvas";
import { withoutCorner } from "./interaction/handles";
import { Nudge, Pointer, whyFixed } from "./interaction/pointer";
import { properties } from "./properties";
import { hintLine, toolBar, toolForKey } from "./tool-bar";
import { duplicateOf } from "./tools";

export interface PlanEditor {
  readonly element: HTMLElement;
  /** Select the thing that a path is in, and focus the field; returns whether there is one. */
  reveal(path: Path): boolean;
  fit(): void;
}

/** The plan editor. */
export function planEditor(store: Store, ctx: FormContext, push: (change: Change) => void): PlanEditor {
  const canvas = new Canvas(store);
  const hint = hintLine();
  const panel = properties(ctx, { push, select: (path) => store.select(path), step: () => canvas.step });
  const tools = toolBar((tool) => {
    pointer.cancel();
    hint.say(tool.hint);
    canvas.element.dataset.tool = tool.draws;
    canvas.element.focus({ preventScroll: true });
  });
  const pointer = new Pointer(canvas, store, {
    push,
    select: (path) => store.select(path),
    tool: () => tools.current(),
    drawn: (change, path) => {
      push(change);
      store.select(path);
      if (tools.current().draws !== "point") tools.choose("select");
    },
    editable: () => !store.broken,
    say: (words) => hint.say(words),
  });
  const nudge = new Nudge(canvas, push);
  const box = h("div", { class: "drawing-box" }, canvas.element as unknown as HTMLElement);
  const cases = caseChoice(store, (name) => {
    canvas.loadCase = name;
    canvas.paint();
  });
  const everywhere = h("div", { class: "everywhere" });
  const fit = h(
    "button",
    { type: "button", class: "small", title: "Show everything (0)", onclick: () => canvas.fit() },
    "Fit",
  );
  const corner = h("div", { class: "drawing-corner" }, cases.element, fit);
  const empty = h(
    "p",
    { class: "drawing-empty" },
    "Draw the slab: choose Slab (B), then drag a rectangle or click corner after corner.",
  );
  box.append(corner, empty);
  const element = h(
    "div",
    { class: "plan-editor" },
    tools.element,
    h("div", { class: "plan-middle" }, box, everywhere, hint.element),
    panel.element,
  );
  hint.say(tools.current().hint);

  const keys = new Keys(
    canvas,
    pointer,
    nudge,
    store,
    push,
    (name) => tools.choose(name),
    () => tools.current().name,
  );
  canvas.element.addEventListener("keydown", (event) => {
    if (keys.down(event)) event.preventDefault();
  });
  new ResizeObserver(() => canvas.resize(box.clientWidth, box.clientHeight)).observe(box);
  store.on(["data"], () => {
    canvas.refresh();
    // what has gone is no longer selected
    if (store.selection && valueAt(store.data, store.selection) === undefined) store.select(null);
    cases.update();
    empty.hidden = canvas.items.some((item) => item.kind === "slab");
    showEverywhere(everywhere, store, push);
    panel.show(store.selection);
  });
  store.on(["doc"], () => {
    canvas.paint();
    panel.update();
  });
  store.on(["selection"], () => {
    canvas.corner = null;
    canvas.paint();
    panel.show(store.selection);
    showEverywhere(everywhere, store, push);
    if (store.selection) {
      const item = canvas.selected;
      if (item)
        hint.say(
          `${item.title} is selected. ${item.movable ? "Drag it, or move it with the arrow keys; Delete removes it." : whyFixed(item)}`,
        );
    } else hint.say(tools.current().hint);
  });
  const reveal = (path: Path) => {
    const item = canvas.items.findLast(
      (each) => each.kind !== "slab" && each.path.every((step, n) => step === path[n]),
    );
    if (item) store.select(item.path);
    else if (path[0] === "plate") store.select(null);
    else return false;
    return panel.reveal(path);
  };
  return { element, reveal, fit: () => canvas.fit() };
}

/** The choice of the load case that is drawn strongly, and that new loads belong to. */
function caseChoice(store: Store, chosen: (name: string) => void): { element: HTMLElement; update(): void } {
  const select = h("select", {
    "aria-label": "load case shown",
    title: "Loads of this case are drawn strongly, and new loads belong to it",
  });
  select.addEventListener("change", () => chosen(select.value));
  const update = () => {
    const names = namesIn(listAt(store.data, ["cases"]));
    const before = select.value;
    fill(
      select,
      h("option", { value: "" }, "all load cases"),
      ...names.map((name) => h("option", { value: name }, name)),
    );
    select.value = names.includes(before) ? before : "";
    select.hidden = names.length === 0;
    if (select.value !== before) chosen(select.value);
  };
  return { element: select, update };
}

/** Loads without a place: on the whole slab. */
function showEverywhere(element: HTMLElement, store: Store, push: (change: Change) => void): void {
  const loads = listAt(store.data, ["loads"]).flatMap((load, n) => {
    const table = typeof load === "object" && load !== null && !Array.isArray(load) ? load : {};
    if (!EVERYWHERE.has(String(table.kind))) return [];
    const value = String(table.q ?? table.unit_weight ?? table.difference ?? table.w ?? "");
    const name = table.name ? String(table.name) : String(table.kind);
    const path: Path = ["loads", n];
    const words = `${name} ${value}${table.case ? ` (${String(table.case)})` : ""}`;
    return [
      h(
        "button",
        {
          type: "button",
          class: "chip",
          "aria-pressed": samePath(path, store.selection) ? "true" : "false",
          title: "Load on the whole slab",
          onclick: () => store.select(path),
        },
        words,
      ),
    ];
  });
  const chips = h(
    "span",
    { class: "chips" },
    ...(loads.length > 0 ? loads : [h("span", { class: "quiet" }, "no loads")]),
  );
  fill(element, h("span", {}, "Whole slab:"), chips, addLoad(store, push));
}

/** Buttons that add a load without a place. */
function addLoad(store: Store, push: (change: Change) => void): HTMLElement {
  const button = (definition: string, words: string) =>
    h(
      "button",
      {
        type: "button",
        class: "chip add",
        disabled: store.broken,
        title: `Add ${words}`,
        onclick: () => {
          const first = namesIn(listAt(store.data, ["cases"]))[0];
          const path: Path = ["loads", listAt(store.data, ["loads"]).length];
          push({
            edits: [
              {
                op: "add",
                path: ["loads"],
                value: { ...starter(definition, store.data), ...(first ? { case: first } : {}) },
              },
            ],
            text: `add ${words}`,
          });
          store.select(path);
        },
      },
      `+ ${words}`,
    );
  return h("span", { class: "chip-adds" }, button("UniformLoad", "uniform load"), button("SelfWeight", "own weight"));
}

/** What keys do in the drawing. */
class Keys {
  constructor(
    private readonly canvas: Canvas,
    private readonly pointer: Pointer,
    private readonly nudge: Nudge,
    private readonly store: Store,
    private readonly push: (change: Change) => void,
    private readonly choose: (name: ReturnType<typeof toolForKey> & string) => void,
    private readonly tool: () => string,
  ) {}

  /** Take a key; returns whether it meant something here. */
  down(event: KeyboardEvent): boolean {
    const { canvas } = this;
    if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "d") return this.duplicate();
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    switch (event.key) {
      case "Escape":
        if (!this.pointer.cancel() && this.tool() === "select") this.store.select(null);
        this.choose("select");
        return true;
      case "Enter":
        this.pointer.finish();
        return true;
      case "Delete":
      case "Backspace":
        return this.remove();
      case "0":
        canvas.fit();
        return true;
      case "+":
      case "=":
      case "-":
        canvas.camera.zoom(event.key === "-" ? 0.8 : 1.25);
        canvas.moved();
        return true;
      case "n":
      case "N":
        return this.next(event.shiftKey ? -1 : 1);
      case " ":
        return true;
    }
    const arrow = ARROWS[event.key];
    if (arrow) return this.arrow(arrow, event.shiftKey ? 10 : 1);
    const tool = toolForKey(event.key);
    if (!tool) return false;
    this.choose(tool);
    return true;
  }

  private arrow([dx, dy]: readonly [number, number], times: number): boolean {
    const item = this.canvas.selected;
    if (item?.movable && !this.store.broken) {
      const step = this.canvas.step * times;
      this.nudge.step(item, dx * step, dy * step);
    } else {
      this.canvas.camera.pan(-dx * 40, dy * 40);
      this.canvas.moved();
    }
    return true;
  }

  private remove(): boolean {
    const { selected, corner } = this.canvas;
    if (this.store.broken) return true;
    if (selected && corner !== null) {
      const after = withoutCorner(selected.geometry, corner);
      if (after) {
        this.canvas.corner = null;
        this.push({ edits: editsBetween(selected.geometry, after), text: `remove a corner of ${selected.title}` });
        return true;
      }
    }
    const path = this.store.selection;
    if (!path || (path[0] === "plate" && path.length < 3)) return true;
    this.push(removal(this.store.data, path));
    this.store.select(null);
    return true;
  }

  private duplicate(): boolean {
    const item = this.canvas.selected;
    if (!item || this.store.broken) return true;
    const step = this.canvas.step * 2;
    const made = duplicateOf(this.store.data, item.path, item.title, item.movable ? [step, step] : [0, 0]);
    if (!made) return true;
    this.push(made.change);
    this.store.select(made.path);
    return true;
  }

  /** Select the next thing in the order of the drawing. */
  private next(by: number): boolean {
    const { items } = this.canvas;
    const now = items.findIndex((item: Item) => samePath(item.path, this.store.selection));
    const item = items[(now + by + items.length) % Math.max(1, items.length)];
    this.store.select(item?.path ?? null);
    return true;
  }
}

const ARROWS: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

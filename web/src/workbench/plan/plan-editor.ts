// The drawing with its tools, keys and properties.
import { button, h, setText } from "../../viewer/shared/dom";
import type { Store } from "../client/store";
import type { FormContext } from "../form/context";
import type { Change } from "../model/changes/edits";
import { type Path, startsWith, valueAt } from "../model/paths";
import { Canvas } from "./canvas";
import { Keyboard } from "./interaction/keyboard";
import { Pointer, whyFixed } from "./interaction/pointer";
import { caseChoice, unplacedLoads } from "./loads";
import { propertyPanel } from "./properties";
import { toolBar } from "./tool-bar";
import "./plan-editor.css";

export interface PlanEditor {
  readonly element: HTMLElement;
  /** Select the item that a path is in, and focus the field; returns whether there is one. */
  reveal(path: Path): boolean;
}

export function planEditor(store: Store, ctx: FormContext, push: (change: Change) => void): PlanEditor {
  const canvas = new Canvas(store);
  const hint = h("p", { class: "drawing-hint", role: "status" });
  const showHint = (text: string) => setText(hint, text);
  const panel = propertyPanel(
    ctx,
    push,
    (path) => store.select(path),
    () => canvas.step,
  );
  const tools = toolBar((tool) => {
    pointer.cancel();
    showHint(tool.hint);
    canvas.element.dataset.tool = tool.draws;
    canvas.element.focus({ preventScroll: true });
  });
  const pointer = new Pointer(canvas, store, {
    push,
    tool: () => tools.current(),
    onDrawn: ({ change, path }) => {
      push(change);
      store.select(path);
      if (tools.current().draws !== "point") tools.choose("select");
    },
    showHint,
  });
  new Keyboard(canvas, pointer, store, push, tools);
  const cases = caseChoice(store, (name) => {
    canvas.loadCase = name;
    canvas.redraw();
  });
  const loads = unplacedLoads(store, push);
  const fit = button("Fit", "Show everything (0)", () => canvas.fit(), "small");
  const emptyHint = "Draw the slab: choose Slab (B), then drag a rectangle or click corner after corner.";
  const empty = h("p", { class: "drawing-empty" }, emptyHint);
  const corner = h("div", { class: "drawing-corner" }, cases.element, fit);
  const box = h("div", { class: "drawing-box" }, canvas.element, corner, empty);
  const middle = h("div", { class: "plan-middle" }, box, loads.element, hint);
  const element = h("div", { class: "plan-editor" }, tools.element, middle, panel.element);
  showHint(tools.current().hint);
  new ResizeObserver(() => canvas.resize(box.clientWidth, box.clientHeight)).observe(box);
  store.on(["data"], () => {
    canvas.refresh();
    // what has been removed is no longer selected
    if (store.selection && valueAt(store.data, store.selection) === undefined) store.select(null);
    cases.update();
    empty.hidden = canvas.items.some((item) => item.kind === "slab");
  });
  store.on(["doc"], () => {
    canvas.redraw();
    panel.update();
  });
  store.on(["selection"], () => {
    canvas.corner = null;
    canvas.redraw();
    const item = canvas.selected;
    const how = item?.movable ? "Drag it, or move it with the arrow keys; Delete removes it." : item && whyFixed(item);
    showHint(item ? `${item.title} is selected. ${how}` : tools.current().hint);
  });
  store.on(["data", "selection"], () => {
    loads.update();
    panel.show(store.selection);
  });
  const reveal = (path: Path) => {
    const item = canvas.items.findLast((each) => each.kind !== "slab" && startsWith(path, each.path));
    if (!item && path[0] !== "plate") return false;
    store.select(item?.path ?? null);
    return panel.reveal(path);
  };
  return { element, reveal };
}

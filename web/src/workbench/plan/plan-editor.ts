// The drawing with its tools, keys and properties.

import { button, h, setText } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import type { Store } from "../client/store";
import type { FormContext } from "../form/context";
import { joinEdits } from "../model/changes/batches";
import type { Change } from "../model/edits";
import { countItems } from "../model/items";
import { type Path, startsWith, valueAt } from "../model/paths";
import { actionBar } from "./actions/action-bar";
import { Actions } from "./actions/actions";
import { useClipboard } from "./actions/clipboard";
import { ActionDialog } from "./actions/dialog";
import { whyFixed, whyNotDrawn } from "./actions/why-not";
import { Canvas } from "./canvas";
import { Keyboard } from "./interaction/keyboard";
import { Pointer } from "./interaction/pointer";
import { caseChoice, unplacedLoads } from "./loads";
import { propertyPanel } from "./properties";
import { toolBar } from "./tool-bar";
import type { Tool } from "./tools";
import { underlayBar } from "./underlay/underlay-bar";
import "./plan-editor.css";

const EMPTY = "Draw the slab: choose Slab (B), then drag a rectangle or click the corners one by one.";
const HOW_AXES =
  "Drag the circles or handles of axes to move or turn them; to place one exactly, type while dragging and press Enter.";
const HOW_MANY = "Drag or use the arrow keys to move them; press Delete to remove them.";

export interface PlanEditor {
  readonly element: HTMLElement;
  /** Select the item that a path is in, and focus the field; returns whether there is one. */
  reveal(path: Path): boolean;
}

export function planEditor(store: Store, context: FormContext, send: (change: Change) => void): PlanEditor {
  const push = (change: Change) => send(joinEdits(store.data, change));
  const ctx: FormContext = { ...context, change: push };
  const canvas = new Canvas(store);
  const hint = h("p", { class: "drawing-hint", role: "status" });
  const showHint = (text: string) => setText(hint, text);
  const actions = new Actions(canvas, store, push, showHint);
  const dialog = new ActionDialog(canvas, actions);
  const acts = actionBar(actions, dialog);
  const panel = propertyPanel(ctx, push, dialog.element, acts.buttons);
  const takeTool = (tool: Tool) => {
    pointer.cancel();
    showHint(tool.hint);
    canvas.element.dataset.tool = tool.draws;
    passFocus(tools.element, canvas.element);
  };
  const tools = toolBar({
    onChange: takeTool,
    onGenerate: (generator) => dialog.open(generator),
    onRefuse: showHint,
    whyNot: (name) => whyNotDrawn(store, canvas.hasSlab, name),
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
  new Keyboard(canvas, pointer, store, push, tools, actions, dialog, showHint);
  useClipboard(canvas.element, actions, () => pointer.place);
  const box = drawingBox(store, canvas, push);
  const loads = unplacedLoads(store, push, { loadCase: () => canvas.loadCase, remove: () => actions.remove() });
  const middle = h("div", { class: "plan-middle" }, box, loads.element, hint);
  const element = h("div", { class: "plan-editor" }, tools.element, middle, panel.element);
  showHint(tools.current().hint);
  store.on(["doc"], () => {
    canvas.redraw();
    panel.update();
    dialog.update();
  });
  store.on(["selection"], () => {
    dialog.close();
    canvas.corner = null;
    canvas.redraw();
    const isOfAxes = store.selection?.[0] === "axes";
    showHint(describeSelection(canvas) ?? (isOfAxes ? HOW_AXES : tools.current().hint));
  });
  store.on(["data", "doc", "selection"], () => {
    tools.update();
    acts.update();
    loads.update();
  });
  store.on(["data", "selection"], () => panel.show(store.selected));
  return { element, reveal: (path) => selectAt(store, canvas, path) && panel.reveal(path) };
}

/** Let the drawing have the keyboard, unless it is elsewhere than at the tools, as where one of them is put down. */
function passFocus(tools: HTMLElement, drawing: HTMLElement): void {
  const { activeElement } = document;
  if (activeElement === document.body || tools.contains(activeElement)) drawing.focus({ preventScroll: true });
}

/** Select the item that a path is in, none for the slab itself; returns whether it is in any. */
function selectAt(store: Store, canvas: Canvas, path: Path): boolean {
  const item = canvas.items.findLast((one) => one.kind !== "slab" && startsWith(path, one.path));
  if (!item && path[0] !== "plate") return false;
  store.select(item?.path ?? null);
  return true;
}

/** Make the drawing with the controls in its corner, and with what it says while there is no slab. */
function drawingBox(store: Store, canvas: Canvas, push: (change: Change) => void): HTMLElement {
  const cases = caseChoice(store, push, (name) => {
    canvas.loadCase = name;
    canvas.redraw();
  });
  const empty = h("p", { class: "drawing-empty" }, EMPTY);
  const bar = [underlayBar(store, canvas), cases.element, ...viewButtons(canvas)];
  const corner = h("div", { class: "drawing-corner" }, ...bar);
  const box = h("div", { class: "drawing-box" }, canvas.element, corner, empty);
  new ResizeObserver(() => {
    const { width, height } = box.getBoundingClientRect();
    canvas.resize(width, height);
  }).observe(box);
  store.on(["opened"], () => canvas.fit());
  store.on(["data"], () => {
    canvas.refresh();
    // what has been removed is no longer selected
    store.selectAll(store.selected.filter((path) => valueAt(store.data, path) !== undefined));
    cases.update();
    empty.hidden = canvas.hasSlab;
  });
  return box;
}

/** Make the buttons that show or hide axes and dimensions, and show everything. */
function viewButtons(canvas: Canvas): HTMLButtonElement[] {
  const toggle = () => {
    canvas.showAxes(!canvas.hasAxes);
    element.setAttribute("aria-pressed", String(canvas.hasAxes));
  };
  const element = button("Axes", "Show column axes and dimensions (Z)", toggle, "small");
  element.setAttribute("aria-pressed", String(canvas.hasAxes));
  element.setAttribute("aria-keyshortcuts", "Z");
  canvas.element.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() === "z" && !event.ctrlKey && !event.metaKey && !event.altKey) toggle();
  });
  return [element, button("Fit", "Show everything (0)", () => canvas.fit(), "small")];
}

/** Return what is selected and what can be done with it, null if nothing is. */
function describeSelection(canvas: Canvas): string | null {
  const items = canvas.selectedItems;
  const item = canvas.selected;
  if (items.length > 1) return say("{items} selected. {how}", { items: countItems(items), how: HOW_MANY });
  if (!item) return null;
  const how = item.movable ? "Drag it or use the arrow keys to move it; press Delete to remove it." : whyFixed(item);
  return say("{item} is selected. {how}", { item: item.title, how });
}

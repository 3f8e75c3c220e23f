// The pointer over the drawing: selecting, moving, reshaping, drawing, moving and zooming the view.

import { isFar, pixelOf, Touches, zoomByWheel } from "../../../viewer/plan/navigation";
import { say, verbatim } from "../../../viewer/shared/language";
import type { Store } from "../../client/store";
import type { Addition, Change } from "../../model/edits";
import type { Point } from "../../model/geometry";
import { type Item, isPlate, loadsOn } from "../../model/items";
import { type Path, samePath } from "../../model/paths";
import { whyFixed } from "../actions/why-not";
import type { Canvas } from "../canvas";
import type { Tool } from "../tools";
import { AxisGesture } from "./axis-gesture";
import { type DragGesture, DrawGesture, MoveGesture, ReshapeGesture } from "./gestures";
import { itemsInBand } from "./rubber-band";
import { alongAxis, typedPlace } from "./typed-input";

const TYPED_REACH = 1e-9; // m: typed places are the same only if they are equal

export interface PointerHooks {
  push(change: Change): void;
  tool(): Tool;
  /** Something was drawn. */
  onDrawn(addition: Addition): void;
  showHint(text: string): void;
}

/** What goes on while the pointer is down. */
type Press =
  | { kind: "pan" }
  | { kind: "item"; item: Item; start: Point; wasSelected: boolean; adds: boolean }
  | { kind: "drag"; gesture: DragGesture }
  | { kind: "axis"; gesture: AxisGesture; start: Point }
  | { kind: "band"; start: Point; before: readonly Path[] }
  | { kind: "empty"; start: Point; adds: boolean };

export class Pointer {
  private drawing: DrawGesture | null = null;
  private press: Press | null = null;
  private space = false;
  private lastClick: Point | null = null; // another click at the same place selects what lies below
  private readonly touches = new Touches();
  /** The place below the pointer, snapped; null while it is elsewhere. */
  place: Point | null = null;

  constructor(
    private readonly canvas: Canvas,
    private readonly store: Store,
    private readonly hooks: PointerHooks,
  ) {
    const { element } = canvas;
    element.addEventListener("pointerdown", (event) => this.down(event));
    element.addEventListener("pointermove", (event) => this.move(event));
    element.addEventListener("pointerup", (event) => this.up(event));
    element.addEventListener("pointercancel", () => this.cancel());
    element.addEventListener("pointerleave", () => this.leave());
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("dblclick", () => this.finish());
    const zoom = (event: WheelEvent) => {
      zoomByWheel(canvas.camera, event, pixelOf(element, event));
      canvas.moved();
    };
    element.addEventListener("wheel", zoom, { passive: false });
    for (const type of ["keydown", "keyup"] as const)
      element.addEventListener(type, (event) => {
        if (event.key === " ") this.space = type === "keydown";
      });
  }

  /** End a drawing of several clicks with what there is. */
  finish(): void {
    if (this.drawing && this.drawing.points.length >= 2) this.complete();
  }

  /** Whether items or an axis are being moved. */
  get isMoving(): boolean {
    return (this.press?.kind === "drag" && this.press.gesture instanceof MoveGesture) || this.press?.kind === "axis";
  }

  /** Return why what was typed is nothing that can be placed, in words. */
  refusal(typed: string): string {
    if (this.press?.kind === "axis") return this.press.gesture.refusal(typed);
    return say('Found "{typed}", expected a length such as 3.5 or a point such as 2;3.', { typed: verbatim(typed) });
  }

  /** Go on drawing or moving at a place or by a length that was typed; returns whether it was one. */
  placeTyped(text: string): boolean {
    if (this.press?.kind === "drag" && this.press.gesture instanceof MoveGesture)
      return this.dropTyped(this.press.gesture, text);
    if (this.press?.kind === "axis") return this.dropTypedAxis(this.press.gesture, text);
    const drawing = this.drawing ?? new DrawGesture(this.hooks.tool());
    const place = typedPlace(text, drawing.points.at(-1) ?? null, this.place);
    if (!place) return false;
    this.drawing = drawing;
    const isComplete = drawing.down(place, TYPED_REACH);
    drawing.up(place, TYPED_REACH);
    if (isComplete) this.complete();
    else this.canvas.preview = drawing.preview({ at: place, fromX: null, fromY: null, onPoint: false });
    this.canvas.redraw();
    return true;
  }

  /** End a move at a place, or after a length towards the pointer. */
  private dropTyped(gesture: MoveGesture, text: string): boolean {
    const pointer = this.canvas.guides?.at;
    const place = typedPlace(text, gesture.held, pointer ? alongAxis(gesture.held, pointer) : null);
    if (!place) return false;
    gesture.moveTo({ at: place, fromX: null, fromY: null, onPoint: false });
    this.press = null;
    this.drop(gesture);
    return true;
  }

  private dropTypedAxis(gesture: AxisGesture, text: string): boolean {
    if (!gesture.type(text)) return false;
    this.press = null;
    this.dropAxis(gesture);
    return true;
  }

  private drop(gesture: DragGesture): void {
    const change = gesture.change();
    this.canvas.preview = this.canvas.guides = null;
    if (change) this.hooks.push(change);
    this.canvas.redraw();
  }

  /** Abandon what is being done; returns whether there was anything. */
  cancel(): boolean {
    const isBusy = this.press !== null || this.drawing !== null;
    this.touches.clear();
    this.press = this.drawing = this.canvas.preview = this.canvas.guides = this.canvas.band = this.canvas.tip = null;
    this.canvas.trial = [];
    this.canvas.redraw();
    return isBusy;
  }

  private down(event: PointerEvent): void {
    const { canvas } = this;
    canvas.element.focus({ preventScroll: true });
    canvas.element.setPointerCapture(event.pointerId);
    const pixel = pixelOf(canvas.element, event);
    this.touches.set(event.pointerId, pixel);
    if (this.touches.size > 1 || event.button > 0 || this.space) {
      this.press = { kind: "pan" };
      return;
    }
    const tool = this.hooks.tool();
    if (tool.draws === "nothing") this.press = this.pressAt(pixel, event.shiftKey);
    else if (!this.store.broken) {
      this.drawing ??= new DrawGesture(tool);
      if (this.drawing.down(this.snapDrawing(this.drawing, pixel, event).at, canvas.reach)) this.complete();
    }
  }

  /** Return what a press on a pixel begins. */
  private pressAt(pixel: Point, adds: boolean): Press {
    const { canvas, store } = this;
    const handle = canvas.handleAt(pixel);
    const { selected } = canvas;
    if (handle && selected && !store.broken) {
      canvas.corner = handle.kind === "corner" ? handle.index : null;
      canvas.redraw();
      return { kind: "drag", gesture: new ReshapeGesture(selected, handle) };
    }
    const axis = canvas.axisAt(pixel);
    if (axis) {
      const gesture = new AxisGesture(store.data, axis, canvas.camera.toPlan(pixel));
      return { kind: "axis", gesture, start: pixel };
    }
    const items = canvas.itemsAt(pixel);
    const isRepeated = this.lastClick !== null && !isFar(this.lastClick, pixel);
    const own = isRepeated ? items.find((item) => samePath(item.path, store.selection)) : undefined;
    const item = own ?? items[0];
    return item
      ? { kind: "item", item, start: pixel, wasSelected: own !== undefined, adds }
      : { kind: "empty", start: pixel, adds };
  }

  private move(event: PointerEvent): void {
    const { canvas, press, touches } = this;
    const pixel = pixelOf(canvas.element, event);
    this.place = canvas.snap(canvas.camera.toPlan(pixel), true, []).at;
    const before = touches.get(event.pointerId) ?? pixel;
    if (touches.pinch(canvas.camera, event.pointerId, pixel)) {
      this.press = { kind: "pan" };
      canvas.moved();
    } else if (press?.kind === "pan") {
      canvas.camera.pan(pixel[0] - before[0], pixel[1] - before[1]);
      canvas.moved();
    } else if (press?.kind === "item" || press?.kind === "empty") {
      if (isFar(press.start, pixel)) this.startDrag(press, pixel, event.pointerType === "touch");
    } else if (press?.kind === "band") this.stretchBand(press, pixel);
    else if (press?.kind === "axis") this.dragAxis(press, pixel, event.altKey);
    else if (press) {
      const { gesture } = press;
      if (gesture instanceof ReshapeGesture) gesture.bends = event.ctrlKey || event.metaKey;
      canvas.guides = canvas.snap(
        gesture.aim(canvas.camera.toPlan(pixel)),
        event.altKey,
        gesture.items.map((item) => item.path),
      );
      canvas.preview = gesture.moveTo(canvas.guides);
      canvas.redraw();
    } else if (this.hooks.tool().draws !== "nothing") {
      const drawing = this.drawing ?? new DrawGesture(this.hooks.tool());
      canvas.guides = this.snapDrawing(drawing, pixel, event);
      canvas.preview = drawing.preview(canvas.guides);
      canvas.redraw();
    } else this.hover(pixel);
  }

  /** Move or turn an axis, as far as its neighbors allow; what is attached to it follows. */
  private dragAxis({ gesture, start }: Extract<Press, { kind: "axis" }>, pixel: Point, free: boolean): void {
    const { canvas, store } = this;
    const isHeld = gesture.edits.length === 0 && !isFar(start, pixel);
    const to = canvas.camera.toPlan(pixel);
    if (store.broken || isHeld || !gesture.moveTo(to, canvas.step, free)) return;
    canvas.trial = gesture.edits;
    canvas.tip = { at: to, text: gesture.text };
    canvas.redraw();
  }

  private snapDrawing(drawing: DrawGesture, pixel: Point, event: PointerEvent) {
    drawing.round = event.ctrlKey || event.metaKey;
    return this.canvas.snap(this.canvas.camera.toPlan(pixel), event.altKey, [], drawing.points);
  }

  private startDrag(press: Extract<Press, { adds: boolean }>, pixel: Point, isTouch: boolean): void {
    const { canvas, store } = this;
    const { start } = press;
    // the slab fills the view: it is dragged only if it is selected
    const isHeld = press.kind === "item" && (!isPlate(press.item) || store.isSelected(press.item.path));
    if (isHeld && !press.adds) this.startMove(press.item, start);
    else if (isTouch) {
      this.press = { kind: "pan" };
      canvas.camera.pan(pixel[0] - start[0], pixel[1] - start[1]);
      canvas.moved();
    } else {
      this.press = { kind: "band", start: canvas.camera.toPlan(start), before: press.adds ? store.selected : [] };
      this.stretchBand(this.press, pixel);
    }
  }

  /** Begin to move an item; with all that are selected if it is one of them. */
  private startMove(item: Item, start: Point): void {
    const { canvas, store } = this;
    if (!store.isSelected(item.path)) store.select(item.path);
    const selected = canvas.selectedItems.filter((each) => each.movable);
    const held = item.movable ? item : selected.length > 0 && store.selected.length > 1 ? selected[0]! : null;
    if (!held || store.broken) {
      this.hooks.showHint(whyFixed(item));
      this.press = null;
      return;
    }
    const others = selected.filter((each) => each !== held);
    const carried = loadsOn(canvas.items, [held, ...others]);
    const gesture = new MoveGesture(held, canvas.camera.toPlan(start), [...others, ...carried], canvas.buildingAxes);
    this.press = { kind: "drag", gesture };
  }

  /** Select what lies in the rubber band up to a pixel. */
  private stretchBand({ start, before }: Extract<Press, { kind: "band" }>, pixel: Point): void {
    const { canvas, store } = this;
    const to = canvas.camera.toPlan(pixel);
    canvas.band = [start, to];
    store.selectAll([...before, ...itemsInBand(canvas.items, start, to).map((item) => item.path)]);
    canvas.redraw();
  }

  private hover(pixel: Point): void {
    const { canvas } = this;
    const handle = canvas.handleAt(pixel);
    const item = handle ? null : (canvas.itemsAt(pixel)[0] ?? null);
    const isAxis = !handle && canvas.axisAt(pixel) !== null;
    const overItem = isAxis || (item && item.kind !== "slab") ? "item" : "";
    canvas.element.dataset.cursor = handle ? (handle.along ?? handle.kind) : overItem;
    if (samePath(canvas.hovered, item?.path ?? null)) return;
    canvas.hovered = item?.path ?? null;
    canvas.redraw();
  }

  private leave(): void {
    this.place = null;
    if (this.press) return;
    this.canvas.hovered = null;
    this.canvas.guides = null;
    if (!this.drawing) this.canvas.preview = null;
    this.canvas.redraw();
  }

  private up(event: PointerEvent): void {
    const { canvas, press } = this;
    const pixel = pixelOf(canvas.element, event);
    this.touches.delete(event.pointerId);
    this.press = null;
    if (this.drawing?.up(this.snapDrawing(this.drawing, pixel, event).at, canvas.reach)) this.complete();
    if (press?.kind === "axis") this.dropAxis(press.gesture);
    else if (press?.kind === "drag") this.drop(press.gesture);
    else if (press?.kind === "band") {
      canvas.band = null;
      canvas.redraw();
    } else if (press?.kind === "item" && press.adds) this.store.toggle(press.item.path);
    else if (press?.kind === "item") this.click(press.item, press.wasSelected, pixel);
    else if (press?.kind === "empty" && !press.adds) this.store.select(null);
  }

  /** Select the family of an axis, and make its move. */
  private dropAxis(gesture: AxisGesture): void {
    const change = gesture.change();
    this.canvas.trial = [];
    this.canvas.tip = null;
    if (change) this.hooks.push(change);
    this.store.select(gesture.axis.path);
    this.canvas.redraw();
  }

  /** A click selects; another one at the same place selects what lies below. */
  private click(item: Item, wasSelected: boolean, pixel: Point): void {
    this.canvas.corner = null;
    this.lastClick = pixel;
    if (!wasSelected) return this.store.select(item.path);
    const items = this.canvas.itemsAt(pixel);
    const next = items[(items.findIndex((each) => samePath(each.path, item.path)) + 1) % items.length];
    this.store.select(next?.path ?? item.path);
  }

  private complete(): void {
    const addition = this.drawing?.finish(this.store.data, this.canvas.loadCase, this.canvas.reach);
    this.cancel();
    if (addition) this.hooks.onDrawn(addition);
  }
}

// The pointer over the drawing: selecting, moving, reshaping, drawing, shifting and zooming what is seen.

import type { Change } from "../../client/api";
import type { Store } from "../../client/store";
import { moved, type Point } from "../../model/geometry";
import type { Item } from "../../model/items";
import { type Path, samePath } from "../../model/paths";
import type { Canvas } from "../canvas";
import type { Tool } from "../tools";
import { Drawing, Moving, Reshaping } from "./gestures";

const STILL = 4; // px: what moves less is a click

export interface PointerHooks {
  push(change: Change): void;
  select(path: Path | null): void;
  tool(): Tool;
  /** Something was drawn; `path` is the new thing's. */
  drawn(change: Change, path: Path): void;
  /** Whether edits are possible at present. */
  editable(): boolean;
  say(words: string): void;
}

/** What goes on while the pointer is down. */
type Press =
  | { kind: "pan"; last: Point }
  | { kind: "thing"; item: Item; start: Point; wasSelected: boolean }
  | { kind: "move"; moving: Moving }
  | { kind: "reshape"; reshaping: Reshaping }
  | { kind: "empty"; start: Point };

export class Pointer {
  drawing: Drawing | null = null;
  private press: Press | null = null;
  private space = false;
  private lastClick: Point | null = null; // one more click at the same place selects what lies below
  private readonly touches = new Map<number, Point>();

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
    element.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("dblclick", () => this.finish());
    element.addEventListener("keydown", (event) => {
      if (event.key === " ") this.space = true;
    });
    element.addEventListener("keyup", (event) => {
      if (event.key === " ") this.space = false;
    });
  }

  /** End a drawing of several clicks with what there is. */
  finish(): void {
    if (!this.drawing || this.drawing.points.length < 2) return;
    this.complete();
  }

  /** Forget what is being done; returns whether there was anything. */
  cancel(): boolean {
    const busy = this.press !== null || this.drawing !== null;
    this.press = null;
    this.drawing = null;
    this.canvas.ghost = null;
    this.canvas.guides = null;
    this.canvas.paint();
    return busy;
  }

  private pixel(event: MouseEvent): Point {
    const box = this.canvas.element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  private down(event: PointerEvent): void {
    const { canvas } = this;
    canvas.element.focus({ preventScroll: true });
    canvas.element.setPointerCapture(event.pointerId);
    const pixel = this.pixel(event);
    this.touches.set(event.pointerId, pixel);
    if (this.touches.size > 1 || event.button > 0 || this.space) {
      this.press = { kind: "pan", last: pixel };
      return;
    }
    const tool = this.hooks.tool();
    if (tool.draws !== "nothing") {
      if (!this.hooks.editable()) return;
      this.drawing ??= new Drawing(tool);
      const at = canvas.snapped(canvas.camera.toPlan(pixel), event.altKey, null, this.drawing.points).at;
      if (this.drawing.down(at, canvas.reach)) this.complete();
      return;
    }
    const handle = canvas.handleAt(pixel);
    const selected = canvas.selected;
    if (handle && selected && this.hooks.editable()) {
      canvas.corner = handle.kind === "corner" ? handle.index : null;
      this.press = { kind: "reshape", reshaping: new Reshaping(selected, handle) };
      canvas.paint();
      return;
    }
    const things = canvas.thingsAt(pixel);
    const again = this.lastClick !== null && !far(this.lastClick, pixel);
    const own = again ? things.find((item) => samePath(item.path, this.store.selection)) : undefined;
    const item = own ?? things[0];
    this.press = item
      ? { kind: "thing", item, start: pixel, wasSelected: own !== undefined }
      : { kind: "empty", start: pixel };
  }

  private move(event: PointerEvent): void {
    const { canvas, press } = this;
    const pixel = this.pixel(event);
    const before = this.touches.get(event.pointerId);
    if (before && this.touches.size > 1) return this.pinch(event.pointerId, before, pixel);
    if (press?.kind === "pan") {
      canvas.camera.pan(pixel[0] - press.last[0], pixel[1] - press.last[1]);
      press.last = pixel;
      canvas.moved();
    } else if ((press?.kind === "thing" || press?.kind === "empty") && far(press.start, pixel)) {
      this.startDrag(press, pixel);
    } else if (press?.kind === "move") {
      const at = canvas.snapped(press.moving.wanted(canvas.camera.toPlan(pixel)), event.altKey, press.moving.item.path);
      canvas.guides = at;
      canvas.ghost = press.moving.to(at);
      canvas.paint();
    } else if (press?.kind === "reshape") {
      const at = canvas.snapped(canvas.camera.toPlan(pixel), event.altKey, press.reshaping.item.path);
      canvas.guides = at;
      canvas.ghost = press.reshaping.to(at);
      canvas.paint();
    } else if (!press && this.hooks.tool().draws !== "nothing") this.hoverTool(pixel, event.altKey);
    else if (!press) this.hover(pixel);
  }

  private startDrag(
    press: { kind: "thing"; item: Item; start: Point } | { kind: "empty"; start: Point },
    pixel: Point,
  ): void {
    const selected = press.kind === "thing" && samePath(press.item.path, this.store.selection);
    const free = press.kind === "thing" && (press.item.kind !== "slab" || selected);
    if (press.kind === "empty" || !free) {
      this.press = { kind: "pan", last: press.start };
      this.canvas.camera.pan(pixel[0] - press.start[0], pixel[1] - press.start[1]);
      this.press.last = pixel;
      this.canvas.moved();
      return;
    }
    this.hooks.select(press.item.path);
    if (!press.item.movable || !this.hooks.editable()) {
      this.hooks.say(whyFixed(press.item));
      this.press = null;
      return;
    }
    this.press = { kind: "move", moving: new Moving(press.item, this.canvas.camera.toPlan(press.start)) };
  }

  private hoverTool(pixel: Point, free: boolean): void {
    const { canvas } = this;
    const drawing = this.drawing ?? new Drawing(this.hooks.tool());
    const at = canvas.snapped(canvas.camera.toPlan(pixel), free, null, drawing.points);
    canvas.guides = at;
    canvas.ghost = drawing.ghost(at);
    canvas.paint();
  }

  private hover(pixel: Point): void {
    const { canvas } = this;
    const handle = canvas.handleAt(pixel);
    const item = handle ? null : (canvas.thingsAt(pixel)[0] ?? null);
    canvas.element.dataset.cursor = handle
      ? (handle.along ?? handle.kind)
      : item && item.kind !== "slab"
        ? "thing"
        : "";
    if (samePath(canvas.hovered, item?.path ?? null)) return;
    canvas.hovered = item?.path ?? null;
    canvas.paint();
  }

  private leave(): void {
    if (this.press) return;
    this.canvas.hovered = null;
    this.canvas.guides = null;
    if (!this.drawing) this.canvas.ghost = null;
    this.canvas.paint();
  }

  private up(event: PointerEvent): void {
    const { canvas, press } = this;
    const pixel = this.pixel(event);
    this.touches.delete(event.pointerId);
    this.press = null;
    if (this.drawing) {
      const at = canvas.snapped(canvas.camera.toPlan(pixel), event.altKey, null, this.drawing.points).at;
      if (this.drawing.up(at, canvas.reach)) this.complete();
    }
    if (press?.kind === "move" || press?.kind === "reshape") {
      const change = press.kind === "move" ? press.moving.change() : press.reshaping.change();
      canvas.ghost = null;
      canvas.guides = null;
      if (change) this.hooks.push(change);
      canvas.paint();
    } else if (press?.kind === "thing") this.click(press.item, press.wasSelected, pixel);
    else if (press?.kind === "empty") this.hooks.select(null);
  }

  /** A click selects; one more at the same place selects what lies below. */
  private click(item: Item, wasSelected: boolean, pixel: Point): void {
    this.canvas.corner = null;
    this.lastClick = pixel;
    if (!wasSelected) return this.hooks.select(item.path);
    const things = this.canvas.thingsAt(pixel);
    const next = things[(things.findIndex((each) => samePath(each.path, item.path)) + 1) % things.length];
    this.hooks.select(next?.path ?? item.path);
  }

  private complete(): void {
    const made = this.drawing?.made(this.store.data, this.canvas.loadCase);
    this.cancel();
    if (made) this.hooks.drawn(made.change, made.path);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    this.canvas.camera.zoom(Math.exp(-event.deltaY * lines * 0.0015), this.pixel(event));
    this.canvas.moved();
  }

  private pinch(id: number, before: Point, now: Point): void {
    const other = [...this.touches].find(([each]) => each !== id)?.[1];
    this.touches.set(id, now);
    if (!other) return;
    const distance = (point: Point) => Math.hypot(point[0] - other[0], point[1] - other[1]) || 1;
    this.canvas.camera.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
    this.canvas.camera.zoom(distance(now) / distance(before), [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2]);
    this.press = { kind: "pan", last: now };
    this.canvas.moved();
  }
}

function far(a: Point, b: Point): boolean {
  return Math.hypot(a[0] - b[0], a[1] - b[1]) > STILL;
}

/** Why a thing cannot be moved. */
export function whyFixed(item: Item): string {
  if (item.kind === "slab")
    return "A rectangle by its sides lies about the origin: drag its edges, or change it into a polygon to move it.";
  return item.kind === "load"
    ? `It stands on column ${String(item.table.column)} and goes with it.`
    : "It cannot be moved at present.";
}

/** Moving the selected thing by keys: one edit for a row of steps. */
export class Nudge {
  private by: [number, number] = [0, 0];
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(
    private readonly canvas: Canvas,
    private readonly push: (change: Change) => void,
  ) {}

  /** Move by steps of the grid; the edit follows when the keys rest. */
  step(item: Item, dx: number, dy: number): void {
    this.by = [this.by[0] + dx, this.by[1] + dy];
    this.canvas.ghost = { geometry: moved(item.geometry, this.by), item, words: "" };
    this.canvas.paint();
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = setTimeout(() => this.flush(item), 350);
  }

  private flush(item: Item): void {
    const by = this.by.map((each) => Number(each.toFixed(6))) as [number, number];
    this.by = [0, 0];
    this.timer = null;
    this.canvas.ghost = null;
    if (by[0] !== 0 || by[1] !== 0)
      this.push({ edits: [{ op: "move", path: item.path, by }], text: `move ${item.title}` });
    this.canvas.paint();
  }
}

// Moving the selected items by keys: one edit for a series of steps.
import type { Change } from "../../model/edits";
import type { Point } from "../../model/geometry";
import type { Item } from "../../model/items";
import type { Canvas } from "../canvas";
import { moveChange, movePreview, roundOff } from "./gestures";

const QUIET = 350; // ms without a key until the edit is sent

export class Nudge {
  private by: Point = [0, 0];
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly canvas: Canvas,
    private readonly push: (change: Change) => void,
  ) {}

  /** Move by a step [m]; the edit follows when the keys rest. */
  step(items: readonly Item[], dx: number, dy: number): void {
    this.by = [this.by[0] + dx, this.by[1] + dy];
    this.canvas.preview = movePreview(items, this.by, "");
    this.canvas.redraw();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.finish(items), QUIET);
  }

  private finish(items: readonly Item[]): void {
    const by: Point = [roundOff(this.by[0]), roundOff(this.by[1])];
    this.by = [0, 0];
    this.canvas.preview = null;
    if (by[0] !== 0 || by[1] !== 0) this.push(moveChange(items, by, this.canvas.buildingAxes));
    this.canvas.redraw();
  }
}

// Moving the selected item by keys: one edit for a series of steps.
import type { Change } from "../../model/changes/edits";
import { moveGeometry, type Point } from "../../model/geometry";
import type { Item } from "../../model/items";
import type { Canvas } from "../canvas";
import { roundOff } from "./gestures";

const QUIET = 350; // ms without a key until the edit is sent

export class Nudge {
  private by: Point = [0, 0];
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly canvas: Canvas,
    private readonly push: (change: Change) => void,
  ) {}

  /** Move by a step [m]; the edit follows when the keys rest. */
  step(item: Item, dx: number, dy: number): void {
    this.by = [this.by[0] + dx, this.by[1] + dy];
    this.canvas.preview = { geometry: moveGeometry(item.geometry, this.by), item, text: "" };
    this.canvas.redraw();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.finish(item), QUIET);
  }

  private finish(item: Item): void {
    const by: Point = [roundOff(this.by[0]), roundOff(this.by[1])];
    this.by = [0, 0];
    this.canvas.preview = null;
    if (by[0] !== 0 || by[1] !== 0)
      this.push({ edits: [{ op: "move", path: item.path, by }], text: `move ${item.title}` });
    this.canvas.redraw();
  }
}

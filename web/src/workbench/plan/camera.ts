// What part of the plan is seen: metres to pixels and back.

import type { Point } from "../model/geometry";

const NEAREST = 20_000; // pixels per metre
const FARTHEST = 0.2;

export class Camera {
  /** The middle of what is seen [m], and pixels per metre. */
  x = 0;
  y = 0;
  scale = 50;
  width = 1;
  height = 1;

  /** Pixels, from the upper left corner, of a place. */
  toPixel([x, y]: Point): [number, number] {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  /** The place under a pixel [m]. */
  toPlan([u, v]: Point): [number, number] {
    return [this.x + (u - this.width / 2) / this.scale, this.y - (v - this.height / 2) / this.scale];
  }

  /** Move what is seen by pixels. */
  pan(du: number, dv: number): void {
    this.x -= du / this.scale;
    this.y += dv / this.scale;
  }

  /** Enlarge by a factor; what is under a pixel stays there. */
  zoom(factor: number, pixel: Point = [this.width / 2, this.height / 2]): void {
    const before = this.toPlan(pixel);
    this.scale = Math.min(NEAREST, Math.max(FARTHEST, this.scale * factor));
    const after = this.toPlan(pixel);
    this.x += before[0] - after[0];
    this.y += before[1] - after[1];
  }

  /** Show a rectangle [x0, y0, x1, y1] with some space around it. */
  fit([x0, y0, x1, y1]: readonly [number, number, number, number], margin = 46): void {
    this.x = (x0 + x1) / 2;
    this.y = (y0 + y1) / 2;
    const [width, height] = [Math.max(x1 - x0, 0.1), Math.max(y1 - y0, 0.1)];
    const scale = Math.min((this.width - 2 * margin) / width, (this.height - 2 * margin) / height);
    this.scale = Math.min(NEAREST, Math.max(FARTHEST, scale));
  }
}

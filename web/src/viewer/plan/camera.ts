// Which part of the plan is seen: meters to pixels and back.
import { OrthographicCamera } from "three";
import type { Box } from "../data/boxes";
import type { Point } from "../data/scene";

const NEAREST = 20_000; // pixels per meter
const FARTHEST = 0.2;

/** How a drawing has to be moved [px] and stretched to be where it belongs. */
export interface Shift {
  dx: number;
  dy: number;
  zoom: number;
}

/** Return a shift as a style. */
export function transformOf({ dx, dy, zoom }: Shift): string {
  return `translate(${dx}px, ${dy}px) scale(${zoom})`;
}

/** Whether a shifted drawing, which reaches beyond the view by a share of its size, still does for it. */
export function isNear({ dx, dy, zoom }: Shift, { width, height }: Camera, beyond: number): boolean {
  return zoom > 0.6 && zoom < 1.8 && Math.abs(dx) < beyond * width && Math.abs(dy) < beyond * height;
}

export class Camera {
  /** The middle of what is seen [m], and pixels per meter. */
  x = 0;
  y = 0;
  scale = 50;
  width = 1;
  height = 1;

  /** Return the pixel, from the upper left corner, of a place. */
  toPixel([x, y]: Readonly<Point>): Point {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  /** Return the place under a pixel [m]. */
  toPlan([u, v]: Readonly<Point>): Point {
    return [this.x + (u - this.width / 2) / this.scale, this.y - (v - this.height / 2) / this.scale];
  }

  /** The part of the plan that is seen [m]. */
  get box(): Box {
    const [[x0, y1], [x1, y0]] = [this.toPlan([0, 0]), this.toPlan([this.width, this.height])];
    return [x0, y0, x1, y1];
  }

  /** Move what is seen by pixels. */
  pan(du: number, dv: number): void {
    this.x -= du / this.scale;
    this.y += dv / this.scale;
  }

  /** Enlarge by a factor; what is under a pixel stays there. */
  zoom(factor: number, pixel: Readonly<Point> = [this.width / 2, this.height / 2]): void {
    const before = this.toPlan(pixel);
    this.scale = Math.min(NEAREST, Math.max(FARTHEST, this.scale * factor));
    const after = this.toPlan(pixel);
    this.x += before[0] - after[0];
    this.y += before[1] - after[1];
  }

  /** Show a box with some space around it, and more of it at the left, at the bottom and at the top [px]. */
  fit([x0, y0, x1, y1]: Readonly<Box>, margin = 46, left = 0, bottom = 0, top = 0): void {
    const [width, height] = [Math.max(x1 - x0, 0.1), Math.max(y1 - y0, 0.1)];
    const scale = Math.min(
      (this.width - left - 2 * margin) / width,
      (this.height - bottom - top - 2 * margin) / height,
    );
    this.scale = Math.min(NEAREST, Math.max(FARTHEST, scale));
    this.x = (x0 + x1) / 2 - left / 2 / this.scale;
    this.y = (y0 + y1) / 2 + (top - bottom) / 2 / this.scale;
  }

  /** Return a copy, which stays where it is. */
  copy(): Camera {
    return Object.assign(new Camera(), this);
  }

  /** Whether another camera shows the same. */
  isAt(other: Camera): boolean {
    return (["x", "y", "scale", "width", "height"] as const).every((name) => this[name] === other[name]);
  }

  /** Return how far what an earlier camera drew has moved since [px], and how much larger it is, about the middle. */
  since(drawn: Camera): Shift {
    const [dx, dy] = [(drawn.x - this.x) * this.scale, (this.y - drawn.y) * this.scale];
    return { dx, dy, zoom: this.scale / drawn.scale };
  }

  /** Return a camera that looks down on the same part of the plan. */
  lookDown(): OrthographicCamera {
    const [x0, y0, x1, y1] = this.box;
    const camera = new OrthographicCamera(x0, x1, y1, y0, -1, 1);
    camera.updateMatrixWorld();
    return camera;
  }
}

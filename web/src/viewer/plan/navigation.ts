// Moving a plan by pointers: dragging, pinching, the wheel.
import { distanceBetween, pointBetween } from "../data/points";
import type { Point } from "../data/scene";
import type { Camera } from "./camera";

/** A press that moves less than this [px] is a click. */
const CLICK = 4;
const STILL = 140; // ms without movement until everything is drawn again
const LONGEST = 600; // ms: movements farther apart are not one

/** Return where an event is on an element, from its upper left corner [px]. */
export function pixelOf(element: Element, event: MouseEvent): Point {
  const box = element.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

/** Zoom as a turn of the wheel says. */
export function zoomByWheel(camera: Camera, event: WheelEvent, pixel: Point): void {
  event.preventDefault();
  const lines = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 160 : 1;
  const turn = Math.min(Math.max(event.deltaY * lines, -300), 300);
  camera.zoom(Math.exp(-turn * (event.ctrlKey ? 0.01 : 0.0015)), pixel);
}

/** Whether two pixels are too far apart for a click. */
export function isFar(a: Readonly<Point>, b: Readonly<Point>): boolean {
  return distanceBetween(a, b) >= CLICK;
}

/** Tells whether the view moves: from its first movement until it has been still for a while. */
export class Motion {
  /** Whether the view moves. */
  on = false;
  private at = Number.NEGATIVE_INFINITY; // ms
  private timer = 0;

  constructor(private readonly onStill: () => void) {}

  /** The view has moved. */
  moved(): void {
    const now = performance.now();
    // where frames come slowly, movements do too
    const apart = now - this.at < LONGEST ? now - this.at : 0;
    this.on = true;
    this.at = now;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(
      () => {
        this.on = false;
        this.onStill();
      },
      Math.max(STILL, 2 * apart),
    );
  }
}

/** The pointers that are down, and where. */
export class Touches extends Map<number, Point> {
  /** Move one pointer; with a second one down, move and zoom the camera so that both places stay under them. */
  pinch(camera: Camera, id: number, now: Point): boolean {
    const before = this.get(id);
    const other = [...this].find(([each]) => each !== id)?.[1];
    if (!before) return false;
    this.set(id, now);
    if (!other) return false;
    const distance = (point: Point) => Math.max(distanceBetween(point, other), 1);
    camera.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
    camera.zoom(distance(now) / distance(before), pointBetween(now, other));
    return true;
  }
}

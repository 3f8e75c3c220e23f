// Places that a dialog takes from clicks on the drawing.
import { pixelOf } from "../../../viewer/plan/navigation";
import type { Point } from "../../model/geometry";
import type { Canvas } from "../canvas";

/** Pass the next places that are clicked to `take`, with their number, and call `end` after the last; returns what stops it. */
export function pickPlaces(canvas: Canvas, count: number, take: (at: Point, n: number) => void, end: () => void) {
  const { element } = canvas;
  const tool = element.dataset.tool ?? "";
  const listening = new AbortController();
  let taken = 0;
  const placeOf = (event: PointerEvent) => canvas.snap(canvas.camera.toPlan(pixelOf(element, event)), event.altKey, []);
  const stop = () => {
    if (listening.signal.aborted) return;
    listening.abort();
    element.dataset.tool = tool;
    canvas.guides = null;
    canvas.redraw();
  };
  const listen = (type: "pointerdown" | "pointermove" | "pointerup", handle: (event: PointerEvent) => void) =>
    element.addEventListener(
      type,
      (event) => {
        // other buttons move the view
        if (type === "pointermove" ? event.buttons !== 0 : event.button !== 0) return;
        event.stopImmediatePropagation();
        handle(event);
      },
      { capture: true, signal: listening.signal },
    );
  listen("pointerdown", () => {});
  listen("pointermove", (event) => {
    canvas.guides = placeOf(event);
    canvas.redraw();
  });
  listen("pointerup", (event) => {
    take(placeOf(event).at, taken);
    taken += 1;
    if (taken < count) return;
    stop();
    end();
  });
  element.dataset.tool = "point";
  return stop;
}

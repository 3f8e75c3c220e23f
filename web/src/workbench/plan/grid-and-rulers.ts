// What lies below the drawing: grid, axes and their figures.

import { plain } from "../model/quantities";
import { svg } from "../shell/elements";
import type { Camera } from "./camera";
import { roundStep } from "./interaction/snapping";
import { label } from "./rendering";

const FINE = 11; // px: least distance of grid lines
const MEANT = 4.5; // px: least distance of round lengths to snap to
const COARSE = 70; // px: least distance of figures
export const MARGIN = { left: 40, bottom: 20 } as const;

/** The spacing of round lengths that a pointer can mean at a scale [m]; finer than the grid. */
export function snapStep(camera: Camera): number {
  return roundStep(MEANT / camera.scale);
}

/** Grid lines, stronger ones where figures stand, and the axes through the origin. */
export function paintGrid(camera: Camera): SVGElement[] {
  const [x0, y1] = camera.toPlan([0, 0]);
  const [x1, y0] = camera.toPlan([camera.width, camera.height]);
  const lines = (step: number, name: string) => {
    let words = "";
    for (const x of between(x0, x1, step))
      words += `M${Math.round(camera.toPixel([x, 0])[0]) + 0.5} 0V${camera.height}`;
    for (const y of between(y0, y1, step)) words += `M0 ${Math.round(camera.toPixel([0, y])[1]) + 0.5}H${camera.width}`;
    return svg("path", { class: name, d: words });
  };
  const [u, v] = camera.toPixel([0, 0]);
  const axes = svg("path", {
    class: "axes",
    d: `M${Math.round(u) + 0.5} 0V${camera.height}M0 ${Math.round(v) + 0.5}H${camera.width}`,
  });
  return [lines(roundStep(FINE / camera.scale), "grid fine"), lines(roundStep(COARSE / camera.scale), "grid"), axes];
}

/** Figures along the left and the lower edge. */
export function paintFigures(camera: Camera): SVGElement[] {
  const step = roundStep(COARSE / camera.scale);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const [x0, y1] = camera.toPlan([MARGIN.left, 0]);
  const [x1, y0] = camera.toPlan([camera.width, camera.height - MARGIN.bottom]);
  const marks: SVGElement[] = [
    svg("rect", { class: "ruler", x: 0, y: camera.height - MARGIN.bottom, width: camera.width, height: MARGIN.bottom }),
    svg("rect", { class: "ruler", x: 0, y: 0, width: MARGIN.left, height: camera.height }),
  ];
  for (const x of between(x0, x1, step)) {
    if (camera.toPixel([x, 0])[0] > camera.width - 54) break;
    marks.push(
      label(
        [camera.toPixel([x, 0])[0], camera.height - 6],
        plain(x, digits).replace("-", "−"),
        [0, 0],
        "figure middle",
      ),
    );
  }
  for (const y of between(y0, y1, step)) {
    if (camera.toPixel([0, y])[1] < 28) break;
    marks.push(
      label([MARGIN.left - 6, camera.toPixel([0, y])[1] + 4], plain(y, digits).replace("-", "−"), [0, 0], "figure end"),
    );
  }
  marks.push(
    label([camera.width - 8, camera.height - 6], "x [m]", [0, 0], "figure end"),
    label([MARGIN.left - 6, 13], "y [m]", [0, 0], "figure end"),
  );
  return marks;
}

function* between(from: number, to: number, step: number): Generator<number> {
  for (let n = Math.ceil(from / step); n <= Math.floor(to / step) && n < 1e9; n += 1) yield n * step;
}

// Grid, rulers with figures along the left and the lower edge, and the scale bar of a plan.
import { METERS } from "../data/lengths";
import { formatShort, formatTicks, multiplesWithin, roundStep, roundStepOf } from "../data/numbers";
import { offset } from "../data/points";
import { svg } from "../shared/dom";
import type { Camera } from "./camera";
import { drawPath, drawText } from "./symbols";

const FINE = 11; // px: least distance of grid lines
const COARSE = 70; // px: least distance of figures
/** Space that the rulers take [px]. */
export const RULER = { left: 46, bottom: 24 } as const;

/** Return the round step, 1, 2 or 5 times a power of ten [m], that is at least so many pixels. */
export function stepOf(camera: Camera, pixels: number): number {
  return roundStepOf([1, 2, 5], pixels / camera.scale);
}

/** Draw grid lines, stronger ones at the figures, and the lines through the origin. */
export function drawGrid(camera: Camera): SVGElement[] {
  const { width, height } = camera;
  const [x0, y0, x1, y1] = camera.box;
  const drawLines = (xs: readonly number[], ys: readonly number[], className: string) => {
    const vertical = xs.map((x) => `M${Math.round(camera.toPixel([x, 0])[0]) + 0.5} 0V${height}`);
    const horizontal = ys.map((y) => `M0 ${Math.round(camera.toPixel([0, y])[1]) + 0.5}H${width}`);
    return svg("path", { class: className, d: [...vertical, ...horizontal].join("") });
  };
  const drawStep = (step: number, className: string) =>
    drawLines(multiplesWithin(x0, x1, step), multiplesWithin(y0, y1, step), className);
  return [
    drawStep(stepOf(camera, FINE), "grid fine"),
    drawStep(stepOf(camera, COARSE), "grid"),
    drawLines([0], [0], "origin"),
  ];
}

/** Draw the rulers. */
export function drawRulers(camera: Camera, lengths = METERS): SVGElement[] {
  const { width, height, scale } = camera;
  const [left, bottom] = [RULER.left, height - RULER.bottom];
  const [x0, y0, x1, y1] = camera.box;
  const { unit, per_meter: per } = lengths;
  const step = roundStepOf([1, 2, 5], (COARSE / scale) * per);
  const xs = multiplesWithin((x0 + left / scale) * per, x1 * per, step);
  const ys = multiplesWithin((y0 + RULER.bottom / scale) * per, y1 * per, step);
  const drawFigure = (x: number, y: number, text: string, align: string) =>
    svg("text", { x, y, class: `figure ${align}` }, text);
  return [
    svg("path", { class: "ruler", d: `M0 0H${left}V${bottom}H${width}V${height}H0Z` }),
    svg("path", { class: "ruler-edge", d: `M${left + 0.5} 0V${bottom + 0.5}H${width}` }),
    ...formatTicks(xs).flatMap((text, i) => {
      const u = camera.toPixel([xs[i]! / per, 0])[0];
      return u < left + 14 || u > width - 54 ? [] : [drawFigure(u, height - 7, text, "middle")];
    }),
    ...formatTicks(ys).flatMap((text, i) => {
      const v = camera.toPixel([0, ys[i]! / per])[1];
      return v < 28 || v > bottom - 6 ? [] : [drawFigure(left - 7, v + 4, text, "end")];
    }),
    drawFigure(width - 8, height - 7, `x [${unit}]`, "end"),
    drawFigure(left - 7, 13, `y [${unit}]`, "end"),
  ];
}

/** Draw the scale bar in the lower right corner. */
export function drawScaleBar({ width, height, scale }: Camera, { unit, per_meter: per } = METERS): SVGElement[] {
  const length = roundStep((50 / scale) * per);
  const [left, right, y] = [width - 12 - (length / per) * scale, width - 12, height - RULER.bottom - 10];
  const ends = [...offset([left, y], [0, -4], [0, 2]), ...offset([right, y], [0, 2], [0, -4])];
  const bar = drawPath(ends, false, "scale-bar");
  return [bar, drawText([right, y - 5], `${formatShort(length)} ${unit}`, [0, 0], "end")];
}

// A drawing below the plan: its lines in gray, whose ends and intersections others snap to. It is no part of the case.

import { type Box, extend } from "../../../viewer/data/boxes";
import { distanceBetween } from "../../../viewer/data/points";
import type { Camera } from "../../../viewer/plan/camera";
import { svg } from "../../../viewer/shared/dom";
import type { Point } from "../../model/geometry";
import { enlargement, type Underlay } from "../../model/survey";
import { intersection, type SnapPlace } from "../interaction/snap-places";

const MOST_CROSSED = 60; // lines near the pointer of which intersections are looked for

/** The lines of an underlay in the plan, prepared for drawing and snapping. */
export class UnderlayLines {
  /** Ends of each straight piece, x0, y0, x1, y1 [m]. */
  private readonly pieces: Float64Array;
  /** Ends of each curve; what lies between them are chords, which do not lie on it. */
  private readonly curves: Float64Array;
  private readonly element: SVGPathElement;
  /** Where the path's own zero lies [m]: coordinates of pictures have few digits. */
  private readonly zero: Point;

  constructor({ survey, unit, offset }: Underlay) {
    const factor = enlargement(survey, unit);
    const layers = survey.layers.filter((layer) => !layer.hidden);
    const [lines, curves] = [layers.flatMap((layer) => layer.lines), layers.flatMap((layer) => layer.curves)];
    const place = (line: readonly number[], n: number) => line[n]! * factor + offset[n % 2]!;
    const pieces = lines.flatMap((line) =>
      line.slice(3).flatMap((_, n) => (n % 2 ? [] : [0, 1, 2, 3].map((k) => place(line, n + k)))),
    );
    this.pieces = Float64Array.from(pieces);
    this.curves = Float64Array.from(
      curves.flatMap((curve) => [0, 1, -2, -1].map((k) => place(curve, k < 0 ? curve.length + k : k))),
    );
    const first = this.pieces.length > 0 ? this.pieces : this.curves;
    this.zero = first.length > 0 ? [first[0]!, first[1]!] : [0, 0];
    const all = [...lines, ...curves].map((line) => line.map((_, n) => place(line, n)));
    this.element = svg("path", { class: "underlay", d: all.map((line) => this.path(line)).join("") });
  }

  /** The box around the lines, null if there are none. */
  get bounds(): Box | null {
    const box: Box = [Infinity, Infinity, -Infinity, -Infinity];
    for (const ends of [this.pieces, this.curves])
      for (let n = 0; n < ends.length; n += 2) extend(box, ends[n]!, ends[n + 1]!, ends[n]!, ends[n + 1]!);
    return box[0] <= box[2] ? box : null;
  }

  /** Draw the lines; they are one path, of which only the place changes. */
  draw(camera: Camera): SVGElement {
    const [u, v] = camera.toPixel(this.zero);
    this.element.setAttribute("transform", `matrix(${camera.scale} 0 0 ${-camera.scale} ${u} ${v})`);
    return this.element;
  }

  /** Return the ends of lines and curves near a place, and where straight lines cross. */
  placesNear(at: Point, reach: number): SnapPlace[] {
    const near = piecesNear(this.pieces, at, reach);
    const isNear = (place: SnapPlace) => distanceBetween(place.at, at) <= reach;
    const ends = [...near, ...piecesNear(this.curves, at, reach)]
      .flat()
      .map((end): SnapPlace => ({ at: end, name: "end" }));
    const some = near.slice(0, MOST_CROSSED);
    const crossings = some.flatMap((one, n) =>
      some.slice(n + 1).flatMap((other): SnapPlace[] => {
        const crossing = intersection(one, other);
        return crossing ? [{ at: crossing, name: "intersection" }] : [];
      }),
    );
    return [...ends, ...crossings].filter(isNear);
  }

  private path(line: readonly number[]): string {
    return line.map((value, n) => `${n % 2 ? " " : n ? "L" : "M"}${(value - this.zero[n % 2]!).toFixed(5)}`).join("");
  }
}

/** Return the pieces whose boxes come near a place. */
function piecesNear(pieces: Float64Array, [x, y]: Point, reach: number): [Point, Point][] {
  const near: [Point, Point][] = [];
  for (let n = 0; n < pieces.length; n += 4) {
    const [x0, y0, x1, y1] = [pieces[n]!, pieces[n + 1]!, pieces[n + 2]!, pieces[n + 3]!];
    if (x < Math.min(x0, x1) - reach || x > Math.max(x0, x1) + reach) continue;
    if (y < Math.min(y0, y1) - reach || y > Math.max(y0, y1) + reach) continue;
    near.push([
      [x0, y0],
      [x1, y1],
    ]);
  }
  return near;
}

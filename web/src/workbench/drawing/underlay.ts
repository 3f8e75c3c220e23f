// A drawing below the plan: its lines in gray, whose ends and intersections others snap to. It is no part of the case.

import { type Box, extend } from "../../viewer/data/boxes";
import { distanceBetween } from "../../viewer/data/points";
import type { Camera } from "../../viewer/plan/camera";
import { svg } from "../../viewer/shared/dom";
import type { Point } from "../model/geometry";
import { intersection, type SnapPlace } from "../plan/interaction/snap-places";
import { boundsOfLayers, enlargement, type Survey } from "./survey";

const MOST_CROSSED = 60; // lines near the pointer of which intersections are looked for

/** A drawing below the plan: where its origin lies in the plan [m], and whether it is shown. */
export interface Underlay {
  name: string;
  survey: Survey;
  unit: string;
  offset: Point;
  shown: boolean;
}

/** Return the place by which the middle of a drawing comes to lie at the origin. */
export function centeringOffset(survey: Survey, unit: string): Point {
  const [x0, y0, x1, y1] = boundsOfLayers(survey.layers.filter((layer) => !layer.hidden)) ?? [0, 0, 0, 0];
  const factor = enlargement(survey, unit);
  return [(-(x0 + x1) / 2) * factor, (-(y0 + y1) / 2) * factor];
}

/** The lines of an underlay in the plan, prepared for drawing and snapping. */
export class UnderlayLines {
  /** Ends of each straight piece, x0, y0, x1, y1 [m]. */
  private readonly pieces: Float64Array;
  private readonly element: SVGPathElement;
  /** Where the path's own zero lies [m]: coordinates of pictures have few digits. */
  private readonly zero: Point;

  constructor({ survey, unit, offset }: Underlay) {
    const factor = enlargement(survey, unit);
    const lines = survey.layers.filter((layer) => !layer.hidden).flatMap((layer) => layer.lines);
    const count = lines.reduce((sum, line) => sum + Math.max(0, line.length / 2 - 1), 0);
    this.pieces = new Float64Array(4 * count);
    let at = 0;
    for (const line of lines)
      for (let n = 0; n + 3 < line.length; n += 2, at += 4)
        for (let k = 0; k < 4; k += 1) this.pieces[at + k] = line[n + k]! * factor + offset[k % 2]!;
    this.zero = count > 0 ? [this.pieces[0]!, this.pieces[1]!] : [0, 0];
    this.element = svg("path", { class: "underlay", d: this.path(lines, factor, offset) });
  }

  /** The box around the lines, null if there are none. */
  get bounds(): Box | null {
    const { pieces } = this;
    const box: Box = [Infinity, Infinity, -Infinity, -Infinity];
    for (let n = 0; n < pieces.length; n += 2) extend(box, pieces[n]!, pieces[n + 1]!, pieces[n]!, pieces[n + 1]!);
    return pieces.length > 0 ? box : null;
  }

  /** Draw the lines; they are one path, of which only the place changes. */
  draw(camera: Camera): SVGElement {
    const [u, v] = camera.toPixel(this.zero);
    this.element.setAttribute("transform", `matrix(${camera.scale} 0 0 ${-camera.scale} ${u} ${v})`);
    return this.element;
  }

  /** Return the ends of lines near a place, and where they cross. */
  placesNear(at: Point, reach: number): SnapPlace[] {
    const near = this.piecesNear(at, reach);
    const isNear = (place: SnapPlace) => distanceBetween(place.at, at) <= reach;
    const ends = near.flat().map((end): SnapPlace => ({ at: end, name: "end" }));
    const some = near.slice(0, MOST_CROSSED);
    const crossings = some.flatMap((one, n) =>
      some.slice(n + 1).flatMap((other): SnapPlace[] => {
        const found = intersection(one, other);
        return found ? [{ at: found, name: "intersection" }] : [];
      }),
    );
    return [...ends, ...crossings].filter(isNear);
  }

  /** Return the pieces whose boxes come near a place. */
  private piecesNear([x, y]: Point, reach: number): [Point, Point][] {
    const { pieces } = this;
    const found: [Point, Point][] = [];
    for (let n = 0; n < pieces.length; n += 4) {
      const [x0, y0, x1, y1] = [pieces[n]!, pieces[n + 1]!, pieces[n + 2]!, pieces[n + 3]!];
      if (x < Math.min(x0, x1) - reach || x > Math.max(x0, x1) + reach) continue;
      if (y < Math.min(y0, y1) - reach || y > Math.max(y0, y1) + reach) continue;
      found.push([
        [x0, y0],
        [x1, y1],
      ]);
    }
    return found;
  }

  private path(lines: readonly number[][], factor: number, offset: Point): string {
    const place = (line: readonly number[], n: number) => {
      const x = line[n]! * factor + offset[0] - this.zero[0];
      const y = line[n + 1]! * factor + offset[1] - this.zero[1];
      return `${x.toFixed(5)} ${y.toFixed(5)}`;
    };
    return lines
      .map((line) => line.flatMap((_, n) => (n % 2 ? [] : [`${n ? "L" : "M"}${place(line, n)}`])).join(""))
      .join("");
  }
}

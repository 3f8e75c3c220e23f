// What happens between pressing and letting go in the drawing: moving, reshaping, drawing.

import type { Change } from "../../client/api";
import { editsBetween, type Geometry, isClosed, moved, type Point, type Ring, ringOf } from "../../model/geometry";
import type { Item } from "../../model/items";
import type { Table } from "../../model/paths";
import { plain, written } from "../../model/quantities";
import { nearestCorner } from "../rendering";
import { type Made, madeAtPoint, madeOfLine, madeOfShape, type Shape, type Tool } from "../tools";
import { dragged, type Handle } from "./handles";
import type { Snapped } from "./snapping";

/** What the pointer makes of the drawing for the moment. */
export interface Ghost {
  geometry: Geometry;
  /** The thing that it stands for; null for a new one. */
  item: Item | null;
  words: string;
}

/** Moving a thing as a whole: the place by which it is held goes to round lengths and corners. */
export class Moving {
  private readonly held: Point;
  private by: Point = [0, 0];

  constructor(
    readonly item: Item,
    private readonly start: Point,
  ) {
    this.held = nearestCorner(ringOf(item.geometry), start);
  }

  /** Where the held place would be, to be snapped. */
  wanted(at: Point): Point {
    return [this.held[0] + at[0] - this.start[0], this.held[1] + at[1] - this.start[1]];
  }

  to({ at }: Snapped): Ghost {
    this.by = [tidy(at[0] - this.held[0]), tidy(at[1] - this.held[1])];
    const words = `${pair(at)}   Δ ${signed(this.by[0])}, ${signed(this.by[1])} m`;
    return { geometry: moved(this.item.geometry, this.by), item: this.item, words };
  }

  change(): Change | null {
    if (this.by[0] === 0 && this.by[1] === 0) return null;
    return { edits: [{ op: "move", path: this.item.path, by: this.by }], text: `move ${this.item.title}` };
  }
}

/** Dragging one handle of a thing. */
export class Reshaping {
  private after: Geometry;

  constructor(
    readonly item: Item,
    readonly handle: Handle,
  ) {
    this.after = item.geometry;
  }

  to({ at }: Snapped): Ghost {
    this.after = dragged(this.item.geometry, this.handle, at) ?? this.after;
    return { geometry: this.after, item: this.item, words: `${pair(at)}   ${measures(this.after)}` };
  }

  change(): Change | null {
    const edits = editsBetween(this.item.geometry, this.after);
    if (edits.length === 0) return null;
    const verb = this.handle.kind === "add" ? "add a corner to" : "reshape";
    return { edits, text: `${verb} ${this.item.title}` };
  }
}

/** Drawing a new thing: by dragging, or by clicking place after place. */
export class Drawing {
  readonly points: Point[] = [];
  private dragging = false;

  constructor(readonly tool: Tool) {}

  /** The pointer goes down; returns whether the drawing is complete with it. */
  down(at: Point, reach: number): boolean {
    const [first] = this.points;
    const last = this.points.at(-1);
    if (this.tool.draws === "point") {
      this.points.push(at);
      return true;
    }
    const closes = this.tool.draws === "shape" && first && this.points.length >= 3 && near(first, at, reach);
    const ends = this.tool.draws === "line" && last && this.points.length >= 2 && near(last, at, reach);
    if (closes || ends) return true;
    if (!last || !near(last, at, 1e-9)) this.points.push(at);
    this.dragging = this.points.length === 1;
    return this.tool.draws === "segment" && this.points.length === 2;
  }

  /** The pointer goes up; returns whether the drawing is complete with it. */
  up(at: Point, reach: number): boolean {
    const [first] = this.points;
    const far = this.dragging && first && !near(first, at, reach);
    this.dragging = false;
    if (!far) return false;
    this.points.push(at);
    return true;
  }

  /** Whether what is drawn is a dragged rectangle. */
  private get boxed(): boolean {
    return this.tool.draws === "shape" && this.points.length === 2;
  }

  /** What is drawn if the pointer stays where it is. */
  ghost({ at }: Snapped): Ghost {
    const points: Ring = [...this.points, at];
    const [first] = this.points;
    if (!first) return { geometry: { type: "point", at: [], x: at[0], y: at[1] }, item: null, words: pair(at) };
    const size = `${plain(Math.abs(at[0] - first[0]), 3)} × ${plain(Math.abs(at[1] - first[1]), 3)} m`;
    if (this.tool.draws === "shape" && this.dragging) {
      const box: Geometry = { type: "box", at: [], x: [first[0], at[0]], y: [first[1], at[1]] };
      return { geometry: box, item: null, words: `${pair(at)}   ${size}` };
    }
    const last = this.points.at(-1) ?? first;
    const length = Math.hypot(at[0] - last[0], at[1] - last[1]);
    const angle = (Math.atan2(at[1] - last[1], at[0] - last[0]) * 180) / Math.PI;
    return {
      geometry: { type: "line", at: [], points },
      item: null,
      words: `${pair(at)}   ${plain(length, 3)} m at ${plain(angle, 1)}°`,
    };
  }

  /** What has been drawn, null if it is not enough. */
  made(data: Table, loadCase: string): Made | null {
    const { tool, points } = this;
    const [first, second] = points;
    if (!first) return null;
    if (tool.draws === "point") return madeAtPoint(tool.name, data, first, loadCase);
    if (!second) return null;
    if (tool.draws === "line" || tool.draws === "segment") return madeOfLine(tool.name, data, points, loadCase);
    if (this.boxed && (first[0] === second[0] || first[1] === second[1])) return null;
    if (!this.boxed && points.length < 3) return null;
    const shape: Shape = this.boxed ? { kind: "rectangle", from: first, to: second } : { kind: "polygon", points };
    return madeOfShape(tool.name, data, shape, loadCase);
  }
}

/** The measures of a geometry in words. */
export function measures(geometry: Geometry): string {
  switch (geometry.type) {
    case "sides":
      return `${plain(geometry.x, 3)} × ${plain(geometry.y, 3)} m`;
    case "box":
      return `${plain(geometry.x[1] - geometry.x[0], 3)} × ${plain(geometry.y[1] - geometry.y[0], 3)} m`;
    case "circle":
      return `r = ${plain(geometry.radius, 3)} m`;
    case "point":
      return pair([geometry.x, geometry.y]);
    default: {
      const ring: Ring = ringOf(geometry);
      const all = isClosed(geometry) ? [...ring, ...ring.slice(0, 1)] : ring;
      const length = all
        .slice(1)
        .reduce((sum, point, n) => sum + Math.hypot(point[0] - (all[n]?.[0] ?? 0), point[1] - (all[n]?.[1] ?? 0)), 0);
      return isClosed(geometry) ? `${ring.length} corners` : `${plain(length, 3)} m long`;
    }
  }
}

function near(a: Point, b: Point, reach: number): boolean {
  return Math.hypot(a[0] - b[0], a[1] - b[1]) <= reach;
}

/** A place in words: x and y to a millimetre. */
export function pair([x, y]: Point): string {
  return `x ${written(x)}, y ${written(y)}`.replaceAll("-", "−");
}

function signed(value: number): string {
  return `${value < 0 ? "−" : "+"}${plain(Math.abs(value), 3)}`;
}

function tidy(value: number): number {
  return Number(value.toFixed(6)) + 0;
}

// What pointers do between press and release: moving, reshaping and drawing.

import { withMinus } from "../../../viewer/data/numbers";
import { distanceBetween } from "../../../viewer/data/points";
import { say, together } from "../../../viewer/shared/language";
import type { Axis } from "../../model/axes";
import { attach, detach, detachingEdits } from "../../model/changes/attachment";
import {
  addEdgeWall,
  addJoint,
  addLine,
  addPoint,
  addShape,
  type DrawnShape,
  RINGS,
} from "../../model/changes/new-items";
import { editsToTable, Impossible, transformTable } from "../../model/changes/transform";
import type { Addition, Change, Edit } from "../../model/edits";
import {
  editsBetween,
  type Geometry,
  isClosed,
  moveGeometry,
  nearestCorner,
  type Point,
  type Ring,
  ringOf,
} from "../../model/geometry";
import { translation } from "../../model/isometry";
import { countItems, type Item } from "../../model/items";
import type { Table } from "../../model/paths";
import { formatDecimals, formatLength } from "../../model/quantities";
import type { Tool } from "../tools";
import { canBend, dragHandle, type Handle } from "./handles";
import type { Snapped } from "./snapping";

/** What the drawing becomes if the pointer is released now. */
export interface Preview {
  geometry: Geometry;
  /** The item that it stands for; null for a new one. */
  item: Item | null;
  text: string;
  /** Items that change with it. */
  others?: readonly ShownItem[];
}

/** An item as it is shown for now. */
export interface ShownItem {
  item: Item;
  geometry: Geometry;
}

/** Return the items that a preview shows differently. */
export function shownBy(preview: Preview | null): ShownItem[] {
  if (!preview?.item) return [];
  return [{ item: preview.item, geometry: preview.geometry }, ...(preview.others ?? [])];
}

/** Return the preview of items moved by a step [m]; the first is the one that is held. */
export function movePreview([first, ...others]: readonly Item[], by: Point, text: string): Preview | null {
  if (!first) return null;
  const move = (item: Item): ShownItem => ({ item, geometry: moveGeometry(item.geometry, by) });
  return { ...move(first), text, others: others.map(move) };
}

/** Return the change that moves items by a step [m]; loads on columns go with these. */
export function moveChange(items: readonly Item[], by: Point, axes: readonly Axis[] = []): Change {
  const moved = items.filter((item) => item.movable);
  const isPlain = moved.length === 1 && axes.length === 0;
  const edits = moved.flatMap((item) => (isPlain ? moveItem(item, by) : translateItem(item, by, axes)));
  return { edits, text: say("move {items}", { items: countItems(moved) }) };
}

function moveItem(item: Item, by: Point): Edit[] {
  return [{ op: "move", path: item.path, by }];
}

/** Return the edits that write an item at its new place, which can be joined with those of others. */
function translateItem(item: Item, by: Point, axes: readonly Axis[]): Edit[] {
  if (item.kind === "slab") return moveItem(item, by);
  try {
    const moved = transformTable(detach(item.table, axes), translation(by));
    return editsToTable(item.path, item.table, attach(moved, item.path[0], axes));
  } catch (error) {
    if (error instanceof Impossible) return moveItem(item, by); // the server says what is wrong with it
    throw error;
  }
}

/** Dragging items. */
export interface DragGesture {
  readonly items: readonly Item[];
  /** Return the place to be snapped for a place of the pointer. */
  aim(at: Point): Point;
  /** Move to a snapped place. */
  moveTo(snapped: Snapped): Preview;
  /** Return the change that was made, null for none. */
  change(): Change | null;
}

/** Moving items: the corner by which the first is held goes to round lengths and other corners. */
export class MoveGesture implements DragGesture {
  /** Where the corner by which it is held was. */
  readonly held: Point;
  private by: Point = [0, 0];

  readonly items: readonly Item[];

  constructor(
    item: Item,
    private readonly start: Point,
    others: readonly Item[] = [],
    /** Those of the building, from which what is moved is detached, or to which it is attached. */
    private readonly axes: readonly Axis[] = [],
  ) {
    this.items = [item, ...others];
    this.held = nearestCorner(ringOf(item.geometry), start);
  }

  aim(at: Point): Point {
    return [this.held[0] + at[0] - this.start[0], this.held[1] + at[1] - this.start[1]];
  }

  moveTo({ at }: Snapped): Preview {
    this.by = [roundOff(at[0] - this.held[0]), roundOff(at[1] - this.held[1])];
    const text = `${formatPoint(at)}   Δ ${formatSigned(this.by[0])}, ${formatSigned(this.by[1])} m`;
    return movePreview(this.items, this.by, text)!;
  }

  change(): Change | null {
    if (this.by[0] === 0 && this.by[1] === 0) return null;
    return moveChange(this.items, this.by, this.axes);
  }
}

/** Dragging one handle of an item. */
export class ReshapeGesture implements DragGesture {
  /** Whether a straight edge is bent instead of getting a corner. */
  bends = false;
  readonly items: readonly Item[];
  private after: Geometry;

  constructor(
    private readonly item: Item,
    readonly handle: Handle,
  ) {
    this.items = [item];
    this.after = item.geometry;
  }

  aim(at: Point): Point {
    return at;
  }

  moveTo({ at }: Snapped): Preview {
    const bends = this.bends && this.handle.kind === "add" && canBend(this.item.geometry);
    const handle: Handle = bends ? { ...this.handle, kind: "bend" } : this.handle;
    this.after = dragHandle(this.item.geometry, handle, at) ?? this.after;
    return { geometry: this.after, item: this.item, text: together([formatPoint(at), measureText(this.after)], "   ") };
  }

  change(): Change | null {
    const written = editsBetween(this.item.geometry, this.after);
    if (written.length === 0) return null;
    // a corner that is dragged leaves the axes, and the line with it
    const edits = [...detachingEdits(this.item), ...written];
    const corners = (geometry: Geometry) => ("points" in geometry ? geometry.points.length : 0);
    const isMore = corners(this.after) > corners(this.item.geometry);
    return { edits, text: say(isMore ? "add a corner to {item}" : "reshape {item}", { item: this.item.title }) };
  }
}

/** Drawing a new item: by dragging, or by clicking place after place. */
export class DrawGesture {
  readonly points: Point[] = [];
  /** Whether a shape that is dragged is a circle about its first place. */
  round = false;
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
    const closes = this.tool.draws === "shape" && first && this.points.length >= 3 && isNear(first, at, reach);
    const ends = this.tool.draws === "line" && last && this.points.length >= 2 && isNear(last, at, reach);
    if (closes || ends) return true;
    if (!last || !isNear(last, at, 1e-9)) this.points.push(at);
    this.dragging = this.points.length === 1;
    return this.tool.draws === "segment" && this.points.length === 2;
  }

  /** The pointer goes up; returns whether the drawing is complete with it. */
  up(at: Point, reach: number): boolean {
    const [first] = this.points;
    const far = this.dragging && first && !isNear(first, at, reach);
    this.dragging = false;
    if (!far) return false;
    this.points.push(at);
    return true;
  }

  /** Whether a circle is drawn: of shapes and lines that can be rings. */
  private get isRound(): boolean {
    return this.round && (this.tool.draws === "shape" || RINGS.has(this.tool.name));
  }

  /** Return what is drawn if the pointer is released at a place. */
  preview({ at }: Snapped): Preview {
    const [first] = this.points;
    if (!first) return { geometry: { type: "point", at: [], x: at[0], y: at[1] }, item: null, text: formatPoint(at) };
    if (this.isRound && this.dragging) {
      const radius = roundOff(distanceBetween(first, at));
      const geometry: Geometry = { type: "circle", at: [], center: first, radius };
      return { geometry, item: null, text: together([formatPoint(first), measureText(geometry)], "   ") };
    }
    if (this.tool.draws === "shape" && this.dragging) {
      const geometry: Geometry = { type: "box", at: [], x: [first[0], at[0]], y: [first[1], at[1]] };
      const text = sizeText(Math.abs(at[0] - first[0]), Math.abs(at[1] - first[1]));
      return { geometry, item: null, text: together([formatPoint(at), text], "   ") };
    }
    const last = this.points.at(-1) ?? first;
    const length = formatDecimals(distanceBetween(at, last), 3);
    const angle = formatDecimals((Math.atan2(at[1] - last[1], at[0] - last[0]) * 180) / Math.PI, 1);
    const geometry: Geometry = { type: "line", at: [], points: [...this.points, at], bulges: [] };
    return {
      geometry,
      item: null,
      text: say("{point}   {length} m at {angle}°", { point: formatPoint(at), length, angle }),
    };
  }

  /** Return the change that adds what has been drawn, null if it is not enough. */
  finish(data: Table, loadCase: string, reach = 0): Addition | null {
    const { tool, points } = this;
    const [first, second] = points;
    if (!first || tool.name === "select") return null;
    if (tool.name === "joint") return addJoint(data, first, reach);
    if (tool.name === "edge wall") return addEdgeWall(data, first, reach);
    if (tool.draws === "point") return addPoint(tool.name, data, first, loadCase);
    if (!second) return null;
    if (this.isRound && points.length === 2) {
      const radius = roundOff(distanceBetween(first, second));
      return radius > 0 ? addShape(tool.name, data, { kind: "circle", center: first, radius }, loadCase) : null;
    }
    if (tool.draws !== "shape") return addLine(tool.name, data, points, loadCase);
    const isBox = points.length === 2;
    if (isBox && (first[0] === second[0] || first[1] === second[1])) return null;
    const shape: DrawnShape = isBox ? { kind: "rectangle", from: first, to: second } : { kind: "polygon", points };
    return addShape(tool.name, data, shape, loadCase);
  }
}

function sizeText(x: number, y: number): string {
  return `${formatDecimals(x, 3)} × ${formatDecimals(y, 3)} m`;
}

/** Return the measures of a geometry as text. */
function measureText(geometry: Geometry): string {
  switch (geometry.type) {
    case "sides":
      return sizeText(geometry.x, geometry.y);
    case "box":
      return sizeText(geometry.x[1] - geometry.x[0], geometry.y[1] - geometry.y[0]);
    case "circle":
      return `r = ${formatDecimals(geometry.radius, 3)} m`;
    case "point":
      return formatPoint([geometry.x, geometry.y]);
    default: {
      const ring: Ring = ringOf(geometry);
      if (isClosed(geometry)) return say("{count} corners", { count: ring.length });
      const length = ring.slice(1).reduce((sum, point, n) => sum + distanceBetween(point, ring[n]!), 0);
      return say("{length} m long", { length: formatDecimals(length, 3) });
    }
  }
}

function isNear(a: Point, b: Point, reach: number): boolean {
  return distanceBetween(a, b) <= reach;
}

/** Return x and y to a millimeter as text. */
function formatPoint([x, y]: Point): string {
  return withMinus(`x ${formatLength(x)}, y ${formatLength(y)}`);
}

function formatSigned(value: number): string {
  return `${value < 0 ? "−" : "+"}${formatDecimals(Math.abs(value), 3)}`;
}

/** Remove the noise of a length [m]. */
export function roundOff(value: number): number {
  return Number(value.toFixed(6)) + 0;
}

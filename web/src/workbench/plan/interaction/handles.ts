// Handles of a geometry: the places that can be dragged, and what dragging them makes.

import { distanceBetween, pointBetween } from "../../../viewer/data/points";
import {
  arcMiddle,
  bulgeThrough,
  type Geometry,
  type Point,
  quarterPoints,
  type Range,
  type Ring,
  rectangleCorners,
} from "../../model/geometry";

export interface Handle {
  kind: "corner" | "edge" | "add" | "bend" | "radius" | "end";
  /** Which of its kind. */
  index: number;
  at: Point;
  /** Along which axis it moves; both by default. */
  along?: "x" | "y";
}

/** All handles of a geometry. */
export function handlesOf(geometry: Geometry): Handle[] {
  switch (geometry.type) {
    case "sides":
      return boxHandles([-geometry.x / 2, geometry.x / 2], [-geometry.y / 2, geometry.y / 2]);
    case "box":
      return boxHandles(geometry.x, geometry.y);
    case "line":
    case "polygon":
      return [
        ...geometry.points.map((at, index): Handle => ({ kind: "corner", index, at })),
        ...edgeHandles(geometry.points, geometry.type === "polygon", geometry.bulges),
      ];
    case "circle":
      return quarterPoints(geometry).map((at, index) => ({ kind: "radius", index, at }));
    case "segment":
      return [geometry.start, geometry.end].map((at, index) => ({ kind: "end", index, at }));
    default:
      return [];
  }
}

const FLATTEST = 0.005; // an edge that is bent less is straight
const ROUNDEST = 20;

/** Whether the edges of a geometry can be arcs. */
export function canBend({ type, at }: Geometry): boolean {
  return type === "polygon" || (type === "line" && at[0] === "loads");
}

/** Handles that add a corner to a straight edge, or bend an arc further. */
function edgeHandles(points: Ring, closed: boolean, bulges: readonly number[]): Handle[] {
  const last = closed ? points.length : points.length - 1;
  return points.slice(0, last).flatMap((a, index): Handle[] => {
    const b = points[(index + 1) % points.length];
    if (!b) return [];
    const bulge = bulges[index] ?? 0;
    return [
      bulge === 0
        ? { kind: "add", index, at: pointBetween(a, b) }
        : { kind: "bend", index, at: arcMiddle(a, b, bulge) },
    ];
  });
}

function boxHandles(x: Range, y: Range): Handle[] {
  const [middleX, middleY] = [(x[0] + x[1]) / 2, (y[0] + y[1]) / 2];
  const edges: Handle[] = [
    { kind: "edge", index: 0, at: [x[0], middleY], along: "x" },
    { kind: "edge", index: 1, at: [x[1], middleY], along: "x" },
    { kind: "edge", index: 2, at: [middleX, y[0]], along: "y" },
    { kind: "edge", index: 3, at: [middleX, y[1]], along: "y" },
  ];
  return [...rectangleCorners(x, y).map((at, index): Handle => ({ kind: "corner", index, at })), ...edges];
}

/** The geometry after a handle was dragged to a place; null if that is no geometry, such as an empty rectangle. */
export function dragHandle(geometry: Geometry, handle: Handle, to: Point): Geometry | null {
  switch (geometry.type) {
    case "sides": {
      const box = dragBox([-geometry.x / 2, geometry.x / 2], [-geometry.y / 2, geometry.y / 2], handle, to);
      // the plate stays about the origin: the opposite edge goes the other way
      const x = 2 * Math.abs(handle.at[0] < 0 ? box.x[0] : box.x[1]);
      const y = 2 * Math.abs(handle.at[1] < 0 ? box.y[0] : box.y[1]);
      return x > 0 && y > 0
        ? { ...geometry, x: handle.along === "y" ? geometry.x : x, y: handle.along === "x" ? geometry.y : y }
        : null;
    }
    case "box": {
      const { x, y } = dragBox(geometry.x, geometry.y, handle, to);
      if (x[0] === x[1] || y[0] === y[1]) return null;
      return { ...geometry, x: sortPair(x), y: sortPair(y) };
    }
    case "circle": {
      const radius = distanceBetween(to, geometry.center);
      return radius > 0 ? { ...geometry, radius } : null;
    }
    case "segment":
      return handle.index === 0 ? { ...geometry, start: to } : { ...geometry, end: to };
    case "line":
    case "polygon": {
      if (handle.kind === "bend") return bendEdge(geometry, handle.index, to);
      if (handle.kind !== "add") return { ...geometry, points: geometry.points.with(handle.index, to) };
      // the edges beside a new corner are straight
      const next = handle.index + 1;
      const bulges = geometry.bulges.length < next ? geometry.bulges : geometry.bulges.toSpliced(next, 0, 0);
      return { ...geometry, points: geometry.points.toSpliced(next, 0, to), bulges };
    }
    default:
      return geometry;
  }
}

/** Return a geometry with the edge after a corner bent through a place; null where that is hardly an arc any more. */
function bendEdge<G extends { points: Ring; bulges: readonly number[] }>(geometry: G, index: number, to: Point) {
  const { points } = geometry;
  const bulge = bulgeThrough(points[index]!, points[(index + 1) % points.length]!, to);
  if (Math.abs(bulge) > ROUNDEST) return null;
  const bulges = Array.from({ length: Math.max(geometry.bulges.length, index + 1) }, (_, n) => geometry.bulges[n] ?? 0);
  return { ...geometry, bulges: bulges.with(index, Math.abs(bulge) < FLATTEST ? 0 : bulge) };
}

function dragBox(x: Range, y: Range, handle: Handle, to: Point): { x: Range; y: Range } {
  const left = handle.kind === "edge" ? handle.index === 0 : handle.index === 0 || handle.index === 3;
  const below = handle.kind === "edge" ? handle.index === 2 : handle.index < 2;
  const movesX = handle.along !== "y";
  const movesY = handle.along !== "x";
  return {
    x: [movesX && left ? to[0] : x[0], movesX && !left ? to[0] : x[1]],
    y: [movesY && below ? to[1] : y[0], movesY && !below ? to[1] : y[1]],
  };
}

function sortPair([a, b]: Range): Range {
  return a < b ? [a, b] : [b, a];
}

/** Return the geometry without one of its corners; null where too few would be left. */
export function removeCorner(geometry: Geometry, index: number): Geometry | null {
  if (geometry.type !== "line" && geometry.type !== "polygon") return null;
  const { points, bulges } = geometry;
  const isLine = geometry.type === "line";
  if (points.length <= (isLine ? 2 : 3)) return null;
  // the edge after the corner goes with it, the one before it at the end of a line
  const edge = isLine ? Math.min(index, points.length - 2) : index;
  return { ...geometry, points: points.toSpliced(index, 1), bulges: bulges.toSpliced(edge, 1) };
}

// Doors of walls without a height, where these do not stand on the slab.

import { distanceBetween, pointBetween } from "../../viewer/data/points";
import { type Geometry, isClosed, type Point, type Ring, ringOf } from "./geometry";
import { isTable, listAt, type Table } from "./paths";
import { parseLength } from "./quantities";

type Ways = [start: number, end: number];

/** Return what there is of a wall between its doors, undefined if it has none. */
export function piecesOf(wall: Table, geometry: Geometry): Ring[] | undefined {
  const doors = wall.height === undefined ? doorsOf(wall) : [];
  if (doors.length === 0) return undefined;
  const ring = ringOf(geometry);
  const axis = isClosed(geometry) ? [...ring, ...ring.slice(0, 1)] : ring;
  const ends = [0, ...doors.map(([, end]) => end)];
  const starts = [...doors.map(([start]) => start), lengthOf(axis)];
  return ends.map((from, n) => partOf(axis, [from, starts[n]!])).filter((piece) => piece.length > 1);
}

/** Return the doors of a wall, from way to way along it [m], in their order. */
function doorsOf(wall: Table): Ways[] {
  const doors = listAt(wall, ["openings"]).flatMap((each): Ways[] => {
    if (!isTable(each)) return [];
    const [start, end] = [parseLength(each.start), parseLength(each.end)];
    return start !== null && end !== null && start < end ? [[start, end]] : [];
  });
  return doors.toSorted(([one], [other]) => one - other);
}

function lengthOf(axis: Ring): number {
  return axis.slice(1).reduce((length, point, n) => length + distanceBetween(axis[n]!, point), 0);
}

/** Return the part of an axis from way to way along it [m]. */
function partOf(axis: Ring, [from, to]: Ways): Point[] {
  const part: Point[] = [];
  let low = 0;
  axis.slice(1).forEach((point, n) => {
    const [before, length] = [axis[n]!, distanceBetween(axis[n]!, point)];
    const [start, end] = [Math.max(from, low), Math.min(to, low + length)];
    if (length > 0 && start < end) {
      if (part.length === 0) part.push(pointBetween(before, point, (start - low) / length));
      part.push(pointBetween(before, point, (end - low) / length));
    }
    low += length;
  });
  return part;
}

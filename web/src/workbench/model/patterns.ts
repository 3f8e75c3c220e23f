// The forces of a pattern in plan: a vehicle's wheels, a rack's legs.
import { type Geometry, type Point, type Ring, rectangleCorners, ringOf } from "./geometry";
import { applyTo, rotation } from "./isometry";
import { isTable, type Json, listAt, type Table } from "./paths";
import { parseLength } from "./quantities";

const MOST = 4000; // legs that are drawn

/** Return the footprints of a pattern's forces at the place, or at the first of the path, of a move. */
export function patternFeet(data: Table, move: Table, geometry: Geometry): Ring[] {
  const pattern = listAt(data, ["patterns"]).find((each) => isTable(each) && each.name === move.pattern);
  const [origin, next] = ringOf(geometry);
  if (!isTable(pattern) || !origin) return [];
  const path = next ? (Math.atan2(next[1] - origin[1], next[0] - origin[0]) * 180) / Math.PI : 0;
  const turn = rotation(path + (typeof move.turn === "number" ? move.turn : 0), [0, 0]);
  const place = (point: Point): Point => {
    const [x, y] = applyTo(turn, point);
    return [x + origin[0], y + origin[1]];
  };
  return forcesOf(pattern).map(({ at, size }) => footprint(size, at).map(place));
}

function forcesOf(pattern: Table): { at: Point; size: Table }[] {
  const length = (value: Json | undefined, otherwise = 0) => parseLength(value) ?? otherwise;
  if (pattern.kind !== "rack")
    return listAt(pattern, ["wheels"])
      .filter(isTable)
      .map((wheel) => ({ at: [length(wheel.x), length(wheel.y)], size: wheel }));
  const frames = Math.min(typeof pattern.frames === "number" ? pattern.frames : 1, 200);
  const bay = length(pattern.bay, 2.7);
  const rows = pattern.rows === undefined ? ["0 m"] : listAt(pattern, ["rows"]);
  return Array.from({ length: frames }, (_, n) =>
    rows.map((row) => ({ at: [n * bay, length(row)] as Point, size: pattern })),
  )
    .flat()
    .slice(0, MOST);
}

/** Return a rectangle or a circle of a size, a small square where none is given. */
function footprint(size: Table, [x, y]: Point): Ring {
  const diameter = parseLength(size.diameter);
  if (diameter !== null && diameter > 0)
    return ringOf({ type: "circle", at: [], center: [x, y], radius: diameter / 2 });
  const [a, b] = [(parseLength(size.width_x) ?? 0.1) / 2, (parseLength(size.width_y) ?? 0.1) / 2];
  return rectangleCorners([x - a, x + a], [y - b, y + b]);
}

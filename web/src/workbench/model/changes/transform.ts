// Items of the case file moved, turned and mirrored: their places, footprints and the components of what acts on them.

import { say, verbatim } from "../../../viewer/shared/language";
import type { Edit } from "../edits";
import { rectangleCorners } from "../geometry";
import { applyTo, type Isometry, isReflection, keepsAxes, rotation } from "../isometry";
import { isTable, type Json, listAt, type Path, sameValue, type Table } from "../paths";
import { formatExact, parseLength, parsePoint } from "../quantities";

/** Why an item cannot be transformed, in words for users. */
export class Impossible extends Error {}

const PLACES = ["start", "end", "centre", "about", "origin"];
const SHAPES = ["shape", "outline"];
const SHAPE_LISTS = ["openings", "zones", "holes"];
const ZERO = ["0 m", "0 m"];

/** Return a table of the case file under an isometry; throws Impossible where the case file cannot say that. */
export function transformTable(table: Table, by: Isometry): Table {
  const placed = turnFootprint(placeCoordinates(placeParts(table, by), by), by);
  return { ...placed, ...turnVectors(table, by), ...turnPattern(table, by), ...turnAxes(table, by) };
}

/** Return the edits that write a table in place of an older one, key by key. */
export function editsToTable(path: Path, before: Table, after: Table): Edit[] {
  const removed = Object.keys(before).filter((key) => !(key in after));
  const changed = Object.entries(after).filter(([key, value]) => !sameValue(value, before[key]));
  return [
    ...removed.map((key): Edit => ({ op: "remove", path: [...path, key] })),
    ...changed.map(([key, value]): Edit => ({ op: "set", path: [...path, key], value })),
  ];
}

/** Place what has coordinates of its own. */
function placeCoordinates(table: Table, by: Isometry): Table {
  if (Array.isArray(table.x) && Array.isArray(table.y)) return placeBox(table, by);
  const { x, y } = table;
  const isPoint = x !== undefined || y !== undefined;
  if (!isPoint) return { ...table };
  const [newX, newY] = placePoint([x ?? "0 m", y ?? "0 m"], by);
  return { ...table, x: newX!, y: newY! };
}

/** Place a rectangle given by its ranges; one that is turned by other than right angles becomes a polygon. */
function placeBox(table: Table, by: Isometry): Table {
  const [x, y] = [parsePoint(table.x), parsePoint(table.y)];
  if (!x || !y) throw new Impossible("its x and y must both be ranges of lengths");
  const corners = rectangleCorners(x, y).map((corner) => applyTo(by, corner));
  if (!keepsAxes(by)) {
    const { x: _, y: __, ...others } = table;
    const points = corners.map(([u, v]) => [formatExact(u, firstOf(table.x)), formatExact(v, firstOf(table.y))]);
    const polygon: Table = { kind: "polygon", points };
    if (table.kind === "rectangle") return { ...others, ...polygon };
    return { ...others, ...(table.kind === "patch" ? { kind: "area" } : {}), shape: polygon };
  }
  const range = (n: 0 | 1, old: Json | undefined): Json[] => {
    const ends = corners.map((corner) => corner[n]);
    return [Math.min(...ends), Math.max(...ends)].map((end, k) => formatExact(end, Array.isArray(old) ? old[k] : old));
  };
  const [oldX, oldY] = by.a === 0 ? [table.y, table.x] : [table.x, table.y];
  return { ...table, x: range(0, oldX), y: range(1, oldY) };
}

/** Place lists of points and shapes within a table. */
function placeParts(table: Table, by: Isometry): Table {
  const result = { ...table };
  const varies = table.slope !== undefined || table.bend !== undefined;
  // a circle without a center lies about the origin, and so varies a pressure without a place
  if (table.radius !== undefined || table.kind === "ray" || table.kind === "ring") result.centre ??= ZERO;
  if (table.kind === "straight") result.origin ??= ZERO;
  if (varies) result.about ??= ZERO;
  for (const key of PLACES) if (Array.isArray(result[key])) result[key] = placePoint(result[key] as Json[], by);
  if (Array.isArray(table.points))
    result.points = table.points.map((point) => placePoint(Array.isArray(point) ? point : [], by));
  if (Array.isArray(table.bulges) && isReflection(by))
    result.bulges = table.bulges.map((bulge) => (typeof bulge === "number" ? -bulge + 0 : bulge));
  for (const key of SHAPES) if (isTable(table[key])) result[key] = transformTable(table[key], by);
  for (const key of SHAPE_LISTS)
    if (Array.isArray(table[key]))
      result[key] = table[key].map((each) => (isTable(each) ? transformTable(each, by) : each));
  return result;
}

function placePoint(point: Json[], by: Isometry): Json[] {
  const place = parsePoint(point);
  if (!place)
    throw new Impossible(say("{point} is not a point with two lengths", { point: verbatim(JSON.stringify(point)) }));
  return applyTo(by, place).map((value, n) => formatExact(value, point[n]));
}

function firstOf(value: Json | undefined): Json | undefined {
  return Array.isArray(value) ? value[0] : value;
}

/** Return a table with its footprint turned: its sides change places at right angles, else they have an angle. */
export function turnFootprint(table: Table, by: Isometry): Table {
  const { width_x, width_y, angle, ...others } = table;
  const known = typeof angle === "number" ? angle : 0;
  if (width_x === undefined || width_y === undefined || (by.b === 0 && known === 0)) return table;
  const [dx, dy] = applyTo({ ...by, u: 0, v: 0 }, applyTo(rotation(known, [0, 0]), [1, 0]));
  // after half a turn a rectangle is the same
  const degrees = Number(((Math.atan2(dy, dx) * 180) / Math.PI).toFixed(9));
  const turned = degrees > 90 ? degrees - 180 : degrees <= -90 ? degrees + 180 : degrees;
  if (turned === 90) return { ...others, width_x: width_y, width_y: width_x };
  return { ...others, width_x, width_y, ...(turned === 0 ? {} : { angle: turned }) };
}

/** Return moments, slope and second derivatives of a load. */
function turnVectors(table: Table, by: Isometry): Table {
  const { a, b, c, d } = by;
  const result: Table = {};
  if (table.M_x !== undefined || table.M_y !== undefined) {
    // sums of forces times distances along x and y, which turn as the distances do
    const moments = [table.M_x, table.M_y];
    const turned: [string, Json | undefined][] = [
      ["M_x", combine([a, b], moments)],
      ["M_y", combine([c, d], moments)],
    ];
    for (const [key, value] of turned) if (value !== undefined || key in table) result[key] = value ?? "0 kNm";
  }
  if (Array.isArray(table.slope)) {
    const zero = zeroLike(table.slope);
    result.slope = [combine([a, b], table.slope) ?? zero, combine([c, d], table.slope) ?? zero];
  }
  if (Array.isArray(table.bend)) {
    // Q' = R Q R^T of the symmetric second derivatives (q_xx, q_xy, q_yy)
    const rows = [
      [a * a, 2 * a * b, b * b],
      [a * c, a * d + b * c, b * d],
      [c * c, 2 * c * d, d * d],
    ];
    const { bend } = table;
    result.bend = rows.map((row) => combine(row, bend) ?? zeroLike(bend));
  }
  return result;
}

const QUANTITY = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(\S.*?)\s*$/;

/** Return the sum of quantities of one unit with factors; undefined if nothing contributes. */
function combine(factors: readonly number[], values: readonly (Json | undefined)[]): Json | undefined {
  const terms = values.flatMap((value, n): [number, string, string][] => {
    const match = typeof value === "string" ? QUANTITY.exec(value) : null;
    if (value !== undefined && !match)
      throw new Impossible(say("{value} is not a quantity", { value: verbatim(JSON.stringify(value)) }));
    return match && factors[n] !== 0 && Number(match[1]) !== 0 ? [[factors[n]!, match[1]!, match[2]!]] : [];
  });
  const [first, ...others] = terms;
  if (!first) return undefined;
  if (others.some((term) => term[2] !== first[2])) {
    const units = terms.map((term) => term[2]).join(", ");
    throw new Impossible(say("its components have different units ({units}); use the same unit first", { units }));
  }
  if (others.length === 0 && first[0] === 1) return `${first[1]} ${first[2]}`;
  const sum = terms.reduce((total, [factor, number]) => total + factor * Number(number), 0);
  return `${Number(sum.toPrecision(12))} ${first[2]}`;
}

function zeroLike(values: readonly Json[]): Json {
  const match = typeof values[0] === "string" ? QUANTITY.exec(values[0]) : null;
  return `0 ${match?.[2] ?? ""}`.trim();
}

/** Return the directions of axes. */
function turnAxes(table: Table, by: Isometry): Table {
  const isStraight = table.kind === "straight" && table.distances !== undefined;
  if (!isStraight && table.kind !== "ray") return {};
  if (isReflection(by)) throw new Impossible("axes cannot be mirrored");
  if (by.a === 1 && by.b === 0) return {};
  const turn = (Math.atan2(by.c, by.a) * 180) / Math.PI;
  const turned = (angle: Json | undefined): Json => {
    const sum = (typeof angle === "number" ? angle : 0) + turn;
    return Number((sum > 360 ? sum - 360 : sum < -360 ? sum + 360 : sum).toFixed(9));
  };
  return isStraight ? { angle: turned(table.angle) } : { angles: listAt(table, ["angles"]).map(turned) };
}

/** Return the direction of a pattern that stands; one that moves has the direction of its path. */
function turnPattern(table: Table, by: Isometry): Table {
  if (typeof table.pattern !== "string") return {};
  if (isReflection(by)) throw new Impossible("a pattern cannot be mirrored");
  const stands = Array.isArray(table.points) && table.points.length === 1;
  if (!stands || (by.a === 1 && by.b === 0)) return {};
  const degrees = (Math.atan2(by.c, by.a) * 180) / Math.PI;
  const turn = (typeof table.turn === "number" ? table.turn : 0) + degrees;
  return { turn: Number((turn > 360 ? turn - 360 : turn < -360 ? turn + 360 : turn).toFixed(9)) };
}

/** Whether a length has a value here, for messages about items that cannot be moved. */
export function hasPlace(table: Table): boolean {
  const isLength = (value: Json | undefined) => parseLength(value) !== null;
  const keys = [...PLACES, ...SHAPES, "points", "radius"];
  return isLength(table.x) || isLength(table.y) || Array.isArray(table.x) || keys.some((key) => key in table);
}

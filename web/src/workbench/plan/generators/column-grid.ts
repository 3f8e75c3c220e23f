// Columns on the axes of a building, with a load each.

import { say } from "../../../viewer/shared/language";
import { axesIn, crossingsOf, letters } from "../../model/axes";
import { attach } from "../../model/changes/attachment";
import { applyOptimistic } from "../../model/changes/optimistic-edits";
import { Impossible } from "../../model/changes/transform";
import type { Edit } from "../../model/edits";
import { isInside, nearestOnSegment, type Point, type Ring, ringOf } from "../../model/geometry";
import { itemsOf } from "../../model/items";
import { freeName, takenNames } from "../../model/names";
import { listAt, type Path, type Table } from "../../model/paths";
import { formatLength } from "../../model/quantities";
import { force, forceOf, length, lengthOf, lengthsOf, sizeOf, type Values } from "../fields";
import { CASE, chosenCase, formatForce, type Generator } from "./generator";

const MOST = 1000;
const ON = ["a grid", "crossings of axes"];

const isGrid = ({ on }: Values) => on !== ON[1];

interface Place {
  name: string;
  at: Point;
}

export const COLUMN_GRID: Generator = {
  name: "columns",
  label: "Columns",
  key: "D",
  hint: "Add columns on a grid, each with loads",
  fields: [
    { key: "on", label: "on", is: "choice", initial: ON[0]!, options: ON },
    { ...length("x", "first x", "-5 m"), shown: isGrid },
    { ...length("y", "first y", "-3 m"), shown: isGrid },
    { key: "spacing_x", label: "spacing in x", is: "lengths", initial: "2x5 m", shown: isGrid },
    { key: "spacing_y", label: "spacing in y", is: "lengths", initial: "6 m", shown: isGrid },
    length("width_x", "width in x", "400 mm"),
    length("width_y", "width in y", "400 mm"),
    force("P", "load per column", "500 kN"),
    CASE,
    force("P_2", "second load per column", "0 kN"),
    { ...CASE, key: "case_2", label: "its load case", shown: ({ P_2 }) => /[1-9]/.test(P_2 ?? "") },
  ],
  places: [["x", "y"]],
  generate: (data, values) => {
    const on = makeIsOnSlab(data);
    const all = isGrid(values) ? placesOfGrid(values) : placesOnAxes(data);
    if (all.length > MOST)
      throw new Impossible(
        say("{count} columns are too many, expected at most {most}", { count: all.length, most: MOST }),
      );
    const kept = all.filter(({ at }) => on(at));
    if (kept.length === 0) throw new Impossible("none of them would be on the slab");
    const first = loadOf(data, values, "P", "case");
    const second = loadOf(first.edits.reduce(applyOptimistic, data), values, "P_2", "case_2");
    const acting = [first, second].filter(({ P }) => P.value !== 0);
    const size = {
      width_x: formatLength(sizeOf(values, "width_x"), "mm"),
      width_y: formatLength(sizeOf(values, "width_y"), "mm"),
    };
    const taken = takenNames(data, ["columns"]);
    const edits: Edit[] = [...first.edits, ...second.edits];
    for (const { name, at } of kept) {
      const free = freeName(taken, name);
      taken.push(free);
      const value = { name: free, x: formatLength(at[0]), y: formatLength(at[1]), ...size };
      edits.push({ op: "add", path: ["columns"], value: attach(value, "columns", axesIn(data)) });
      for (const load of acting)
        edits.push({
          op: "add",
          path: ["loads"],
          value: { kind: "point", case: load.case, column: free, P: formatForce(load.P) },
        });
    }
    const count = listAt(data, ["columns"]).length;
    const left = all.length - kept.length;
    return {
      change: { edits, text: say("add {count} columns", { count: kept.length }) },
      paths: kept.map((_, n): Path => ["columns", count + n]),
      note: say(left > 0 ? "{count} columns. {left} outside the slab were skipped." : "{count} columns.", {
        count: kept.length,
        left,
      }),
    };
  },
};

/** Return a load that all columns get, its case, and the edits that this needs; the fields of both are named. */
function loadOf(data: Table, values: Values, force: string, loadCase: string) {
  const P = forceOf(values, force);
  const own = { ...values, case: values[loadCase] ?? "" };
  return { P, ...(P.value === 0 ? { edits: [], case: "" } : chosenCase(data, own, "columns")) };
}

function placesOfGrid(values: Values): Place[] {
  const xs = axes(lengthOf(values, "x"), lengthsOf(values, "spacing_x"));
  const ys = axes(lengthOf(values, "y"), lengthsOf(values, "spacing_y"));
  if (xs.length * ys.length > MOST)
    throw new Impossible(
      say("{count} columns are too many, expected at most {most}", { count: xs.length * ys.length, most: MOST }),
    );
  return ys.flatMap((y, row) => xs.map((x, n): Place => ({ name: `${letters(n)}${row + 1}`, at: [x, y] })));
}

/** Return the crossings of the axes of the building where no column stands yet. */
function placesOnAxes(data: Table): Place[] {
  const places = crossingsOf(axesIn(data));
  if (places.length === 0) throw new Impossible("there are no axes that cross, make some with Axes");
  const columns = itemsOf(data, null).filter(({ kind }) => kind === "column");
  const isTaken = ([x, y]: Point) =>
    columns.some(({ geometry }) => geometry.type === "point" && Math.hypot(geometry.x - x, geometry.y - y) < 1e-6);
  return places.filter(({ at }) => !isTaken(at)).map(({ name, at }) => ({ name: name.replace("/", ""), at }));
}

/** Return the places of axes from their distances. */
function axes(first: number, distances: readonly number[]): number[] {
  const places = [first];
  for (const each of distances) places.push(places.at(-1)! + each);
  return places;
}

/** Return what says whether a place lies on a plate, its edge included, and in no opening. */
function makeIsOnSlab(data: Table): (at: Point) => boolean {
  const items = itemsOf(data, null);
  const ringsOf = (kinds: readonly string[]) =>
    items.filter(({ kind }) => kinds.includes(kind)).map(({ geometry }) => ringOf(geometry));
  const [plates, openings] = [ringsOf(["slab", "plate"]), ringsOf(["opening"])];
  return (at) =>
    plates.some((ring) => isInside(ring, at) || isOnEdge(ring, at)) && !openings.some((ring) => isInside(ring, at));
}

function isOnEdge(ring: Ring, at: Point): boolean {
  return ring.some((point, n) => nearestOnSegment(point, ring[(n + 1) % ring.length] ?? point, at).distance < 1e-6);
}

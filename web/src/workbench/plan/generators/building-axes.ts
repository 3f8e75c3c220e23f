// Axes of the building: parallel ones across each other, rays and rings, or those on which the columns stand.

import { say } from "../../../viewer/shared/language";
import { axesIn, countOn } from "../../model/axes";
import { attachAll, countAttached, formatDistances } from "../../model/changes/attachment";
import { applyOptimistic } from "../../model/changes/optimistic-edits";
import { Impossible } from "../../model/changes/transform";
import type { Edit } from "../../model/edits";
import { itemsOf } from "../../model/items";
import { type Json, listAt, type Path, type Table } from "../../model/paths";
import { formatLength } from "../../model/quantities";
import { axesOf } from "../axes";
import { angle, angleOf, count, countOf, length, lengthOf, lengthsOf, type Values } from "../fields";
import type { Generator } from "./generator";

const KINDS = ["x and y", "a center", "columns"];
const MOST = 200;

const isGrid = ({ kind }: Values) => kind === KINDS[0];
const isPolar = ({ kind }: Values) => kind === KINDS[1];

export const BUILDING_AXES: Generator = {
  name: "axes",
  label: "Axes",
  key: "",
  hint: "Add axes of the building, which columns, walls and loads on their crossings then follow",
  fields: [
    { key: "kind", label: "along", is: "choice", initial: KINDS[0]!, options: KINDS },
    { ...length("x", "first x", "-6 m"), shown: isGrid },
    { ...length("y", "first y", "-4 m"), shown: isGrid },
    { key: "spacing_x", label: "spacing in x", is: "lengths", initial: "2x6 m", shown: isGrid },
    { key: "spacing_y", label: "spacing in y", is: "lengths", initial: "2x4 m", shown: isGrid },
    { ...angle("angle", "angle [°]", "0"), shown: isGrid },
    { ...length("center_x", "center x", "0 m"), shown: isPolar },
    { ...length("center_y", "center y", "0 m"), shown: isPolar },
    { key: "radii", label: "spacing of rings", is: "lengths", initial: "2x4 m", shown: isPolar },
    { ...count("rays", "rays", "8"), shown: isPolar },
  ],
  places: [["x", "y"]],
  generate: (data, values) => {
    const taken = axesIn(data).map(({ name }) => name);
    const made = isGrid(values) ? gridOf(values) : isPolar(values) ? polarOf(values) : fromColumns(data);
    const families = made.map((family) => (family.names ? family : { ...family, first: freeFirst(taken, family) }));
    const first = listAt(data, ["axes"]).length;
    const added = families.map((value): Edit => ({ op: "add", path: ["axes"], value }));
    const after = added.reduce(applyOptimistic, data);
    const attached = attachAll(after, axesIn(after));
    const number = countAttached(attached.reduce(applyOptimistic, after)) - countAttached(data);
    return {
      change: { edits: [...added, ...attached], text: "add axes" },
      paths: families.slice(0, 1).map((_, n): Path => ["axes", first + n]),
      note: number > 0 ? say("{count} parts on their crossings are attached to them.", { count: number }) : "",
    };
  },
};

/** Return a name for the first of new axes: its letter or number goes on until the names of all of them are free. */
function freeFirst(taken: readonly string[], family: Table): string {
  const first = String(family.first);
  const { length } = axesIn({ axes: [family] });
  const names = countOn(first, taken.length + length + 1);
  return names.find((_, n) => !countOn(names[n]!, length).some((name) => taken.includes(name))) ?? first;
}

function requireFew(number: number): void {
  if (number > MOST)
    throw new Impossible(say("{count} axes are too many, expected at most {most}", { count: number, most: MOST }));
}

function gridOf(values: Values): Table[] {
  const origin = [formatLength(lengthOf(values, "x")), formatLength(lengthOf(values, "y"))];
  const turn = angleOf(values, "angle");
  return [
    straight("A", lengthsOf(values, "spacing_x"), origin, turn),
    straight("1", lengthsOf(values, "spacing_y"), origin, turn + 90),
  ];
}

function straight(first: string, distances: readonly number[], origin: Json[], turn: number): Table {
  if (distances.length === 0) throw new Impossible("there are no distances, expected some such as 3x6");
  requireFew(distances.length);
  const turned = turn === 0 ? {} : { angle: turn > 360 ? turn - 360 : turn };
  return { kind: "straight", first, distances: formatDistances(distances), origin, ...turned };
}

function polarOf(values: Values): Table[] {
  const centre = [formatLength(lengthOf(values, "center_x")), formatLength(lengthOf(values, "center_y"))];
  const rays = countOf(values, "rays");
  const radii = lengthsOf(values, "radii");
  if (radii.length === 0) throw new Impossible("there are no distances, expected some such as 3x6");
  requireFew(Math.max(rays, radii.length));
  const angles = Array.from({ length: rays }, (_, n) => Number(((360 / rays) * n).toFixed(9)));
  return [
    { kind: "ring", first: "A", centre, distances: formatDistances(radii) },
    { kind: "ray", first: "1", centre, angles },
  ];
}

/** Return the axes along x and y on which at least two columns stand. */
function fromColumns(data: Table): Table[] {
  const items = itemsOf(data, null);
  const [xs, ys] = ([0, 1] as const).map((across) => axesOf(items, across).filter(({ columns }) => columns > 1));
  const [x, y] = [xs?.[0], ys?.[0]];
  if (!xs || !ys || !x || !y || xs.length < 2 || ys.length < 2)
    throw new Impossible("the columns do not stand in two rows across two others");
  const origin = [formatLength(x.at), formatLength(y.at)];
  const family = (all: readonly { at: number; name: string }[], first: string, turn: number): Table => {
    const distances = all.slice(1).map(({ at }, n) => at - all[n]!.at);
    const names = all.map(({ name }) => name);
    const { first: _, ...named } = straight(first, distances, origin, turn);
    return names.includes("") ? { ...named, first } : { ...named, names };
  };
  return [family(xs, "A", 0), family(ys, "1", 90)];
}

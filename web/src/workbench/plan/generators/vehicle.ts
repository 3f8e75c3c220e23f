// A vehicle of two axles that moves along a path.
import { say, together, verbatim } from "../../../viewer/shared/language";
import { Impossible } from "../../model/changes/transform";
import { freeName, namesIn } from "../../model/names";
import { listAt, type Table } from "../../model/paths";
import { formatLength } from "../../model/quantities";
import {
  type Force,
  force,
  forceOf,
  length,
  lengthOf,
  newtonsOf,
  pressureOf,
  refuse,
  sizeOf,
  type Values,
} from "../fields";
import { FORKLIFT, noteOnForklift } from "./forklifts";
import { chosenCase, formatForce, type Generator, IMPOSED_CASE } from "./generator";

const TIRE = "tire pressure";
const hasWidths = ({ contact }: Values) => contact !== TIRE;

export const VEHICLE: Generator = {
  name: "vehicle",
  label: "Vehicle",
  key: "Q",
  hint: "Add a vehicle, such as a forklift, that moves along a path",
  fields: [
    FORKLIFT,
    force("front", "front axle", "60 kN"),
    force("rear", "rear axle", "10 kN"),
    length("track", "track width", "1 m"),
    length("base", "wheelbase", "1.6 m"),
    { key: "contact", label: "contact area from", is: "choice", initial: "widths", options: ["widths", TIRE] },
    { ...length("width_x", "contact length", "200 mm"), shown: hasWidths },
    { ...length("width_y", "contact width", "200 mm"), shown: hasWidths },
    {
      key: "pressure",
      label: "tire pressure",
      is: "pressure",
      initial: "0.8 MPa",
      shown: ({ contact }) => contact === TIRE,
    },
    { key: "factor", label: "dynamic factor", is: "number", initial: "1" },
    length("x", "from x", "-5 m"),
    length("y", "from y", "0 m"),
    length("x2", "to x", "5 m"),
    length("y2", "to y", "0 m"),
    length("step", "step", "1 m"),
    IMPOSED_CASE,
  ],
  places: [
    ["x", "y"],
    ["x2", "y2"],
  ],
  generate: (data, values) => {
    const name = freeName(namesIn(listAt(data, ["patterns"])), "vehicle");
    const found = chosenCase(data, values, name, true);
    const [from, to] = [place(values, "x", "y"), place(values, "x2", "y2")];
    const distance = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const step = lengthOf(values, "step");
    if (step < 0.05) refuse('{key}: found "{text}", expected at least 0.05 m', "step", values.step!);
    if (distance === 0) throw new Impossible("the path ends where it begins, expected a different end");
    const points = [from, to].map(([x, y]) => [formatLength(x), formatLength(y)]);
    // several paths of one case need names
    const paths = namesIn(listAt(data, ["moves"]));
    const move = { name: freeName(paths, "path 1"), pattern: name, case: found.case, points, step: formatLength(step) };
    const positions = Math.ceil(distance / step - 1e-9) + 1;
    return {
      change: {
        edits: [
          ...found.edits,
          { op: "add", path: ["patterns"], value: { kind: "vehicle", name, wheels: wheelsOf(values) } },
          { op: "add", path: ["moves"], value: move },
        ],
        text: say("add {item}", { item: verbatim(name) }),
      },
      paths: [["moves", listAt(data, ["moves"]).length]],
      note: together([
        say("{count} positions. Drag the middle of the path to add a corner.", { count: positions }),
        noteOnForklift(values.class),
      ]),
    };
  },
};

function place(values: Values, x: string, y: string): [number, number] {
  return [lengthOf(values, x), lengthOf(values, y)];
}

/** Return the wheels, those in front at the origin; an axle without a load has none. */
function wheelsOf(values: Values): Table[] {
  const factor = Number((values.factor ?? "").trim().replace(",", ".") || Number.NaN);
  if (!(factor > 0)) refuse('{key}: found "{text}", expected a number such as 1.4', "factor", values.factor!);
  const [half, base] = [sizeOf(values, "track") / 2, sizeOf(values, "base")];
  const axles = [
    { load: axleLoadOf(values, "front"), x: 0 },
    { load: axleLoadOf(values, "rear"), x: -base },
  ].filter(({ load }) => load.value !== 0);
  if (axles.length === 0) throw new Impossible("neither axle has a load, expected a force");
  return axles.flatMap(({ load, x }) =>
    [-half, half].map((y) => ({
      P: formatForce(load, factor / 2),
      ...(x === 0 ? {} : { x: formatLength(x) }),
      y: formatLength(y),
      ...contactOf(values, load),
    })),
  );
}

function axleLoadOf(values: Values, key: string): Force {
  const load = forceOf(values, key);
  if (load.value < 0) refuse('{key}: found "{text}", expected a force from 0', key, values[key]!);
  return load;
}

/** Return the widths of a wheel's contact; under a tire, the square on which its static load has the tire's pressure. */
function contactOf(values: Values, axle: Force): Table {
  const side = () => Math.sqrt(newtonsOf(axle) / 2 / pressureOf(values, "pressure"));
  const [x, y] = hasWidths(values) ? [sizeOf(values, "width_x"), sizeOf(values, "width_y")] : [side(), side()];
  return { width_x: formatLength(x, "mm"), width_y: formatLength(y, "mm") };
}

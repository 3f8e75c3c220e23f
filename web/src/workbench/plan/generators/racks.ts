// Racks: rows of frames with two legs each, single or back to back.
import { say, verbatim } from "../../../viewer/shared/language";
import type { Additions } from "../../model/changes/copies";
import { Impossible, turnFootprint } from "../../model/changes/transform";
import type { Edit } from "../../model/edits";
import type { Point } from "../../model/geometry";
import { applyTo, rotation } from "../../model/isometry";
import { freeName, namesIn } from "../../model/names";
import { type Json, listAt, type Table } from "../../model/paths";
import { formatLength } from "../../model/quantities";
import {
  type ActionField,
  angle,
  angleOf,
  count,
  countOf,
  force,
  forceOf,
  length,
  lengthOf,
  sizeOf,
  type Values,
} from "../fields";
import { chosenCase, formatForce, type Generator, IMPOSED_CASE } from "./generator";

const DOUBLE = "back to back";
const LOADS = "point loads";
const MOST_LEGS = 2000;
const MOST_FRAMES = 200; // of a pattern
const hasAisle = ({ rows }: Values) => rows !== "1";

const FIELDS: readonly ActionField[] = [
  force("P", "load per leg", "60 kN"),
  length("width_x", "base plate along", "150 mm"),
  length("width_y", "base plate across", "150 mm"),
  count("bays", "bays", "5"),
  length("bay", "bay width", "2.7 m"),
  length("depth", "frame depth", "1.1 m"),
  { key: "racks", label: "racks", is: "choice", initial: "single", options: ["single", DOUBLE] },
  { ...length("gap", "gap between racks", "0.3 m"), shown: ({ racks }) => racks === DOUBLE },
  count("rows", "rack rows", "1"),
  { ...length("aisle", "aisle", "3.5 m"), shown: hasAisle },
  length("x", "first leg x", "0 m"),
  length("y", "first leg y", "0 m"),
  angle("angle", "direction [°]", "0"),
  IMPOSED_CASE,
  { key: "as", label: "as", is: "choice", initial: "pattern", options: ["pattern", LOADS] },
];

export const RACKS: Generator = {
  name: "racks",
  label: "Racks",
  key: "K",
  hint: "Add rack legs in rows",
  fields: FIELDS,
  places: [["x", "y"]],
  generate: (data, values) => {
    const across = legsAcross(values);
    const frames = countOf(values, "bays") + 1;
    const rows = countOf(values, "rows");
    const legs = rows * frames * across.length;
    if (legs > MOST_LEGS)
      throw new Impossible(say("{count} legs are too many, expected at most {most}", { count: legs, most: MOST_LEGS }));
    const found = chosenCase(data, values, "racks", true);
    const make = values.as === LOADS ? asLoads : asPattern;
    const made = make(data, values, across, found.case);
    return {
      change: {
        edits: [...found.edits, ...made.change.edits],
        text: say("add {count} legs of racks", { count: legs }),
      },
      paths: made.paths,
      note: say("{count} legs.", { count: legs }),
    };
  },
};

/** Return the places of a frame's legs across the rack [m]. */
function legsAcross(values: Values): number[] {
  const depth = sizeOf(values, "depth");
  if (values.racks !== DOUBLE) return [0, depth];
  const gap = sizeOf(values, "gap");
  return [0, depth, depth + gap, 2 * depth + gap];
}

/** Return where the rows begin [m]. */
function rowsOf(values: Values, across: readonly number[]): Point[] {
  const width = (across.at(-1) ?? 0) + (hasAisle(values) ? sizeOf(values, "aisle") : 0);
  const turn = rotation(angleOf(values, "angle"), [0, 0]);
  const [x, y] = [lengthOf(values, "x"), lengthOf(values, "y")];
  return Array.from({ length: countOf(values, "rows") }, (_, n): Point => {
    const [dx, dy] = applyTo(turn, [0, n * width]);
    return [x + dx, y + dy];
  });
}

function legOf(values: Values): Table {
  return {
    P: formatForce(forceOf(values, "P")),
    width_x: formatLength(sizeOf(values, "width_x"), "mm"),
    width_y: formatLength(sizeOf(values, "width_y"), "mm"),
  };
}

/** Return the change that adds a pattern, and a place of it for each row. */
function asPattern(data: Table, values: Values, across: readonly number[], loadCase: string): Additions {
  const name = freeName(namesIn(listAt(data, ["patterns"])), "rack");
  const frames = countOf(values, "bays") + 1;
  if (frames > MOST_FRAMES)
    throw new Impossible(
      say('{key}: found "{text}", expected at most {most} of a pattern', {
        key: verbatim("bays"),
        text: verbatim(values.bays!),
        most: MOST_FRAMES - 1,
      }),
    );
  const { P, ...plate } = legOf(values);
  const pattern: Table = {
    kind: "rack",
    name,
    P: P!,
    frames,
    bay: formatLength(sizeOf(values, "bay")),
    rows: across.map((each): Json => formatLength(each)),
    ...plate,
  };
  const turn = angleOf(values, "angle");
  const moves = rowsOf(values, across).map(
    (at): Table => ({
      pattern: name,
      case: loadCase,
      points: [[formatLength(at[0]), formatLength(at[1])]],
      ...(turn === 0 ? {} : { turn }),
    }),
  );
  const first = listAt(data, ["moves"]).length;
  const edits: Edit[] = [
    { op: "add", path: ["patterns"], value: pattern },
    ...moves.map((value): Edit => ({ op: "add", path: ["moves"], value })),
  ];
  return { change: { edits, text: "" }, paths: moves.map((_, n) => ["moves", first + n]) };
}

/** Return the change that adds a point load for each leg. */
function asLoads(data: Table, values: Values, across: readonly number[], loadCase: string): Additions {
  const turn = rotation(angleOf(values, "angle"), [0, 0]);
  const [bay, frames, size] = [sizeOf(values, "bay"), countOf(values, "bays") + 1, turnFootprint(legOf(values), turn)];
  const places = rowsOf(values, across).flatMap(([x, y]) =>
    Array.from({ length: frames }, (_, n) =>
      across.map((leg): Point => {
        const [dx, dy] = applyTo(turn, [n * bay, leg]);
        return [x + dx, y + dy];
      }),
    ).flat(),
  );
  const first = listAt(data, ["loads"]).length;
  const edits = places.map(([x, y]): Edit => {
    const value = { kind: "point", case: loadCase, ...size, x: formatLength(x), y: formatLength(y) };
    return { op: "add", path: ["loads"], value };
  });
  return { change: { edits, text: "" }, paths: places.map((_, n) => ["loads", first + n]) };
}

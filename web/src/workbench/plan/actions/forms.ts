// What the dialogs of the actions ask for, and what they make of it.

import { say } from "../../../viewer/shared/language";
import { Impossible } from "../../model/changes/transform";
import type { Point } from "../../model/geometry";
import { type Isometry, reflection, rotation, translation } from "../../model/isometry";
import { type ActionField, angle, angleOf, count, countOf, length, lengthOf, type Values } from "../fields";

export type ActionName = "move" | "rotate" | "mirror" | "array";

/** What is made of the selection: its image under the isometry, or a copy under each. */
export interface Plan {
  isometries: Isometry[];
  copies: boolean;
}

export interface ActionForm {
  name: ActionName;
  label: string;
  key: string;
  hint: string;
  fields: readonly ActionField[];
  /** `center` is the middle of what is selected. */
  plan(values: Values, center: Point): Plan;
}

const COPY: ActionField = { key: "copy", label: "keep the original", is: "flag", initial: "" };
const KINDS = ["rows and columns", "circle"];
const LINES = ["line x =", "line y =", "two points"];
const MOST = 2000; // copies that one step makes

const isCircle = ({ kind }: Values) => kind === "circle";
const isGrid = ({ kind }: Values) => kind !== "circle";
const hasTwoPoints = ({ line }: Values) => line === "two points";

export const FORMS: readonly ActionForm[] = [
  {
    name: "move",
    label: "Move",
    key: "M",
    hint: "Move by a distance in x and y",
    fields: [length("dx", "dx", "1 m"), length("dy", "dy", "0 m"), COPY],
    plan: (values) => ({
      isometries: [translation([lengthOf(values, "dx"), lengthOf(values, "dy")])],
      copies: values.copy === "yes",
    }),
  },
  {
    name: "rotate",
    label: "Rotate",
    key: "R",
    hint: "Rotate counterclockwise about a point",
    fields: [
      angle("angle", "angle [°]", "90"),
      length("x", "about x", "center"),
      length("y", "about y", "center"),
      COPY,
    ],
    plan: (values, center) => ({
      isometries: [rotation(angleOf(values, "angle"), pointOf(values, "x", "y", center))],
      copies: values.copy === "yes",
    }),
  },
  {
    name: "mirror",
    label: "Mirror",
    key: "I",
    hint: "Mirror about a line",
    fields: [
      { key: "line", label: "about the", is: "choice", initial: LINES[0]!, options: LINES },
      { ...length("x", "x", "0 m"), shown: ({ line }) => line !== LINES[1] },
      { ...length("y", "y", "0 m"), shown: ({ line }) => line !== LINES[0] },
      { ...length("x2", "second x", "1 m"), shown: hasTwoPoints },
      { ...length("y2", "second y", "1 m"), shown: hasTwoPoints },
      { ...COPY, initial: "yes" },
    ],
    plan: (values) => ({ isometries: [reflectionOf(values)], copies: values.copy === "yes" }),
  },
  {
    name: "array",
    label: "Array",
    key: "Y",
    hint: "Repeat in rows and columns or around a circle",
    fields: [
      { key: "kind", label: "along", is: "choice", initial: KINDS[0]!, options: KINDS },
      { ...count("columns", "columns", "3"), shown: isGrid },
      { ...length("dx", "dx", "2 m"), shown: isGrid },
      { ...count("rows", "rows", "2"), shown: isGrid },
      { ...length("dy", "dy", "2 m"), shown: isGrid },
      { ...count("count", "number", "6"), shown: isCircle },
      { ...angle("angle", "angle [°]", "360"), shown: isCircle },
      { ...length("x", "center x", "0 m"), shown: isCircle },
      { ...length("y", "center y", "0 m"), shown: isCircle },
      { key: "turned", label: "rotate the copies", is: "flag", initial: "", shown: isCircle },
    ],
    plan: (values, center) => ({
      isometries: isCircle(values) ? circle(values, center) : grid(values),
      copies: true,
    }),
  },
];

function pointOf(values: Values, x: string, y: string, center: Point): Point {
  const coordinate = (key: string, own: number) => (values[key]?.trim() === "center" ? own : lengthOf(values, key));
  return [coordinate(x, center[0]), coordinate(y, center[1])];
}

function reflectionOf(values: Values): Isometry {
  if (values.line === LINES[0]) {
    const x = lengthOf(values, "x");
    return reflection([x, 0], [x, 1]);
  }
  if (values.line === LINES[1]) {
    const y = lengthOf(values, "y");
    return reflection([0, y], [1, y]);
  }
  const [from, to]: [Point, Point] = [
    [lengthOf(values, "x"), lengthOf(values, "y")],
    [lengthOf(values, "x2"), lengthOf(values, "y2")],
  ];
  if (from[0] === to[0] && from[1] === to[1])
    throw new Impossible("the two points are the same, expected different ones");
  return reflection(from, to);
}

/** Return the translations of a grid, without the place of the original. */
function grid(values: Values): Isometry[] {
  const [columns, rows] = [countOf(values, "columns"), countOf(values, "rows")];
  requireFew(columns * rows);
  const [dx, dy] = [columns > 1 ? lengthOf(values, "dx") : 0, rows > 1 ? lengthOf(values, "dy") : 0];
  if ((columns > 1 && dx === 0) || (rows > 1 && dy === 0))
    throw new Impossible("the spacing is 0, expected another value");
  const places = Array.from(
    { length: columns * rows },
    (_, n): Point => [dx * (n % columns), dy * Math.floor(n / columns)],
  );
  return places.slice(1).map(translation);
}

/** Return the isometries along a circle; a full one is divided by the number, else the last is at its end. */
function circle(values: Values, center: Point): Isometry[] {
  const number = countOf(values, "count");
  requireFew(number);
  const total = angleOf(values, "angle");
  const about: Point = [lengthOf(values, "x"), lengthOf(values, "y")];
  const step = total / (Math.abs(total) % 360 === 0 ? number : Math.max(1, number - 1));
  return Array.from({ length: number - 1 }, (_, n) => {
    const turn = rotation(step * (n + 1), about);
    if (values.turned === "yes") return turn;
    const { a, b, c, d, u, v } = turn;
    const [x, y] = center;
    return translation([a * x + b * y + u - x, c * x + d * y + v - y]);
  });
}

function requireFew(number: number): void {
  if (number < 2) throw new Impossible("found only the original, expected at least one copy");
  if (number > MOST)
    throw new Impossible(say("{count} copies are too many, expected at most {most}", { count: number, most: MOST }));
}

// Forklifts of EN 1991-1-1 as a choice that fills in the fields of a vehicle.
import { say, verbatim } from "../../../viewer/shared/language";
import type { ActionField, Values } from "../fields";

//: class, axle load Q_k [kN] (Table 6.6), width of the axle a [m] (Table 6.5) of EN 1991-1-1:2002; each wheel stands on
//: a square of 200 mm (Figure 6.1). From memory, not looked up.
const CLASSES: readonly [string, number, number][] = [
  ["FL1", 26, 0.85],
  ["FL2", 40, 0.95],
  ["FL3", 63, 1],
  ["FL4", 90, 1.2],
  ["FL5", 140, 1.5],
  ["FL6", 170, 1.8],
];
const OTHER = "custom";

export const FORKLIFT: ActionField = {
  key: "class",
  label: "forklift",
  is: "choice",
  initial: OTHER,
  options: [OTHER, ...CLASSES.map(([name]) => name)],
  fills: valuesOf,
};

/** Return the values of a class, without a rear axle as in the standard; null for own values. */
function valuesOf(name: string): Values | null {
  const found = CLASSES.find((each) => each[0] === name);
  if (!found) return null;
  const [, Q_k, a] = found;
  return {
    front: `${Q_k} kN`,
    rear: "0 kN",
    track: `${a} m`,
    contact: "widths",
    width_x: "200 mm",
    width_y: "200 mm",
  };
}

/** Return what is to be known of the values of a class, empty for own values. */
export function noteOnForklift(name: string | undefined): string {
  const said =
    "{name} is quoted from memory of EN 1991-1-1, Tables 6.5 and 6.6: verify it and enter the dynamic factor.";
  return name && valuesOf(name) ? say(said, { name: verbatim(name) }) : "";
}

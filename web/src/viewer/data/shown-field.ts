// What a view shows: a field of a combination or an envelope, and its color scale.
import { type ColorScale, makeScale } from "./color-scale";
import { type Choice, combinationsOf, extremesOf, type FieldInfo, isDifference } from "./fields";
import type { Scene } from "./scene";

export interface ShownField {
  choice: Choice;
  field: FieldInfo;
  scale: ColorScale;
  lifted: boolean; // whether some of the plate has no contact
}

/** "auto": the scale fits the combination shown; "common": all combinations; or from a number to another. */
export type ScaleRange = "auto" | "common" | readonly [number, number];

/** Return the color scale of a field: round, from zero for what is never negative. */
export function scaleFor(scene: Scene, choice: Choice, field: FieldInfo, range: ScaleRange): ColorScale {
  const ends = extremesOf(scene, choice, field.name);
  const [min, max] = [ends.min[0], ends.max[0]];
  if (typeof range !== "string") return { ...makeScale(range[0], range[1], field.signed, range), min, max };
  let [low, high] = [min, max];
  if (range === "common" && combinationsOf(scene, "largest").length > 1) {
    high = extremesOf(scene, "largest", field.name).max[0];
    low = extremesOf(scene, "smallest", field.name).min[0];
  }
  if (isDifference(scene)) {
    // zero is in the middle
    high = Math.max(Math.abs(low), Math.abs(high));
    low = -high;
  }
  if (!field.signed) low = Math.min(low, 0);
  return { ...makeScale(low, high, field.signed), min, max };
}

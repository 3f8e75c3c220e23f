// Moving a thing of the case file as a whole: all of its places, in the units that stand there.

import { isTable, type Json } from "./paths";
import { metres, writtenLike } from "./quantities";

type Step = readonly [number, number];

/** The value with all coordinates in it moved [m]; what is no coordinate stays. */
export function movedTable(value: Json, by: Step): Json {
  if (!isTable(value)) return value;
  const result = { ...value };
  for (const [key, old] of Object.entries(value)) {
    if (key === "x" || key === "y") result[key] = movedAlong(old, by[key === "x" ? 0 : 1]);
    else if (key === "centre" || key === "start" || key === "end" || key === "about") result[key] = movedPlace(old, by);
    else if (key === "points" && Array.isArray(old)) result[key] = old.map((each) => movedPlace(each, by));
    else if (key === "shape") result[key] = movedTable(old, by);
  }
  return result;
}

function movedAlong(value: Json, by: number): Json {
  if (Array.isArray(value)) return value.map((each) => movedAlong(each, by));
  const old = metres(value);
  return old === null ? value : writtenLike(value, old + by);
}

function movedPlace(value: Json, by: Step): Json {
  return Array.isArray(value) ? value.map((each, n) => movedAlong(each, by[n] ?? 0)) : value;
}

// Moving an item of the case file: all of its places, in the units that are there.

import { isTable, type Json } from "../paths";
import { formatLike, parseLength } from "../quantities";

type Step = readonly [number, number];

/** The value with all coordinates in it moved [m]; what is no coordinate stays. */
export function moveTable(value: Json, by: Step): Json {
  if (!isTable(value)) return value;
  const result = { ...value };
  for (const [key, old] of Object.entries(value)) {
    if (key === "x" || key === "y") result[key] = moveLength(old, by[key === "x" ? 0 : 1]);
    else if (key === "centre" || key === "start" || key === "end" || key === "about") result[key] = movePoint(old, by);
    else if (key === "points" && Array.isArray(old)) result[key] = old.map((each) => movePoint(each, by));
    else if (key === "shape") result[key] = moveTable(old, by);
  }
  return result;
}

function moveLength(value: Json, by: number): Json {
  if (Array.isArray(value)) return value.map((each) => moveLength(each, by));
  const old = parseLength(value);
  return old === null ? value : formatLike(value, old + by);
}

function movePoint(value: Json, by: Step): Json {
  return Array.isArray(value) ? value.map((each, n) => moveLength(each, by[n] ?? 0)) : value;
}

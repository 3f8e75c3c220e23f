// Lengths and places that are typed while something is drawn.
import { distanceBetween } from "../../../viewer/data/points";
import type { Point } from "../../model/geometry";
import { parseTyped } from "../../model/quantities";
import { roundOff } from "./gestures";

const SKEW = 0.1; // a direction that is less off x or y means that axis

/** Return what has been typed after a key, null if the key is no part of it. */
export function typeKey(typed: string, key: string): string | null {
  if (key === "Backspace") return typed ? typed.slice(0, -1) : null;
  if (/^[\d.,;-]$/.test(key)) return typed + key;
  // a unit or a blank comes after a number only
  return typed && /^[ a-z]$/i.test(key) ? typed + key : null;
}

/** Return the place of the pointer; beside a place in line with it where it is nearly that. */
export function alongAxis(from: Point, pointer: Point): Point {
  const [dx, dy] = [Math.abs(pointer[0] - from[0]), Math.abs(pointer[1] - from[1])];
  if (dy < SKEW * dx) return [pointer[0], from[1]];
  return dx < SKEW * dy ? [from[0], pointer[1]] : pointer;
}

/** Return the place that was typed: `2;3` or `2, 3` itself, `3.5` so far from the last one towards the pointer; else null. */
export function typedPlace(text: string, last: Point | null, pointer: Point | null): Point | null {
  const parts = text.includes(";") ? text.split(";") : text.split(/,\s+/);
  const lengths = parts.map(parseTyped);
  const [x, y] = lengths;
  if (lengths.length === 2 && typeof x === "number" && typeof y === "number") return [x, y];
  if (lengths.length !== 1 || typeof x !== "number" || x <= 0 || !last || !pointer) return null;
  const distance = distanceBetween(last, pointer);
  if (distance === 0) return null;
  const along = (n: 0 | 1) => roundOff(last[n] + ((pointer[n] - last[n]) / distance) * x);
  return [along(0), along(1)];
}

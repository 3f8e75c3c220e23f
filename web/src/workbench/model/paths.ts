// Paths into the case file: keys and positions from 0, as the server takes them.

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type Table = { [key: string]: Json };
export type Path = readonly (string | number)[];

/** Whether a value is a table (not a list, not null). */
export function isTable(value: Json | undefined): value is Table {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** The value at a path, undefined if nothing is there. */
export function valueAt(data: Json | undefined, path: Path): Json | undefined {
  let value = data;
  for (const step of path) {
    if (typeof step === "number") value = Array.isArray(value) ? value[step] : undefined;
    else value = isTable(value) && Object.hasOwn(value, step) ? value[step] : undefined;
    if (value === undefined) return undefined;
  }
  return value;
}

/** The table at a path, an empty one if there is none. */
export function tableAt(data: Json | undefined, path: Path): Table {
  const value = valueAt(data, path);
  return isTable(value) ? value : {};
}

/** The list at a path, an empty one if there is none. */
export function listAt(data: Json | undefined, path: Path): Json[] {
  const value = valueAt(data, path);
  return Array.isArray(value) ? value : [];
}

/** A path as one text: a key for maps and for data attributes. */
export function pathKey(path: Path): string {
  return JSON.stringify(path);
}

/** Return a path as issues and plans write it, positions from 1: `plate.openings[1].x`. */
export function formatPath(path: Path): string {
  let words = "";
  for (const step of path) words += typeof step === "number" ? `[${step + 1}]` : words ? `.${step}` : step;
  return words;
}

/** Return the path that issues and plans write so. */
export function parsePath(words: string): Path {
  return [...words.matchAll(/\[(\d+)\]|[^.[\]]+/g)].map(([step, number]) => (number ? Number(number) - 1 : step));
}

/** Whether two paths are the same. */
export function samePath(a: Path | null, b: Path | null): boolean {
  if (a === null || b === null) return a === b;
  return a.length === b.length && a.every((step, n) => step === b[n]);
}

/** Whether a path starts with another (or is the same). */
export function startsWith(path: Path, start: Path): boolean {
  return path.length >= start.length && start.every((step, n) => step === path[n]);
}

/** Whether two values are equal all through. */
export function sameValue(a: Json | undefined, b: Json | undefined): boolean {
  if (a === b) return true;
  if (Array.isArray(a) && Array.isArray(b)) return a.length === b.length && a.every((each, n) => sameValue(each, b[n]));
  if (!isTable(a) || !isTable(b)) return false;
  const keys = Object.keys(a);
  return (
    keys.length === Object.keys(b).length && keys.every((key) => Object.hasOwn(b, key) && sameValue(a[key], b[key]))
  );
}

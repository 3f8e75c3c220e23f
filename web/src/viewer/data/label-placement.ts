// Where labels stand on a picture: none covers another one, nor what is taken; those without space are left out.
import type { Box } from "./boxes";
import type { Point } from "./scene";

/** A label that wants a place. */
export interface LabelWish {
  size: Point; // width and height [px]
  /** Upper left corners that it could have, the best first [px]. */
  places: readonly Point[];
  /** Whether it is never left out: farther away there is space. */
  kept?: boolean;
}

const CELL = 64; // px: side of the cells in which boxes are looked for
const STEP = 12; // px: how much farther away a label that is kept is tried
const FARTHEST = 40; // steps
const AROUND: readonly Point[] = [
  [1, 0],
  [0, -1],
  [0, 1],
  [-1, 0],
  [1, -1],
  [1, 1],
  [-1, -1],
  [-1, 1],
];

/** The boxes that are taken, by the cells of a grid that they touch. */
export class TakenBoxes {
  private readonly cells = new Map<string, Box[]>();

  add(box: Box): void {
    for (const key of keysOf(box)) {
      const cell = this.cells.get(key);
      if (cell) cell.push(box);
      else this.cells.set(key, [box]);
    }
  }

  isFree(box: Box): boolean {
    return keysOf(box).every((key) => !this.cells.get(key)?.some((other) => overlap(box, other)));
  }
}

/**
 * Return the upper left corner of each label, null of those that are left out.
 *
 * Labels take their places in their order. `limits` is the box that they stay in [px]; a label that is kept leaves a
 * box that is taken only if there is no other space within reach.
 */
export function placeLabels(
  wishes: readonly LabelWish[],
  limits: Readonly<Box>,
  taken: TakenBoxes = new TakenBoxes(),
): (Point | null)[] {
  return wishes.map((wish) => {
    const place = findPlace(wish, limits, taken);
    if (place) taken.add(boxAt(place, wish.size));
    return place;
  });
}

function findPlace({ size, places, kept }: LabelWish, limits: Readonly<Box>, taken: TakenBoxes): Point | null {
  const isFree = (place: Point) => {
    const box = boxAt(place, size);
    return isWithin(box, limits) && taken.isFree(box);
  };
  const free = places.find(isFree);
  if (free || !kept) return free ?? null;
  const [x, y] = clamp(places[0]!, size, limits);
  for (let step = 0; step <= FARTHEST; step++)
    for (const [dx, dy] of AROUND) {
      const place: Point = [x + dx * step * STEP, y + dy * step * STEP];
      if (isFree(place)) return place;
    }
  return [x, y];
}

function boxAt([x, y]: Readonly<Point>, [width, height]: Readonly<Point>): Box {
  return [x, y, x + width, y + height];
}

/** Return the nearest corner with which a label is within limits. */
function clamp([x, y]: Readonly<Point>, [width, height]: Readonly<Point>, [x0, y0, x1, y1]: Readonly<Box>): Point {
  return [Math.max(x0, Math.min(x, x1 - width)), Math.max(y0, Math.min(y, y1 - height))];
}

function isWithin(box: Readonly<Box>, limits: Readonly<Box>): boolean {
  return box[0] >= limits[0] && box[1] >= limits[1] && box[2] <= limits[2] && box[3] <= limits[3];
}

function overlap(a: Readonly<Box>, b: Readonly<Box>): boolean {
  return a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
}

function keysOf([x0, y0, x1, y1]: Readonly<Box>): string[] {
  const keys: string[] = [];
  for (let i = Math.floor(x0 / CELL); i <= Math.floor(x1 / CELL); i++)
    for (let j = Math.floor(y0 / CELL); j <= Math.floor(y1 / CELL); j++) keys.push(`${i} ${j}`);
  return keys;
}

// Triangles, sides and border of a mesh.
import type { Mesh } from "./scene";
import { CORNERS, SIDES, TRIANGLES } from "./shape-functions";

/** Return the nodes of all triangles: eight for each element. */
export function facesOf(mesh: Mesh): Uint32Array {
  const { elements, elementCount } = mesh;
  const faces = new Uint32Array(24 * elementCount);
  for (let e = 0; e < elementCount; e++)
    for (let k = 0; k < 24; k++) faces[24 * e + k] = elements[9 * e + TRIANGLES[k]!]!;
  return faces;
}

/** A part of a mesh that is drawn or left out as a whole: its box [m], and its corners in the list of faces. */
export interface Tile {
  box: [number, number, number, number];
  fine: [start: number, count: number];
  coarse: [start: number, count: number];
}

/** Triangles of a mesh, tile by tile: first eight for each element, then again two for each, for use from afar. */
export interface Tiling {
  faces: Uint32Array;
  tiles: Tile[];
  side: number; // of a usual element [m]
}

/** About so many elements make a tile. */
const TILE = 300;

/** Return a mesh's triangles in square tiles, so that only what is seen has to be drawn. */
export function tilingOf(mesh: Mesh): Tiling {
  const { nodes, elements, elementCount } = mesh;
  const boxes = new Float64Array(4 * elementCount);
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  let area = 0;
  for (let e = 0; e < elementCount; e++) {
    let [a, b, c, d] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k < 9; k++) {
      const node = 2 * elements[9 * e + k]!;
      const [x, y] = [nodes[node]!, nodes[node + 1]!];
      if (x < a) a = x;
      if (y < b) b = y;
      if (x > c) c = x;
      if (y > d) d = y;
    }
    boxes.set([a, b, c, d], 4 * e);
    area += (c - a) * (d - b);
    x0 = Math.min(x0, a);
    y0 = Math.min(y0, b);
    x1 = Math.max(x1, c);
    y1 = Math.max(y1, d);
  }
  const side = Math.max(Math.sqrt(((x1 - x0) * (y1 - y0) * TILE) / Math.max(elementCount, 1)), 1e-9);
  const across = Math.min(32, Math.max(1, Math.ceil((x1 - x0) / side)));
  const up = Math.min(32, Math.max(1, Math.ceil((y1 - y0) / side)));
  const tileOf = (e: number) => {
    const [i, j] = [
      ((boxes[4 * e]! + boxes[4 * e + 2]!) / 2 - x0) / (x1 - x0 || 1),
      ((boxes[4 * e + 1]! + boxes[4 * e + 3]!) / 2 - y0) / (y1 - y0 || 1),
    ];
    return Math.min(up - 1, Math.floor(j * up)) * across + Math.min(across - 1, Math.floor(i * across));
  };
  const members: number[][] = Array.from({ length: across * up }, () => []);
  for (let e = 0; e < elementCount; e++) members[tileOf(e)]!.push(e);
  const faces = new Uint32Array((TRIANGLES.length + CORNERS.length) * elementCount);
  const tiles: Tile[] = [];
  let [fine, coarse] = [0, TRIANGLES.length * elementCount];
  for (const of of members) {
    if (!of.length) continue;
    const box: Tile["box"] = [Infinity, Infinity, -Infinity, -Infinity];
    tiles.push({ box, fine: [fine, of.length * TRIANGLES.length], coarse: [coarse, of.length * CORNERS.length] });
    for (const e of of) {
      for (const k of TRIANGLES) faces[fine++] = elements[9 * e + k]!;
      for (const k of CORNERS) faces[coarse++] = elements[9 * e + k]!;
      box[0] = Math.min(box[0], boxes[4 * e]!);
      box[1] = Math.min(box[1], boxes[4 * e + 1]!);
      box[2] = Math.max(box[2], boxes[4 * e + 2]!);
      box[3] = Math.max(box[3], boxes[4 * e + 3]!);
    }
  }
  return { faces, tiles, side: Math.sqrt(area / Math.max(elementCount, 1)) };
}

/** Return the parts (start, count) of the faces to draw: of the tiles that a box touches; neighbours are joined. */
export function partsIn(
  tiling: Tiling,
  [x0, y0, x1, y1]: readonly [number, number, number, number],
  coarse: boolean,
): [number, number][] {
  const parts: [number, number][] = [];
  for (const tile of tiling.tiles) {
    if (tile.box[0] > x1 || tile.box[2] < x0 || tile.box[1] > y1 || tile.box[3] < y0) continue;
    const [start, count] = coarse ? tile.coarse : tile.fine;
    const last = parts[parts.length - 1];
    if (last && last[0] + last[1] === start) last[1] += count;
    else parts.push([start, count]);
  }
  return parts;
}

/** From elements of fewer pixels than this, nobody sees whether eight triangles draw one or two. */
export const SMALL = 3.5;

/** Return the ends of the lines that draw every element's sides, two lines for each side, each side once. */
export function linesOf(mesh: Mesh): Uint32Array {
  const { elements, elementCount } = mesh;
  const seen = new Uint8Array(mesh.nodeCount);
  const lines: number[] = [];
  for (let e = 0; e < elementCount; e++)
    for (const [from, to, middle] of SIDES) {
      const [a, b, c] = [elements[9 * e + from]!, elements[9 * e + to]!, elements[9 * e + middle]!];
      if (seen[c]) continue;
      seen[c] = 1;
      lines.push(a, c, c, b);
    }
  return Uint32Array.from(lines);
}

/** Return the sides (end, middle, end) that belong to one element only: edges, and borders of two sections. */
export function borderOf(mesh: Mesh): Uint32Array {
  const { elements, elementCount } = mesh;
  const times = new Uint8Array(mesh.nodeCount);
  for (let e = 0; e < elementCount; e++) for (const [, , middle] of SIDES) times[elements[9 * e + middle]!]! += 1;
  const sides: number[] = [];
  for (let e = 0; e < elementCount; e++)
    for (const [from, to, middle] of SIDES) {
      const node = elements[9 * e + middle]!;
      if (times[node] === 1) sides.push(elements[9 * e + from]!, node, elements[9 * e + to]!);
    }
  return Uint32Array.from(sides);
}

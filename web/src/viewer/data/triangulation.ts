// Triangles, sides and border of a mesh.
import { type Box, elementBoxes, extend } from "./boxes";
import type { Mesh } from "./scene";
import { CORNERS, SIDES, TRIANGLES } from "./shape-functions";

/** A part of a mesh that is drawn or left out together: its box [m], and where its triangles are in the list. */
export interface Tile {
  box: Box;
  fine: Range;
  coarse: Range;
}

/** A part of a list. */
export type Range = [start: number, count: number];

/** Triangles of a mesh, tile by tile: first eight for each element, then again two for each, for a view from afar. */
export interface Tiling {
  triangles: Uint32Array; // nodes, three for each
  tiles: Tile[];
  side: number; // of a usual element [m]
}

/** Elements in a tile, about. */
const TILE = 300;

/** Return a mesh's triangles in square tiles, so that only visible ones have to be drawn. */
export function makeTiling(mesh: Mesh): Tiling {
  const { elements, elementCount } = mesh;
  const { boxes, total } = elementBoxes(mesh);
  const triangles = new Uint32Array((TRIANGLES.length + CORNERS.length) * elementCount);
  const tiles: Tile[] = [];
  let area = 0;
  let [fine, coarse] = [0, TRIANGLES.length * elementCount];
  for (const members of groupByTile(boxes, total, elementCount)) {
    if (!members.length) continue;
    const boxOf = (e: number) => [...boxes.subarray(4 * e, 4 * e + 4)] as Box;
    const box = boxOf(members[0]!);
    const [fineCount, coarseCount] = [members.length * TRIANGLES.length, members.length * CORNERS.length];
    tiles.push({ box, fine: [fine, fineCount], coarse: [coarse, coarseCount] });
    for (const e of members) {
      for (const k of TRIANGLES) triangles[fine++] = elements[9 * e + k]!;
      for (const k of CORNERS) triangles[coarse++] = elements[9 * e + k]!;
      const [x0, y0, x1, y1] = boxOf(e);
      extend(box, x0, y0, x1, y1);
      area += (x1 - x0) * (y1 - y0);
    }
  }
  return { triangles, tiles, side: Math.sqrt(area / Math.max(elementCount, 1)) };
}

/** Return the elements of each tile, by the middles of their boxes. */
function groupByTile(boxes: Float64Array, [x0, y0, x1, y1]: Box, count: number): number[][] {
  const side = Math.max(Math.sqrt(((x1 - x0) * (y1 - y0) * TILE) / Math.max(count, 1)), 1e-9);
  const across = Math.min(32, Math.max(1, Math.ceil((x1 - x0) / side)));
  const up = Math.min(32, Math.max(1, Math.ceil((y1 - y0) / side)));
  const tiles: number[][] = Array.from({ length: across * up }, () => []);
  for (let e = 0; e < count; e++) {
    const x = ((boxes[4 * e]! + boxes[4 * e + 2]!) / 2 - x0) / (x1 - x0 || 1);
    const y = ((boxes[4 * e + 1]! + boxes[4 * e + 3]!) / 2 - y0) / (y1 - y0 || 1);
    tiles[Math.min(up - 1, Math.floor(y * up)) * across + Math.min(across - 1, Math.floor(x * across))]!.push(e);
  }
  return tiles;
}

/** Return the triangles to draw: those of the tiles that a box touches; neighboring parts of the list are joined. */
export function visibleRanges(tiling: Tiling, [x0, y0, x1, y1]: Readonly<Box>, coarse: boolean): Range[] {
  const ranges: Range[] = [];
  for (const tile of tiling.tiles) {
    if (tile.box[0] > x1 || tile.box[2] < x0 || tile.box[1] > y1 || tile.box[3] < y0) continue;
    const [start, count] = coarse ? tile.coarse : tile.fine;
    const last = ranges.at(-1);
    if (last && last[0] + last[1] === start) last[1] += count;
    else ranges.push([start, count]);
  }
  return ranges;
}

/** Return the ends of the lines along every element's sides, two lines for each side, each side once. */
export function sideLines(mesh: Mesh): Uint32Array {
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

/** Return the ends of the lines along sides that belong to one element only: edges, and borders of two sections. */
export function borderLines(mesh: Mesh): Uint32Array {
  const { elements } = mesh;
  const times = new Uint8Array(mesh.nodeCount);
  for (let e = 0; e < mesh.elementCount; e++) for (const [, , middle] of SIDES) times[elements[9 * e + middle]!]! += 1;
  const lines = sideLines(mesh);
  // of the two lines of a side, the middle is the end of the first
  return lines.filter((_, i) => times[lines[4 * Math.floor(i / 4) + 1]!] === 1);
}

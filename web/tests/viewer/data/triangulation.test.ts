import { describe, expect, it } from "vitest";
import type { Mesh } from "../../../src/viewer/data/scene";
import { borderLines, makeTiling, sideLines, visibleRanges } from "../../../src/viewer/data/triangulation";
import { beside, grid, trianglesOf } from "../synthetic";

function areaOf(mesh: Mesh, faces: ArrayLike<number>, start = 0, count = faces.length): number {
  let area = 0;
  for (let f = start; f < start + count; f += 3) {
    const [a, b, c] = [0, 1, 2].map(
      (k) => [mesh.nodes[2 * faces[f + k]!]!, mesh.nodes[2 * faces[f + k]! + 1]!] as const,
    );
    area += ((b![0] - a![0]) * (c![1] - a![1]) - (c![0] - a![0]) * (b![1] - a![1])) / 2;
  }
  return area;
}

describe("the triangles of a mesh", () => {
  const mesh = grid(
    60,
    40,
    (x, y) => [6 * x, 4 * y],
    (i, j) => !(i > 30 && j > 20),
  );
  const area = 24 - 2.9 * 1.9;

  it("fill it once, all counter-clockwise", () => {
    const faces = trianglesOf(mesh);
    expect(areaOf(mesh, faces)).toBeCloseTo(area, 3);
    for (let f = 0; f < faces.length; f += 3) expect(areaOf(mesh, faces, f, 3)).toBeGreaterThan(0);
  });

  it("fill it once in tiles too, fine and coarse", () => {
    const tiling = makeTiling(mesh);
    expect(tiling.tiles.length).toBeGreaterThan(4);
    for (const coarse of [false, true]) {
      const parts = visibleRanges(tiling, [-1e9, -1e9, 1e9, 1e9], coarse);
      expect(parts).toHaveLength(1);
      expect(areaOf(mesh, tiling.triangles, ...parts[0]!)).toBeCloseTo(area, 3);
    }
    expect(tiling.side).toBeCloseTo(0.1, 3);
  });

  it("leave out what is not seen, and nothing that is", () => {
    const tiling = makeTiling(mesh);
    const box = [1, 1, 1.5, 1.4] as const;
    const parts = visibleRanges(tiling, box, false);
    expect(parts.reduce((sum, [, count]) => sum + count, 0)).toBeLessThan(trianglesOf(mesh).length / 2);
    // every element that touches the box is there
    const seen = new Set(parts.flatMap(([start, count]) => [...tiling.triangles.subarray(start, start + count)]));
    for (let i = 0; i < mesh.nodeCount; i++) {
      const [x, y] = [mesh.nodes[2 * i]!, mesh.nodes[2 * i + 1]!];
      if (x > box[0] && x < box[2] && y > box[1] && y < box[3]) expect(seen.has(i)).toBe(true);
    }
    expect(visibleRanges(tiling, [100, 100, 101, 101], false)).toEqual([]);
  });
});

describe("the sides of a mesh", () => {
  it("are drawn once each", () => {
    // 3 x 2 elements: 3 * 3 + 4 * 2 = 17 sides, two lines of two ends for each
    expect(sideLines(grid(3, 2))).toHaveLength(17 * 4);
  });

  it("are borders where they belong to one element only, also between sections", () => {
    expect(borderLines(grid(3, 2))).toHaveLength(10 * 4);
    expect(
      borderLines(
        beside(
          grid(3, 2),
          grid(3, 2, (x, y) => [1 + x, y]),
        ),
      ),
    ).toHaveLength(20 * 4);
  });
});

import { describe, expect, it } from "vitest";
import { Locator } from "../../../src/viewer/data/point-location";
import type { Mesh } from "../../../src/viewer/data/scene";
import { shapeDerivatives, shapeFunctions } from "../../../src/viewer/data/shape-functions";
import { beside, grid, type Map2, nodal, randoms } from "../synthetic";

/** Where a place of an element is. */
function at(mesh: Mesh, element: number, xi: number, eta: number): [number, number] {
  const N = shapeFunctions(xi, eta);
  let [x, y] = [0, 0];
  for (let a = 0; a < 9; a++) {
    const node = mesh.elements[9 * element + a]!;
    x += N[a]! * mesh.nodes[2 * node]!;
    y += N[a]! * mesh.nodes[2 * node + 1]!;
  }
  return [x, y];
}

describe("the nine-node functions", () => {
  const nodes = [
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
    [0, -1],
    [1, 0],
    [0, 1],
    [-1, 0],
    [0, 0],
  ] as const;

  it("are one at their own node and zero at the others", () => {
    for (const [a, [xi, eta]] of nodes.entries())
      for (const [b, value] of shapeFunctions(xi, eta).entries()) expect(value).toBeCloseTo(a === b ? 1 : 0, 14);
  });

  it("reproduce all products of powers up to two, and their slopes those of these", () => {
    for (const [i, j] of [
      [0, 0],
      [1, 0],
      [2, 1],
      [2, 2],
      [0, 2],
    ] as const) {
      const at = ([x, y]: readonly [number, number]) => x ** i * y ** j;
      const [xi, eta] = [0.37, -0.61];
      const sum = (of: number[]) => of.reduce((total, value, a) => total + value * at(nodes[a]!), 0);
      expect(sum(shapeFunctions(xi, eta))).toBeCloseTo(at([xi, eta]), 13);
      const [dxi, deta] = shapeDerivatives(xi, eta);
      expect(sum(dxi)).toBeCloseTo(i ? i * xi ** (i - 1) * eta ** j : 0, 13);
      expect(sum(deta)).toBeCloseTo(j ? j * xi ** i * eta ** (j - 1) : 0, 13);
    }
  });
});

describe("a locator", () => {
  const wavy: Map2 = (x, y) => [9 * x + 0.35 * Math.sin(7 * y) + 0.2 * y, 5 * y + 0.25 * Math.sin(9 * x)];
  // a quarter of a ring from radius 2 to 3: its sides are arcs, nearly
  const ring: Map2 = (x, y) => [(2 + x) * Math.cos((y * Math.PI) / 2), (2 + x) * Math.sin((y * Math.PI) / 2)];

  it.each([
    ["distorted elements", grid(12, 9, wavy)],
    ["elements with curved sides", grid(3, 4, ring)],
  ])("finds places within %s", (_, mesh) => {
    const locator = new Locator(mesh);
    const random = randoms(7);
    for (let i = 0; i < 3000; i++) {
      const element = Math.floor(random() * mesh.elementCount);
      const [xi, eta] = [1.98 * random() - 0.99, 1.98 * random() - 0.99];
      const spot = locator.locate(...at(mesh, element, xi, eta));
      expect(spot).not.toBeNull();
      expect(spot!.element).toBe(element);
      expect(spot!.xi).toBeCloseTo(xi, 6);
      expect(spot!.eta).toBeCloseTo(eta, 6);
    }
  });

  it("follows curved sides, not the chords between nodes", () => {
    const mesh = grid(1, 1, ring);
    const locator = new Locator(mesh);
    // a parabola through the arc's ends and middle: between them it bulges beyond the chords
    const [x, y] = at(mesh, 0, 0.999, 0.5);
    expect(Math.hypot(x, y)).toBeGreaterThan(2.97);
    expect(locator.locate(x, y)).not.toBeNull();
    expect(locator.locate(x * 1.01, y * 1.01)).toBeNull();
    expect(locator.locate(0.1, 0.1)).toBeNull();
  });

  it("interpolates quadratic functions exactly on straight elements", () => {
    const mesh = grid(4, 3, (x, y) => [6 * x + y, 4 * y]);
    const locator = new Locator(mesh);
    const of = (x: number, y: number) => 2 * x * x - x * y + 3 * y * y - 4 * x + 1;
    const values = nodal(mesh, of);
    for (const [x, y] of [
      [1.3, 0.7],
      [5.1, 3.9],
      [0, 0],
      [7, 4],
    ] as const)
      expect(locator.interpolate(values, locator.locate(x, y)!)).toBeCloseTo(of(x, y), 4);
  });

  it("knows holes and the outside, and takes nodes and sides as plate", () => {
    const mesh = grid(
      5,
      5,
      (x, y) => [5 * x, 5 * y],
      (i, j) => !(i === 2 && j === 2),
    );
    const locator = new Locator(mesh);
    expect(locator.locate(2.5, 2.5)).toBeNull();
    expect(locator.locate(5.001, 1)).toBeNull();
    expect(locator.locate(-20, 40)).toBeNull();
    expect(locator.locate(NaN, 1)).toBeNull();
    for (const [x, y] of [
      [2, 2.5],
      [5, 5],
      [0, 0],
      [3, 3],
      [1, 0.5],
    ] as const)
      expect(locator.locate(x, y)).not.toBeNull();
  });

  it("gives the values of one side at a border of two sections", () => {
    const mesh = beside(
      grid(1, 1),
      grid(1, 1, (x, y) => [1 + x, y]),
    );
    const locator = new Locator(mesh);
    const values = nodal(mesh, () => 0).map((_, i) => (i < 9 ? 1 : 2));
    expect(locator.interpolate(values, locator.locate(0.9, 0.5)!)).toBeCloseTo(1);
    expect(locator.interpolate(values, locator.locate(1.1, 0.5)!)).toBeCloseTo(2);
    expect([1, 2]).toContain(Math.round(locator.interpolate(values, locator.locate(1, 0.5)!)));
  });
});

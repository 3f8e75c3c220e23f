// Which element holds a point, and values between the nodes.
import { elementBoxes } from "./boxes";
import type { Mesh } from "./scene";
import { shapeDerivatives, shapeFunctions } from "./shape-functions";

/** A place in an element, on the reference square. */
export interface LocalPoint {
  element: number;
  xi: number;
  eta: number;
}

/** A side of quadratic shape bulges beyond the box of its three nodes by at most an eighth of that box. */
const BULGE = 0.125;
/** A point this far outside the reference square still counts as in the element: nodes are single-precision numbers. */
const TOLERANCE = 1e-4;

export class Locator {
  private readonly low: [number, number];
  private readonly size: [number, number]; // of a bucket [m]
  private readonly count: [number, number]; // of buckets
  private readonly first: Uint32Array; // of each bucket, in `held`
  private readonly members: Uint32Array; // elements, bucket by bucket
  private last = 0; // neighbors are located one after the other

  constructor(private readonly mesh: Mesh) {
    const { boxes, total } = elementBoxes(mesh, BULGE);
    const [x0, y0, x1, y1] = total;
    const [width, height] = [Math.max(x1 - x0, 1e-9), Math.max(y1 - y0, 1e-9)];
    const side = Math.sqrt((width * height) / Math.max(mesh.elementCount, 1));
    const cells = (length: number) => Math.min(2048, Math.max(1, Math.round(length / side)));
    this.low = [x0, y0];
    this.count = [cells(width), cells(height)];
    this.size = [width / this.count[0], height / this.count[1]];
    this.first = new Uint32Array(this.count[0] * this.count[1] + 1);
    const each = (act: (bucket: number, element: number) => void) => {
      for (let e = 0; e < mesh.elementCount; e++) {
        const [i0, j0] = this.bucket(boxes[4 * e]!, boxes[4 * e + 1]!);
        const [i1, j1] = this.bucket(boxes[4 * e + 2]!, boxes[4 * e + 3]!);
        for (let j = j0; j <= j1; j++) for (let i = i0; i <= i1; i++) act(j * this.count[0] + i, e);
      }
    };
    each((bucket) => {
      this.first[bucket + 1]! += 1;
    });
    for (let b = 0; b + 1 < this.first.length; b++) this.first[b + 1]! += this.first[b]!;
    const next = this.first.slice();
    this.members = new Uint32Array(this.first[this.first.length - 1]!);
    each((bucket, element) => {
      this.members[next[bucket]!++] = element;
    });
  }

  /** Return the element that holds a point [m] and the point's place in it, or null outside the mesh. */
  locate(x: number, y: number): LocalPoint | null {
    const [i, j] = [(x - this.low[0]) / this.size[0], (y - this.low[1]) / this.size[1]];
    if (!(i >= -TOLERANCE && j >= -TOLERANCE && i <= this.count[0] + TOLERANCE && j <= this.count[1] + TOLERANCE))
      return null;
    const again = this.locateIn(this.last, x, y);
    if (again && distanceFromCenter(again) <= 1) return again;
    const [column, row] = this.bucket(x, y);
    const bucket = row * this.count[0] + column;
    let best: LocalPoint | null = null;
    for (let k = this.first[bucket]!; k < this.first[bucket + 1]!; k++) {
      const spot = this.locateIn(this.members[k]!, x, y);
      if (spot && (best === null || distanceFromCenter(spot) < distanceFromCenter(best))) best = spot;
      if (best && distanceFromCenter(best) <= 1) break;
    }
    if (!best || distanceFromCenter(best) > 1 + TOLERANCE) return null;
    this.last = best.element;
    return best;
  }

  /** Return nodal values at a place, by the nine shape functions. */
  interpolate(values: Float32Array, spot: LocalPoint): number {
    const N = shapeFunctions(spot.xi, spot.eta);
    const { elements } = this.mesh;
    let sum = 0;
    for (let a = 0; a < 9; a++) sum += N[a]! * values[elements[9 * spot.element + a]!]!;
    return sum;
  }

  private bucket(x: number, y: number): [number, number] {
    const cell = (offset: number, axis: 0 | 1) =>
      Math.min(this.count[axis] - 1, Math.max(0, Math.floor(offset / this.size[axis])));
    return [cell(x - this.low[0], 0), cell(y - this.low[1], 1)];
  }

  /** Return the place of a point in one element by Newton's method, or null if it is nowhere near. */
  private locateIn(element: number, x: number, y: number): LocalPoint | null {
    const { nodes, elements } = this.mesh;
    if (element >= this.mesh.elementCount) return null;
    let [xi, eta] = [0, 0];
    for (let step = 0; step < 20; step++) {
      const N = shapeFunctions(xi, eta);
      const [dxi, deta] = shapeDerivatives(xi, eta);
      let [dx, dy, a, b, c, d] = [x, y, 0, 0, 0, 0];
      for (let k = 0; k < 9; k++) {
        const node = 2 * elements[9 * element + k]!;
        const [X, Y] = [nodes[node]!, nodes[node + 1]!];
        dx -= N[k]! * X;
        dy -= N[k]! * Y;
        a += dxi[k]! * X;
        b += dxi[k]! * Y;
        c += deta[k]! * X;
        d += deta[k]! * Y;
      }
      const det = a * d - b * c;
      if (det === 0) return null;
      const next = [xi + (d * dx - c * dy) / det, eta + (a * dy - b * dx) / det] as const;
      // outside, Newton's steps are only followed to the neighborhood
      const [u, v] = [clamp(next[0]), clamp(next[1])];
      const moved = Math.max(Math.abs(u - xi), Math.abs(v - eta));
      [xi, eta] = [u, v];
      if (moved < 1e-10) break;
    }
    return { element, xi, eta };
  }
}

function clamp(value: number): number {
  return Math.min(1.5, Math.max(-1.5, value));
}

function distanceFromCenter(spot: LocalPoint): number {
  return Math.max(Math.abs(spot.xi), Math.abs(spot.eta));
}

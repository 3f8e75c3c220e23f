// Triangles, sides and border of a mesh.
import type { Mesh } from "./scene";
import { SIDES, TRIANGLES } from "./shape";

/** Return the nodes of all triangles: eight for each element. */
export function facesOf(mesh: Mesh): Uint32Array {
  const { elements, elementCount } = mesh;
  const faces = new Uint32Array(24 * elementCount);
  for (let e = 0; e < elementCount; e++) for (let k = 0; k < 24; k++) faces[24 * e + k] = elements[9 * e + TRIANGLES[k]!]!;
  return faces;
}

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

/** Return which nodes lie on the plate's edges: on sides of one element only that have no twin in the same place. */
export function edgeNodes(mesh: Mesh): Uint8Array {
  const sides = borderOf(mesh);
  const { nodes } = mesh;
  // nodes of both sections stand in exactly the same place
  const place = (node: number) => `${nodes[2 * node]} ${nodes[2 * node + 1]}`;
  const times = new Map<string, number>();
  for (let k = 1; k < sides.length; k += 3) times.set(place(sides[k]!), (times.get(place(sides[k]!)) ?? 0) + 1);
  const on = new Uint8Array(mesh.nodeCount);
  const places = new Set<string>();
  for (let k = 0; k < sides.length; k += 3)
    if (times.get(place(sides[k + 1]!)) === 1) for (let j = 0; j < 3; j++) places.add(place(sides[k + j]!));
  for (const node of new Set(sides)) if (places.has(place(node))) on[node] = 1;
  return on;
}

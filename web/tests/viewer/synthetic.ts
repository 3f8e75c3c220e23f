// Small meshes and scenes made up for tests.

import {
  type Block,
  type Combination,
  decodeScene,
  type Field,
  type Head,
  type Mesh,
  type Plan,
  type Scene,
} from "../../src/viewer/data/scene";
import { makeTiling } from "../../src/viewer/data/triangulation";

const COLUMN = [0, 2, 2, 0, 1, 2, 1, 0, 1];
const ROW = [0, 0, 2, 2, 0, 1, 2, 1, 1];

export type Map2 = (x: number, y: number) => [number, number];

/** A mesh of nx x ny elements on the unit square, its nodes moved by a map. */
export function grid(
  nx: number,
  ny: number,
  to: Map2 = (x, y) => [x, y],
  keep: (i: number, j: number) => boolean = () => true,
): Mesh {
  const across = 2 * nx + 1;
  const nodes = new Float32Array(2 * across * (2 * ny + 1));
  for (let j = 0; j <= 2 * ny; j++)
    for (let i = 0; i <= 2 * nx; i++) nodes.set(to(i / (2 * nx), j / (2 * ny)), 2 * (j * across + i));
  const elements: number[] = [];
  for (let j = 0; j < ny; j++)
    for (let i = 0; i < nx; i++)
      if (keep(i, j)) for (let a = 0; a < 9; a++) elements.push((2 * j + ROW[a]!) * across + 2 * i + COLUMN[a]!);
  return {
    origin: [0, 0],
    nodes: Float64Array.from(nodes),
    elements: Uint32Array.from(elements),
    section: null,
    nodeCount: nodes.length / 2,
    elementCount: elements.length / 9,
  };
}

/** Two meshes in one, sharing no nodes: as two sections of a plate are. */
export function beside(a: Mesh, b: Mesh): Mesh {
  return {
    origin: [0, 0],
    nodes: Float64Array.from([...a.nodes, ...b.nodes]),
    elements: Uint32Array.from([...a.elements, ...b.elements.map((node) => node + a.nodeCount)]),
    section: Uint16Array.from([...Array<number>(a.elementCount).fill(0), ...Array<number>(b.elementCount).fill(1)]),
    nodeCount: a.nodeCount + b.nodeCount,
    elementCount: a.elementCount + b.elementCount,
  };
}

/** The nodes of all triangles: eight for each element. */
export function trianglesOf(mesh: Mesh): Uint32Array {
  return makeTiling(mesh).triangles.subarray(0, 24 * mesh.elementCount);
}

/** Nodal values of a function. */
export function nodal(mesh: Mesh, of: (x: number, y: number) => number): Float32Array {
  return Float32Array.from({ length: mesh.nodeCount }, (_, i) => of(mesh.nodes[2 * i]!, mesh.nodes[2 * i + 1]!));
}

/** Collects blocks of numbers as the packed scene holds them. */
export class Packer {
  private readonly bytes: number[] = [];

  add(values: ArrayLike<number>, type: Block["type"], shape: number[], scale = 1, shift = 0): Block {
    while (this.bytes.length % 8) this.bytes.push(0);
    const offset = this.bytes.length;
    const raw = Array.from(values, (value) => (type === "f32" ? value : Math.round((value - shift) / scale)));
    const made = { u8: Uint8Array, u16: Uint16Array, u32: Uint32Array, i32: Int32Array, f32: Float32Array }[type].from(
      raw,
    );
    this.bytes.push(...new Uint8Array(made.buffer));
    return { offset, shape, type, scale, shift };
  }

  packed(head: Head): ArrayBuffer {
    const text = new TextEncoder().encode(JSON.stringify(head));
    const start = Math.ceil((4 + text.length) / 8) * 8;
    const buffer = new ArrayBuffer(start + this.bytes.length);
    new DataView(buffer).setUint32(0, text.length, true);
    new Uint8Array(buffer).set(text, 4);
    new Uint8Array(buffer).set(this.bytes, start);
    return buffer;
  }
}

export const FIELDS: Field[] = [
  ["settlement", "w", "mm", true],
  ["pressure", "p", "kPa", false],
  ["moment_x", "m_x", "kNm/m", true],
  ["moment_y", "m_y", "kNm/m", true],
  ["moment_xy", "m_xy", "kNm/m", true],
  ["contact", "", "", true],
].map(
  ([name, symbol, unit, signed]) =>
    ({ name, symbol, unit, signed, meaning: `${String(name)} of the plate`, averaged: "" }) as Field,
);

export const NO_PLAN: Plan = {
  bounds: [0, 0, 1, 1],
  outline: [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ],
  openings: [],
  zones: [],
  columns: [],
  supports: [],
  loads: [],
  boreholes: [],
  soil_zones: [],
  voids: [],
  lines: [],
  strips: [],
  points: [],
};

export interface Given {
  name: string;
  state?: string;
  certified?: boolean;
  refused?: string;
  fields?: Record<string, (x: number, y: number) => number>; // those not given are zero; none: no values
}

/** The buffer of a scene: fields as functions of the place, packed as single-precision numbers. */
export function packedScene(mesh: Mesh, given: Given[], change: Partial<Head> = {}): ArrayBuffer {
  const packer = new Packer();
  const blocks = {
    nodes: packer.add(mesh.nodes, "f32", [mesh.nodeCount, 2]),
    elements: packer.add(mesh.elements, "u32", [mesh.elementCount, 9]),
    ...(mesh.section ? { section: packer.add(mesh.section, "u16", [mesh.elementCount]) } : {}),
  };
  const combinations = given.map(
    ({ name, state = "ultimate", certified = true, refused, fields }, i): Combination => ({
      name,
      number: i + 1,
      limit_state: state,
      factors: [],
      refused: refused ?? null,
      certified: certified && refused === undefined,
      values: fields
        ? Object.fromEntries(
            FIELDS.map((each) => [
              each.name,
              packer.add(nodal(mesh, fields[each.name] ?? (() => 0)), "f32", [mesh.nodeCount]),
            ]),
          )
        : null,
      extremes: {},
    }),
  );
  return packer.packed({
    format: 3,
    title: "",
    version: "0",
    plan: NO_PLAN,
    mesh: blocks,
    fields: FIELDS,
    combinations,
    left_out: [],
    ...change,
  });
}

export function sceneOf(mesh: Mesh, given: Given[], change: Partial<Head> = {}): Scene {
  return decodeScene(packedScene(mesh, given, change));
}

/** Random numbers in 0 .. 1, the same in every run. */
export function randoms(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

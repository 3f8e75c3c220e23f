// One solved model as the browser gets it: a JSON head, and blocks of numbers behind it.
import { say } from "../shared/language";

/** Arrays of the numbers in a block, by its type. */
const ARRAYS = { u8: Uint8Array, u16: Uint16Array, u32: Uint32Array, i32: Int32Array, f32: Float32Array } as const;

export type Point = [number, number];
export type Ring = Point[];

export interface Block {
  offset: number; // bytes, in the data
  shape: number[];
  type: keyof typeof ARRAYS;
  scale: number; // value = scale * raw + shift
  shift: number;
}

/** A field, or a sum of other fields with their factors. */
export type Values = Block | { sum: [number, Block][] };

/** A part of the model, by its place in the case file. */
interface Part {
  path: string;
}
interface Named extends Part {
  name: string;
}
export interface Area extends Part {
  ring: Ring;
}
export interface Zone extends Area {
  thickness: number;
  name?: string;
  level?: number; // [m] of the top side of a pit
  wall?: number; // [m] thickness of its walls
}
export interface Place extends Named {
  x: number;
  y: number;
}
export interface Column extends Place {
  ring: Ring;
}
export interface Wall extends Named {
  points: Point[];
  pieces?: Point[][]; // between its doors
  thickness: number; // [m]
}

export interface Beam extends Named {
  points: Point[];
  width: number; // [m], 0 without one
}
export interface Support extends Named {
  kind: "point" | "line";
  points: Point[];
  acts: string;
  elastic: boolean;
}
export interface Load extends Named {
  kind: string; // point, line, patch, area, uniform, self weight, ...
  case: string;
  points?: Point[];
  pieces?: Point[][]; // parts of walls through which it acts, the points are those of one of them
  ring?: Ring;
  holes?: Ring[]; // of a loaded area
  footprint?: Ring; // of a point load that has one
  parts: [string, number, string][]; // symbol, value without factor, unit
  on?: string; // "ground" if it presses on the ground beside the slab
  everywhere?: boolean; // whether it acts all over a slab
  varies?: boolean; // whether the pressure varies over the area
}
export interface Line extends Named {
  start: Point;
  end: Point;
}
export interface Strip extends Line {
  width: number;
}

export interface BuildingAxis extends Named {
  points: Point[];
  bubble: Point; // where its name is
}

export interface FurtherPlate extends Area {
  name: string;
  thickness: number; // [m] outside its zones
  openings: Area[];
  zones: Zone[];
}

export interface FrameLine {
  path: string;
  points: Point[];
}

/** How lengths are shown: the unit of places, that of thicknesses and settlements, and how many make a meter. */
export interface Lengths {
  unit: string;
  per_meter: number;
  small: string;
  small_per_meter: number;
}

export interface Plan {
  lengths?: Lengths; // how they are shown; all in a plan are in meters
  bounds: [number, number, number, number]; // x0, y0, x1, y1 of the plate [m]
  outline: Ring;
  thickness?: number; // [m] outside all zones
  openings: Area[];
  zones: Zone[];
  plates?: FurtherPlate[]; // beside the first one
  axes?: BuildingAxis[];
  columns: Column[];
  walls?: Wall[];
  beams?: Beam[];
  building?: FrameLine[]; // beams of the building above
  supports: Support[];
  loads: Load[];
  boreholes: Place[];
  soil_zones: Area[];
  voids: Area[];
  lines: Line[];
  strips: Strip[];
  points: Place[];
}

export interface Field {
  name: string;
  symbol: string;
  unit: string;
  meaning: string;
  averaged: string;
  signed: boolean;
}

export type Extreme = [value: number, x: number, y: number];

interface Range {
  min: Extreme;
  max: Extreme;
}

/** What a support or a wall does to the plate: its force with an arrow and its unit, the most along a line. */
export interface Reaction {
  at: Point;
  text: string;
}

/** Bars that are laid together, all over the slab or in a zone, which has rings; what they are, and a place for that. */
export interface BarSet {
  layer: string;
  zone: string;
  rings: Ring[];
  at: Point;
  text: string;
}

export interface Combination {
  name: string;
  number: number;
  limit_state: string;
  factors: [string, number][];
  refused: string | null; // "FOUNDATION FAILS: why" or "not solved: why"
  certified: boolean;
  values: Record<string, Values> | null;
  extremes: Record<string, Range>; // of "line_force" along the plate's edges, where the ground has one
  reactions?: Reaction[]; // of supports and walls on the plate
  minus?: string | null; // in a difference the combination that is subtracted, null where there is none
}

export interface Head {
  format: number;
  title: string;
  version: string;
  plan: Plan;
  mesh: { origin?: Point; nodes: Block; elements: Block; section?: Block }; // nodes are measured from the origin
  fields: Field[];
  combinations: Combination[];
  left_out: string[];
  bars?: BarSet[];
  difference?: "reference" | "combination"; // what is subtracted in a difference of results
}

/** Nine-node quadrilaterals: four corners, four midsides, center, counter-clockwise. */
export interface Mesh {
  origin: Point; // a place near the plate, from which pictures measure: single precision is too coarse far away [m]
  nodes: Float64Array; // x, y of each node [m]
  elements: Uint32Array; // nine nodes of each element
  section: Uint16Array | null; // of each element: 0 outside all zones, else the zone's number
  nodeCount: number;
  elementCount: number;
}

export interface Scene {
  head: Head;
  data: ArrayBuffer;
  start: number; // of the data in the buffer [bytes]
  mesh: Mesh;
}

/** A scene that cannot be read, with the reason in words for the user. */
export class SceneError extends Error {}

const FORMAT = 3;

/** Read a packed scene: 4 bytes length, JSON, padding to a multiple of 8, data. */
export function decodeScene(buffer: ArrayBuffer): Scene {
  if (buffer.byteLength < 4) throw new SceneError("The results are empty.");
  const length = new DataView(buffer).getUint32(0, true);
  if (4 + length > buffer.byteLength) throw new SceneError("The results are incomplete.");
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))) as Head;
  if (head.format !== FORMAT)
    throw new SceneError(
      say("The results have format {format}; this page reads format {known}.", { format: head.format, known: FORMAT }),
    );
  const start = Math.ceil((4 + length) / 8) * 8;
  const origin = head.mesh.origin ?? [0, 0];
  const nodes = Float64Array.from(readNumbers(buffer, start, head.mesh.nodes), (value, i) => value + origin[i % 2]!);
  const raw = readRaw(buffer, start, head.mesh.elements);
  const elements = raw instanceof Uint32Array ? raw : Uint32Array.from(raw);
  const nodeCount = nodes.length / 2;
  for (const node of elements)
    if (node >= nodeCount) throw new SceneError("The results are damaged: an element refers to a missing node.");
  const section = head.mesh.section ? Uint16Array.from(readRaw(buffer, start, head.mesh.section)) : null;
  const mesh = { origin, nodes, elements, section, nodeCount, elementCount: elements.length / 9 };
  return { head, data: buffer, start, mesh };
}

/** Read base64 of a gzipped packed scene, as a report holds it. */
export async function decodeGzipBase64(text: string): Promise<Scene> {
  if (typeof DecompressionStream === "undefined")
    throw new SceneError(
      "This browser is too old to unpack the results (no DecompressionStream). Use a version from 2023 or later.",
    );
  const bytes = decodeBase64(text);
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  let buffer: ArrayBuffer;
  try {
    buffer = await new Response(unpacked).arrayBuffer();
  } catch {
    throw new SceneError("The results in this file are damaged and cannot be unpacked.");
  }
  return decodeScene(buffer);
}

/** Return the numbers of a field, in its own units. */
export function readValues(scene: Scene, of: Values): Float32Array {
  if (!("sum" in of)) return readNumbers(scene.data, scene.start, of);
  // 64 bits, as terms may cancel each other
  const values = new Float64Array(scene.mesh.nodeCount);
  for (const [factor, block] of of.sum) {
    const raw = readRaw(scene.data, scene.start, block);
    for (let i = 0; i < raw.length; i++) values[i]! += factor * (block.scale * raw[i]! + block.shift);
  }
  return Float32Array.from(values);
}

function readNumbers(buffer: ArrayBuffer, start: number, of: Block): Float32Array {
  const raw = readRaw(buffer, start, of);
  if (raw instanceof Float32Array && of.scale === 1 && of.shift === 0) return raw;
  const values = new Float32Array(raw.length);
  const { scale, shift } = of;
  for (let i = 0; i < raw.length; i++) values[i] = scale * raw[i]! + shift;
  return values;
}

function readRaw(buffer: ArrayBuffer, start: number, of: Block): InstanceType<(typeof ARRAYS)[Block["type"]]> {
  const count = of.shape.reduce((product, side) => product * side, 1);
  const offset = start + of.offset;
  const Numbers = ARRAYS[of.type];
  if (offset + count * Numbers.BYTES_PER_ELEMENT > buffer.byteLength)
    throw new SceneError("The results are incomplete.");
  return new Numbers(buffer, offset, count);
}

function decodeBase64(text: string): Uint8Array<ArrayBuffer> {
  const letters = atob(text.replace(/\s+/g, ""));
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

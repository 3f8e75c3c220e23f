// Draws a field on the mesh, seen from above or bent in space: by the graphics card where there is one, else by the
// processor.
import type { Camera } from "three";
import type { Box } from "../data/boxes";
import type { ColorScale } from "../data/color-scale";
import type { Mesh, Point } from "../data/scene";
import { type Range, type Tiling, visibleRanges } from "../data/triangulation";
import type { Rgb } from "../shared/palette";
import type { Theme } from "../shared/theme";

/** What is shown on the mesh. */
export interface Picture {
  values: Float32Array; // of the nodes
  contact: Float32Array | null; // of the nodes: negative in contact, positive elsewhere
  settlement: Float32Array | null; // of the nodes [mm]; null: the plate is flat and not lit
  scale: ColorScale;
  lines: boolean; // between the bands
  mesh: boolean; // the elements' sides
}

/** From where the mesh is seen, and how large the drawing is. */
export interface View {
  camera: Camera;
  width: number; // [px of style sheets]
  height: number;
  ratio: number; // dots per pixel
  scale: number; // pixels per meter, about
  exaggeration: number; // how high a unit of the settlement is drawn [m]
  box: Readonly<Box>; // the part of the plan that is seen [m]
}

/** Lines in space: x, y, z of both ends of each [m]. */
export interface Lines {
  flat: number[]; // where the plate was before it bent
  columns: number[];
}

export interface FieldRenderer {
  readonly canvas: HTMLCanvasElement;
  /** Whether a graphics card draws. */
  readonly accelerated: boolean;
  /** Time that the last drawing took [ms], 0 where nobody waits for it. */
  readonly cost: number;
  setMesh(mesh: Mesh | null): void;
  setPicture(picture: Picture | null): void;
  setLines(lines: Lines): void;
  setTheme(theme: Theme): void;
  draw(view: View): void;
}

/** Return points x, y, z [m] measured from an origin in plan, in single precision. */
export function fromOrigin(points: ArrayLike<number>, [x, y]: Point): Float32Array {
  return Float32Array.from(points, (value, i) => value - [x, y, 0][i % 3]!);
}

/** Return the mesh's nodes as points in space, measured from its origin. */
export function nodesFromOrigin({ nodes, nodeCount, origin }: Mesh): Float32Array {
  const places = new Float32Array(3 * nodeCount);
  for (let i = 0; i < nodeCount; i++) places.set([nodes[2 * i]! - origin[0], nodes[2 * i + 1]! - origin[1]], 3 * i);
  return places;
}

/** How a field looks, whoever draws it. */
export const LOOK = {
  /** How much the elements' sides cover what is below them. */
  sideAlpha: 0.35,
  /** Distance along x between the stripes where there is no contact [px]. */
  stripes: 12,
  /** Light where none falls directly. */
  ambient: 0.5,
  /** Whence the light comes: the lamp is high, at the left and in front. */
  sun: [-0.4506, -0.3505, 0.8211],
} as const;

/** Return the color of the elements' sides: dark where the scale is light in its middle, else light. */
export function sideColor({ diverging }: ColorScale): Rgb {
  return diverging ? [0, 0, 0] : [255, 255, 255];
}

/** Elements smaller than this [dots] look the same in two triangles as in eight. */
const SMALL = 3.5;

/** Return the triangles that a view shows. */
export function rangesIn(tiling: Tiling, { box, scale, ratio }: View): Range[] {
  return visibleRanges(tiling, box, tiling.side * scale * ratio < SMALL);
}

// What draws a field on the mesh: WebGL where there is one, else the processor (see raster.ts).

import type { Scale } from "../data/color-scale";
import type { Mesh } from "../data/scene";
import type { Theme } from "../shared/theme";

/** Which part of the plan is seen: its centre [m] and pixels (of style sheets) per metre. */
export interface Camera {
  x: number;
  y: number;
  scale: number;
}

/** What is seen on the mesh. */
export interface Picture {
  values: Float32Array; // of the nodes
  contact: Float32Array | null; // negative in contact, positive elsewhere
  scale: Scale;
  lines: boolean; // between the bands
  mesh: boolean; // the elements' sides
}

export interface Painter {
  readonly canvas: HTMLCanvasElement;
  /** What drawing takes [ms], as far as is known. */
  readonly cost: number;
  setMesh(mesh: Mesh | null): void;
  setPicture(picture: Picture | null): void;
  setTheme(theme: Theme): void;
  /** Draw now, `ratio` dots for each of width x height pixels. */
  draw(camera: Camera, width: number, height: number, ratio: number): void;
  dispose(): void;
}

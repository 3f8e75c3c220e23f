// Draws a field by the processor alone: for browsers without WebGL or a graphics card behind it.
import { BufferAttribute, Matrix4, Vector3 } from "three";
import { bandOf } from "../data/color-scale";
import type { Mesh, Point } from "../data/scene";
import { borderLines, makeTiling, type Range, sideLines, type Tiling } from "../data/triangulation";
import { type Palette, paletteOf, type Rgb, rgbOf } from "../shared/palette";
import type { Theme } from "../shared/theme";
import {
  type FieldRenderer,
  fromOrigin,
  type Lines,
  LOOK,
  nodesFromOrigin,
  type Picture,
  rangesIn,
  sideColor,
  type View,
} from "./renderer";

type Pixels = Uint8ClampedArray<ArrayBuffer>; // red, green, blue, alpha of each

/** Bands of pixels without a band. */
const NOTHING = 255; // no plate
const OVER = 254;
const UNDER = 253;

/** What each pixel shows. */
export interface Raster {
  width: number;
  height: number;
  bands: Uint8Array;
  lifted: Uint8Array | null; // 1 where there is no contact
  light: Uint8Array | null; // 0 .. 255
  depth: Float32Array; // -1 .. 1
}

/** Fill triangles of a mesh, values linear between their corners; a pixel belongs to the triangle over its center. */
export function rasterize(
  mesh: Mesh,
  triangles: Uint32Array,
  ranges: readonly Readonly<Range>[],
  picture: Picture,
  view: View,
): Raster {
  const [width, height] = dotsOf(view);
  const raster: Raster = {
    width,
    height,
    bands: new Uint8Array(width * height).fill(NOTHING),
    lifted: picture.contact && new Uint8Array(width * height),
    light: picture.settlement && new Uint8Array(width * height),
    depth: new Float32Array(width * height).fill(1),
  };
  const screen = projectNodes(mesh, picture, view);
  for (const [start, count] of ranges)
    for (let f = start; f < start + count; f += 3) {
      const [a, b, c] = [triangles[f]!, triangles[f + 1]!, triangles[f + 2]!];
      const light = picture.settlement ? lightOn(mesh, picture.settlement, view.exaggeration, a, b, c) : 0;
      fillTriangle(raster, picture, screen, a, b, c, light);
    }
  return raster;
}

/** Color a raster: bands with thin lines between them, light, stripes where the plate has lifted, its boundary. */
export function colorize(raster: Raster, picture: Picture, view: View, palette: Palette): Pixels {
  const { width, height, bands, lifted, light } = raster;
  const { scale } = picture;
  const colors: Rgb[] = [...scale.colors];
  colors[OVER] = scale.over;
  colors[UNDER] = scale.under;
  const pixels = new Uint8ClampedArray(4 * width * height);
  const pitch = LOOK.stripes * view.ratio;
  const origin = new Vector3().project(view.camera);
  const anchor = ((origin.x + 1) * width) / 2 - ((1 - origin.y) * height) / 2;
  const [paper, hatch] = [rgbOf(palette.paper), rgbOf(palette.hatch)];
  const boundary: number[] = [];
  for (let y = 0, i = 0; y < height; y++)
    for (let x = 0; x < width; x++, i++) {
      const band = bands[i]!;
      if (band === NOTHING) continue; // stays transparent
      const right = x + 1 < width ? i + 1 : i;
      const below = y + 1 < height ? i + width : i;
      const line = picture.lines && band < UNDER && (isOther(bands[right]!, band) || isOther(bands[below]!, band));
      const shade = (line ? 0.68 : 1) * (light ? light[i]! / 255 : 1);
      const color = colors[band]!;
      const isLifted = lifted !== null && lifted[i] === 1;
      const along = x - y - anchor;
      const isStripe = isLifted && along - Math.floor(along / pitch) * pitch < 1.4 * view.ratio;
      for (let k = 0; k < 3; k++) {
        let part = color[k]! * shade;
        if (isLifted) part = paper[k]! + 0.45 * (part - paper[k]!);
        if (isStripe) part = 0.45 * part + 0.55 * hatch[k]!;
        pixels[4 * i + k] = part;
      }
      pixels[4 * i + 3] = 255;
      if (lifted && (changes(bands, lifted, i, right) || changes(bands, lifted, i, below))) boundary.push(i);
    }
  for (const i of boundary) drawBoundary(raster, pixels, i, 2.2 * view.ratio, 255);
  for (const i of boundary) drawBoundary(raster, pixels, i, 0.9 * view.ratio, 0);
  return pixels;
}

export class SoftwareRenderer implements FieldRenderer {
  readonly canvas = document.createElement("canvas");
  readonly accelerated = false;
  cost = 0;
  private readonly context = this.canvas.getContext("2d", { willReadFrequently: true })!;
  private mesh: Mesh | null = null;
  private tiling: Tiling | null = null;
  private sides: Uint32Array | null = null;
  private border: Uint32Array | null = null;
  private picture: Picture | null = null;
  private lines: Lines | null = null;
  private palette = paletteOf("light");

  setMesh(mesh: Mesh | null): void {
    this.mesh = mesh;
    this.tiling = mesh && makeTiling(mesh);
    this.sides = this.border = this.picture = this.lines = null;
  }

  setPicture(picture: Picture | null): void {
    this.picture = picture;
  }

  setLines(lines: Lines): void {
    this.lines = lines;
  }

  setTheme(theme: Theme): void {
    this.palette = paletteOf(theme);
  }

  draw(view: View): void {
    const begun = performance.now();
    const { mesh, tiling, picture, palette, canvas } = this;
    const [width, height] = dotsOf(view);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    this.context.clearRect(0, 0, width, height);
    if (!mesh || !tiling || !picture) return;
    const raster = rasterize(mesh, tiling.triangles, rangesIn(tiling, view), picture, view);
    const pixels = colorize(raster, picture, view, palette);
    const ink = rgbOf(palette.ink);
    if (picture.mesh) {
      this.sides ??= sideLines(mesh);
      const color = sideColor(picture.scale);
      drawLines(raster, pixels, projectNodes(mesh, picture, view), this.sides, color, LOOK.sideAlpha, view.ratio);
    }
    if (picture.settlement) {
      this.border ??= borderLines(mesh);
      drawLines(raster, pixels, projectNodes(mesh, picture, view), this.border, ink, 1, view.ratio);
    }
    for (const [ends, color] of [
      [this.lines?.flat, rgbOf(palette.ink2)],
      [this.lines?.columns, ink],
    ] as const)
      if (ends)
        drawLines(
          raster,
          pixels,
          projectPoints(fromOrigin(ends, mesh.origin), mesh.origin, view),
          null,
          color,
          1,
          view.ratio,
        );
    this.context.putImageData(new ImageData(pixels, width, height), 0, 0);
    this.cost = performance.now() - begun;
  }
}

function dotsOf({ width, height, ratio }: View): [number, number] {
  return [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
}

/** Whether contact changes between two pixels of the plate. */
function changes(bands: Uint8Array, lifted: Uint8Array, i: number, j: number): boolean {
  return lifted[i] !== lifted[j] && bands[j] !== NOTHING;
}

function isOther(neighbor: number, band: number): boolean {
  return neighbor !== band && neighbor < UNDER;
}

/** Return x and y [dots] and depth of points, measured from an origin, on the screen; the depth of those behind the eye is beyond 1. */
function projectPoints(points: Float32Array, origin: Point, view: View): Float32Array {
  const [width, height] = dotsOf(view);
  const screen = new Matrix4().makeScale(width / 2, -height / 2, 1).setPosition(width / 2, height / 2, 0);
  screen.multiply(view.camera.projectionMatrix).multiply(view.camera.matrixWorldInverse);
  screen.multiply(new Matrix4().makeTranslation(...origin, 0));
  return new BufferAttribute(points, 3).applyMatrix4(screen).array as Float32Array;
}

function projectNodes(mesh: Mesh, { settlement }: Picture, view: View): Float32Array {
  const places = nodesFromOrigin(mesh);
  if (settlement) for (let i = 0; i < mesh.nodeCount; i++) places[3 * i + 2] = -settlement[i]! * view.exaggeration;
  return projectPoints(places, mesh.origin, view);
}

/** Return the light on a triangle, 0 .. 255; both faces are lit alike. */
function lightOn({ nodes }: Mesh, settlement: Float32Array, times: number, a: number, b: number, c: number): number {
  const [ux, uy] = [nodes[2 * b]! - nodes[2 * a]!, nodes[2 * b + 1]! - nodes[2 * a + 1]!];
  const [vx, vy] = [nodes[2 * c]! - nodes[2 * a]!, nodes[2 * c + 1]! - nodes[2 * a + 1]!];
  const [uz, vz] = [(settlement[a]! - settlement[b]!) * times, (settlement[a]! - settlement[c]!) * times];
  const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const cosine = Math.abs(nx * LOOK.sun[0] + ny * LOOK.sun[1] + nz * LOOK.sun[2]) / (Math.hypot(nx, ny, nz) || 1);
  return 255 * (LOOK.ambient + (1 - LOOK.ambient) * cosine);
}

function fillTriangle(
  raster: Raster,
  picture: Picture,
  screen: Float32Array,
  a: number,
  b: number,
  c: number,
  light: number,
): void {
  const [ax, ay, az] = [screen[3 * a]!, screen[3 * a + 1]!, screen[3 * a + 2]!];
  const [bx, by, bz] = [screen[3 * b]!, screen[3 * b + 1]!, screen[3 * b + 2]!];
  const [cx, cy, cz] = [screen[3 * c]!, screen[3 * c + 1]!, screen[3 * c + 2]!];
  if (!(Math.abs(az) < 1 && Math.abs(bz) < 1 && Math.abs(cz) < 1)) return;
  const { width, height, bands, lifted, depth } = raster;
  const y0 = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5));
  const y1 = Math.min(height - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
  const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  if (y0 > y1 || area === 0 || Math.max(ax, bx, cx) < 0 || Math.min(ax, bx, cx) > width) return;
  const { values, contact, scale } = picture;
  const count = scale.colors.length;
  const [va, vb, vc] = [values[a]!, values[b]! - values[a]!, values[c]! - values[a]!];
  for (let y = y0; y <= y1; y++) {
    const middle = y + 0.5;
    const ab = crossRow(ax, ay, bx, by, middle);
    const bc = crossRow(bx, by, cx, cy, middle);
    const ca = crossRow(cx, cy, ax, ay, middle);
    // a row crosses two of the sides, or none
    const [first, second] = [Number.isNaN(ab) ? bc : ab, Number.isNaN(ca) ? bc : ca];
    const x0 = Math.max(0, Math.ceil(Math.min(first, second) - 0.5));
    const x1 = Math.min(width - 1, Math.ceil(Math.max(first, second) - 0.5) - 1);
    for (let x = x0; x <= x1; x++) {
      // how far towards b and c; depth and values are linear in both, values nearly so in perspective
      const s = ((x + 0.5 - ax) * (cy - ay) - (middle - ay) * (cx - ax)) / area;
      const t = ((middle - ay) * (bx - ax) - (x + 0.5 - ax) * (by - ay)) / area;
      const i = y * width + x;
      const z = az + s * (bz - az) + t * (cz - az);
      if (z >= depth[i]!) continue;
      depth[i] = z;
      const band = bandOf(scale, va + s * vb + t * vc);
      bands[i] = band < 0 ? UNDER : band === count ? OVER : band;
      if (raster.light) raster.light[i] = light;
      if (lifted && contact) lifted[i] = (1 - s - t) * contact[a]! + s * contact[b]! + t * contact[c]! > 0 ? 1 : 0;
    }
  }
}

/** Return where a side crosses a row, NaN if it does not; the same for both triangles, so that no pixel is left between. */
function crossRow(px: number, py: number, qx: number, qy: number, y: number): number {
  if (py < y === qy < y) return Number.NaN;
  return py < qy ? px + ((y - py) / (qy - py)) * (qx - px) : qx + ((y - qy) / (py - qy)) * (px - qx);
}

/** Draw the contact boundary around a pixel, between it and those right of it and below. */
function drawBoundary({ width, height, bands }: Raster, pixels: Pixels, i: number, reach: number, gray: number): void {
  const [x, y, far] = [i % width, Math.floor(i / width), Math.ceil(reach)];
  for (let v = Math.max(0, y - far); v <= Math.min(height - 1, y + far); v++)
    for (let u = Math.max(0, x - far); u <= Math.min(width - 1, x + far); u++) {
      if (Math.hypot(u - x - 0.5, v - y - 0.5) > reach || bands[v * width + u] === NOTHING) continue;
      pixels.fill(gray, 4 * (v * width + u), 4 * (v * width + u) + 3);
    }
}

/** Draw lines between projected points where nothing lies before them: pairs of indices, or all points in pairs. */
function drawLines(
  raster: Raster,
  pixels: Pixels,
  screen: Float32Array,
  pairs: Uint32Array | null,
  color: Rgb,
  alpha: number,
  ratio: number,
): void {
  const { width, height, depth } = raster;
  const thick = Math.max(1, Math.round(ratio));
  const count = pairs ? pairs.length : screen.length / 3;
  for (let k = 0; k + 1 < count; k += 2) {
    const [a, b] = pairs ? [3 * pairs[k]!, 3 * pairs[k + 1]!] : [3 * k, 3 * k + 3];
    const [x0, y0, z0] = [screen[a]!, screen[a + 1]!, screen[a + 2]!];
    const [x1, y1, z1] = [screen[b]!, screen[b + 1]!, screen[b + 2]!];
    if (!(Math.abs(z0) < 1 && Math.abs(z1) < 1)) continue;
    const steps = Math.min(20000, Math.ceil(Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0)))) || 1;
    for (let n = 0; n <= steps; n++) {
      const z = z0 + (n / steps) * (z1 - z0) - 1e-4;
      const [u, v] = [Math.floor(x0 + (n / steps) * (x1 - x0)), Math.floor(y0 + (n / steps) * (y1 - y0))];
      for (let y = Math.max(v, 0); y < Math.min(v + thick, height); y++)
        for (let x = Math.max(u, 0); x < Math.min(u + thick, width); x++) {
          const i = y * width + x;
          if (z > depth[i]!) continue;
          for (let c = 0; c < 3; c++) pixels[4 * i + c] = alpha * color[c]! + (1 - alpha) * pixels[4 * i + c]!;
          pixels[4 * i + 3] = 255;
        }
    }
  }
}

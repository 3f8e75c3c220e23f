// A field on the mesh, drawn by the processor alone: for browsers without WebGL, and as the shader's twin in tests.

import { bandOf, type Rgb, type Scale } from "../data/color-scale";
import type { Mesh } from "../data/scene";
import { linesOf, partsIn, SMALL, type Tiling, tilingOf } from "../data/triangulation";
import { look, rgbOf } from "../shared/palette";
import type { Theme } from "../shared/theme";
import type { Camera, Painter, Picture } from "./renderer";

const NOTHING = 255; // where there is no plate
const OVER = 254;
const UNDER = 253;

/** Distance along x between the stripes where there is no contact [px]. */
export const STRIPES = 12;

/** What each pixel shows: its band (NOTHING, OVER, UNDER apart), and whether it is lifted (1) or not. */
export interface Raster {
  width: number;
  height: number;
  bands: Uint8Array;
  lifted: Uint8Array | null;
}

/** Fill triangles (parts: start and count in the list of faces), the values between their corners linear; pixels count by their centres. */
export function rasterise(
  mesh: Mesh,
  faces: Uint32Array,
  parts: readonly (readonly [number, number])[],
  picture: Picture,
  camera: Camera,
  width: number,
  height: number,
): Raster {
  const bands = new Uint8Array(width * height).fill(NOTHING);
  const lifted = picture.contact ? new Uint8Array(width * height) : null;
  const { nodes } = mesh;
  const { values, contact, scale } = picture;
  const band = bandFinder(scale);
  const [left, top] = [width / 2 - camera.x * camera.scale, height / 2 + camera.y * camera.scale];
  for (const [start, count] of parts)
    for (let f = start; f < start + count; f += 3) {
      const [a, b, c] = [faces[f]!, faces[f + 1]!, faces[f + 2]!];
      const ax = left + nodes[2 * a]! * camera.scale,
        ay = top - nodes[2 * a + 1]! * camera.scale;
      const bx = left + nodes[2 * b]! * camera.scale,
        by = top - nodes[2 * b + 1]! * camera.scale;
      const cx = left + nodes[2 * c]! * camera.scale,
        cy = top - nodes[2 * c + 1]! * camera.scale;
      const y0 = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5));
      const y1 = Math.min(height - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
      if (y0 > y1 || Math.max(ax, bx, cx) < 0 || Math.min(ax, bx, cx) > width) continue;
      const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
      if (area === 0) continue;
      // the value is a plane over the pixels
      const plane = (of: Float32Array): [number, number, number] => {
        const [p, q] = [of[b]! - of[a]!, of[c]! - of[a]!];
        const dx = (p * (cy - ay) - q * (by - ay)) / area;
        const dy = (q * (bx - ax) - p * (cx - ax)) / area;
        return [of[a]! - dx * ax - dy * ay, dx, dy];
      };
      const [v0, vx, vy] = plane(values);
      const [g0, gx, gy] = contact ? plane(contact) : [0, 0, 0];
      for (let y = y0; y <= y1; y++) {
        const middle = y + 0.5;
        let [from, to] = [Infinity, -Infinity];
        const cross = (px: number, py: number, qx: number, qy: number) => {
          if (py < middle === qy < middle) return;
          // reckoned the same way whichever triangle asks, so that neighbours leave no pixel between them
          const x =
            py < qy ? px + ((middle - py) / (qy - py)) * (qx - px) : qx + ((middle - qy) / (py - qy)) * (px - qx);
          if (x < from) from = x;
          if (x > to) to = x;
        };
        cross(ax, ay, bx, by);
        cross(bx, by, cx, cy);
        cross(cx, cy, ax, ay);
        const x0 = Math.max(0, Math.ceil(from - 0.5)),
          x1 = Math.min(width - 1, Math.ceil(to - 0.5) - 1);
        const row = y * width;
        for (let x = x0; x <= x1; x++) {
          bands[row + x] = band(v0 + vx * (x + 0.5) + vy * middle);
          if (lifted && g0 + gx * (x + 0.5) + gy * middle > 0) lifted[row + x] = 1;
        }
      }
    }
  return { width, height, bands, lifted };
}

/** Colour a raster: bands with thin lines between them, stripes where the plate has lifted, its boundary. */
export function coloured(
  raster: Raster,
  picture: Picture,
  camera: Camera,
  ratio: number,
  paper: Rgb,
  hatch: Rgb,
): Uint8ClampedArray<ArrayBuffer> {
  const { width, height, bands, lifted } = raster;
  const palette: Rgb[] = [];
  picture.scale.colours.forEach((colour, i) => {
    palette[i] = colour;
  });
  palette[OVER] = picture.scale.over;
  palette[UNDER] = picture.scale.under;
  const pixels = new Uint8ClampedArray(4 * width * height);
  const pitch = STRIPES * ratio;
  const anchor = width / 2 - camera.x * camera.scale - (height / 2 + camera.y * camera.scale);
  const boundary: number[] = [];
  for (let y = 0, i = 0; y < height; y++)
    for (let x = 0; x < width; x++, i++) {
      const band = bands[i]!;
      if (band === NOTHING) continue; // stays transparent
      let [red, green, blue] = palette[band]!;
      const right = x + 1 < width ? bands[i + 1]! : band;
      const below = y + 1 < height ? bands[i + width]! : band;
      if (picture.lines && ((right !== band && right < UNDER) || (below !== band && below < UNDER)) && band < UNDER)
        [red, green, blue] = [red * 0.68, green * 0.68, blue * 0.68];
      if (lifted) {
        if (lifted[i]) {
          const along = x - y - anchor;
          const stripe = along - Math.floor(along / pitch) * pitch < 1.4 * ratio;
          [red, green, blue] = [
            paper[0] + 0.45 * (red - paper[0]),
            paper[1] + 0.45 * (green - paper[1]),
            paper[2] + 0.45 * (blue - paper[2]),
          ];
          if (stripe)
            [red, green, blue] = [
              0.45 * red + 0.55 * hatch[0],
              0.45 * green + 0.55 * hatch[1],
              0.45 * blue + 0.55 * hatch[2],
            ];
        }
        const other = x + 1 < width && bands[i + 1] !== NOTHING && lifted[i + 1] !== lifted[i];
        const under = y + 1 < height && bands[i + width] !== NOTHING && lifted[i + width] !== lifted[i];
        if (other || under) boundary.push(i);
      }
      pixels[4 * i] = red;
      pixels[4 * i + 1] = green;
      pixels[4 * i + 2] = blue;
      pixels[4 * i + 3] = 255;
    }
  // the contact boundary: a black line on a wider white one
  for (const [reach, colour] of [
    [2.2 * ratio, 255],
    [0.9 * ratio, 0],
  ] as const) {
    const far = Math.ceil(reach);
    for (const i of boundary) {
      const [x, y] = [i % width, Math.floor(i / width)];
      for (let dy = -far; dy <= far; dy++)
        for (let dx = -far; dx <= far; dx++) {
          // it runs between a pixel and those right of it and below
          if (
            (dx - 0.5) ** 2 + (dy - 0.5) ** 2 > reach * reach ||
            x + dx < 0 ||
            x + dx >= width ||
            y + dy < 0 ||
            y + dy >= height
          )
            continue;
          const at = i + dy * width + dx;
          if (bands[at] !== NOTHING) pixels.fill(colour, 4 * at, 4 * at + 3);
        }
    }
  }
  return pixels;
}

/** Paints as the shader does, but slowly. */
export class RasterPainter implements Painter {
  readonly canvas = document.createElement("canvas");
  cost = 0;
  private readonly context = this.canvas.getContext("2d", { willReadFrequently: true })!;
  private mesh: Mesh | null = null;
  private tiling: Tiling | null = null;
  private sides: Uint32Array | null = null;
  private picture: Picture | null = null;
  private look = look("light");

  setMesh(mesh: Mesh | null): void {
    this.mesh = mesh;
    this.tiling = mesh ? tilingOf(mesh) : null;
    this.sides = null;
  }

  setPicture(picture: Picture | null): void {
    this.picture = picture;
  }

  setTheme(theme: Theme): void {
    this.look = look(theme);
  }

  draw(camera: Camera, width: number, height: number, ratio: number): void {
    const begun = performance.now();
    const [w, h] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
    if (this.canvas.width !== w || this.canvas.height !== h) [this.canvas.width, this.canvas.height] = [w, h];
    const { context, mesh, tiling, picture } = this;
    context.fillStyle = this.look.paper;
    context.fillRect(0, 0, w, h);
    if (!mesh || !tiling || !picture) return;
    const inPixels = { ...camera, scale: camera.scale * ratio };
    const [dx, dy] = [w / 2 / inPixels.scale, h / 2 / inPixels.scale];
    const parts = partsIn(
      tiling,
      [camera.x - dx, camera.y - dy, camera.x + dx, camera.y + dy],
      tiling.side * inPixels.scale < SMALL,
    );
    const raster = rasterise(mesh, tiling.faces, parts, picture, inPixels, w, h);
    context.putImageData(
      new ImageData(coloured(raster, picture, inPixels, ratio, rgbOf(this.look.paper), rgbOf(this.look.hatch)), w, h),
      0,
      0,
    );
    if (picture.mesh) this.drawSides(context, inPixels, w, h, ratio);
    this.cost = performance.now() - begun;
  }

  dispose(): void {
    this.canvas.remove();
  }

  private drawSides(
    context: CanvasRenderingContext2D,
    camera: Camera,
    width: number,
    height: number,
    ratio: number,
  ): void {
    const { nodes } = this.mesh!;
    this.sides ??= linesOf(this.mesh!);
    context.strokeStyle = "rgb(0 0 0 / 0.28)";
    context.lineWidth = ratio;
    context.beginPath();
    for (let k = 0; k < this.sides.length; k += 2) {
      const [a, b] = [2 * this.sides[k]!, 2 * this.sides[k + 1]!];
      context.moveTo(
        width / 2 + (nodes[a]! - camera.x) * camera.scale,
        height / 2 - (nodes[a + 1]! - camera.y) * camera.scale,
      );
      context.lineTo(
        width / 2 + (nodes[b]! - camera.x) * camera.scale,
        height / 2 - (nodes[b + 1]! - camera.y) * camera.scale,
      );
    }
    context.stroke();
  }
}

function bandFinder(scale: Scale): (value: number) => number {
  const count = scale.colours.length;
  return (value) => {
    const band = bandOf(scale, value);
    return band < 0 ? UNDER : band === count ? OVER : band;
  };
}

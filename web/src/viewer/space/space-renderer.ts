// What draws the bent plate in space: WebGL where a graphics card stands behind it, else the processor.
import {
  BufferAttribute,
  BufferGeometry,
  Mesh as Faces,
  GLSL3,
  LineBasicMaterial,
  LineSegments,
  type PerspectiveCamera,
  RawShaderMaterial,
  Vector3,
  WebGLRenderer,
  Scene as World,
} from "three";
import { bandOf, type Scale } from "../data/color-scale";
import type { Mesh } from "../data/scene";
import { borderOf, type Tiling } from "../data/triangulation";
import { contextOf } from "../renderer/webgl-context";
import { BANDS, bandUniforms, setBands } from "../renderer/webgl-renderer";
import { look, rgbOf } from "../shared/palette";
import type { Theme } from "../shared/theme";

/** The bent plate and what stands around it. Lines are pairs of ends: x, y, z, x, y, z. */
export interface SpacePicture {
  settlement: Float32Array; // of the nodes [mm]
  values: Float32Array;
  scale: Scale;
}

export interface SpacePainter {
  readonly canvas: HTMLCanvasElement;
  setMesh(mesh: Mesh | null, tiling: Tiling | null): void;
  setPicture(picture: SpacePicture | null): void;
  /** Lines where the plate was before it bent, and those of the columns. */
  setLines(flat: Float32Array, columns: Float32Array): void;
  setTheme(theme: Theme): void;
  /** Draw now; settlements are `times` enlarged; `coarse`: with two triangles for each element. */
  draw(camera: PerspectiveCamera, times: number, width: number, height: number, ratio: number, coarse: boolean): void;
  dispose(): void;
}

/** The lamp's direction: high, from the left and the front. */
const SUN = new Vector3(-0.45, -0.35, 0.82).normalize();
const DIM = 0.5; // light where none falls

const PLACE = `
in vec3 position;
in float settlement;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
uniform float uTimes;`;

const VERTEX = `${PLACE}
in float value;
centroid out float vValue;
out vec3 vPlace;
void main() {
  vValue = value;
  vec4 place = modelViewMatrix * vec4(position.xy, -settlement * uTimes, 1.0);
  vPlace = place.xyz;
  gl_Position = projectionMatrix * place;
}`;

// both faces are lit alike
const FRAGMENT = `
precision highp float;
centroid in float vValue;
in vec3 vPlace;
uniform vec3 uSun;
out vec4 result;
${BANDS}
void main() {
  vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  float light = ${DIM} + ${1 - DIM} * abs(dot(normal, uSun));
  result = vec4(banded(vValue) * light, 1.0);
}`;

const LINE_VERTEX = `${PLACE}
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position.xy, -settlement * uTimes, 1.0);
  gl_Position.z -= 1e-4 * gl_Position.w;
}`;

const LINE_FRAGMENT = `
precision highp float;
uniform vec3 uInk;
out vec4 result;
void main() { result = vec4(uInk, 1.0); }`;

/** Return the ends of the lines along a mesh's border, as nodes. */
function edgesOf(mesh: Mesh): Uint32Array {
  const sides = borderOf(mesh);
  const pairs = new Uint32Array((sides.length / 3) * 4);
  for (let k = 0; k < sides.length / 3; k++)
    pairs.set([sides[3 * k]!, sides[3 * k + 1]!, sides[3 * k + 1]!, sides[3 * k + 2]!], 4 * k);
  return pairs;
}

export class GlSpacePainter implements SpacePainter {
  readonly canvas = document.createElement("canvas");
  private readonly renderer: WebGLRenderer;
  private readonly world = new World();
  private readonly uniforms = {
    ...bandUniforms(),
    uTimes: { value: 1 },
    uSun: { value: new Vector3() },
    uInk: { value: [0, 0, 0] },
  };
  private readonly faces: Faces<BufferGeometry, RawShaderMaterial>;
  private readonly edges: LineSegments<BufferGeometry, RawShaderMaterial>;
  private readonly flat = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
  private readonly columns = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
  private fine = 0; // corners of triangles in the fine part of the list
  private size = "";

  /** Throws if no graphics card stands behind the browser's WebGL 2. */
  constructor() {
    const context = contextOf(this.canvas, { antialias: true, alpha: false, depth: true });
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context });
    const shader = { glslVersion: GLSL3, uniforms: this.uniforms, side: 2 as const };
    this.faces = new Faces(
      new BufferGeometry(),
      new RawShaderMaterial({ ...shader, vertexShader: VERTEX, fragmentShader: FRAGMENT }),
    );
    this.edges = new LineSegments(
      new BufferGeometry(),
      new RawShaderMaterial({ ...shader, vertexShader: LINE_VERTEX, fragmentShader: LINE_FRAGMENT }),
    );
    for (const each of this.parts()) {
      each.frustumCulled = false;
      each.visible = false;
      this.world.add(each);
    }
  }

  setMesh(mesh: Mesh | null, tiling: Tiling | null): void {
    for (const each of this.parts()) {
      each.geometry.dispose();
      each.geometry = new BufferGeometry();
      each.visible = false;
    }
    if (!mesh || !tiling) return;
    const places = new Float32Array(3 * mesh.nodeCount);
    for (let i = 0; i < mesh.nodeCount; i++) {
      places[3 * i] = mesh.nodes[2 * i]!;
      places[3 * i + 1] = mesh.nodes[2 * i + 1]!;
    }
    const position = new BufferAttribute(places, 3);
    this.faces.geometry.setAttribute("position", position);
    this.faces.geometry.setIndex(new BufferAttribute(tiling.faces, 1));
    this.edges.geometry.setAttribute("position", position);
    this.edges.geometry.setIndex(new BufferAttribute(edgesOf(mesh), 1));
    this.fine = 24 * mesh.elementCount;
  }

  setPicture(picture: SpacePicture | null): void {
    this.faces.visible = this.edges.visible = picture !== null;
    if (!picture) return;
    const settlement = new BufferAttribute(picture.settlement, 1);
    this.faces.geometry.setAttribute("settlement", settlement);
    this.edges.geometry.setAttribute("settlement", settlement);
    this.faces.geometry.setAttribute("value", new BufferAttribute(picture.values, 1));
    setBands(this.uniforms, picture.scale, true);
  }

  setLines(flat: Float32Array, columns: Float32Array): void {
    for (const [lines, ends] of [
      [this.flat, flat],
      [this.columns, columns],
    ] as const) {
      lines.geometry.dispose();
      lines.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(ends, 3));
      lines.visible = ends.length > 0;
    }
  }

  setTheme(theme: Theme): void {
    const { paper, ink, ink2 } = look(theme);
    this.renderer.setClearColor(paper, 1);
    this.uniforms.uInk.value = rgbOf(ink).map((part) => part / 255);
    this.flat.material.color.set(ink2);
    this.columns.material.color.set(ink);
  }

  draw(camera: PerspectiveCamera, times: number, width: number, height: number, ratio: number, coarse: boolean): void {
    const size = `${width} ${height} ${ratio}`;
    if (size !== this.size) {
      this.size = size;
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
    }
    this.uniforms.uRatio.value = ratio;
    this.uniforms.uTimes.value = times;
    this.uniforms.uSun.value.copy(SUN).transformDirection(camera.matrixWorldInverse);
    const { geometry } = this.faces;
    if (coarse) geometry.setDrawRange(this.fine, Infinity);
    else geometry.setDrawRange(0, this.fine);
    this.renderer.render(this.world, camera);
  }

  dispose(): void {
    for (const each of this.parts()) {
      each.geometry.dispose();
      each.material.dispose();
    }
    this.uniforms.uBands.value?.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
  }

  private parts() {
    return [this.faces, this.edges, this.flat, this.columns] as const;
  }
}

/** The processor's drawing: depth, colour and band of every pixel, filled triangle by triangle. */
export class CpuSpacePainter implements SpacePainter {
  readonly canvas = document.createElement("canvas");
  private readonly context = this.canvas.getContext("2d", { willReadFrequently: true })!;
  private mesh: Mesh | null = null;
  private tiling: Tiling | null = null;
  private edges = new Uint32Array() as Uint32Array;
  private picture: SpacePicture | null = null;
  private flat = new Float32Array() as Float32Array;
  private columns = new Float32Array() as Float32Array;
  private look = look("light");
  private pixels = new ImageData(1, 1);
  private depth = new Float32Array() as Float32Array;
  private bands = new Uint8Array() as Uint8Array;

  setMesh(mesh: Mesh | null, tiling: Tiling | null): void {
    this.mesh = mesh;
    this.tiling = tiling;
    this.edges = mesh ? edgesOf(mesh) : new Uint32Array();
    this.picture = null;
    this.setLines(new Float32Array(), new Float32Array());
  }

  setPicture(picture: SpacePicture | null): void {
    this.picture = picture;
  }

  setLines(flat: Float32Array, columns: Float32Array): void {
    this.flat = flat;
    this.columns = columns;
  }

  setTheme(theme: Theme): void {
    this.look = look(theme);
  }

  draw(camera: PerspectiveCamera, times: number, width: number, height: number, ratio: number, coarse: boolean): void {
    const [w, h] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
    if (this.canvas.width !== w || this.canvas.height !== h) {
      [this.canvas.width, this.canvas.height] = [w, h];
      this.pixels = new ImageData(w, h);
      this.depth = new Float32Array(w * h);
      this.bands = new Uint8Array(w * h);
    }
    const { mesh, tiling, picture, look } = this;
    const [red, green, blue] = rgbOf(look.paper);
    new Uint32Array(this.pixels.data.buffer).fill((255 << 24) | (blue << 16) | (green << 8) | red);
    this.depth.fill(1);
    this.bands.fill(255);
    const matrix = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse).elements;
    if (mesh && tiling && picture) {
      const { nodes, nodeCount } = mesh;
      const places = new Float32Array(3 * nodeCount); // x, y, depth on the screen
      for (let i = 0; i < nodeCount; i++)
        project(matrix, nodes[2 * i]!, nodes[2 * i + 1]!, -picture.settlement[i]! * times, w, h, places, 3 * i);
      const fine = 24 * mesh.elementCount;
      this.fill(tiling.faces, coarse ? fine : 0, coarse ? tiling.faces.length : fine, places, times, w, h);
      this.drawBandLines(w, h);
      const ink = rgbOf(look.ink);
      for (let k = 0; k < this.edges.length; k += 2) {
        const [a, b] = [3 * this.edges[k]!, 3 * this.edges[k + 1]!];
        this.line(
          places[a]!,
          places[a + 1]!,
          places[a + 2]!,
          places[b]!,
          places[b + 1]!,
          places[b + 2]!,
          ink,
          ratio,
          w,
          h,
        );
      }
    }
    const ends = new Float32Array(6);
    for (const [lines, colour] of [
      [this.flat, rgbOf(look.ink2)],
      [this.columns, rgbOf(look.ink)],
    ] as const)
      for (let k = 0; k + 5 < lines.length; k += 6) {
        project(matrix, lines[k]!, lines[k + 1]!, lines[k + 2]!, w, h, ends, 0);
        project(matrix, lines[k + 3]!, lines[k + 4]!, lines[k + 5]!, w, h, ends, 3);
        this.line(ends[0]!, ends[1]!, ends[2]!, ends[3]!, ends[4]!, ends[5]!, colour, ratio, w, h);
      }
    this.context.putImageData(this.pixels, 0, 0);
  }

  dispose(): void {
    this.canvas.remove();
  }

  private fill(
    faces: Uint32Array,
    start: number,
    end: number,
    places: Float32Array,
    times: number,
    width: number,
    height: number,
  ): void {
    const { nodes } = this.mesh!;
    const { values, settlement, scale } = this.picture!;
    const { depth, bands } = this;
    const { data } = this.pixels;
    const count = scale.colours.length;
    for (let f = start; f < end; f += 3) {
      const a = faces[f]!,
        b = faces[f + 1]!,
        c = faces[f + 2]!;
      const ax = places[3 * a]!,
        ay = places[3 * a + 1]!,
        az = places[3 * a + 2]!;
      const bx = places[3 * b]!,
        by = places[3 * b + 1]!,
        bz = places[3 * b + 2]!;
      const cx = places[3 * c]!,
        cy = places[3 * c + 1]!,
        cz = places[3 * c + 2]!;
      if (!(az > -1 && bz > -1 && cz > -1 && az < 1 && bz < 1 && cz < 1)) continue;
      const y0 = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5)),
        y1 = Math.min(height - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
      if (y0 > y1 || Math.max(ax, bx, cx) < 0 || Math.min(ax, bx, cx) > width) continue;
      const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
      if (area === 0) continue;
      // depth and value are planes over the screen; for the value that is true of triangles small beside their distance
      const p = bz - az,
        q = cz - az;
      const zx = (p * (cy - ay) - q * (by - ay)) / area,
        zy = (q * (bx - ax) - p * (cx - ax)) / area;
      const s = values[b]! - values[a]!,
        t = values[c]! - values[a]!;
      const vx = (s * (cy - ay) - t * (by - ay)) / area,
        vy = (t * (bx - ax) - s * (cx - ax)) / area;
      const light = this.light(nodes, settlement, times, a, b, c);
      for (let y = y0; y <= y1; y++) {
        const middle = y + 0.5;
        let from = Infinity,
          to = -Infinity;
        for (let side = 0; side < 3; side++) {
          const px = side === 0 ? ax : side === 1 ? bx : cx,
            py = side === 0 ? ay : side === 1 ? by : cy;
          const qx = side === 0 ? bx : side === 1 ? cx : ax,
            qy = side === 0 ? by : side === 1 ? cy : ay;
          if (py < middle === qy < middle) continue;
          // reckoned the same way whichever triangle asks, so that neighbours leave no pixel between them
          const x =
            py < qy ? px + ((middle - py) / (qy - py)) * (qx - px) : qx + ((middle - qy) / (py - qy)) * (px - qx);
          if (x < from) from = x;
          if (x > to) to = x;
        }
        const x0 = Math.max(0, Math.ceil(from - 0.5)),
          x1 = Math.min(width - 1, Math.ceil(to - 0.5) - 1);
        for (let x = x0; x <= x1; x++) {
          const i = y * width + x;
          const z = az + zx * (x + 0.5 - ax) + zy * (middle - ay);
          if (z >= depth[i]!) continue;
          depth[i] = z;
          const band = bandOf(scale, values[a]! + vx * (x + 0.5 - ax) + vy * (middle - ay));
          bands[i] = band < 0 ? 253 : band === count ? 254 : band;
          const colour = band < 0 ? scale.under : band === count ? scale.over : scale.colours[band]!;
          data[4 * i] = colour[0] * light;
          data[4 * i + 1] = colour[1] * light;
          data[4 * i + 2] = colour[2] * light;
        }
      }
    }
  }

  private light(nodes: Float32Array, settlement: Float32Array, times: number, a: number, b: number, c: number): number {
    const ux = nodes[2 * b]! - nodes[2 * a]!,
      uy = nodes[2 * b + 1]! - nodes[2 * a + 1]!,
      uz = (settlement[a]! - settlement[b]!) * times;
    const vx = nodes[2 * c]! - nodes[2 * a]!,
      vy = nodes[2 * c + 1]! - nodes[2 * a + 1]!,
      vz = (settlement[a]! - settlement[c]!) * times;
    const nx = uy * vz - uz * vy,
      ny = uz * vx - ux * vz,
      nz = ux * vy - uy * vx;
    const length = Math.sqrt(nx * nx + ny * ny + nz * nz) || 1;
    return DIM + (1 - DIM) * (Math.abs(nx * SUN.x + ny * SUN.y + nz * SUN.z) / length);
  }

  private drawBandLines(width: number, height: number): void {
    const { bands } = this;
    const { data } = this.pixels;
    for (let y = 0, i = 0; y < height; y++)
      for (let x = 0; x < width; x++, i++) {
        const band = bands[i]!;
        if (band >= 253) continue;
        const right = x + 1 < width ? bands[i + 1]! : band,
          below = y + 1 < height ? bands[i + width]! : band;
        if ((right === band || right >= 253) && (below === band || below >= 253)) continue;
        data[4 * i]! *= 0.66;
        data[4 * i + 1]! *= 0.66;
        data[4 * i + 2]! *= 0.66;
      }
  }

  private line(
    ax: number,
    ay: number,
    az: number,
    bx: number,
    by: number,
    bz: number,
    [red, green, blue]: readonly number[],
    ratio: number,
    width: number,
    height: number,
  ): void {
    if (!(Math.abs(az) < 1 && Math.abs(bz) < 1)) return;
    const steps = Math.min(20000, Math.ceil(Math.max(Math.abs(bx - ax), Math.abs(by - ay)))) || 1;
    const thick = Math.max(1, Math.round(ratio));
    for (let k = 0; k <= steps; k++) {
      const part = k / steps;
      const x = Math.floor(ax + part * (bx - ax)),
        y = Math.floor(ay + part * (by - ay)),
        z = az + part * (bz - az) - 1e-4;
      for (let dy = 0; dy < thick; dy++)
        for (let dx = 0; dx < thick; dx++) {
          if (x + dx < 0 || y + dy < 0 || x + dx >= width || y + dy >= height) continue;
          const i = (y + dy) * width + x + dx;
          if (z > this.depth[i]!) continue;
          this.pixels.data[4 * i] = red!;
          this.pixels.data[4 * i + 1] = green!;
          this.pixels.data[4 * i + 2] = blue!;
        }
    }
  }
}

/** Write the place on the screen of a point in space: x and y in pixels, depth -1 .. 1; behind the eye: depth 2. */
function project(
  m: ArrayLike<number>,
  x: number,
  y: number,
  z: number,
  width: number,
  height: number,
  into: Float32Array,
  at: number,
): void {
  const w = m[3]! * x + m[7]! * y + m[11]! * z + m[15]!;
  into[at] = ((m[0]! * x + m[4]! * y + m[8]! * z + m[12]!) / w + 1) * 0.5 * width;
  into[at + 1] = (1 - (m[1]! * x + m[5]! * y + m[9]! * z + m[13]!) / w) * 0.5 * height;
  into[at + 2] = w > 0 ? (m[2]! * x + m[6]! * y + m[10]! * z + m[14]!) / w : 2;
}

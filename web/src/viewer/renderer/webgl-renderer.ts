// Draws a field by the graphics card: one vertex for each node, eight triangles for each element, colors by bands.
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  GLSL3,
  LineSegments,
  NearestFilter,
  RawShaderMaterial,
  Scene,
  Mesh as Surface,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { BEYOND } from "../data/color-scale";
import type { Mesh, Point } from "../data/scene";
import { borderLines, makeTiling, sideLines, type Tiling } from "../data/triangulation";
import { paletteOf, rgbOf } from "../shared/palette";
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
import { contextOf } from "./webgl-context";

const PLACE = `
in vec3 position;
in float settlement;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
uniform float uExaggeration;
vec4 bent() { return modelViewMatrix * vec4(position.xy, position.z - settlement * uExaggeration, 1.0); }`;

const VERTEX = `${PLACE}
in float value;
in float contact;
SAMPLED out float vValue;
SAMPLED out float vContact;
out vec3 vPlace;
void main() {
  vValue = value;
  vContact = contact;
  vec4 place = bent();
  vPlace = place.xyz;
  gl_Position = projectionMatrix * place;
}`;

const FRAGMENT = `
precision highp float;
SAMPLED in float vValue;
SAMPLED in float vContact;
in vec3 vPlace;
uniform sampler2D uBands;
uniform float uOrigin, uStep, uCount, uLow, uHigh, uLines, uRatio, uContact, uLit;
uniform vec3 uOver, uUnder, uPaper, uHatch, uSun;
uniform vec2 uAnchor;
out vec4 result;
vec3 banded(float value) {
  float f = (value - uOrigin) / uStep;
  float slope = length(vec2(dFdx(f), dFdy(f)));
  float band = clamp(floor(f), 0.0, uCount - 1.0);
  vec3 color = texelFetch(uBands, ivec2(int(band), 0), 0).rgb;
  if (value < uLow - ${BEYOND} * uStep) color = uUnder;
  if (value > uHigh + ${BEYOND} * uStep) color = uOver;
  // a thin line between bands; none where they are too close, nor on a plateau that lies on a limit
  float nearest = floor(f + 0.5);
  if (uLines > 0.0 && nearest > 0.5 && nearest < uCount - 0.5) {
    float pixels = abs(f - nearest) / max(slope, 1e-7) / uRatio;
    float seen = smoothstep(2e-5, 1e-4, slope * uRatio) * (1.0 - smoothstep(0.08, 0.2, slope * uRatio));
    color *= 1.0 - 0.38 * uLines * seen * (1.0 - smoothstep(0.35, 0.95, pixels));
  }
  return color;
}
vec3 lifted(vec3 color) {
  float slope = length(vec2(dFdx(vContact), dFdy(vContact)));
  if (vContact > 0.0) {
    vec2 p = (gl_FragCoord.xy - uAnchor) / uRatio;
    float stripe = abs(fract((p.x + p.y) / ${LOOK.stripes.toFixed(1)}) - 0.5) * ${LOOK.stripes.toFixed(1)} * 0.7071;
    color = mix(mix(color, uPaper, 0.55), uHatch, 0.6 * (1.0 - smoothstep(0.3, 1.0, stripe)));
  }
  float d = abs(vContact) / max(slope, 1e-30) / uRatio;
  color = mix(vec3(1.0), color, smoothstep(1.6, 2.4, d));
  return mix(vec3(0.0), color, smoothstep(0.6, 1.3, d));
}
void main() {
  vec3 color = banded(vValue);
  if (uContact > 0.0) color = lifted(color);
  // both faces are lit alike
  vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  if (uLit > 0.0) color *= ${LOOK.ambient} + ${1 - LOOK.ambient} * abs(dot(normal, uSun));
  result = vec4(color, 1.0);
}`;

const LINE_VERTEX = `${PLACE}
void main() {
  gl_Position = projectionMatrix * bent();
  gl_Position.z -= 1e-4 * gl_Position.w;
}`;

const LINE_FRAGMENT = `
precision highp float;
uniform vec4 uColor;
out vec4 result;
void main() { result = uColor; }`;

export class WebglRenderer implements FieldRenderer {
  readonly canvas = document.createElement("canvas");
  readonly accelerated = true;
  readonly cost = 0;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly exaggeration = { value: 0 }; // [m] for each unit of the settlement
  private readonly uniforms = {
    uBands: { value: null as DataTexture | null },
    ...makeUniforms(() => 0, "uOrigin", "uStep", "uCount", "uLow", "uHigh", "uLines", "uRatio", "uContact", "uLit"),
    ...makeUniforms(() => new Vector3(), "uOver", "uUnder", "uPaper", "uHatch", "uSun"),
    uAnchor: { value: new Vector2() },
    uExaggeration: this.exaggeration,
  };
  private readonly surface: Surface<BufferGeometry, RawShaderMaterial[]>;
  private readonly sides = this.makeLines(LOOK.sideAlpha);
  private readonly border = this.makeLines();
  private readonly flat = this.makeLines();
  private readonly columns = this.makeLines();
  private readonly parts: readonly (WebglRenderer["surface"] | ReturnType<WebglRenderer["makeLines"]>)[];
  private mesh: Mesh | null = null;
  private tiling: Tiling | null = null;
  private size = "";

  /** Throws if no graphics card stands behind the browser's WebGL 2: without one the processor does better alone. */
  constructor(antialias: boolean) {
    const context = contextOf(this.canvas, { antialias, alpha: false, depth: true, stencil: false });
    // of several samples for a pixel some lie beyond the triangle, where values must not be taken
    const [vertexShader, fragmentShader] = [VERTEX, FRAGMENT].map((shader) =>
      shader.replaceAll("SAMPLED", antialias ? "centroid" : ""),
    ) as [string, string];
    const { uniforms } = this;
    const material = new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, side: 2 });
    // a list of materials: then only the geometry's groups are drawn
    this.surface = new Surface(new BufferGeometry(), [material]);
    this.parts = [this.surface, this.sides, this.border, this.flat, this.columns];
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context });
    this.parts.forEach((part, order) => {
      Object.assign(part, { frustumCulled: false, visible: false, renderOrder: order });
      this.scene.add(part);
    });
    this.setTheme("light");
  }

  setMesh(mesh: Mesh | null): void {
    this.mesh = mesh;
    this.tiling = mesh ? makeTiling(mesh) : null;
    for (const part of this.parts) {
      part.geometry.dispose();
      part.geometry = new BufferGeometry();
      part.visible = false;
    }
    if (!mesh) return;
    for (const part of this.parts) part.position.set(...mesh.origin, 0);
    const position = new BufferAttribute(nodesFromOrigin(mesh), 3);
    for (const part of [this.surface, this.sides, this.border]) part.geometry.setAttribute("position", position);
    this.surface.geometry.setIndex(new BufferAttribute(this.tiling!.triangles, 1));
    this.border.geometry.setIndex(new BufferAttribute(borderLines(mesh), 1));
  }

  setPicture(picture: Picture | null): void {
    const { mesh, uniforms } = this;
    this.surface.visible = mesh !== null && picture !== null;
    this.sides.visible = this.surface.visible && picture!.mesh;
    this.border.visible = this.surface.visible && picture!.settlement !== null;
    if (!mesh || !picture) return;
    setAttribute(this.surface.geometry, "value", picture.values);
    setAttribute(this.surface.geometry, "contact", picture.contact ?? picture.values);
    if (picture.settlement)
      for (const part of [this.surface, this.sides, this.border])
        setAttribute(part.geometry, "settlement", picture.settlement);
    if (picture.mesh && !this.sides.geometry.index)
      this.sides.geometry.setIndex(new BufferAttribute(sideLines(mesh), 1));
    this.sides.material.uniforms.uColor!.value = [...shares(sideColor(picture.scale)), LOOK.sideAlpha];
    uniforms.uContact.value = picture.contact ? 1 : 0;
    uniforms.uLit.value = picture.settlement ? 1 : 0;
    uniforms.uLines.value = picture.lines ? 1 : 0;
    this.setScale(picture.scale);
  }

  setLines(lines: Lines): void {
    for (const name of ["flat", "columns"] as const) {
      this[name].geometry.dispose();
      const places = fromOrigin(lines[name], this.origin);
      this[name].geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(places, 3));
      this[name].visible = lines[name].length > 0;
    }
  }

  setTheme(theme: Theme): void {
    const { paper, hatch, ink, ink2 } = paletteOf(theme);
    this.renderer.setClearColor(paper, 1);
    this.uniforms.uPaper.value.set(...shares(rgbOf(paper)));
    this.uniforms.uHatch.value.set(...shares(rgbOf(hatch)));
    for (const [lines, color] of [
      [this.border, ink],
      [this.columns, ink],
      [this.flat, ink2],
    ] as const)
      lines.material.uniforms.uColor!.value = [...shares(rgbOf(color)), 1];
  }

  draw(view: View): void {
    const { width, height, ratio, camera } = view;
    const size = `${width} ${height} ${ratio}`;
    if (size !== this.size) {
      this.size = size;
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
    }
    this.exaggeration.value = view.exaggeration;
    this.uniforms.uRatio.value = ratio;
    this.uniforms.uSun.value.set(...LOOK.sun).transformDirection(camera.matrixWorldInverse);
    // stripes stay where they are on the plate while it moves
    const origin = new Vector3(...this.origin).project(camera);
    this.uniforms.uAnchor.value.set(((origin.x + 1) * width * ratio) / 2, ((origin.y + 1) * height * ratio) / 2);
    this.surface.geometry.clearGroups();
    if (this.tiling)
      for (const [start, count] of rangesIn(this.tiling, view)) this.surface.geometry.addGroup(start, count, 0);
    this.renderer.render(this.scene, camera);
  }

  private get origin(): Point {
    return this.mesh?.origin ?? [0, 0];
  }

  private setScale(scale: Picture["scale"]): void {
    const { uniforms } = this;
    const count = scale.colors.length;
    uniforms.uBands.value?.dispose();
    const texels = Uint8Array.from(scale.colors.flatMap((color) => [...color, 255]));
    const texture = new DataTexture(texels, count, 1);
    texture.minFilter = texture.magFilter = NearestFilter;
    texture.needsUpdate = true;
    uniforms.uBands.value = texture;
    uniforms.uOrigin.value = scale.origin;
    uniforms.uStep.value = scale.step;
    uniforms.uCount.value = count;
    uniforms.uLow.value = scale.levels[0]!;
    uniforms.uHigh.value = scale.levels[count]!;
    uniforms.uOver.value.set(...shares(scale.over));
    uniforms.uUnder.value.set(...shares(scale.under));
  }

  private makeLines(alpha = 1): LineSegments<BufferGeometry, RawShaderMaterial> {
    const uniforms = { uExaggeration: this.exaggeration, uColor: { value: [0, 0, 0, alpha] } };
    const shaders = { glslVersion: GLSL3, vertexShader: LINE_VERTEX, fragmentShader: LINE_FRAGMENT };
    return new LineSegments(
      new BufferGeometry(),
      new RawShaderMaterial({ ...shaders, uniforms, transparent: alpha < 1 }),
    );
  }
}

function makeUniforms<K extends string, T>(make: () => T, ...names: K[]): Record<K, { value: T }> {
  return Object.fromEntries(names.map((name) => [name, { value: make() }])) as Record<K, { value: T }>;
}

/** Return the parts of a color as shares of 1. */
function shares(rgb: readonly number[]): [number, number, number] {
  return rgb.map((part) => part / 255) as [number, number, number];
}

function setAttribute(geometry: BufferGeometry, name: string, values: Float32Array): void {
  if (geometry.getAttribute(name)?.array !== values) geometry.setAttribute(name, new BufferAttribute(values, 1));
}

// A field on the mesh, drawn by the graphics card through WebGL: one vertex for each node, eight triangles for each element, colours by bands.
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  Mesh as Faces,
  GLSL3,
  LineBasicMaterial,
  LineSegments,
  NearestFilter,
  OrthographicCamera,
  RawShaderMaterial,
  Vector2,
  WebGLRenderer,
  Scene as World,
} from "three";
import { BEYOND, type Scale } from "../data/color-scale";
import type { Mesh } from "../data/scene";
import { linesOf, partsIn, SMALL, type Tiling, tilingOf } from "../data/triangulation";
import { look, rgbOf } from "../shared/palette";
import type { Theme } from "../shared/theme";
import type { Camera, Painter, Picture } from "./renderer";
import { STRIPES } from "./software-renderer";
import { contextOf } from "./webgl-context";

const VERTEX = `
in vec3 position;
in float value;
in float contact;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
out float vValue;
out float vContact;
void main() {
  vValue = value;
  vContact = contact;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

/** The bands' colours: shared by the plan and the view in space. */
export const BANDS = `
uniform sampler2D uBands;
uniform float uOrigin, uStep, uCount, uLow, uHigh, uLines, uRatio;
uniform vec3 uOver, uUnder;
vec3 banded(float value) {
  float f = (value - uOrigin) / uStep;
  float slope = length(vec2(dFdx(f), dFdy(f)));
  float band = clamp(floor(f), 0.0, uCount - 1.0);
  vec3 colour = texelFetch(uBands, ivec2(int(band), 0), 0).rgb;
  if (value < uLow - ${BEYOND} * uStep) colour = uUnder;
  if (value > uHigh + ${BEYOND} * uStep) colour = uOver;
  // a thin line between bands; none where they are too close, nor on a plateau that lies on a limit
  float nearest = floor(f + 0.5);
  if (uLines > 0.0 && nearest > 0.5 && nearest < uCount - 0.5) {
    float pixels = abs(f - nearest) / max(slope, 1e-7) / uRatio;
    float seen = smoothstep(2e-5, 1e-4, slope * uRatio) * (1.0 - smoothstep(0.08, 0.2, slope * uRatio));
    colour *= 1.0 - 0.38 * uLines * seen * (1.0 - smoothstep(0.35, 0.95, pixels));
  }
  return colour;
}`;

const FRAGMENT = `
precision highp float;
in float vValue;
in float vContact;
uniform float uContact;
uniform vec2 uAnchor;
uniform vec3 uPaper, uHatch;
out vec4 result;
${BANDS}
void main() {
  vec3 colour = banded(vValue);
  if (uContact > 0.0) {
    float slope = length(vec2(dFdx(vContact), dFdy(vContact)));
    if (vContact > 0.0) {
      vec2 p = (gl_FragCoord.xy - uAnchor) / uRatio;
      float stripe = abs(fract((p.x + p.y) / ${STRIPES.toFixed(1)}) - 0.5) * ${STRIPES.toFixed(1)} * 0.7071;
      colour = mix(mix(colour, uPaper, 0.55), uHatch, 0.6 * (1.0 - smoothstep(0.3, 1.0, stripe)));
    }
    float d = abs(vContact) / max(slope, 1e-30) / uRatio;
    colour = mix(vec3(1.0), colour, smoothstep(1.6, 2.4, d));
    colour = mix(vec3(0.0), colour, smoothstep(0.6, 1.3, d));
  }
  result = vec4(colour, 1.0);
}`;

/** Return the shader's inputs for colours, to be filled by `setBands`. */
export function bandUniforms() {
  return {
    uBands: { value: null as DataTexture | null },
    uOrigin: { value: 0 },
    uStep: { value: 1 },
    uCount: { value: 1 },
    uLow: { value: 0 },
    uHigh: { value: 1 },
    uLines: { value: 1 },
    uRatio: { value: 1 },
    uOver: { value: [1, 0, 1] },
    uUnder: { value: [0, 1, 0] },
  };
}

export function setBands(uniforms: ReturnType<typeof bandUniforms>, scale: Scale, lines: boolean): void {
  const count = scale.colours.length;
  const texels = new Uint8Array(4 * count);
  scale.colours.forEach((colour, i) => texels.set([...colour, 255], 4 * i));
  uniforms.uBands.value?.dispose();
  const texture = new DataTexture(texels, count, 1);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  uniforms.uBands.value = texture;
  uniforms.uOrigin.value = scale.origin;
  uniforms.uStep.value = scale.step;
  uniforms.uCount.value = count;
  uniforms.uLow.value = scale.levels[0]!;
  uniforms.uHigh.value = scale.levels[count]!;
  uniforms.uLines.value = lines ? 1 : 0;
  uniforms.uOver.value = scale.over.map((part) => part / 255);
  uniforms.uUnder.value = scale.under.map((part) => part / 255);
}

export class GlPainter implements Painter {
  readonly canvas = document.createElement("canvas");
  private readonly renderer: WebGLRenderer;
  private readonly world = new World();
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, -1, 1);
  private readonly uniforms = {
    ...bandUniforms(),
    uContact: { value: 0 },
    uAnchor: { value: new Vector2() },
    uPaper: { value: [1, 1, 1] },
    uHatch: { value: [0.25, 0.25, 0.25] },
  };
  private readonly material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: this.uniforms,
    depthTest: false,
    depthWrite: false,
    side: 2,
  });
  // a list of materials: then only the geometry's groups are drawn
  private readonly faces = new Faces(new BufferGeometry(), [this.material]);
  private readonly sides = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.28, depthTest: false }),
  );
  private mesh: Mesh | null = null;
  private tiling: Tiling | null = null;
  private costs: number[] = [];
  private draws = 0;
  private sidesOf: Mesh | null = null;
  private size = "";

  /** Throws if no graphics card stands behind the browser's WebGL 2: without one the processor does better alone. */
  constructor() {
    const context = contextOf(this.canvas, { antialias: false, alpha: false, depth: false, stencil: false });
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context, antialias: false, alpha: false, depth: false });
    this.faces.frustumCulled = this.sides.frustumCulled = false;
    this.sides.renderOrder = 1;
    this.world.add(this.faces, this.sides);
    this.world.matrixWorldAutoUpdate = false;
    this.setTheme("light");
  }

  get cost(): number {
    return this.costs.length ? Math.min(...this.costs) : 0;
  }

  setMesh(mesh: Mesh | null): void {
    this.mesh = mesh;
    this.tiling = mesh ? tilingOf(mesh) : null;
    this.costs = [];
    this.draws = 0;
    this.faces.geometry.dispose();
    this.faces.geometry = new BufferGeometry();
    this.faces.visible = this.sides.visible = false;
    if (!mesh) return;
    const { geometry } = this.faces;
    const places = new Float32Array(3 * mesh.nodeCount);
    for (let i = 0; i < mesh.nodeCount; i++) {
      places[3 * i] = mesh.nodes[2 * i]!;
      places[3 * i + 1] = mesh.nodes[2 * i + 1]!;
    }
    geometry.setAttribute("position", new BufferAttribute(places, 3));
    geometry.setIndex(new BufferAttribute(this.tiling!.faces, 1));
  }

  setPicture(picture: Picture | null): void {
    this.faces.visible = this.mesh !== null && picture !== null;
    this.sides.visible = this.faces.visible && picture!.mesh;
    if (!this.mesh || !picture) return;
    const { geometry } = this.faces;
    put(geometry, "value", picture.values);
    put(geometry, "contact", picture.contact ?? picture.values);
    this.uniforms.uContact.value = picture.contact ? 1 : 0;
    setBands(this.uniforms, picture.scale, picture.lines);
    if (picture.mesh && this.sidesOf !== this.mesh) {
      this.sides.geometry.dispose();
      this.sides.geometry = new BufferGeometry();
      this.sides.geometry.setAttribute("position", geometry.getAttribute("position"));
      this.sides.geometry.setIndex(new BufferAttribute(linesOf(this.mesh), 1));
      this.sidesOf = this.mesh;
    }
  }

  setTheme(theme: Theme): void {
    const { paper, hatch } = look(theme);
    this.renderer.setClearColor(paper, 1);
    this.uniforms.uPaper.value = rgbOf(paper).map((part) => part / 255);
    this.uniforms.uHatch.value = rgbOf(hatch).map((part) => part / 255);
  }

  draw(camera: Camera, width: number, height: number, ratio: number): void {
    const size = `${width} ${height} ${ratio}`;
    if (size !== this.size) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height);
      this.size = size;
    }
    const [dx, dy] = [width / 2 / camera.scale, height / 2 / camera.scale];
    Object.assign(this.camera, {
      left: camera.x - dx,
      right: camera.x + dx,
      bottom: camera.y - dy,
      top: camera.y + dy,
    });
    this.camera.updateProjectionMatrix();
    this.uniforms.uRatio.value = ratio;
    // stripes stay where they are on the plate while it is moved
    this.uniforms.uAnchor.value.set(
      (width / 2 - camera.x * camera.scale) * ratio,
      (height / 2 - camera.y * camera.scale) * ratio,
    );
    if (this.tiling && this.faces.visible) {
      const { geometry } = this.faces;
      geometry.clearGroups();
      const coarse = this.tiling.side * camera.scale * ratio < SMALL;
      for (const [start, count] of partsIn(
        this.tiling,
        [camera.x - dx, camera.y - dy, camera.x + dx, camera.y + dy],
        coarse,
      ))
        geometry.addGroup(start, count, 0);
    }
    this.renderer.render(this.world, this.camera);
    this.draws += 1;
    // the first drawing sends everything to the graphics card; of later ones some are timed
    if (this.draws > 1 && (this.draws < 8 || this.draws % 60 === 0)) this.time();
  }

  /** Find out how long the drawing just begun takes, without waiting for it. */
  private time(): void {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!sync) return;
    gl.flush();
    const begun = performance.now();
    const look = (): void => {
      const state = gl.clientWaitSync(sync, 0, 0);
      if (state === gl.TIMEOUT_EXPIRED && performance.now() - begun < 2000) {
        setTimeout(look, 1);
        return;
      }
      gl.deleteSync(sync);
      this.costs = [...this.costs.slice(-2), performance.now() - begun];
    };
    setTimeout(look, 1);
  }

  dispose(): void {
    this.faces.geometry.dispose();
    this.sides.geometry.dispose();
    this.material.dispose();
    this.uniforms.uBands.value?.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
  }
}

function put(geometry: BufferGeometry, name: string, values: Float32Array): void {
  const before = geometry.getAttribute(name) as BufferAttribute | undefined;
  if (before && before.array.length === values.length) {
    if (before.array === values) return;
    before.array = values;
    before.needsUpdate = true;
  } else geometry.setAttribute(name, new BufferAttribute(values, 1));
}

// The plate in space, bent by its settlement many times enlarged, with a field in colours.
import {
  BufferAttribute, BufferGeometry, GLSL3, LineBasicMaterial, LineSegments, Mesh as Faces, PerspectiveCamera, RawShaderMaterial,
  Scene as World, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { make } from "./dom";
import { SMALL, type Tiling, borderOf, tilingOf } from "./faces";
import { type Choice, endsOf, fieldOf, values } from "./fields";
import { BANDS, bandUniforms, setBands } from "./gl-painter";
import { look, rgbOf } from "./look";
import { type Range, type Shown, scaleFor } from "./plan-view";
import { neat, roundStep } from "./scale";
import type { Scene } from "./scene";
import { type Theme, theme } from "./theme";
import "./space-view.css";

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

// lit from above left; both faces alike
const FRAGMENT = `
precision highp float;
centroid in float vValue;
in vec3 vPlace;
uniform vec3 uSun;
out vec4 result;
${BANDS}
void main() {
  vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  float light = 0.5 + 0.5 * abs(dot(normal, uSun));
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

/** The lamp's direction in the world: high, from the left and the front. */
const SUN = new Vector3(-0.45, -0.35, 0.82).normalize();
const FIELD_OF_VIEW = 32;

interface Drawn {
  renderer: WebGLRenderer;
  world: World;
  camera: PerspectiveCamera;
  controls: OrbitControls;
  uniforms: ReturnType<typeof bandUniforms> & { uTimes: { value: number }; uSun: { value: Vector3 }; uInk: { value: number[] } };
  faces: Faces<BufferGeometry, RawShaderMaterial>;
  edges: LineSegments<BufferGeometry, RawShaderMaterial>;
  flat: LineSegments<BufferGeometry, LineBasicMaterial>; // outline and openings where they were
  columns: LineSegments<BufferGeometry, LineBasicMaterial>;
}

export class SpaceView {
  /** Another field, combination or scale is shown; null: none. */
  onShow?: (shown: Shown | null) => void;
  readonly element = make("div", {
    class: "gs-space", tabindex: 0, role: "application",
    "aria-label": "View in space. Drag or arrow keys turn it, the wheel or plus and minus zoom, 0 shows all.",
  });
  private readonly slider = make("input", { type: "range", min: 0, max: 100, value: 50, "aria-label": "Enlargement of the settlement" });
  private readonly times = make("output", {});
  private gl: Drawn | null = null;
  private scene: Scene | null = null;
  private tiling: Tiling | null = null;
  private what: { choice: Choice; field: string } | null = null;
  private range: Range = "auto";
  private theme: Theme = theme();
  private base = 1; // enlargement in the slider's middle
  private depth = 0; // of the middle between least and largest settlement [mm]
  private fitted = false; // whether the user has left the view as `fit` made it
  private frame = 0;
  private size = "";
  private readonly resized: ResizeObserver;

  constructor(container: HTMLElement) {
    container.append(this.element);
    this.slider.addEventListener("input", () => this.enlarge());
    this.resized = new ResizeObserver(() => (this.fitted ? this.fit() : this.request()));
    this.resized.observe(this.element);
    this.element.addEventListener("keydown", (event) => { if (this.key(event)) event.preventDefault(); });
    try {
      this.gl = this.start();
      this.setTheme(this.theme);
    } catch {
      this.refuse("This browser has no WebGL 2, which the view in space needs. The plan works without it.");
    }
  }

  get accelerated(): boolean {
    return this.gl !== null;
  }

  setScene(scene: Scene | null): void {
    this.scene = scene;
    this.what = null;
    const { gl } = this;
    if (!gl) return;
    for (const each of [gl.faces, gl.edges, gl.flat, gl.columns]) {
      each.geometry.dispose();
      each.geometry = new BufferGeometry();
      each.visible = false;
    }
    this.tiling = scene ? tilingOf(scene.mesh) : null;
    if (!scene || !this.tiling) return this.request();
    const { mesh, head } = scene;
    const places = new Float32Array(3 * mesh.nodeCount);
    for (let i = 0; i < mesh.nodeCount; i++) places.set([mesh.nodes[2 * i]!, mesh.nodes[2 * i + 1]!], 3 * i);
    const position = new BufferAttribute(places, 3);
    gl.faces.geometry.setAttribute("position", position);
    gl.faces.geometry.setIndex(new BufferAttribute(this.tiling.faces, 1));
    gl.edges.geometry.setAttribute("position", position);
    const sides = borderOf(mesh);
    const pairs = new Uint32Array((sides.length / 3) * 4);
    for (let k = 0; k < sides.length / 3; k++) pairs.set([sides[3 * k]!, sides[3 * k + 1]!, sides[3 * k + 1]!, sides[3 * k + 2]!], 4 * k);
    gl.edges.geometry.setIndex(new BufferAttribute(pairs, 1));
    const rings = [head.plan.outline, ...head.plan.openings.map((each) => each.ring)];
    gl.flat.geometry.setFromPoints(rings.flatMap((ring) => ring.flatMap(([x, y], i) => {
      const [u, v] = ring[(i + 1) % ring.length]!;
      return [new Vector3(x, y, 0), new Vector3(u, v, 0)];
    })));
    gl.flat.visible = true;
    this.fit();
  }

  show(choice: Choice, field: string): void {
    this.what = { choice, field };
    const { scene, gl } = this;
    if (!scene || !gl) return;
    const info = fieldOf(scene, field);
    const scale = scaleFor(scene, choice, info, this.range);
    const settlement = new BufferAttribute(values(scene, choice, "settlement"), 1);
    gl.faces.geometry.setAttribute("value", new BufferAttribute(values(scene, choice, field), 1));
    gl.faces.geometry.setAttribute("settlement", settlement);
    gl.edges.geometry.setAttribute("settlement", settlement);
    gl.faces.visible = gl.edges.visible = true;
    setBands(gl.uniforms, { values: settlement.array as Float32Array, contact: null, scale, lines: true, mesh: false });
    const ends = endsOf(scene, choice, "settlement");
    const most = Math.max(Math.abs(ends.min[0]), Math.abs(ends.max[0]), 1e-9) / 1000;
    this.base = roundStep((0.06 * this.extent()) / most);
    this.depth = (ends.min[0] + ends.max[0]) / 2;
    this.enlarge();
    this.onShow?.({ choice, field: info, scale, lifted: false });
  }

  setRange(range: Range): void {
    this.range = range;
    if (this.what) this.show(this.what.choice, this.what.field);
  }

  setTheme(to: Theme): void {
    this.theme = to;
    this.dress(to);
    this.request();
  }

  /** Show the whole plate, from the front and above. */
  fit(): void {
    const { gl, scene } = this;
    if (!gl || !scene) return;
    const [x0, y0, x1, y1] = scene.head.plan.bounds;
    const { clientWidth: width, clientHeight: height } = this.element;
    const half = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
    const wide = half * Math.min(1, (width || 1) / (height || 1) / 1.25);
    const away = (0.5 * Math.hypot(x1 - x0, y1 - y0) * 0.86) / wide;
    const target = new Vector3((x0 + x1) / 2, (y0 + y1) / 2, -this.depth * gl.uniforms.uTimes.value);
    gl.controls.target.copy(target);
    gl.camera.position.copy(target).addScaledVector(new Vector3(-0.42, -0.78, 0.62).normalize(), away);
    gl.camera.near = away / 100;
    gl.camera.far = away * 20;
    gl.controls.update();
    this.fitted = true;
    this.request();
  }

  /** Draw what is seen into a canvas of its own, on white: for paper. */
  snapshot(width: number, height: number, ratio: number): HTMLCanvasElement | null {
    const { gl } = this;
    if (!gl) return null;
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    this.dress("light");
    this.draw(width, height, ratio);
    canvas.getContext("2d")!.drawImage(gl.renderer.domElement, 0, 0, canvas.width, canvas.height);
    this.dress(this.theme);
    this.draw();
    return canvas;
  }

  /** What the settlement is multiplied by in the picture. */
  get enlargement(): number {
    return (this.gl?.uniforms.uTimes.value ?? 0) * 1000;
  }

  dispose(): void {
    this.resized.disconnect();
    cancelAnimationFrame(this.frame);
    const { gl } = this;
    this.gl = null;
    if (gl) {
      gl.controls.dispose();
      for (const each of [gl.faces, gl.edges, gl.flat, gl.columns]) {
        each.geometry.dispose();
        each.material.dispose();
      }
      gl.uniforms.uBands.value?.dispose();
      gl.renderer.dispose();
      gl.renderer.forceContextLoss();
    }
    this.element.remove();
  }

  private start(): Drawn {
    const canvas = make("canvas", {});
    const context = canvas.getContext("webgl2", { antialias: true, alpha: false, depth: true });
    if (!context) throw new Error("no WebGL 2");
    const renderer = new WebGLRenderer({ canvas, context });
    canvas.addEventListener("webglcontextlost", () => {
      if (this.gl) this.refuse("The graphics card has given up; load the page again for the view in space.");
    });
    const uniforms = { ...bandUniforms(), uTimes: { value: 1 }, uSun: { value: new Vector3() }, uInk: { value: [0, 0, 0] } };
    const shader = { glslVersion: GLSL3, uniforms, side: 2 as const };
    const faces = new Faces(new BufferGeometry(), new RawShaderMaterial({ ...shader, vertexShader: VERTEX, fragmentShader: FRAGMENT }));
    const edges = new LineSegments(new BufferGeometry(), new RawShaderMaterial({ ...shader, vertexShader: LINE_VERTEX, fragmentShader: LINE_FRAGMENT }));
    const flat = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
    const columns = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
    const world = new World();
    for (const each of [faces, edges, flat, columns]) {
      each.frustumCulled = false;
      each.visible = false;
      world.add(each);
    }
    const camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 1000);
    camera.up.set(0, 0, 1);
    const controls = new OrbitControls(camera, canvas);
    controls.addEventListener("change", () => this.request());
    controls.addEventListener("start", () => { this.fitted = false; });
    this.element.append(canvas, make("label", { class: "gs-space-times" }, "settlement enlarged", this.slider, this.times));
    return { renderer, world, camera, controls, uniforms, faces, edges, flat, columns };
  }

  private refuse(why: string): void {
    this.gl = null;
    this.element.replaceChildren(make("p", { class: "gs-space-none" }, why));
  }

  private dress(to: Theme): void {
    const { gl } = this;
    if (!gl) return;
    const { paper, ink, ink2 } = look(to);
    gl.renderer.setClearColor(paper, 1);
    gl.uniforms.uInk.value = rgbOf(ink).map((part) => part / 255);
    gl.flat.material.color.set(ink2);
    gl.columns.material.color.set(ink);
  }

  private extent(): number {
    const [x0, y0, x1, y1] = this.scene?.head.plan.bounds ?? [0, 0, 1, 1];
    return Math.max(x1 - x0, y1 - y0);
  }

  private enlarge(): void {
    const part = Number(this.slider.value);
    const times = part === 0 ? 0 : this.base * 10 ** ((part - 50) / 50);
    this.times.textContent = `${neat(times, 2)}\u00d7`;
    const { gl, scene } = this;
    if (!gl || !scene) return;
    gl.uniforms.uTimes.value = times / 1000; // settlements are in mm
    this.raiseColumns();
    if (this.fitted) this.fit();
    this.request();
  }

  /** Draw each column as an upright prism that stands on the bent plate. */
  private raiseColumns(): void {
    const { gl, scene, what } = this;
    if (!gl || !scene || !what) return;
    const { columns } = scene.head.plan;
    gl.columns.visible = columns.length > 0;
    const settlement = values(scene, what.choice, "settlement");
    const { nodes, nodeCount } = scene.mesh;
    const lines: Vector3[] = [];
    const tall = 0.07 * this.extent();
    for (const { x, y, ring } of columns) {
      let [nearest, least] = [0, Infinity];
      for (let i = 0; i < nodeCount; i++) {
        const far = (nodes[2 * i]! - x) ** 2 + (nodes[2 * i + 1]! - y) ** 2;
        if (far < least) [nearest, least] = [i, far];
      }
      const foot = -settlement[nearest]! * gl.uniforms.uTimes.value;
      // corners of a rectangle; of a round one every few
      const corners = ring.length > 8 ? ring.filter((_, i) => i % Math.ceil(ring.length / 8) === 0) : ring;
      corners.forEach(([u, v], i) => {
        const [s, t] = corners[(i + 1) % corners.length]!;
        lines.push(new Vector3(u, v, foot), new Vector3(u, v, foot + tall), new Vector3(u, v, foot + tall), new Vector3(s, t, foot + tall));
      });
    }
    gl.columns.geometry.dispose();
    gl.columns.geometry = new BufferGeometry().setFromPoints(lines);
  }

  private key(event: KeyboardEvent): boolean {
    const { gl } = this;
    if (!gl || event.target !== this.element || event.ctrlKey || event.metaKey || event.altKey) return false;
    const turn = Math.PI / 24;
    switch (event.key) {
      case "ArrowLeft": gl.controls.rotateLeft(turn); break;
      case "ArrowRight": gl.controls.rotateLeft(-turn); break;
      case "ArrowUp": gl.controls.rotateUp(turn); break;
      case "ArrowDown": gl.controls.rotateUp(-turn); break;
      case "+": case "=": gl.controls.dollyIn(0.85); break;
      case "-": gl.controls.dollyOut(0.85); break;
      case "0": this.fit(); return true;
      default: return false;
    }
    this.fitted = false;
    gl.controls.update();
    this.request();
    return true;
  }

  private request(): void {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  private draw(width = this.element.clientWidth, height = this.element.clientHeight, ratio = Math.min(window.devicePixelRatio || 1, 2)): void {
    const { gl } = this;
    if (!gl || !width || !height) return;
    const size = `${width} ${height} ${ratio}`;
    if (size !== this.size) {
      this.size = size;
      gl.renderer.setPixelRatio(ratio);
      gl.renderer.setSize(width, height, false);
      gl.camera.aspect = width / height;
      gl.camera.updateProjectionMatrix();
    }
    gl.uniforms.uRatio.value = ratio;
    gl.camera.updateMatrixWorld();
    gl.uniforms.uSun.value.copy(SUN).transformDirection(gl.camera.matrixWorldInverse);
    if (this.tiling && this.scene) {
      const away = gl.camera.position.distanceTo(gl.controls.target);
      const perMetre = (height * ratio) / (2 * Math.tan((FIELD_OF_VIEW * Math.PI) / 360) * away);
      const fine = 24 * this.scene.mesh.elementCount;
      if (this.tiling.side * perMetre < SMALL) gl.faces.geometry.setDrawRange(fine, this.tiling.faces.length - fine);
      else gl.faces.geometry.setDrawRange(0, fine);
    }
    gl.renderer.render(gl.world, gl.camera);
  }
}

// The plate in space, bent by its settlement many times enlarged, with a field in colours.
import {
  BufferAttribute, BufferGeometry, GLSL3, LineBasicMaterial, LineLoop, Mesh as Faces, PerspectiveCamera, RawShaderMaterial,
  Scene as World, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { make } from "./dom";
import { facesOf } from "./faces";
import { type Choice, extremes, fieldOf, values } from "./fields";
import { BANDS, bandUniforms, setBands } from "./gl-painter";
import { type Range, type Shown, scaleFor } from "./plan-view";
import { number, roundStep } from "./scale";
import type { Scene } from "./scene";
import { type Theme, theme } from "./theme";
import "./space-view.css";

const VERTEX = `
in vec3 position;
in float value;
in float settlement;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
uniform float uTimes;
out float vValue;
out vec3 vPlace;
void main() {
  vValue = value;
  vec4 place = modelViewMatrix * vec4(position.xy, -settlement * uTimes, 1.0);
  vPlace = place.xyz;
  gl_Position = projectionMatrix * place;
}`;

const FRAGMENT = `
precision highp float;
in float vValue;
in vec3 vPlace;
out vec4 result;
${BANDS}
void main() {
  vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  float light = 0.62 + 0.38 * abs(dot(normal, normalize(vec3(0.25, 0.55, 0.8))));
  result = vec4(banded(vValue) * light, 1.0);
}`;

export class SpaceView {
  /** Another field, combination or scale is shown; null: none. */
  onShow?: (shown: Shown | null) => void;
  readonly element = make("div", { class: "gs-space", tabindex: 0, role: "application", "aria-label": "View in space. Drag turns it, the wheel zooms." });
  private readonly slider = make("input", { type: "range", min: 0, max: 100, value: 50, "aria-label": "Exaggeration of the settlement" });
  private readonly times = make("output", {});
  private gl: {
    renderer: WebGLRenderer; world: World; camera: PerspectiveCamera; controls: OrbitControls; faces: Faces<BufferGeometry, RawShaderMaterial>;
    uniforms: ReturnType<typeof bandUniforms> & { uTimes: { value: number } }; lines: LineLoop[];
  } | null = null;
  private scene: Scene | null = null;
  private what: { choice: Choice; field: string } | null = null;
  private range: Range = "auto";
  private base = 1; // exaggeration in the slider's middle
  private frame = 0;
  private readonly resized: ResizeObserver;

  constructor(container: HTMLElement) {
    container.append(this.element);
    this.slider.addEventListener("input", () => this.exaggerate());
    this.resized = new ResizeObserver(() => this.request());
    this.resized.observe(this.element);
    try {
      this.gl = this.start();
    } catch {
      this.element.append(make("p", { class: "gs-space-none" }, "This browser has no WebGL 2, which the view in space needs. The plan works without it."));
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
    gl.faces.geometry.dispose();
    gl.faces.geometry = new BufferGeometry();
    gl.faces.visible = false;
    for (const line of gl.lines.splice(0)) gl.world.remove(line);
    if (!scene) return this.request();
    const { mesh, head } = scene;
    const places = new Float32Array(3 * mesh.nodeCount);
    for (let i = 0; i < mesh.nodeCount; i++) places.set([mesh.nodes[2 * i]!, mesh.nodes[2 * i + 1]!], 3 * i);
    gl.faces.geometry.setAttribute("position", new BufferAttribute(places, 3));
    gl.faces.geometry.setIndex(new BufferAttribute(facesOf(mesh), 1));
    for (const ring of [head.plan.outline, ...head.plan.openings.map((each) => each.ring)]) {
      const geometry = new BufferGeometry().setFromPoints(ring.map(([x, y]) => new Vector3(x, y, 0)));
      const line = new LineLoop(geometry, new LineBasicMaterial({ color: 0x808890 }));
      gl.lines.push(line);
      gl.world.add(line);
    }
    this.fit();
  }

  show(choice: Choice, field: string): void {
    this.what = { choice, field };
    const { scene, gl } = this;
    if (!scene || !gl) return;
    const info = fieldOf(scene, field);
    const [of, settlement] = [values(scene, choice, field), values(scene, choice, "settlement")];
    const scale = scaleFor(scene, choice, info, of, this.range);
    const geometry = gl.faces.geometry;
    geometry.setAttribute("value", new BufferAttribute(of, 1));
    geometry.setAttribute("settlement", new BufferAttribute(settlement, 1));
    gl.faces.visible = true;
    setBands(gl.uniforms, { values: of, contact: null, scale, lines: true, mesh: false });
    const { min, max } = extremes(settlement);
    const [x0, y0, x1, y1] = scene.head.plan.bounds;
    const most = Math.max(Math.abs(min), Math.abs(max), 1e-9) / 1000;
    this.base = roundStep((0.08 * Math.max(x1 - x0, y1 - y0)) / most);
    this.exaggerate();
    this.onShow?.({ choice, field: info, scale, lifted: false });
  }

  setRange(range: Range): void {
    this.range = range;
    if (this.what) this.show(this.what.choice, this.what.field);
  }

  setTheme(to: Theme): void {
    this.gl?.renderer.setClearColor(to === "dark" ? 0x16191d : 0xffffff, 1);
    this.request();
  }

  /** Show the whole plate from the front, above. */
  fit(): void {
    const { gl, scene } = this;
    if (!gl || !scene) return;
    const [x0, y0, x1, y1] = scene.head.plan.bounds;
    const size = Math.hypot(x1 - x0, y1 - y0);
    gl.controls.target.set((x0 + x1) / 2, (y0 + y1) / 2, 0);
    gl.camera.position.set((x0 + x1) / 2 - 0.45 * size, (y0 + y1) / 2 - size, 0.75 * size);
    gl.camera.near = size / 100;
    gl.camera.far = size * 20;
    gl.controls.update();
    this.request();
  }

  /** Draw what is seen into a canvas of its own, on white: for paper. */
  snapshot(width: number, height: number, ratio: number): HTMLCanvasElement | null {
    const { gl } = this;
    if (!gl) return null;
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    this.setTheme("light");
    this.draw(width, height, ratio);
    canvas.getContext("2d")!.drawImage(gl.renderer.domElement, 0, 0, canvas.width, canvas.height);
    this.setTheme(theme());
    this.draw();
    return canvas;
  }

  dispose(): void {
    this.resized.disconnect();
    cancelAnimationFrame(this.frame);
    if (this.gl) {
      this.gl.controls.dispose();
      this.gl.faces.geometry.dispose();
      this.gl.faces.material.dispose();
      this.gl.renderer.dispose();
      this.gl.renderer.forceContextLoss();
    }
    this.element.remove();
  }

  private start() {
    const canvas = make("canvas", {});
    const context = canvas.getContext("webgl2", { antialias: true, alpha: false, depth: true });
    if (!context) throw new Error("no WebGL 2");
    const renderer = new WebGLRenderer({ canvas, context });
    renderer.setClearColor(theme() === "dark" ? 0x16191d : 0xffffff, 1);
    const uniforms = { ...bandUniforms(), uTimes: { value: 1 } };
    const material = new RawShaderMaterial({ glslVersion: GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms, side: 2 });
    const faces = new Faces(new BufferGeometry(), material);
    faces.frustumCulled = false;
    faces.visible = false;
    const world = new World();
    world.add(faces);
    const camera = new PerspectiveCamera(35, 1, 0.1, 1000);
    camera.up.set(0, 0, 1);
    const controls = new OrbitControls(camera, canvas);
    controls.addEventListener("change", () => this.request());
    this.element.append(canvas, make("label", { class: "gs-space-times" }, "settlement enlarged ", this.slider, this.times));
    return { renderer, world, camera, controls, faces, uniforms, lines: [] as LineLoop[] };
  }

  private exaggerate(): void {
    const part = Number(this.slider.value);
    const times = part === 0 ? 0 : this.base * 10 ** ((part - 50) / 50);
    this.times.textContent = ` ${number(times, 2)}\u00d7`;
    if (this.gl) this.gl.uniforms.uTimes.value = times / 1000; // settlements are in mm
    this.request();
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
    gl.renderer.setPixelRatio(ratio);
    gl.renderer.setSize(width, height);
    gl.camera.aspect = width / height;
    gl.camera.updateProjectionMatrix();
    gl.uniforms.uRatio.value = ratio;
    gl.renderer.render(gl.world, gl.camera);
  }
}

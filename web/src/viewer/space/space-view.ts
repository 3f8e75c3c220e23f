// The plate in space, bent by its settlement many times enlarged, with a field in colours.
import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { neat, roundStep } from "../data/color-scale";
import { type Choice, endsOf, fieldOf, values } from "../data/fields";
import type { Scene } from "../data/scene";
import { SMALL, type Tiling, tilingOf } from "../data/triangulation";
import { type Range, type Shown, scaleFor } from "../plan/plan-view";
import { make } from "../shared/dom";
import { type Theme, theme } from "../shared/theme";
import { CpuSpacePainter, GlSpacePainter, type SpacePainter } from "./space-renderer";
import "./space-view.css";

const FIELD_OF_VIEW = 32;

export class SpaceView {
  /** Another field, combination or scale is shown; null: none. */
  onShow?: (shown: Shown | null) => void;
  readonly element = make("div", {
    class: "gs-space",
    tabindex: 0,
    role: "application",
    "aria-label": "View in space. Drag or arrow keys turn it, the wheel or plus and minus zoom, 0 shows all.",
  });
  private readonly slider = make("input", {
    type: "range",
    min: 0,
    max: 100,
    value: 50,
    "aria-label": "Enlargement of the settlement",
  });
  private readonly times = make("output", {});
  private readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 1000);
  private readonly stage = make("div", { class: "gs-space-stage" });
  private readonly controls: OrbitControls;
  private painter: SpacePainter;
  private scene: Scene | null = null;
  private tiling: Tiling | null = null;
  private what: { choice: Choice; field: string } | null = null;
  private range: Range = "auto";
  private theme: Theme = theme();
  private base = 1; // enlargement in the slider's middle
  private enlarged = 1;
  private depth = 0; // of the middle between least and largest settlement [mm]
  private feet: number[] = []; // the node next to each column
  private fitted = false; // whether the user has left the view as `fit` made it
  private frame = 0;
  private readonly resized: ResizeObserver;

  constructor(container: HTMLElement) {
    this.painter = this.makePainter();
    this.stage.append(this.painter.canvas);
    this.element.append(
      this.stage,
      make("label", { class: "gs-space-times" }, "settlement enlarged", this.slider, this.times),
    );
    container.append(this.element);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.stage);
    this.controls.addEventListener("change", () => this.request());
    this.controls.addEventListener("start", () => {
      this.fitted = false;
    });
    this.slider.addEventListener("input", () => this.enlarge());
    this.element.addEventListener("keydown", (event) => {
      if (this.key(event)) event.preventDefault();
    });
    this.resized = new ResizeObserver(() => (this.fitted ? this.fit() : this.request()));
    this.resized.observe(this.element);
    this.painter.setTheme(this.theme);
  }

  /** Whether a graphics card draws; otherwise the processor does. */
  get accelerated(): boolean {
    return this.painter instanceof GlSpacePainter;
  }

  /** What the settlement is multiplied by in the picture. */
  get enlargement(): number {
    return this.enlarged;
  }

  setScene(scene: Scene | null): void {
    this.scene = scene;
    this.what = null;
    this.tiling = scene ? tilingOf(scene.mesh) : null;
    this.painter.setMesh(scene?.mesh ?? null, this.tiling);
    this.feet = scene ? scene.head.plan.columns.map(({ x, y }) => nearestNode(scene, x, y)) : [];
    this.fit();
  }

  show(choice: Choice, field: string): void {
    this.what = { choice, field };
    const { scene } = this;
    if (!scene) return;
    const info = fieldOf(scene, field);
    const scale = scaleFor(scene, choice, info, this.range);
    this.painter.setPicture({
      settlement: values(scene, choice, "settlement"),
      values: values(scene, choice, field),
      scale,
    });
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
    this.painter.setTheme(to);
    this.request();
  }

  /** Show the whole plate, from the front and above. */
  fit(): void {
    const { scene, camera, controls } = this;
    this.request();
    if (!scene) return;
    const [x0, y0, x1, y1] = scene.head.plan.bounds;
    const { clientWidth: width, clientHeight: height } = this.element;
    const half = Math.tan((FIELD_OF_VIEW * Math.PI) / 360) * Math.min(1, (width || 1) / (height || 1) / 1.25);
    const away = (0.5 * Math.hypot(x1 - x0, y1 - y0) * 0.86) / half;
    const target = new Vector3((x0 + x1) / 2, (y0 + y1) / 2, (-this.depth * this.enlarged) / 1000);
    controls.target.copy(target);
    camera.position.copy(target).addScaledVector(new Vector3(-0.42, -0.78, 0.62).normalize(), away);
    camera.near = away / 100;
    camera.far = away * 20;
    camera.updateProjectionMatrix();
    controls.update();
    this.fitted = true;
  }

  /** Draw what is seen into a canvas of its own, on white: for paper. */
  snapshot(width: number, height: number, ratio: number): HTMLCanvasElement {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    this.painter.setTheme("light");
    this.draw(width, height, ratio);
    canvas.getContext("2d")!.drawImage(this.painter.canvas, 0, 0, canvas.width, canvas.height);
    this.painter.setTheme(this.theme);
    this.draw();
    return canvas;
  }

  dispose(): void {
    this.resized.disconnect();
    cancelAnimationFrame(this.frame);
    this.controls.dispose();
    this.painter.dispose();
    this.element.remove();
  }

  /** Return what draws; if the graphics card is lost later, the processor takes over. */
  private makePainter(): SpacePainter {
    try {
      const painter = new GlSpacePainter();
      painter.canvas.addEventListener("webglcontextlost", () => {
        if (this.painter !== painter || !this.element.isConnected) return;
        this.painter = new CpuSpacePainter();
        painter.canvas.replaceWith(this.painter.canvas);
        this.painter.setTheme(this.theme);
        this.painter.setMesh(this.scene?.mesh ?? null, this.tiling);
        if (this.what) this.show(this.what.choice, this.what.field);
      });
      return painter;
    } catch {
      return new CpuSpacePainter();
    }
  }

  private extent(): number {
    const [x0, y0, x1, y1] = this.scene?.head.plan.bounds ?? [0, 0, 1, 1];
    return Math.max(x1 - x0, y1 - y0);
  }

  private enlarge(): void {
    const part = Number(this.slider.value);
    this.enlarged = part === 0 ? 0 : this.base * 10 ** ((part - 50) / 50);
    this.times.textContent = `${neat(this.enlarged, 2)}\u00d7`;
    if (!this.scene || !this.what) return;
    this.painter.setLines(this.flatLines(), this.columnLines());
    if (this.fitted) this.fit();
    this.request();
  }

  /** Return the outline and the openings where they were. */
  private flatLines(): Float32Array {
    const { plan } = this.scene!.head;
    const rings = [plan.outline, ...plan.openings.map((each) => each.ring)];
    return Float32Array.from(
      rings.flatMap((ring) =>
        ring.flatMap(([x, y], i) => {
          const [u, v] = ring[(i + 1) % ring.length]!;
          return [x, y, 0, u, v, 0];
        }),
      ),
    );
  }

  /** Return each column as an upright prism that stands on the bent plate. */
  private columnLines(): Float32Array {
    const { scene, what } = this;
    const settlement = values(scene!, what!.choice, "settlement");
    const tall = 0.07 * this.extent();
    return Float32Array.from(
      scene!.head.plan.columns.flatMap(({ ring }, k) => {
        const foot = (-settlement[this.feet[k]!]! * this.enlarged) / 1000; // settlements are in mm
        // corners of a rectangle; of a round one every few
        const corners = ring.length > 8 ? ring.filter((_, i) => i % Math.ceil(ring.length / 8) === 0) : ring;
        return corners.flatMap(([u, v], i) => {
          const [s, t] = corners[(i + 1) % corners.length]!;
          return [u, v, foot, u, v, foot + tall, u, v, foot + tall, s, t, foot + tall];
        });
      }),
    );
  }

  private key(event: KeyboardEvent): boolean {
    if (event.target !== this.element || event.ctrlKey || event.metaKey || event.altKey) return false;
    const { controls } = this;
    const turn = Math.PI / 24;
    switch (event.key) {
      case "ArrowLeft":
        controls.rotateLeft(turn);
        break;
      case "ArrowRight":
        controls.rotateLeft(-turn);
        break;
      case "ArrowUp":
        controls.rotateUp(turn);
        break;
      case "ArrowDown":
        controls.rotateUp(-turn);
        break;
      case "+":
      case "=":
        controls.dollyIn(0.85);
        break;
      case "-":
        controls.dollyOut(0.85);
        break;
      case "0":
        this.fit();
        return true;
      default:
        return false;
    }
    this.fitted = false;
    controls.update();
    this.request();
    return true;
  }

  private request(): void {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  private draw(
    width = this.stage.clientWidth,
    height = this.stage.clientHeight,
    ratio = Math.min(window.devicePixelRatio || 1, 2),
  ): void {
    const { camera } = this;
    if (!width || !height) return;
    if (camera.aspect !== width / height) {
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
    }
    camera.updateMatrixWorld();
    const away = camera.position.distanceTo(this.controls.target);
    const perMetre = (height * ratio) / (2 * Math.tan((FIELD_OF_VIEW * Math.PI) / 360) * away);
    this.painter.draw(camera, this.enlarged / 1000, width, height, ratio, (this.tiling?.side ?? 1) * perMetre < SMALL);
  }
}

function nearestNode({ mesh }: Scene, x: number, y: number): number {
  let [nearest, least] = [0, Infinity];
  for (let i = 0; i < mesh.nodeCount; i++) {
    const far = (mesh.nodes[2 * i]! - x) ** 2 + (mesh.nodes[2 * i + 1]! - y) ** 2;
    if (far < least) [nearest, least] = [i, far];
  }
  return nearest;
}

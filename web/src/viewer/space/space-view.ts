// The plate in space, bent by its settlement many times exaggerated, with a field in colors.

import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { EVERYTHING } from "../data/boxes";
import { type Choice, extremesOf, fieldOf, nodalValues } from "../data/fields";
import { lengthsOf } from "../data/lengths";
import { formatShort, roundStep } from "../data/numbers";
import type { Ring, Scene } from "../data/scene";
import { scaleFor } from "../data/shown-field";
import { FieldView } from "../renderer/field-view";
import { h, setText } from "../shared/dom";
import "./space-view.css";

const FIELD_OF_VIEW = 32; // degrees
const TANGENT = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
export class SpaceView extends FieldView {
  private readonly slider = h("input", {
    type: "range",
    min: 0,
    max: 100,
    "aria-label": "Settlement exaggeration",
  });
  private readonly factor = h("output");
  private readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 1000);
  private readonly stage = h("div", { class: "gs-space-stage" });
  private readonly controls: OrbitControls;
  private base = 1; // exaggeration in the slider's middle
  private exaggeration = 1;
  private depth = 0; // of the middle between least and greatest settlement
  private feet: number[] = []; // the node next to each column

  constructor(container: HTMLElement) {
    const help =
      "3-D view. Drag or use the arrow keys to rotate, scroll or press plus and minus to zoom, 0 to show everything.";
    super(h("div", { class: "gs-space", tabindex: 0, role: "application", "aria-label": help }), true);
    this.stage.append(this.renderer.canvas);
    const label = h("label", { class: "gs-space-factor" }, "settlement exaggerated", this.slider, this.factor);
    this.element.append(this.stage, label);
    container.append(this.element);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.stage);
    this.controls.addEventListener("change", () => this.redraw());
    this.controls.addEventListener("start", () => {
      this.fitted = false;
    });
    this.slider.addEventListener("input", () => this.exaggerate());
    new ResizeObserver(() => (this.fitted ? this.fit() : this.redraw())).observe(this.element);
    this.load();
  }

  override setScene(scene: Scene | null): void {
    super.setScene(scene);
    this.feet = scene ? scene.head.plan.columns.map(({ x, y }) => nearestNode(scene, x, y)) : [];
    this.fit();
  }

  protected refresh(): void {
    const { scene } = this;
    if (!scene || !this.choice) return;
    const { choice, field } = this.choice;
    const info = fieldOf(scene, field);
    const scale = scaleFor(scene, choice, info, this.range);
    const settlement = nodalValues(scene, choice, "settlement");
    const nodal = nodalValues(scene, choice, field);
    this.renderer.setPicture({ values: nodal, contact: null, settlement, scale, lines: true, mesh: this.mesh });
    const ends = extremesOf(scene, choice, "settlement");
    const greatest = Math.max(Math.abs(ends.min[0]), Math.abs(ends.max[0]), 1e-9) / this.perMeter;
    this.base = roundStep((0.06 * this.extent()) / greatest);
    this.depth = (ends.min[0] + ends.max[0]) / 2;
    this.exaggerate();
    this.onShow?.({ choice, field: info, scale, lifted: false });
  }

  /** Show the entire plate, from the front and above. */
  fit(): void {
    const { scene, camera, controls } = this;
    this.redraw();
    if (!scene) return;
    const [x0, y0, x1, y1] = scene.head.plan.bounds;
    const { clientWidth: width, clientHeight: height } = this.element;
    const half = TANGENT * Math.min(1, (width || 1) / (height || 1) / 1.25);
    const away = (0.5 * Math.hypot(x1 - x0, y1 - y0) * 0.86) / half;
    const target = new Vector3((x0 + x1) / 2, (y0 + y1) / 2, (-this.depth * this.exaggeration) / this.perMeter);
    controls.target.copy(target);
    camera.position.copy(target).addScaledVector(new Vector3(-0.42, -0.78, 0.62).normalize(), away);
    camera.near = away / 100;
    camera.far = away * 20;
    camera.updateProjectionMatrix();
    controls.update();
    this.fitted = true;
  }

  /** Draw what is seen, on white: for paper. */
  snapshot(width: number, height: number, ratio: number): HTMLElement {
    const picture = this.takePicture(width, height, ratio, () => this.draw(width, height, ratio));
    picture.style.width = `${width}px`;
    return picture;
  }

  /** Return how many units of the settlement make a meter. */
  private get perMeter(): number {
    return lengthsOf(this.scene?.head.plan).small_per_meter;
  }

  private extent(): number {
    const [x0, y0, x1, y1] = this.scene?.head.plan.bounds ?? [0, 0, 1, 1];
    return Math.max(x1 - x0, y1 - y0);
  }

  private exaggerate(): void {
    const part = Number(this.slider.value);
    this.exaggeration = part === 0 ? 0 : this.base * 10 ** ((part - 50) / 50);
    setText(this.factor, `${formatShort(this.exaggeration, 2)}\u00d7`);
    if (!this.scene || !this.choice) return;
    this.renderer.setLines({
      flat: this.flatLines(this.scene),
      columns: this.columnLines(this.scene, this.choice.choice),
    });
    if (this.fitted) this.fit();
    this.redraw();
  }

  /** Return the outline and the openings where they were. */
  private flatLines({ head: { plan } }: Scene): number[] {
    const rings = [plan.outline, ...plan.openings.map((each) => each.ring)];
    return rings.flatMap((ring) => sidesOf(ring, ([x, y], [u, v]) => [x, y, 0, u, v, 0]));
  }

  /** Return each column as an upright prism that stands on the bent plate. */
  private columnLines(scene: Scene, choice: Choice): number[] {
    const settlement = nodalValues(scene, choice, "settlement");
    const height = 0.07 * this.extent();
    return scene.head.plan.columns.flatMap(({ ring }, k) => {
      const foot = (-settlement[this.feet[k]!]! * this.exaggeration) / this.perMeter;
      const top = foot + height;
      // corners of a rectangle; of a round one every few
      const corners = ring.length > 8 ? ring.filter((_, i) => i % Math.ceil(ring.length / 8) === 0) : ring;
      return sidesOf(corners, ([x, y], [u, v]) => [x, y, foot, x, y, top, x, y, top, u, v, top]);
    });
  }

  protected step([x, y]: readonly [number, number]): void {
    this.controls.rotateLeft((-x * Math.PI) / 24);
    this.controls.rotateUp((y * Math.PI) / 24);
    this.follow();
  }

  protected zoom(enlarge: boolean): void {
    if (enlarge) this.controls.dollyIn(0.85);
    else this.controls.dollyOut(0.85);
    this.follow();
  }

  /** Draw from where the keys have moved the camera. */
  private follow(): void {
    this.fitted = false;
    this.controls.update();
    this.redraw();
  }

  protected draw(width = this.stage.clientWidth, height = this.stage.clientHeight, ratio = this.screenRatio): void {
    const { camera } = this;
    const exaggeration = this.exaggeration / this.perMeter;
    if (!width || !height) return;
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    const scale = height / (2 * TANGENT * camera.position.distanceTo(this.controls.target));
    this.renderer.draw({ camera, width, height, ratio, scale, exaggeration, box: EVERYTHING });
  }
}

/** Return what is made of each side of a ring. */
function sidesOf(ring: Ring, make: (from: Ring[number], to: Ring[number]) => number[]): number[] {
  return ring.flatMap((from, i) => make(from, ring[(i + 1) % ring.length]!));
}

function nearestNode({ mesh }: Scene, x: number, y: number): number {
  let [nearest, least] = [0, Infinity];
  for (let i = 0; i < mesh.nodeCount; i++) {
    const distance = (mesh.nodes[2 * i]! - x) ** 2 + (mesh.nodes[2 * i + 1]! - y) ** 2;
    if (distance < least) [nearest, least] = [i, distance];
  }
  return nearest;
}

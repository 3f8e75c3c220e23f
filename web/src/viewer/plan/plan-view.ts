// The plate in plan: a field in colors, and above it the symbols of the plan.

import { boxAround } from "../data/boxes";
import { clearOfEdges, contourNumbers, rasterNumbers } from "../data/field-numbers";
import {
  CONTACT,
  extremesOf,
  type FieldExtremes,
  fieldOf,
  findExtremes,
  isEnvelope,
  nodalValues,
} from "../data/fields";
import { lengthsOf } from "../data/lengths";
import { formatNumber } from "../data/numbers";
import { distanceBetween, placeBeside } from "../data/points";
import type { Extreme, Plan, Point, Scene } from "../data/scene";
import { type ShownField, scaleFor } from "../data/shown-field";
import { FieldView } from "../renderer/field-view";
import type { Picture } from "../renderer/renderer";
import { h } from "../shared/dom";
import { Camera, isNear, transformOf } from "./camera";
import { isFar, Motion, pixelOf, Touches, zoomByWheel } from "./navigation";
import { BEYOND, type Marks, type NumbersAt, Overlay } from "./overlay";
import { ALL_LAYERS, type Layers } from "./plan-symbols";
import { annotationsOf } from "./result-symbols";
import { RULER } from "./rulers";
import "./plan-view.css";

export type Tool = "pan" | "pick" | "section";

const NEAR = 7; // px: how near to the section a drag begins that makes a strip

export class PlanView extends FieldView {
  /** A point of the plan was picked [m]. */
  onPick?: (at: Point) => void;
  /** A section was cut between two points, or with a width a strip [m]. */
  onSection?: (start: Point, end: Point, width: number) => void;
  /** The pointer is over a point of the plan [m]; null: it left. */
  onHover?: (at: Point | null) => void;
  /** What is shown; null: no field. */
  shown: ShownField | null = null;
  private readonly overlay = new Overlay();
  private plan: Plan | null = null;
  private picture: Picture | null = null;
  private readonly camera = new Camera();
  private tool: Tool = "pan";
  private readonly layers: Layers = { ...ALL_LAYERS };
  private readonly options = { lines: true, contact: true };
  private readonly marks: Marks = {
    pick: null,
    place: null,
    section: null,
    width: 0,
    selected: null,
    extremes: [],
    factors: null,
    written: { reactions: [], bars: [] },
  };
  private sectionStart: Point | null = null;
  private readonly touches = new Touches();
  private pressed: Point | null = null; // where a click may begin
  private pulling = false; // whether a section is pulled from where the pointer was pressed
  private widening = false; // whether the side of a strip is
  private readonly motion = new Motion(() => this.redraw());
  private isDrawn = false; // whether the overlay shows what is to be shown
  private painted: { camera: Camera; when: number } | null = null; // what the renderer drew last

  constructor(container: HTMLElement) {
    const label = "Plan view. Use the arrow keys to pan, plus and minus to zoom, 0 to show everything.";
    super(h("div", { class: "gs-plan", tabindex: 0, role: "application", "aria-label": label }), false);
    this.element.append(this.renderer.canvas, this.overlay.element);
    container.append(this.element);
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.element);
    this.load();
    this.resize();
  }

  /** Show a scene, with its plan; null takes the field away and leaves the plan. */
  override setScene(scene: Scene | null): void {
    super.setScene(scene);
    if (scene) this.setPlan(scene.head.plan);
  }

  /** Show a plan; the field, if there is one, stays. */
  setPlan(plan: Plan | null): void {
    const isFirst = this.plan === null && plan !== null;
    const hasMoved = plan !== null && this.plan !== null && String(plan.bounds) !== String(this.plan.bounds);
    this.plan = plan;
    if (isFirst || (hasMoved && this.fitted)) this.fit();
    this.redraw();
  }

  setTool(tool: Tool): void {
    this.tool = tool;
    this.sectionStart = null;
    this.element.dataset.tool = tool;
  }

  /** Choose what is drawn above the field. */
  setLayers(layers: Partial<Layers>): void {
    Object.assign(this.layers, layers);
    this.redraw();
  }

  /** Choose lines between bands, the contact boundary. */
  setOptions(options: Partial<{ lines: boolean; contact: boolean }>): void {
    Object.assign(this.options, options);
    this.refresh();
  }

  /** Set a mark; null: remove it. */
  mark<K extends "pick" | "place" | "section" | "width" | "selected">(name: K, at: Marks[K]): void {
    this.marks[name] = at;
    super.redraw();
  }

  /** Return how far so many pixels reach on the plan [m]. */
  lengthOf(pixels: number): number {
    return pixels / this.camera.scale;
  }

  /** Move the view so that a place is in its middle, unless all is seen. */
  center([x, y]: Point): void {
    if (this.fitted) return;
    Object.assign(this.camera, { x, y });
    this.redraw();
  }

  fit(): void {
    this.fitTo(this.camera);
    this.fitted = true;
    this.redraw();
  }

  /** Draw what is seen, on white, `ratio` dots per pixel: for paper. */
  snapshot(width: number, height: number, ratio: number): HTMLElement {
    const camera = Object.assign(new Camera(), this.camera, { width, height });
    // what is seen now fits into the paper
    camera.scale *= Math.min(width / Math.max(this.camera.width, 1), height / Math.max(this.camera.height, 1));
    if (this.fitted) this.fitTo(camera);
    const picture = this.takePicture(width, height, ratio, () => this.paint(camera, ratio));
    const overlay = new Overlay();
    overlay.draw(camera, this.plan, this.layers, this.marks, this.numbersAt);
    return h("div", { class: "gs-snapshot", style: `width:${width}px;height:${height}px` }, picture, overlay.element);
  }

  protected refresh(): void {
    const { scene, choice: shown, options, marks } = this;
    this.picture = this.shown = this.painted = marks.factors = null;
    marks.extremes = [];
    marks.written = { reactions: [], bars: [] };
    if (scene && shown) {
      const field = fieldOf(scene, shown.field);
      const hasContact = scene.head.fields.some((each) => each.name === CONTACT);
      const contact = hasContact ? nodalValues(scene, shown.choice, CONTACT) : null;
      const lifted = contact !== null && findExtremes(contact).max > 0;
      const scale = scaleFor(scene, shown.choice, field, this.range);
      const { lines } = options;
      const nodal = nodalValues(scene, shown.choice, shown.field);
      const visible = options.contact && lifted ? contact : null;
      this.picture = { values: nodal, contact: visible, settlement: null, scale, lines, mesh: this.mesh };
      this.shown = { choice: shown.choice, field, scale, lifted };
      marks.extremes = extremeMarks(extremesOf(scene, shown.choice, shown.field));
      const factors = isEnvelope(shown.choice) ? null : scene.head.combinations[shown.choice]?.factors;
      const combination = isEnvelope(shown.choice) ? null : shown.choice;
      marks.written = annotationsOf(scene.head, combination, shown.field);
      if (factors?.length) marks.factors = new Map(factors);
    }
    this.renderer.setPicture(this.picture);
    this.onShow?.(this.shown);
    this.resize(); // keys and clicks may come before the observer has seen an element that has just appeared
  }

  /** Let the camera have the element's size, and show the entire plate still if it is what was seen. */
  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (!width || !height) return;
    Object.assign(this.camera, { width, height });
    if (this.fitted) this.fit();
    else this.redraw();
  }

  private fitTo(camera: Camera): void {
    const { axes, rulers } = this.layers;
    const bubbles = (axes && this.plan?.axes) || [];
    const [x0, y0, x1, y1] = this.plan?.bounds ?? [-5, -5, 5, 5];
    const all = boxAround([[x0, y0], [x1, y1], ...bubbles.map(({ bubble }) => bubble)]);
    camera.fit(all, 36, rulers ? RULER.left : 0, rulers ? RULER.bottom + 14 : 0);
  }

  protected override redraw(): void {
    this.isDrawn = false;
    super.redraw();
  }

  /** The user has moved the view: draw roughly until nothing has moved for a while. */
  private moved(): void {
    this.fitted = false;
    this.motion.moved();
    super.redraw();
  }

  protected draw(): void {
    const { camera, plan, layers, marks, overlay } = this;
    if (!this.element.clientWidth || !this.element.clientHeight) return;
    if (this.isDrawn && !this.motion.on) return overlay.drawMarks(camera, marks);
    this.drawField();
    if (this.motion.on && this.isDrawn && overlay.follow(camera))
      return overlay.drawRulers(camera, layers, lengthsOf(plan));
    overlay.draw(camera, plan, layers, marks, this.numbersAt);
    this.isDrawn = true;
  }

  /** Return the numbers on the field. */
  private readonly numbersAt: NumbersAt = (box, scale) => {
    const { scene, picture, layers } = this;
    if (!scene || !picture || !layers.numbers) return [];
    const { values, scale: colors, lines } = picture;
    const isClear = clearOfEdges(scene.head.plan, scale);
    const levels = lines ? contourNumbers(scene.mesh, values, colors, box, scale, isClear) : [];
    return [...levels, ...rasterNumbers(scene.mesh, values, box, scale, isClear)];
  };

  /**
   * Draw the field. Without a graphics card, while the view moves, the last drawing is moved and stretched instead, and
   * the field is drawn again when the view is still or shows too much beyond that drawing.
   */
  private drawField(): void {
    const { renderer, camera, painted } = this;
    const now = performance.now();
    if (this.motion.on && painted && !renderer.accelerated) {
      const shift = camera.since(painted.camera);
      if (isNear(shift, camera, BEYOND) || now - painted.when < 4 * renderer.cost) {
        renderer.canvas.style.transform = transformOf(shift);
        return;
      }
    }
    this.paint(camera, this.screenRatio);
    renderer.canvas.style.transform = "";
    this.painted = { camera: camera.copy(), when: now };
  }

  private paint(camera: Camera, ratio: number): void {
    const { width, height, scale, box } = camera;
    this.renderer.draw({ camera: camera.lookDown(), width, height, ratio, scale, exaggeration: 0, box });
  }

  private listen(): void {
    const { element, camera, touches } = this;
    element.addEventListener("pointerdown", (event) => {
      if (event.button > 1) return;
      element.setPointerCapture(event.pointerId);
      touches.set(event.pointerId, pixelOf(element, event));
      this.pressed = touches.size === 1 ? pixelOf(element, event) : null;
      this.pulling = false;
    });
    element.addEventListener("pointermove", (event) => this.drag(event));
    const release = (event: PointerEvent) => {
      if (!touches.delete(event.pointerId)) return;
      const isClick = event.type === "pointerup" && (this.pressed || this.pulling) && event.button === 0;
      if (isClick) this.click(camera.toPlan(pixelOf(element, event)), event.shiftKey);
      this.pressed = null;
      this.pulling = false;
    };
    element.addEventListener("pointerup", release);
    element.addEventListener("pointercancel", release);
    element.addEventListener("pointerleave", () => this.hover(null));
    element.addEventListener(
      "wheel",
      (event) => {
        zoomByWheel(camera, event, pixelOf(element, event));
        this.moved();
      },
      { passive: false },
    );
    element.addEventListener("dblclick", () => {
      if (this.tool === "pan") this.fit();
    });
  }

  private drag(event: PointerEvent): void {
    const { camera, touches } = this;
    const at = pixelOf(this.element, event);
    const before = this.pressed ?? touches.get(event.pointerId);
    if (!before) return this.hover(camera.toPlan(at), event.shiftKey);
    if (this.pressed && !isFar(this.pressed, at)) return;
    if (this.pressed && this.tool === "section" && event.buttons === 1) {
      this.widening = !this.sectionStart && this.isOnSection(this.pressed);
      if (!this.sectionStart && !this.widening) this.sectionStart = this.round(camera.toPlan(this.pressed), false);
      this.pulling = true;
    }
    this.pressed = null;
    if (this.pulling && touches.size === 1) return this.hover(camera.toPlan(at), event.shiftKey);
    if (this.pulling) this.dropSection();
    if (!touches.pinch(camera, event.pointerId, at)) camera.pan(at[0] - before[0], at[1] - before[1]);
    this.moved();
  }

  /** Return a point rounded to what a pixel can mean; `straight`: along x or y from the section's start. */
  private round([x, y]: Point, straight: boolean): Point {
    const digits = Math.max(0, Math.ceil(Math.log10(this.camera.scale)));
    const [u, v] = [Number(x.toFixed(digits)), Number(y.toFixed(digits))];
    const { sectionStart: from } = this;
    if (!straight || !from) return [u, v];
    return Math.abs(u - from[0]) > Math.abs(v - from[1]) ? [u, from[1]] : [from[0], v];
  }

  /** Whether a pixel is on the section, so that a drag from there to the side makes a strip of it. */
  private isOnSection(pixel: Point): boolean {
    const { section } = this.marks;
    if (!section || distanceBetween(...section) === 0) return false;
    const [off, along] = placeBeside(...section, this.camera.toPlan(pixel));
    return off * this.camera.scale < NEAR && along > 0 && along < 1;
  }

  private hover(at: Point | null, straight = false): void {
    if (this.widening && this.pulling && at) this.mark("width", this.widthTo(at));
    if (this.sectionStart && at) this.mark("section", [this.sectionStart, this.round(at, straight)]);
    this.onHover?.(at);
  }

  /** Return the width of a strip about the section whose side is at a point. */
  private widthTo(at: Point): number {
    const [off] = placeBeside(...this.marks.section!, at);
    return this.round([2 * off, 0], false)[0];
  }

  private click(point: Point, straight: boolean): void {
    const { section } = this.marks;
    if (this.widening && section) {
      this.widening = false;
      return this.onSection?.(...section, this.widthTo(point));
    }
    const at = this.round(point, straight);
    if (this.tool === "pick") {
      this.mark("pick", at);
      this.onPick?.(at);
    } else if (this.tool === "section") {
      const start = this.sectionStart;
      this.sectionStart = start ? null : at;
      this.mark("width", 0);
      this.mark("section", [start ?? at, at]);
      if (start) this.onSection?.(start, at, 0);
    }
  }

  protected step([x, y]: readonly [number, number], far: boolean): void {
    const pixels = far ? 200 : 50;
    this.camera.pan(-x * pixels, y * pixels);
    this.moved();
  }

  protected zoom(enlarge: boolean): void {
    this.camera.zoom(enlarge ? 1.25 : 0.8);
    this.moved();
  }

  protected override handleKey(event: KeyboardEvent): boolean {
    if (event.key !== "Escape" || !this.sectionStart) return super.handleKey(event);
    this.dropSection();
    return true;
  }

  /** Give up the section that was begun. */
  private dropSection(): void {
    this.pulling = this.widening = false;
    this.sectionStart = null;
    this.mark("width", 0);
    this.mark("section", null);
  }
}

/** Return the marks of minimum and maximum; none of a zero, which much of the plate may have. */
function extremeMarks({ min, max }: FieldExtremes): Marks["extremes"] {
  const small = 1e-6 * Math.max(Math.abs(min[0]), Math.abs(max[0]));
  const mark = ([value, x, y]: Extreme, word: string, isMaximum: boolean) =>
    Math.abs(value) > small ? [{ point: [x, y] as Point, text: `${word} ${formatNumber(value)}`, isMaximum }] : [];
  return max[0] - min[0] > small ? [...mark(max, "max", true), ...mark(min, "min", false)] : [];
}

// The plate in plan: a field in colours, and above it the outline, columns, supports, loads, axes.

import { number, type Scale, scaleOf } from "../data/color-scale";
import {
  type Choice,
  CONTACT,
  type Ends,
  endsOf,
  extremes,
  type FieldInfo,
  fieldOf,
  isEnvelope,
  members,
  values,
} from "../data/fields";
import type { Extreme, Plan, Point, Scene } from "../data/scene";
import type { Camera, Painter, Picture } from "../renderer/renderer";
import { RasterPainter } from "../renderer/software-renderer";
import { GlPainter } from "../renderer/webgl-renderer";
import { look } from "../shared/palette";
import { type Theme, theme } from "../shared/theme";
import { ALL_LAYERS, AXES, drawAxes, drawOverlay, type Layers, type Marks, STRIP } from "./overlay";
import "./plan-view.css";

export type Tool = "pan" | "pick" | "section";

/** What a view shows, for a legend. */
export interface Shown {
  choice: Choice;
  field: FieldInfo;
  scale: Scale;
  lifted: boolean; // whether some of the plate has no contact
}

const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "Liberation Sans", "DejaVu Sans", sans-serif';
/** A press that moves less than this [px] is a click. */
const CLICK = 4;
/** Where drawing takes longer than this, or frames of a movement follow later than this [ms], not every one is drawn anew. */
const SLOW = 22;
const LAG = 30;
/** ... and what lies above it only so often [ms]; between, it is moved. */
const SELDOM = 120;
const STILL = 140; // ms without movement until the picture is drawn sharp

export class PlanView {
  /** A point of the plan was picked [m]. */
  onPick?: (x: number, y: number) => void;
  /** A section was cut between two points [m]. */
  onSection?: (start: Point, end: Point) => void;
  /** The view was moved, zoomed or resized. */
  onView?: () => void;
  /** The pointer is over a point of the plan [m]; null: it left. */
  onHover?: (at: Point | null) => void;
  /** Another field, combination or scale is shown; null: none. */
  onShow?: (shown: Shown | null) => void;
  /** Asked first of each press, move and release; true: the view leaves the event alone. */
  onPointer?: (event: PointerEvent, x: number, y: number) => boolean;

  readonly element = document.createElement("div");
  private readonly overlay = document.createElement("canvas");
  private readonly axes = [document.createElement("canvas"), document.createElement("canvas")] as const; // left, bottom
  private painter: Painter;
  private scene: Scene | null = null;
  private plan: Plan | null = null;
  private what: { choice: Choice; field: string } | null = null;
  private picture: Picture | null = null;
  private seen: Shown | null = null;
  private camera: Camera = { x: 0, y: 0, scale: 40 };
  private fitted = false; // whether the user has left the view as `fit` made it
  private size: [number, number] = [0, 0];
  private tool: Tool = "pan";
  private theme: Theme = theme();
  private layers: Layers = { ...ALL_LAYERS };
  private options = { lines: true, mesh: false, contact: true };
  private range: Range = "auto";
  private marks: Marks = { pick: null, place: null, section: null, extremes: [], factors: null };
  private sectionStart: Point | null = null;
  private readonly pointers = new Map<number, Point>();
  private pressed: { at: Point; moved: boolean } | null = null;
  private frame = 0;
  private still = 0;
  private moving = false;
  private drawn: { camera: Camera; when: number } | null = null; // what the overlay shows
  private slow = false;
  private before = 0; // time of the last frame of a movement [ms]
  private between = 0; // usual time between frames of a movement [ms]
  private frames = 0;
  private sharp: { camera: Camera; when: number } | null = null; // what the painter drew last
  private readonly resized: ResizeObserver;
  private readonly ended = new AbortController();

  constructor(container: HTMLElement) {
    const { element, overlay } = this;
    element.className = "gs-plan";
    element.tabIndex = 0;
    element.setAttribute("role", "application");
    element.setAttribute("aria-label", "Plan view. Arrow keys move it, plus and minus zoom, 0 shows all.");
    this.painter = this.makePainter();
    overlay.className = "gs-overlay";
    this.axes[0].className = "gs-axis-left";
    this.axes[1].className = "gs-axis-bottom";
    element.append(this.painter.canvas, overlay, ...this.axes);
    container.append(element);
    this.listen();
    this.resized = new ResizeObserver(() => this.resize());
    this.resized.observe(element);
    this.setTheme(this.theme);
    this.resize();
  }

  /** Whether a graphics card draws; otherwise the processor does. */
  get accelerated(): boolean {
    return this.painter instanceof GlPainter;
  }

  get shown(): Shown | null {
    return this.seen;
  }

  /** Show a scene, with its plan; null takes the field away and leaves the plan. */
  setScene(scene: Scene | null): void {
    this.scene = scene;
    this.sharp = null;
    this.what = null;
    this.painter.setMesh(scene?.mesh ?? null);
    if (scene) this.setPlan(scene.head.plan);
    this.refresh();
  }

  /** Show a plan; the field, if there is one, stays. */
  setPlan(plan: Plan | null): void {
    const first = this.plan === null && plan !== null;
    const moved = plan !== null && this.plan !== null && String(plan.bounds) !== String(this.plan.bounds);
    this.plan = plan;
    if (first || (moved && this.fitted)) this.fit();
    this.request();
  }

  /** Show a field of a combination or an envelope. */
  show(choice: Choice, field: string): void {
    this.what = { choice, field };
    this.refresh();
  }

  setTool(tool: Tool): void {
    this.tool = tool;
    this.sectionStart = null;
    this.element.dataset["tool"] = tool;
  }

  setTheme(to: Theme): void {
    this.theme = to;
    this.painter.setTheme(to);
    this.request();
  }

  /** Choose what is drawn above the field. */
  setLayers(layers: Partial<Layers>): void {
    Object.assign(this.layers, layers);
    this.request();
  }

  /** Choose lines between bands, the elements' sides, the contact boundary. */
  setOptions(options: Partial<{ lines: boolean; mesh: boolean; contact: boolean }>): void {
    Object.assign(this.options, options);
    this.refresh();
  }

  /** "auto": the scale fits the combination shown; "common": all combinations; or from a number to another. */
  setRange(range: Range): void {
    this.range = range;
    this.refresh();
  }

  /** Mark a picked point, or none. */
  markPick(point: Point | null): void {
    this.marks.pick = point;
    this.request();
  }

  /** Mark a section, or none. */
  markSection(section: [Point, Point] | null): void {
    this.marks.section = section;
    this.request();
  }

  /** Mark a place for as long as a chart points at it; null: no more. */
  markPlace(point: Point | null): void {
    this.marks.place = point;
    this.request();
  }

  /** Show the whole plate. */
  fit(): void {
    const [x0, y0, x1, y1] = this.plan?.bounds ?? [-5, -5, 5, 5];
    const [width, height] = this.size;
    this.camera = fitted([x0, y0, x1, y1], width, height, this.layers.axes);
    this.fitted = true;
    this.changed();
  }

  /** Return the plan's point [m] under a pixel, counted from the view's left top. */
  toPlan(px: number, py: number): Point {
    const [width, height] = this.size;
    return [
      this.camera.x + (px - width / 2) / this.camera.scale,
      this.camera.y - (py - height / 2) / this.camera.scale,
    ];
  }

  /** Return the pixel of a point [m], counted from the view's left top. */
  toPixel(x: number, y: number): Point {
    const [width, height] = this.size;
    return [width / 2 + (x - this.camera.x) * this.camera.scale, height / 2 - (y - this.camera.y) * this.camera.scale];
  }

  /** Pixels per metre. */
  get zoom(): number {
    return this.camera.scale;
  }

  /** Draw what is seen into a canvas of its own, on white, `ratio` dots per pixel: for paper. */
  snapshot(width: number, height: number, ratio: number): HTMLCanvasElement {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    const context = canvas.getContext("2d")!;
    // the part that is seen now, wholly
    const scale = this.camera.scale * Math.min(width / Math.max(this.size[0], 1), height / Math.max(this.size[1], 1));
    const camera =
      this.fitted && this.plan ? fitted(this.plan.bounds, width, height, this.layers.axes) : { ...this.camera, scale };
    const painter = this.painter;
    painter.setTheme("light");
    painter.draw(camera, width, height, ratio);
    context.drawImage(painter.canvas, 0, 0, canvas.width, canvas.height);
    context.scale(ratio, ratio);
    const sheet = { context, camera, width, height, look: look("light"), font: FONT };
    drawOverlay(sheet, this.plan, this.layers, this.marks);
    if (this.layers.axes) drawAxes(sheet);
    painter.setTheme(this.theme);
    this.draw();
    return canvas;
  }

  dispose(): void {
    this.ended.abort();
    this.resized.disconnect();
    cancelAnimationFrame(this.frame);
    clearTimeout(this.still);
    this.painter.dispose();
    this.element.remove();
  }

  /** Find what is to be shown anew: values, scale, marks. */
  private refresh(): void {
    const { scene, what } = this;
    this.picture = null;
    this.seen = null;
    this.marks.extremes = [];
    this.marks.factors = null;
    if (scene && what) {
      const field = fieldOf(scene, what.field);
      const of = values(scene, what.choice, what.field);
      const hasContact = scene.head.fields.some((each) => each.name === CONTACT);
      const contact = hasContact ? values(scene, what.choice, CONTACT) : null;
      const lifted = contact !== null && extremes(contact).max > 0;
      const scale = scaleFor(scene, what.choice, field, this.range);
      this.picture = {
        values: of,
        contact: this.options.contact && lifted ? contact : null,
        scale,
        lines: this.options.lines,
        mesh: this.options.mesh,
      };
      this.seen = { choice: what.choice, field, scale, lifted };
      this.marks.extremes = extremeMarks(endsOf(scene, what.choice, what.field));
      const factors = isEnvelope(what.choice) ? null : scene.head.combinations[what.choice]?.factors;
      if (factors?.length) this.marks.factors = new Map(factors);
    }
    this.painter.setPicture(this.picture);
    this.sharp = null;
    this.onShow?.(this.seen);
    this.request();
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (!width || !height) return;
    this.size = [width, height];
    if (this.fitted) this.fit();
    else this.changed();
  }

  private changed(): void {
    this.request();
    this.onView?.();
  }

  /** Draw with the next frame. */
  private request(): void {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  /** Draw roughly until nothing has moved for a while. */
  private movingNow(): void {
    this.moving = true;
    clearTimeout(this.still);
    this.still = window.setTimeout(() => {
      this.moving = false;
      this.request();
    }, STILL);
  }

  private draw(): void {
    const [width, height] = this.size;
    if (!width || !height) return;
    this.watch();
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    this.paint(width, height, ratio);
    const { overlay, camera, drawn } = this;
    const now = performance.now();
    if (this.moving && this.slow && drawn && drawn.camera.scale === camera.scale && now - drawn.when < SELDOM) {
      overlay.style.transform = `translate(${(drawn.camera.x - camera.x) * camera.scale}px, ${(camera.y - drawn.camera.y) * camera.scale}px)`;
      return;
    }
    const sheet = { camera, width, height, look: look(this.theme), font: FONT };
    overlay.style.transform = "";
    drawOverlay({ ...sheet, context: cleared(overlay, width, height, ratio) }, this.plan, this.layers, this.marks);
    this.drawn = { camera: { ...camera }, when: now };
    const [left, bottom] = this.axes;
    left.hidden = bottom.hidden = !this.layers.axes;
    if (!this.layers.axes) return;
    drawAxes({ ...sheet, context: cleared(left, AXES.left + 2, height, ratio) });
    const strip = cleared(bottom, width, STRIP, ratio);
    strip.translate(0, STRIP - height);
    drawAxes({ ...sheet, context: strip });
  }

  /** Find out whether this computer is too slow to draw every frame of a movement anew. */
  private watch(): void {
    const now = performance.now();
    if (this.painter.cost > SLOW) this.slow = true;
    // the browser's own work for each frame counts too, and only the time between frames shows it
    if (this.moving && this.before && now - this.before < 500) {
      this.between = this.between ? 0.8 * this.between + 0.2 * (now - this.before) : now - this.before;
      this.frames += 1;
      if (this.frames > 8 && this.between > LAG) this.slow = true;
    }
    this.before = this.moving ? now : 0;
  }

  /**
   * Draw the field. Where that takes long (no graphics card), the last drawing is moved and stretched instead while the
   * view moves, and drawn anew when it is still or shows too little.
   */
  private paint(width: number, height: number, ratio: number): void {
    const { painter, camera, sharp } = this;
    const now = performance.now();
    if (this.moving && sharp && this.slow) {
      const zoom = camera.scale / sharp.camera.scale;
      const [dx, dy] = [(sharp.camera.x - camera.x) * camera.scale, (camera.y - sharp.camera.y) * camera.scale];
      const enough = zoom > 0.6 && zoom < 2 && Math.abs(dx) < width / 3 && Math.abs(dy) < height / 3;
      if (enough || now - sharp.when < 4 * painter.cost) {
        painter.canvas.style.transform = `translate(${dx}px, ${dy}px) scale(${zoom})`;
        return;
      }
    }
    painter.draw(camera, width, height, ratio);
    painter.canvas.style.transform = "";
    this.sharp = { camera: { ...camera }, when: now };
    this.element.dataset["cost"] = painter.cost.toFixed(1);
  }

  private move(dx: number, dy: number): void {
    this.camera.x -= dx / this.camera.scale;
    this.camera.y += dy / this.camera.scale;
    this.fitted = false;
    this.movingNow();
    this.changed();
  }

  private zoomAt([px, py]: Point, factor: number): void {
    const [x, y] = this.toPlan(px, py);
    const [x0, y0, x1, y1] = this.plan?.bounds ?? [-5, -5, 5, 5];
    const whole = Math.min(...this.size) / Math.max(x1 - x0, y1 - y0, 1e-6);
    this.camera.scale = Math.min(Math.max(this.camera.scale * factor, whole / 20), whole * 2000);
    const [nx, ny] = this.toPlan(px, py);
    this.camera.x += x - nx;
    this.camera.y += y - ny;
    this.fitted = false;
    this.movingNow();
    this.changed();
  }

  /** Return what draws the field; if the graphics card is lost later, the processor takes over. */
  private makePainter(): Painter {
    try {
      const painter = new GlPainter();
      painter.canvas.addEventListener("webglcontextlost", () => {
        if (this.painter !== painter || this.ended.signal.aborted) return;
        this.painter = new RasterPainter();
        painter.canvas.replaceWith(this.painter.canvas);
        this.painter.setTheme(this.theme);
        this.painter.setMesh(this.scene?.mesh ?? null);
        this.painter.setPicture(this.picture);
        this.sharp = null;
        this.request();
      });
      return painter;
    } catch {
      return new RasterPainter();
    }
  }

  private listen(): void {
    const { element } = this;
    const options = { signal: this.ended.signal };
    const place = (event: MouseEvent): Point => {
      const box = element.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    element.addEventListener(
      "pointerdown",
      (event) => {
        const at = place(event);
        if (this.onPointer?.(event, ...this.toPlan(...at))) return;
        if (event.button > 1) return;
        element.setPointerCapture(event.pointerId);
        this.pointers.set(event.pointerId, at);
        this.pressed = { at, moved: this.pointers.size > 1 };
      },
      options,
    );
    element.addEventListener(
      "pointermove",
      (event) => {
        const at = place(event);
        if (this.onPointer?.(event, ...this.toPlan(...at))) return;
        const before = this.pointers.get(event.pointerId);
        if (!before) {
          this.hover(this.toPlan(...at), event.shiftKey);
          return;
        }
        const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, point]) => point);
        this.pointers.set(event.pointerId, at);
        const other = others[0];
        if (other) {
          // two fingers: the point between them stays under them
          const far = (point: Point) => Math.max(Math.hypot(point[0] - other[0], point[1] - other[1]), 1);
          this.move((at[0] - before[0]) / 2, (at[1] - before[1]) / 2);
          this.zoomAt([(at[0] + other[0]) / 2, (at[1] + other[1]) / 2], far(at) / far(before));
          return;
        }
        const { pressed } = this;
        if (pressed && !pressed.moved && Math.hypot(at[0] - pressed.at[0], at[1] - pressed.at[1]) < CLICK) return;
        if (pressed && !pressed.moved) {
          pressed.moved = true;
          this.move(at[0] - pressed.at[0], at[1] - pressed.at[1]);
          return;
        }
        this.move(at[0] - before[0], at[1] - before[1]);
      },
      options,
    );
    const release = (event: PointerEvent) => {
      const at = place(event);
      if (this.onPointer?.(event, ...this.toPlan(...at))) return;
      if (!this.pointers.delete(event.pointerId)) return;
      const { pressed } = this;
      if (!this.pointers.size) this.pressed = null;
      if (event.type === "pointerup" && pressed && !pressed.moved && event.button === 0)
        this.click(this.toPlan(...at), event.shiftKey);
    };
    element.addEventListener("pointerup", release, options);
    element.addEventListener("pointercancel", release, options);
    element.addEventListener("pointerleave", () => this.hover(null), options);
    element.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        const lines = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 160 : 1;
        this.zoomAt(
          place(event),
          Math.exp(-Math.min(Math.max(event.deltaY * lines, -300), 300) * (event.ctrlKey ? 0.01 : 0.0015)),
        );
      },
      { ...options, passive: false },
    );
    element.addEventListener(
      "dblclick",
      () => {
        if (this.tool === "pan") this.fit();
      },
      options,
    );
    element.addEventListener(
      "keydown",
      (event) => {
        if (this.key(event)) event.preventDefault();
      },
      options,
    );
  }

  /** Return a point rounded to what a pixel can mean; `straight`: along x or y from the section's start. */
  private rounded([x, y]: Point, straight: boolean): Point {
    const digits = Math.max(0, Math.ceil(Math.log10(this.camera.scale)));
    const [u, v] = [Number(x.toFixed(digits)), Number(y.toFixed(digits))];
    const { sectionStart: from } = this;
    if (!straight || !from) return [u, v];
    return Math.abs(u - from[0]) > Math.abs(v - from[1]) ? [u, from[1]] : [from[0], v];
  }

  private hover(at: Point | null, straight = false): void {
    if (this.sectionStart && at) {
      this.marks.section = [this.sectionStart, this.rounded(at, straight)];
      this.request();
    }
    this.onHover?.(at);
  }

  private click(point: Point, straight: boolean): void {
    const at = this.rounded(point, straight);
    if (this.tool === "pick") {
      this.marks.pick = at;
      this.request();
      this.onPick?.(...at);
    } else if (this.tool === "section") {
      if (!this.sectionStart) {
        this.sectionStart = at;
        this.marks.section = [at, at];
      } else {
        const start = this.sectionStart;
        this.sectionStart = null;
        this.marks.section = [start, at];
        this.onSection?.(start, at);
      }
      this.request();
    }
  }

  private key(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const step = event.shiftKey ? 200 : 50;
    const middle: Point = [this.size[0] / 2, this.size[1] / 2];
    switch (event.key) {
      case "ArrowLeft":
        this.move(step, 0);
        return true;
      case "ArrowRight":
        this.move(-step, 0);
        return true;
      case "ArrowUp":
        this.move(0, step);
        return true;
      case "ArrowDown":
        this.move(0, -step);
        return true;
      case "+":
      case "=":
        this.zoomAt(middle, 1.25);
        return true;
      case "-":
        this.zoomAt(middle, 0.8);
        return true;
      case "0":
        this.fit();
        return true;
      case "Escape":
        if (!this.sectionStart) return false;
        this.sectionStart = null;
        this.markSection(null);
        return true;
      default:
        return false;
    }
  }
}

export type Range = "auto" | "common" | readonly [number, number];

function fitted(
  [x0, y0, x1, y1]: readonly [number, number, number, number],
  width: number,
  height: number,
  axes: boolean,
): Camera {
  const [left, bottom] = axes ? [AXES.left, AXES.bottom] : [0, 0];
  const rim = 22;
  const bar = axes ? 14 : 0; // more, for the scale bar
  const scale = Math.max(
    1e-6,
    Math.min(
      (width - left - 2 * rim) / Math.max(x1 - x0, 1e-6),
      (height - bottom - bar - 2 * rim) / Math.max(y1 - y0, 1e-6),
    ),
  );
  return { x: (x0 + x1) / 2 - left / 2 / scale, y: (y0 + y1) / 2 - (bottom + bar) / 2 / scale, scale };
}

/** Return the marks of the smallest and the largest value; none of a zero, which a whole part of the plate may have. */
function extremeMarks({ min, max }: Ends): Marks["extremes"] {
  const mark = ([value, x, y]: Extreme, word: string, largest: boolean) => ({
    point: [x, y] as Point,
    text: `${word} ${number(value)}`,
    largest,
  });
  const small = 1e-6 * Math.max(Math.abs(min[0]), Math.abs(max[0]));
  return [
    ...(max[0] - min[0] > small && Math.abs(max[0]) > small ? [mark(max, "max", true)] : []),
    ...(max[0] - min[0] > small && Math.abs(min[0]) > small ? [mark(min, "min", false)] : []),
  ];
}

/** Return a canvas's context, all clear, drawing in pixels of style sheets. */
function cleared(canvas: HTMLCanvasElement, width: number, height: number, ratio: number): CanvasRenderingContext2D {
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  const context = canvas.getContext("2d")!;
  if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, w, h);
  context.scale(ratio, ratio);
  return context;
}

/** Return the colour scale of a field: round, from zero for what is never negative. */
export function scaleFor(scene: Scene, choice: Choice, field: FieldInfo, range: Range): Scale {
  const ends = endsOf(scene, choice, field.name);
  const [min, max] = [ends.min[0], ends.max[0]];
  if (typeof range !== "string") return { ...scaleOf(range[0], range[1], field.signed, range), min, max };
  let [low, high] = [min, max];
  if (range === "common" && members(scene, "largest").length > 1) {
    const most = endsOf(scene, "largest", field.name);
    [low, high] = [endsOf(scene, "smallest", field.name).min[0], most.max[0]];
  }
  // what is never negative is shown from zero
  if (!field.signed) low = Math.min(low, 0);
  return { ...scaleOf(low, high, field.signed), min, max };
}

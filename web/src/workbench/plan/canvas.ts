// The drawing on the screen: what is seen, what is drawn, which part of it is under the pointer.

import { distanceBetween } from "../../viewer/data/points";
import { Camera } from "../../viewer/plan/camera";
import { drawGrid, drawRulers, RULER, stepOf } from "../../viewer/plan/rulers";
import { drawPath, drawText } from "../../viewer/plan/symbols";
import { svg } from "../../viewer/shared/dom";
import type { Store } from "../client/store";
import { isClosed, type Point, ringOf } from "../model/geometry";
import { boundsOfItems, footprintOf, type Item, itemsOf, snapPoints } from "../model/items";
import { type Path, samePath } from "../model/paths";
import type { Preview } from "./interaction/gestures";
import { type Handle, handlesOf } from "./interaction/handles";
import { itemsAt } from "./interaction/hit-testing";
import { type Snapped, snap } from "./interaction/snapping";
import { drawDimensions, drawItems } from "./rendering";

const REACH = 9; // px: how near is near enough
const HANDLE = 8; // px: side of a handle
const SNAP = 4.5; // px: least distance of round lengths to snap to

/** Everything drawn, kept in step with the store's data. */
export class Canvas {
  readonly camera = new Camera();
  readonly element: SVGSVGElement;
  items: Item[] = [];
  preview: Preview | null = null;
  guides: Snapped | null = null;
  hovered: Path | null = null;
  corner: number | null = null;
  loadCase = "";
  private readonly grid = svg("g");
  private readonly symbols = svg("g");
  private readonly marks = svg("g");
  private readonly rulers = svg("g");
  private fitted = true;
  private slab = ""; // its bounds, as they were last
  private frame = 0;

  constructor(private readonly store: Store) {
    const attributes = {
      class: "drawing gs-symbols",
      role: "application",
      tabindex: 0,
      "aria-label": "drawing of the slab in plan",
      "aria-roledescription": "drawing",
    };
    this.element = svg("svg", attributes, this.grid, this.symbols, this.marks, this.rulers);
  }

  /** The size of the element has changed. */
  resize(width: number, height: number): void {
    if (width < 1 || height < 1) return;
    Object.assign(this.camera, { width, height });
    if (this.fitted) this.fit();
    else this.redraw();
  }

  /** Take the store's data. */
  refresh(): void {
    this.items = itemsOf(this.store.data, this.store.doc?.plan ?? null);
    const slab = String(boundsOfItems(this.items.filter((item) => item.kind === "slab")));
    const hasChanged = slab !== this.slab;
    this.slab = slab;
    // a slab of another size is shown entirely, unless the user has chosen what is seen
    if (hasChanged && this.fitted && !this.preview) this.fit();
    else this.redraw();
  }

  /** Show everything. */
  fit(): void {
    this.camera.fit(boundsOfItems(this.items) ?? [-6, -4, 6, 4], 42, RULER.left, RULER.bottom);
    this.fitted = true;
    this.redraw();
  }

  /** The user has moved or zoomed: from now on nothing is fitted by itself. */
  moved(): void {
    this.fitted = false;
    this.redraw();
  }

  get selected(): Item | null {
    return this.items.find((item) => samePath(item.path, this.store.selection)) ?? null;
  }

  /** Return the items under a pixel, the likeliest first. */
  itemsAt(pixel: Point): Item[] {
    return itemsAt(this.items, this.camera.toPlan(pixel), this.reach);
  }

  /** Return the handle of the selected item under a pixel. */
  handleAt(pixel: Point): Handle | null {
    const item = this.selected;
    if (!item) return null;
    const distance = (handle: Handle) => distanceBetween(this.camera.toPixel([...handle.at]), pixel);
    const near = handlesOf(item.geometry).filter((handle) => distance(handle) <= REACH);
    return near.sort((a, b) => distance(a) - distance(b))[0] ?? null;
  }

  /** Return the place that a pixel means; `free` switches snapping off. */
  snap(at: Point, free: boolean, without: Path | null, own: readonly Point[] = []): Snapped {
    if (free) return { at, fromX: null, fromY: null, onPoint: false };
    const points = [...snapPoints(this.items, without), ...own];
    return snap({ at, points, step: this.step, reach: this.reach });
  }

  /** How near is near enough [m]. */
  get reach(): number {
    return REACH / this.camera.scale;
  }

  /** The spacing of round lengths that a pointer can mean [m]; finer than the grid. */
  get step(): number {
    return stepOf(this.camera, SNAP);
  }

  /** Draw with the next frame. */
  redraw(): void {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  private draw(): void {
    const { camera, preview, store } = this;
    this.element.setAttribute("width", String(camera.width));
    this.element.setAttribute("height", String(camera.height));
    // where a place of the plan is on the screen, for tests
    this.element.dataset.view = `${camera.x} ${camera.y} ${camera.scale}`;
    const isPreviewed = (item: Item) => preview?.item && samePath(preview.item.path, item.path);
    const shown = this.items.map((item) => (isPreviewed(item) ? withGeometry(item, preview!) : item));
    const highlights = {
      selected: store.selection,
      hovered: this.hovered,
      faulty: (store.doc?.issues ?? []).map((fault) => fault.path),
      loadCase: this.loadCase,
    };
    this.grid.replaceChildren(...drawGrid(camera));
    this.symbols.replaceChildren(...drawItems(camera, shown, highlights));
    this.marks.replaceChildren(...this.drawMarks(shown.find((item) => samePath(item.path, store.selection))));
    this.rulers.replaceChildren(...drawRulers(camera));
  }

  private drawMarks(selected: Item | undefined): SVGElement[] {
    const { camera, preview } = this;
    const marks: SVGElement[] = [];
    if (selected && selected.geometry.type !== "point")
      marks.push(...drawDimensions(camera, dimensionRing(selected), isClosed(selected.geometry)));
    if (selected?.geometry.type === "point" && !selected.foot)
      marks.push(this.drawCircle([selected.geometry.x, selected.geometry.y], 11, "halo"));
    if (selected && !preview) marks.push(...handlesOf(selected.geometry).map((handle) => this.drawHandle(handle)));
    if (preview && !preview.item) marks.push(...this.drawPreview(preview));
    if (this.guides) marks.push(...this.drawGuides(this.guides));
    return marks;
  }

  private drawCircle(at: Point, r: number, className: string): SVGElement {
    const [cx, cy] = this.camera.toPixel(at);
    return svg("circle", { class: className, cx, cy, r });
  }

  private drawHandle(handle: Handle): SVGElement {
    const isChosen = handle.kind === "corner" && handle.index === this.corner;
    const name = `handle ${handle.kind}${isChosen ? " chosen" : ""}`;
    if (handle.kind === "add") return this.drawCircle(handle.at, 3.5, name);
    const [x, y] = this.camera.toPixel(handle.at);
    return svg("rect", { class: name, x: x - HANDLE / 2, y: y - HANDLE / 2, width: HANDLE, height: HANDLE });
  }

  private drawPreview({ geometry }: Preview): SVGElement[] {
    const ring = ringOf(geometry);
    const closed = isClosed(geometry);
    const corners = closed ? [] : ring.slice(0, -1).map((at) => this.drawCircle(at, 3, "drawn"));
    const pixels = ring.map((point) => this.camera.toPixel(point));
    return [drawPath(pixels, closed, "preview"), ...corners, ...drawDimensions(this.camera, ring, closed)];
  }

  private drawGuides({ at, fromX, fromY, onPoint }: Snapped): SVGElement[] {
    const [x, y] = this.camera.toPixel(at);
    const lines = [fromX, fromY].flatMap((from) =>
      from ? [drawPath([this.camera.toPixel(from), [x, y]], false, "guide")] : [],
    );
    const circle = onPoint ? [this.drawCircle(at, 6, "on-point")] : [];
    if (!this.preview?.text) return [...lines, ...circle];
    const atRight = x > this.camera.width - 220;
    const offset: Point = [atRight ? -14 : 14, y < 40 ? 26 : -14];
    return [...lines, ...circle, drawText([x, y], this.preview.text, offset, atRight ? "tip end" : "tip")];
  }
}

function withGeometry(item: Item, { geometry }: Preview): Item {
  return { ...item, geometry, foot: footprintOf(item.table, geometry) };
}

/** Return the corners whose distances are shown: those of the shape itself, not of the chords of its arcs. */
function dimensionRing({ geometry }: Item): readonly Point[] {
  if (geometry.type === "circle") return [];
  return ringOf(geometry.type === "polygon" ? { ...geometry, bulges: [] } : geometry);
}

// The drawing on the screen: what is seen, what is drawn, which part of it is under the pointer.

import { boxAround } from "../../viewer/data/boxes";
import { distanceBetween } from "../../viewer/data/points";
import { Camera, isNear, transformOf } from "../../viewer/plan/camera";
import { Motion } from "../../viewer/plan/navigation";
import { drawGrid, drawRulers, RULER, stepOf } from "../../viewer/plan/rulers";
import { drawPath, drawText } from "../../viewer/plan/symbols";
import { h, keepChildren, svg } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import { readStored, writeStored } from "../../viewer/shared/storage";
import type { Store } from "../client/store";
import { type Axis, axesIn, crossingsOf, distanceTo, nearestOn } from "../model/axes";
import { applyOptimistic } from "../model/changes/optimistic-edits";
import type { Edit } from "../model/edits";
import { type Geometry, isClosed, type Point, rectangleCorners, ringOf } from "../model/geometry";
import { boundsOfItems, footprintOf, type Item, isPlate, itemsOf } from "../model/items";
import { namesIn } from "../model/names";
import { listAt, type Path, pathKey, type Table } from "../model/paths";
import type { Underlay } from "../model/survey";
import { axisUnder, drawBuildingAxes, drawDimensionChains } from "./axes";
import { drawDistances } from "./distances";
import { type Preview, shownBy } from "./interaction/gestures";
import { type Handle, handlesOf } from "./interaction/handles";
import { itemsAt } from "./interaction/hit-testing";
import { snapPlaces } from "./interaction/snap-places";
import { type Snapped, snap } from "./interaction/snapping";
import { type Drawn, drawDimensions, drawHandle, drawItems } from "./rendering";
import { UnderlayLines } from "./underlay/underlay-lines";

const REACH = 9; // px: how near is near enough
const NOTHING_MARKED = { selected: [], hovered: null, faulty: [], loadCase: "" };
const MARGIN = 42; // px around what is shown entirely
const MARGIN_OF_AXES = 58;
const BAR = 18; // px more where names of axes would be below the bar over the drawing
const AXES = "groundslab-axes";
const BEYOND = 0.5; // of the view: how far a drawing is moved with it, instead of being drawn again
const SNAP = 4.5; // px: least distance of round lengths to snap to

/** Everything drawn, kept in step with the store's data. */
export class Canvas {
  readonly camera = new Camera();
  readonly element: HTMLElement;
  items: Item[] = [];
  preview: Preview | null = null;
  /** Edits that are shown as if they were made, while an axis is dragged. */
  trial: readonly Edit[] = [];
  /** What is said beside the pointer, while an axis is dragged. */
  tip: { at: Point; text: string } | null = null;
  /** What an action would make, drawn faintly. */
  ghosts: readonly Item[] = [];
  /** The corners of the rubber band, the first where it began. */
  band: readonly [Point, Point] | null = null;
  guides: Snapped | null = null;
  hovered: Path | null = null;
  corner: number | null = null;
  loadCase = "";
  /** Whether axes and dimensions are drawn. */
  hasAxes = readStored(AXES) !== "no";
  private readonly grid = svg("g");
  private readonly chains = svg("g");
  private readonly plates = svg("g");
  private readonly axes = svg("g");
  private readonly below = svg("g");
  private underlay: UnderlayLines | null = null;
  private readonly symbols = svg("g");
  private readonly marks = svg("g");
  private readonly moving = svg(
    "svg",
    { class: "moving" },
    ...[this.below, this.chains, this.plates, this.axes, this.symbols, this.marks],
  );
  private readonly rulers = svg("g");
  private readonly motion = new Motion(() => this.redraw());
  private drawnBy: Camera | null = null;
  private readonly drawings: Drawn = new Map(); // of the items, by that camera
  private isDrawn = false; // whether nothing but the camera has changed since
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
    this.element = h("div", attributes, svg("svg", {}, this.grid), this.moving, svg("svg", {}, this.rulers));
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

  /** Show a drawing below the items, or none. */
  showUnderlay(underlay: Underlay | null): void {
    this.underlay = underlay?.shown ? new UnderlayLines(underlay) : null;
    if (this.fitted) this.fit();
    else this.redraw();
  }

  /** Show everything. */
  fit(): void {
    const boxes = [boundsOfItems(this.items), this.underlay?.bounds ?? null].filter((box) => box !== null);
    const all = boxAround(
      boxes.flatMap(([x0, y0, x1, y1]): Point[] => [
        [x0, y0],
        [x1, y1],
      ]),
    );
    const margin = this.hasAxes ? MARGIN_OF_AXES : MARGIN;
    const top = this.hasAxes && this.buildingAxes.length > 0 ? BAR : 0;
    this.camera.fit(boxes.length > 0 ? all : [-6, -4, 6, 4], margin, RULER.left, RULER.bottom, top);
    this.fitted = true;
    this.redraw();
  }

  /** Draw axes and dimensions, or not, also at the next visit. */
  showAxes(on: boolean): void {
    this.hasAxes = on;
    writeStored(AXES, on ? "yes" : "no");
    if (this.fitted) this.fit();
    else this.redraw();
  }

  /** The user has moved or zoomed: from now on nothing is fitted by itself. */
  moved(): void {
    this.fitted = false;
    this.motion.moved();
    this.request();
  }

  /** The only selected item; null if none or several are selected. */
  get selected(): Item | null {
    return this.store.selection ? (this.selectedItems[0] ?? null) : null;
  }

  get hasSlab(): boolean {
    return this.items.some(({ kind }) => kind === "slab");
  }

  /** The selected items that have a place in plan. */
  get selectedItems(): Item[] {
    return this.items.filter((item) => this.store.isSelected(item.path));
  }

  /** Return the items under a pixel, the likeliest first. */
  itemsAt(pixel: Point): Item[] {
    return itemsAt(this.items, this.camera.toPlan(pixel), this.reach);
  }

  /** The axes of the building. */
  get buildingAxes(): readonly Axis[] {
    return axesIn(this.shownData);
  }

  /** Return the axis whose bubble is under a pixel, null if none is. */
  axisAt(pixel: Point): Axis | null {
    return this.hasAxes ? axisUnder(this.camera, this.items, this.buildingAxes, this.store.selected, pixel) : null;
  }

  /** The data that are drawn: those of the store, with what is tried. */
  private get shownData(): Table {
    return this.trial.reduce(applyOptimistic, this.store.data);
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
  snap(at: Point, free: boolean, without: readonly Path[], own: readonly Point[] = []): Snapped {
    if (free) return { at, fromX: null, fromY: null, onPoint: false };
    const axes = this.hasAxes ? this.buildingAxes : [];
    const places = [
      ...crossingsOf(axes),
      ...snapPlaces(this.items, without),
      ...(this.underlay?.placesNear(at, this.reach) ?? []),
    ];
    const points = [...places.map((place) => place.at), ...own];
    const snapped = snap({ at, points, step: this.step, reach: this.reach });
    const near = axes.filter((axis) => distanceTo(axis, at) <= this.reach * 0.75);
    if (near[0] && !snapped.onPoint && !snapped.fromX && !snapped.fromY)
      return {
        ...snapped,
        at: nearestOn(near[0], snapped.at),
        onPoint: true,
        name: say("axis {name}", { name: verbatim(near[0].name) }),
      };
    const name = snapped.onPoint ? places.find((place) => place.at === snapped.at)?.name : undefined;
    return name ? { ...snapped, name } : snapped;
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
    this.isDrawn = false;
    this.request();
  }

  private request(): void {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  private draw(): void {
    const { camera } = this;
    // where a place of the plan is on the screen, for tests
    this.element.dataset.view = `${camera.x} ${camera.y} ${camera.scale}`;
    this.grid.replaceChildren(...drawGrid(camera));
    this.rulers.replaceChildren(...drawRulers(camera));
    if (this.follow()) return;
    this.drawAll();
    this.isDrawn = true;
    this.moving.style.transform = "";
  }

  /** Move and stretch what is drawn while the view moves; false if it has to be drawn again. */
  private follow(): boolean {
    if (!this.motion.on || !this.isDrawn || !this.drawnBy) return false;
    const shift = this.camera.since(this.drawnBy);
    if (!isNear(shift, this.camera, BEYOND)) return false;
    this.moving.style.transform = transformOf(shift);
    return true;
  }

  private drawAll(): void {
    const { camera, preview, store } = this;
    const changed = new Map(
      shownBy(preview).map(({ item, geometry }) => [pathKey(item.path), withGeometry(item, geometry)]),
    );
    const items = this.trial.length > 0 ? itemsOf(this.shownData, store.doc?.plan ?? null) : this.items;
    const shown = items.map((item) => changed.get(pathKey(item.path)) ?? item);
    const highlights = {
      selected: store.selected,
      hovered: this.hovered,
      faulty: (store.doc?.issues ?? []).map((fault) => fault.path),
      loadCase: this.loadCase,
      cases: namesIn(listAt(store.data, ["cases"])),
    };
    this.below.replaceChildren(...(this.underlay ? [this.underlay.draw(camera)] : []));
    if (!this.drawnBy?.isAt(camera)) this.drawings.clear();
    this.drawnBy = camera.copy();
    const axes = this.hasAxes ? this.buildingAxes : [];
    this.chains.replaceChildren(...(this.hasAxes ? drawDimensionChains(camera, shown, axes) : []));
    this.axes.replaceChildren(...drawBuildingAxes(camera, shown, axes, store.selected));
    const drawn = drawItems(camera, shown, highlights, this.drawings);
    keepChildren(
      this.plates,
      drawn.filter((_, n) => isPlate(shown[n]!)),
    );
    keepChildren(
      this.symbols,
      drawn.filter((_, n) => !isPlate(shown[n]!)),
    );
    const ghosts = svg("g", { class: "ghosts" }, ...drawItems(camera, this.ghosts, { ...NOTHING_MARKED }));
    this.marks.replaceChildren(ghosts, ...this.drawMarks(shown.filter((item) => store.isSelected(item.path))));
  }

  private drawMarks(items: readonly Item[]): SVGElement[] {
    const { camera, preview } = this;
    const marks = items.length > 1 ? items.flatMap((item) => this.drawHalo(item)) : [];
    const selected = items.length === 1 ? items[0] : undefined;
    if (selected && selected.geometry.type !== "point")
      marks.push(...drawDimensions(camera, dimensionRing(selected), isClosed(selected.geometry)));
    if (selected) marks.push(...drawDistances(camera, selected, this.items), ...this.drawHalo(selected));
    if (selected && !preview) marks.push(...handlesOf(selected.geometry).map((handle) => this.drawHandle(handle)));
    if (preview && !preview.item) marks.push(...this.drawPreview(preview));
    if (this.guides) marks.push(...this.drawGuides(this.guides));
    if (this.tip) marks.push(this.drawTip(this.tip.at, this.tip.text));
    if (this.band) marks.push(this.drawBand(this.band));
    return marks;
  }

  /** Draw a circle around a point that has no outline to be marked. */
  private drawHalo({ geometry, foot }: Item): SVGElement[] {
    return geometry.type === "point" && !foot ? [this.drawCircle([geometry.x, geometry.y], 11, "halo")] : [];
  }

  private drawBand([from, to]: readonly [Point, Point]): SVGElement {
    const corners = rectangleCorners([from[0], to[0]], [from[1], to[1]]).map((corner) => this.camera.toPixel(corner));
    return drawPath(corners, true, from[0] <= to[0] ? "band" : "band crossing");
  }

  private drawCircle(at: Point, r: number, className: string): SVGElement {
    const [cx, cy] = this.camera.toPixel(at);
    return svg("circle", { class: className, cx, cy, r });
  }

  private drawHandle(handle: Handle): SVGElement {
    const isChosen = handle.kind === "corner" && handle.index === this.corner;
    const name = `handle ${handle.kind}${isChosen ? " chosen" : ""}`;
    if (handle.kind === "add" || handle.kind === "bend") return this.drawCircle(handle.at, 3.5, name);
    return drawHandle(this.camera.toPixel(handle.at), name);
  }

  private drawPreview({ geometry }: Preview): SVGElement[] {
    const ring = ringOf(geometry);
    const closed = isClosed(geometry);
    const corners = closed ? [] : ring.slice(0, -1).map((at) => this.drawCircle(at, 3, "drawn"));
    const pixels = ring.map((point) => this.camera.toPixel(point));
    return [drawPath(pixels, closed, "preview"), ...corners, ...drawDimensions(this.camera, ring, closed)];
  }

  private drawGuides({ at, fromX, fromY, onPoint, name }: Snapped): SVGElement[] {
    const [x, y] = this.camera.toPixel(at);
    const lines = [fromX, fromY].flatMap((from) =>
      from ? [drawPath([this.camera.toPixel(from), [x, y]], false, "guide")] : [],
    );
    const circle = onPoint
      ? [this.drawCircle(at, 6, "on-point"), drawText([x, y], name ?? "", [9, 18], "snap-name")]
      : [];
    return this.preview?.text ? [...lines, ...circle, this.drawTip(at, this.preview.text)] : [...lines, ...circle];
  }

  /** Draw words beside a place. */
  private drawTip(at: Point, text: string): SVGElement {
    const [x, y] = this.camera.toPixel(at);
    const atRight = x > this.camera.width - 220;
    const offset: Point = [atRight ? -14 : 14, y < 40 ? 26 : -14];
    return drawText([x, y], text, offset, atRight ? "tip end" : "tip");
  }
}

function withGeometry(item: Item, geometry: Geometry): Item {
  return { ...item, geometry, foot: footprintOf(item.table, geometry) };
}

/** Return the corners whose distances are shown: those of the shape itself, not of the chords of its arcs. */
function dimensionRing({ geometry }: Item): readonly Point[] {
  if (geometry.type === "circle") return [];
  return ringOf(geometry.type === "polygon" ? { ...geometry, bulges: [] } : geometry);
}

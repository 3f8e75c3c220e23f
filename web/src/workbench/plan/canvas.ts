// The drawing on the screen: what is seen, what is drawn, which part of it answers to the pointer.

import type { Store } from "../client/store";
import { isClosed, type Point, ringOf } from "../model/geometry";
import { boundsOfItems, footOf, type Item, itemsOf, snapPoints } from "../model/items";
import { type Path, samePath } from "../model/paths";
import { svg } from "../shell/elements";
import { Camera } from "./camera";
import { MARGIN, paintFigures, paintGrid, snapStep } from "./grid-and-rulers";
import type { Ghost } from "./interaction/gestures";
import { type Handle, handlesOf } from "./interaction/handles";
import { itemsAt } from "./interaction/hit-testing";
import { type Snapped, snap } from "./interaction/snapping";
import { type Look, label, paintDimensions, paintItems, path } from "./rendering";

const REACH = 9; // px: how near is near enough
const HANDLE = 8; // px: side of a handle

/** Everything drawn, kept the same as the store's data. */
export class Canvas {
  readonly camera = new Camera();
  readonly element: SVGSVGElement;
  items: Item[] = [];
  ghost: Ghost | null = null;
  guides: Snapped | null = null;
  hovered: Path | null = null;
  corner: number | null = null;
  loadCase = "";
  private readonly layers = ["sheet", "things", "marks", "figures"].map((name) => svg("g", { class: `layer-${name}` }));
  private fitted = true;
  private slab = ""; // its bounds, as they were last
  private frame = 0;

  constructor(private readonly store: Store) {
    this.element = svg(
      "svg",
      {
        class: "drawing",
        role: "application",
        tabindex: 0,
        "aria-label": "drawing of the slab in plan",
        "aria-roledescription": "drawing",
      },
      ...this.layers,
    );
  }

  /** The size of the element has changed. */
  resize(width: number, height: number): void {
    if (width < 1 || height < 1) return;
    Object.assign(this.camera, { width, height });
    if (this.fitted) this.fit();
    else this.paint();
  }

  /** Take the store's data. */
  refresh(): void {
    this.items = itemsOf(this.store.data, this.store.doc?.plan ?? null);
    const slab = String(boundsOfItems(this.items.filter((item) => item.kind === "slab")));
    const another = slab !== this.slab;
    this.slab = slab;
    // a slab of another size is shown as a whole, unless the user has chosen what is seen
    if (another && this.fitted && !this.ghost) this.fit();
    else this.paint();
  }

  /** Show everything. */
  fit(): void {
    const bounds = boundsOfItems(this.items) ?? [-6, -4, 6, 4];
    this.camera.fit(bounds);
    // the figures cover the left and the lower edge
    this.camera.pan(MARGIN.left / 2, -MARGIN.bottom / 2);
    this.fitted = true;
    this.paint();
  }

  /** The user has moved or zoomed: from now on nothing is fitted by itself. */
  moved(): void {
    this.fitted = false;
    this.paint();
  }

  get selected(): Item | null {
    return this.items.find((item) => samePath(item.path, this.store.selection)) ?? null;
  }

  /** Things under a pixel, the likeliest first. */
  thingsAt(pixel: Point): Item[] {
    return itemsAt(this.items, this.camera.toPlan(pixel), REACH / this.camera.scale);
  }

  /** The handle of the selected thing under a pixel. */
  handleAt(pixel: Point): Handle | null {
    const item = this.selected;
    if (!item) return null;
    const distance = (handle: Handle) => {
      const [x, y] = this.camera.toPixel(handle.at);
      return Math.hypot(x - pixel[0], y - pixel[1]);
    };
    const near = handlesOf(item.geometry).filter((handle) => distance(handle) <= REACH);
    return near.sort((a, b) => distance(a) - distance(b))[0] ?? null;
  }

  /** The place that a pixel means; `free` switches snapping off. */
  snapped(at: Point, free: boolean, without: Path | null, own: readonly Point[] = []): Snapped {
    if (free) return { at, fromX: null, fromY: null, onPoint: false };
    const points = [...snapPoints(this.items, without), ...own];
    return snap({ at, points, step: snapStep(this.camera), reach: REACH / this.camera.scale });
  }

  get reach(): number {
    return REACH / this.camera.scale;
  }

  get step(): number {
    return snapStep(this.camera);
  }

  /** Draw with the next frame. */
  paint(): void {
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.paintNow();
    });
  }

  private paintNow(): void {
    const { camera, ghost } = this;
    const [sheet, things, marks, figures] = this.layers as [SVGGElement, SVGGElement, SVGGElement, SVGGElement];
    this.element.setAttribute("width", String(camera.width));
    this.element.setAttribute("height", String(camera.height));
    // where a place of the plan lies on the screen, for those who look from outside
    this.element.dataset.view = `${camera.x} ${camera.y} ${camera.scale}`;
    const look: Look = {
      selected: this.store.selection,
      hovered: this.hovered,
      faulty: (this.store.doc?.faults ?? []).map((fault) => fault.path),
      loadCase: this.loadCase,
    };
    const shown = this.items.map((item) =>
      ghost?.item && samePath(ghost.item.path, item.path) ? withGeometry(item, ghost) : item,
    );
    sheet.replaceChildren(...paintGrid(camera));
    things.replaceChildren(...paintItems(camera, shown, look));
    marks.replaceChildren(...this.marks(shown));
    figures.replaceChildren(...paintFigures(camera));
  }

  private marks(shown: readonly Item[]): SVGElement[] {
    const { camera, ghost } = this;
    const selected = shown.find((item) => samePath(item.path, this.store.selection));
    const marks: SVGElement[] = [];
    if (selected && selected.geometry.type !== "point")
      marks.push(...paintDimensions(camera, dimensionRing(selected), isClosed(selected.geometry)));
    if (selected?.geometry.type === "point" && !selected.foot) {
      const [x, y] = camera.toPixel([selected.geometry.x, selected.geometry.y]);
      marks.push(svg("circle", { class: "halo", cx: x, cy: y, r: 11 }));
    }
    if (selected && !ghost) marks.push(...this.handles(selected));
    if (ghost) marks.push(...this.ghostMarks(ghost));
    if (this.guides) marks.push(...this.guideMarks(this.guides));
    return marks;
  }

  private handles(item: Item): SVGElement[] {
    return handlesOf(item.geometry).map((handle) => {
      const [x, y] = this.camera.toPixel(handle.at);
      const chosen = handle.kind === "corner" && handle.index === this.corner;
      const name = `handle ${handle.kind}${chosen ? " chosen" : ""}`;
      if (handle.kind === "add") return svg("circle", { class: name, cx: x, cy: y, r: 3.5 });
      return svg("rect", { class: name, x: x - HANDLE / 2, y: y - HANDLE / 2, width: HANDLE, height: HANDLE });
    });
  }

  private ghostMarks(ghost: Ghost): SVGElement[] {
    const ring = ringOf(ghost.geometry);
    const closed = isClosed(ghost.geometry);
    if (ghost.item) return [];
    const pixels = ring.map((point) => this.camera.toPixel(point));
    const corners = pixels.slice(0, -1).map(([x, y]) => svg("circle", { class: "drawn", cx: x, cy: y, r: 3 }));
    return [path(pixels, closed, "ghost"), ...(closed ? [] : corners), ...paintDimensions(this.camera, ring, closed)];
  }

  private guideMarks(guides: Snapped): SVGElement[] {
    const [x, y] = this.camera.toPixel(guides.at);
    const marks: SVGElement[] = [];
    for (const from of [guides.fromX, guides.fromY]) {
      if (!from) continue;
      marks.push(path([this.camera.toPixel(from), [x, y]], false, "guide"));
    }
    if (guides.onPoint) marks.push(svg("circle", { class: "on-point", cx: x, cy: y, r: 6 }));
    const words = this.ghost?.words;
    if (words) {
      const left = x > this.camera.width - 220;
      marks.push(label([x, y], words, [left ? -14 : 14, y < 40 ? 26 : -14], left ? "label tip end" : "label tip"));
    }
    return marks;
  }
}

function withGeometry(item: Item, ghost: Ghost): Item {
  return { ...item, geometry: ghost.geometry, foot: footOf(item.table, ghost.geometry) };
}

/** The corners whose distances are written: those of the shape itself, not of the chords of its arcs. */
function dimensionRing(item: Item): readonly Point[] {
  if (item.geometry.type === "circle") return [];
  return ringOf(item.geometry.type === "polygon" ? { ...item.geometry, bulges: [] } : item.geometry);
}

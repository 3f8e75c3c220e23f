// What is drawn above the field: the plan's symbols, marks, rulers. All of it moves with the plan.
import { type Box, boxAround } from "../data/boxes";
import type { FieldNumber } from "../data/field-numbers";
import { TakenBoxes } from "../data/label-placement";
import { lengthsOf } from "../data/lengths";
import type { Lengths, Plan, Point } from "../data/scene";
import { h, svg } from "../shared/dom";
import { type Camera, isNear, transformOf } from "./camera";
import { drawLabels } from "./labels";
import { type Layers, symbolsOf } from "./plan-symbols";
import { type Annotations, annotationSymbols } from "./result-symbols";
import { drawRulers, drawScaleBar } from "./rulers";
import { drawGroup, drawJoined } from "./symbol-groups";
import { drawCross, drawEnds, drawPath, drawStripSides, type PlanSymbol } from "./symbols";
import { thinLoads } from "./thinning";

/** Marks that the user sets, and those of the field. */
export interface Marks {
  pick: Point | null;
  place: Point | null; // that a chart points at
  section: [Point, Point] | null;
  width: number; // of the strip about the section, 0 of none [m]
  selected: { points: readonly Point[]; closed: boolean } | null; // an item of the model
  extremes: { point: Point; text: string; isMaximum: boolean }[];
  factors: ReadonlyMap<string, number> | null; // of the load cases in what is shown; null: no one combination
  written: Annotations; // beside the field
}

/** Return the numbers on a field where it is seen [m], at a scale [pixels per meter]. */
export type NumbersAt = (box: Box, scale: number) => FieldNumber[];

/** How far beyond the view symbols are drawn, as a share of it, so that they are there when it moves. */
export const BEYOND = 0.35;

export class Overlay {
  readonly element: HTMLElement;
  private readonly symbols = svg("svg", { class: "moving" });
  private readonly marks = svg("g");
  private readonly rulers = svg("svg");
  private drawn: { camera: Camera; when: number; cost: number } | null = null;

  constructor() {
    const about = { class: "gs-overlay gs-symbols gs-on-field", "aria-hidden": "true" };
    this.element = h("div", about, this.symbols, this.rulers);
  }

  /** Move and stretch what is drawn to where it belongs now; false if it has to be drawn again. */
  follow(camera: Camera): boolean {
    const { drawn } = this;
    if (!drawn) return false;
    const shift = camera.since(drawn.camera);
    if (!isNear(shift, camera, BEYOND) && performance.now() - drawn.when > 6 * drawn.cost) return false;
    this.symbols.style.transform = transformOf(shift);
    return true;
  }

  draw(camera: Camera, plan: Plan | null, layers: Layers, marks: Marks, numbers: NumbersAt | null = null): void {
    const start = performance.now();
    this.drawRulers(camera, layers, lengthsOf(plan));
    this.symbols.style.transform = "";
    const symbols = plan
      ? [...symbolsOf(plan, layers, marks.factors), ...annotationSymbols(marks.written, layers)]
      : [];
    const seen = symbols.filter((symbol) => isSeen(symbol, camera));
    const { groups, labels } = drawJoined(camera, thinLoads(seen, camera));
    const taken = new TakenBoxes();
    for (const symbol of seen) reserve(symbol, camera, taken);
    for (const mark of layers.extremes ? marks.extremes : []) {
      const at = camera.toPixel(mark.point);
      groups.push(drawExtreme(at, mark.isMaximum));
      taken.add([at[0] - 4, at[1] - 4, at[0] + 4, at[1] + 4]);
      labels.push({ kind: "extreme", text: mark.text, at: [at[0] + 8, at[1] + 5], align: "" });
    }
    for (const { at, text } of numbers?.(camera.box, camera.scale) ?? [])
      labels.push({ kind: "number", text, at: camera.toPixel(at), align: "over" });
    this.drawMarks(camera, marks);
    this.symbols.replaceChildren(...groups, ...drawLabels(labels, camera, taken), this.marks);
    this.symbols.setAttribute("viewBox", `0 0 ${camera.width} ${camera.height}`);
    const now = performance.now();
    this.drawn = { camera: camera.copy(), when: now, cost: now - start };
  }

  /** Draw what the user has marked. */
  drawMarks(camera: Camera, marks: Marks): void {
    const groups: SVGElement[] = [];
    if (marks.selected) groups.push(drawSelected(camera, marks.selected));
    if (marks.section) {
      const pixels = marks.section.map((point) => camera.toPixel(point));
      const sides = marks.width > 0 ? drawStripSides(pixels, (marks.width / 2) * camera.scale) : [];
      groups.push(drawGroup("cut", [drawPath(pixels, false), ...drawEnds(pixels), ...sides]));
    }
    if (marks.place) groups.push(drawGroup("place", [drawDot(camera.toPixel(marks.place), 5)]));
    if (marks.pick) groups.push(drawGroup("pick", drawPick(camera.toPixel(marks.pick))));
    this.marks.replaceChildren(...groups);
  }

  drawRulers(camera: Camera, layers: Layers, lengths: Lengths): void {
    this.rulers.setAttribute("viewBox", `0 0 ${camera.width} ${camera.height}`);
    this.rulers.replaceChildren(
      ...(layers.rulers ? [...drawRulers(camera, lengths), ...drawScaleBar(camera, lengths)] : []),
    );
  }
}

/** Draw a selected item: a ring around a point, a thick line along a line or around an area. */
function drawSelected(camera: Camera, { points, closed }: NonNullable<Marks["selected"]>): SVGGElement {
  const pixels = points.map((point) => camera.toPixel(point));
  return drawGroup("selected", pixels.length === 1 ? [drawDot(pixels[0]!, 11)] : [drawPath(pixels, closed)]);
}

function drawDot([cx, cy]: Point, r: number): SVGElement {
  return svg("circle", { cx, cy, r });
}

function drawExtreme(at: Point, isMaximum: boolean): SVGGElement {
  const group = drawGroup("extreme", [drawDot(at, 4)]);
  group.classList.toggle("maximum", isMaximum);
  return group;
}

function drawPick(at: Point): SVGElement[] {
  return [svg("circle", { cx: at[0], cy: at[1], r: 7 }), ...drawCross(at, 12)];
}

/** Whether a symbol is in the view or near it. */
function isSeen({ points }: PlanSymbol, { box, width, height, scale }: Camera): boolean {
  const [x0, y0, x1, y1] = boxAround(points);
  const [dx, dy] = [(BEYOND * width) / scale, (BEYOND * height) / scale];
  return x1 >= box[0] - dx && x0 <= box[2] + dx && y1 >= box[1] - dy && y0 <= box[3] + dy;
}

/** Let no label cover a column or a support. */
function reserve({ kind, shape, points, foot }: PlanSymbol, camera: Camera, taken: TakenBoxes): void {
  if (kind !== "column" && !(kind === "support" && shape === "point")) return;
  const [x0, y0, x1, y1] = boxAround((foot?.length ? foot : points).map((point) => camera.toPixel(point)));
  const below = kind === "support" ? 14 : 0;
  taken.add([x0 - 2, y0 - 2, x1 + 2, y1 + 2 + below]);
}

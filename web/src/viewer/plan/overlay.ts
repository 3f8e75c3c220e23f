// What is drawn above the field: the plan's symbols, marks, rulers. All of it moves with the plan.
import { lengthsOf } from "../data/lengths";
import type { Lengths, Plan, Point } from "../data/scene";
import { svg } from "../shared/dom";
import { FONT } from "../shared/palette";
import type { Camera } from "./camera";
import { type Layers, symbolsOf } from "./plan-symbols";
import { drawRulers, drawScaleBar, RULER } from "./rulers";
import { drawCross, drawEnds, drawPath, drawSymbol, drawText, type Kind } from "./symbols";

/** Marks that the user sets, and those of the field. */
export interface Marks {
  pick: Point | null;
  place: Point | null; // that a chart points at
  section: [Point, Point] | null;
  selected: { points: readonly Point[]; closed: boolean } | null; // an item of the model
  extremes: { point: Point; text: string; isMaximum: boolean }[];
  factors: ReadonlyMap<string, number> | null; // of the load cases in what is shown; null: no one combination
}

/** Kinds whose texts get a place first. */
const PRIORITY: readonly (Kind | "extreme")[] = [
  "extreme",
  "axis",
  "zone",
  "borehole",
  "strip",
  "section line",
  "output point",
  "load",
  "support",
];

export class Overlay {
  readonly element: SVGSVGElement;
  private readonly symbols = svg("g");
  private readonly rulers = svg("g");

  constructor() {
    this.element = svg(
      "svg",
      { class: "gs-overlay gs-symbols gs-on-field", "aria-hidden": "true" },
      this.symbols,
      this.rulers,
    );
  }

  /** Move what is drawn by pixels, until it is drawn again. */
  shift(du: number, dv: number): void {
    this.symbols.setAttribute("transform", `translate(${du} ${dv})`);
  }

  draw(camera: Camera, plan: Plan | null, layers: Layers, marks: Marks): void {
    this.drawRulers(camera, layers, lengthsOf(plan));
    this.symbols.removeAttribute("transform");
    const groups = plan
      ? symbolsOf(plan, layers, marks.factors).map((symbol) => drawGroup(symbol.kind, drawSymbol(camera, symbol)))
      : [];
    if (layers.extremes) groups.push(...marks.extremes.map((mark) => drawExtreme(camera, mark)));
    groups.push(...placeTexts(groups, camera));
    if (marks.selected) groups.push(drawSelected(camera, marks.selected));
    if (marks.section) {
      const pixels = marks.section.map((point) => camera.toPixel(point));
      groups.push(drawGroup("cut", [drawPath(pixels, false), ...drawEnds(pixels)]));
    }
    if (marks.place) groups.push(drawGroup("place", [drawDot(camera.toPixel(marks.place), 5)]));
    if (marks.pick) groups.push(drawGroup("pick", drawPick(camera.toPixel(marks.pick))));
    this.symbols.replaceChildren(...groups);
  }

  drawRulers(camera: Camera, layers: Layers, lengths: Lengths): void {
    this.element.setAttribute("viewBox", `0 0 ${camera.width} ${camera.height}`);
    this.rulers.replaceChildren(
      ...(layers.axes ? [...drawRulers(camera, lengths), ...drawScaleBar(camera, lengths)] : []),
    );
  }
}

/** Draw elements with a halo below them, so that they are seen on every color. */
function drawGroup(kind: string, elements: SVGElement[]): SVGGElement {
  const lines = elements.filter((element) => element.tagName !== "text");
  const halo = svg("g", { class: "halo" }, ...lines.map((element) => element.cloneNode() as SVGElement));
  return svg("g", { class: `symbol ${kind.replaceAll(" ", "-")}`, "data-kind": kind }, halo, ...elements);
}

/** Draw a selected item: a ring around a point, a thick line along a line or around an area. */
function drawSelected(camera: Camera, { points, closed }: NonNullable<Marks["selected"]>): SVGGElement {
  const pixels = points.map((point) => camera.toPixel(point));
  return drawGroup("selected", pixels.length === 1 ? [drawDot(pixels[0]!, 11)] : [drawPath(pixels, closed)]);
}

function drawDot([cx, cy]: Point, r: number): SVGElement {
  return svg("circle", { cx, cy, r });
}

function drawPick(at: Point): SVGElement[] {
  return [svg("circle", { cx: at[0], cy: at[1], r: 7 }), ...drawCross(at, 12)];
}

function drawExtreme(camera: Camera, { point, text, isMaximum }: Marks["extremes"][number]): SVGGElement {
  const at = camera.toPixel(point);
  const group = drawGroup("extreme", [drawDot(at, 4), drawText(at, text, [8, 5])]);
  group.classList.toggle("maximum", isMaximum);
  return group;
}

/**
 * Move the texts of groups above all of them, and remove those that would cover others or lie outside.
 *
 * Texts that would leave the view move to the other side of their symbol, or beside the ruler.
 */
function placeTexts(groups: readonly SVGGElement[], { width, height }: Camera): SVGGElement[] {
  const rank = (group: SVGGElement) => {
    const position = PRIORITY.indexOf(group.dataset.kind as Kind);
    return position < 0 ? PRIORITY.length : position;
  };
  const boxes: number[][] = [];
  const context = document.createElement("canvas").getContext("2d");
  if (context) context.font = `11px ${FONT}`;
  const isPlaced = (text: SVGTextElement) => {
    const [x, y] = [Number(text.getAttribute("x")), Number(text.getAttribute("y"))];
    const length = context?.measureText(text.textContent ?? "").width ?? 0;
    const before = text.classList.contains("middle") ? x - length / 2 : x;
    const beside = before + length > width - 2 && x < width ? x - length - 16 : before;
    const left = beside < RULER.left + 4 && x > RULER.left ? RULER.left + 4 : beside;
    text.setAttribute("x", String(left));
    text.setAttribute("class", "label");
    const box = [left - 2, y - 11, left + length + 2, y + 4];
    if (!text.textContent || y < -20 || y > height + 20 || boxes.some((other) => overlap(box, other))) return false;
    boxes.push(box);
    return true;
  };
  return [...groups]
    .sort((a, b) => rank(a) - rank(b))
    .map((group) => {
      const texts = [...group.querySelectorAll("text")];
      for (const text of texts) text.remove();
      return svg("g", { class: group.getAttribute("class") }, ...texts.filter(isPlaced));
    });
}

function overlap(a: readonly number[], b: readonly number[]): boolean {
  return a[0]! < b[2]! && b[0]! < a[2]! && a[1]! < b[3]! && b[1]! < a[3]!;
}

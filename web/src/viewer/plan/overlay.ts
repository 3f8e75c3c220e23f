// What is drawn above the field: outline, openings, columns, supports, loads, marks, axes. Pure drawing on a 2-D canvas.

import { neat, roundStep, roundTicks, tickTexts } from "../data/color-scale";
import { shownLoads } from "../data/load-labels";
import type { Plan, Point, Ring } from "../data/scene";
import type { Camera } from "../renderer/renderer";
import { plainWords } from "../shared/dom";
import type { Look } from "../shared/palette";

/** What of the plan is drawn. */
export interface Layers {
  loads: boolean;
  columns: boolean;
  supports: boolean;
  zones: boolean;
  ground: boolean; // boreholes, soil zones, voids
  output: boolean; // section lines, strips, points
  labels: boolean;
  extremes: boolean; // where the shown field is smallest and largest
  axes: boolean;
}

export const ALL_LAYERS: Layers = {
  loads: true,
  columns: true,
  supports: true,
  zones: true,
  ground: true,
  output: true,
  labels: true,
  extremes: true,
  axes: true,
};

/** Marks that the user sets, and those of the field. */
export interface Marks {
  pick: Point | null;
  place: Point | null; // that a chart points at
  section: [Point, Point] | null;
  extremes: { point: Point; text: string; largest: boolean }[];
  factors: ReadonlyMap<string, number> | null; // of the load cases in what is shown; null: no one combination
}

/** Room that the axes take at the left and at the bottom [px]. */
export const AXES = { left: 46, bottom: 26 } as const;

export interface Sheet {
  context: CanvasRenderingContext2D; // scaled to pixels of style sheets
  camera: Camera;
  width: number;
  height: number;
  look: Look;
  font: string;
}

export function pixel(sheet: Pick<Sheet, "camera" | "width" | "height">, x: number, y: number): Point {
  const { camera, width, height } = sheet;
  return [width / 2 + (x - camera.x) * camera.scale, height / 2 - (y - camera.y) * camera.scale];
}

/** Height of the strip at the bottom that holds the axis and, above it, the scale bar [px]. */
export const STRIP = AXES.bottom + 40;

/** Draw the plan and the marks; all of it moves with the plan. */
export function drawOverlay(sheet: Sheet, plan: Plan | null, layers: Layers, marks: Marks): void {
  const { context } = sheet;
  context.lineJoin = context.lineCap = "round";
  const labels = new Labels(sheet);
  if (plan) {
    if (layers.ground) drawGround(sheet, plan, labels, layers);
    if (layers.zones) drawZones(sheet, plan, labels, layers);
    drawOutline(sheet, plan);
    if (layers.output) drawOutput(sheet, plan, labels, layers);
    if (layers.loads) drawLoads(sheet, plan, labels, layers, marks.factors);
    if (layers.supports) drawSupports(sheet, plan, labels, layers);
    if (layers.columns) drawColumns(sheet, plan, labels, layers);
  }
  if (layers.extremes) for (const mark of marks.extremes) drawExtreme(sheet, mark, labels);
  labels.draw();
  if (marks.section) drawSection(sheet, marks.section);
  if (marks.place) drawPlace(sheet, marks.place);
  if (marks.pick) drawPick(sheet, marks.pick);
}

/** Texts that are drawn last, each only if it has room. */
class Labels {
  private readonly boxes: [number, number, number, number][] = [];
  private readonly texts: {
    text: string;
    x: number;
    y: number;
    colour: string;
    weight: number;
    align: CanvasTextAlign;
  }[] = [];

  constructor(private readonly sheet: Sheet) {}

  /** `weight`: those that weigh more get their room first. */
  add(text: string, [x, y]: Point, colour: string, weight = 1, align: CanvasTextAlign = "left"): void {
    if (text) this.texts.push({ text, x, y, colour, weight, align });
  }

  draw(): void {
    const { context, look, font, width, height } = this.sheet;
    context.font = `12px ${font}`;
    context.textBaseline = "middle";
    context.lineWidth = 3.5;
    context.strokeStyle = look.halo;
    for (const { text, x, y, colour, align } of this.texts.sort((one, other) => other.weight - one.weight)) {
      if (x < -200 || y < -20 || x > width + 200 || y > height + 20) continue;
      const long = context.measureText(text).width;
      let left = align === "center" ? x - long / 2 : align === "right" ? x - long : x;
      // a text that would leave the view goes to its mark's other side
      if (align === "left" && left + long > width - 2 && x < width) left = x - long - 16;
      const box: [number, number, number, number] = [left - 2, y - 8, left + long + 2, y + 8];
      if (this.boxes.some((other) => box[0] < other[2] && other[0] < box[2] && box[1] < other[3] && other[1] < box[3]))
        continue;
      this.boxes.push(box);
      context.textAlign = "left";
      context.strokeText(text, left, y);
      context.fillStyle = colour;
      context.fillText(text, left, y);
    }
  }
}

function trace(sheet: Sheet, ring: readonly Point[], closed = true): void {
  const { context } = sheet;
  ring.forEach(([x, y], i) => {
    const [px, py] = pixel(sheet, x, y);
    if (i) context.lineTo(px, py);
    else context.moveTo(px, py);
  });
  if (closed) context.closePath();
}

function stroke(
  sheet: Sheet,
  rings: readonly (readonly Point[])[],
  colour: string,
  width: number,
  dash: number[] = [],
  closed = true,
  halo = 0,
): void {
  if (!rings.length) return;
  const { context, look } = sheet;
  context.beginPath();
  for (const ring of rings) trace(sheet, ring, closed);
  if (halo) {
    context.setLineDash([]);
    context.lineWidth = width + halo;
    context.strokeStyle = look.halo;
    context.stroke();
  }
  context.setLineDash(dash);
  context.lineWidth = width;
  context.strokeStyle = colour;
  context.stroke();
  context.setLineDash([]);
}

function drawOutline(sheet: Sheet, plan: Plan): void {
  const { context, look } = sheet;
  for (const { ring } of plan.openings) {
    context.beginPath();
    trace(sheet, ring);
    context.fillStyle = look.paper;
    context.fill();
    // the cross of an opening, within its edges
    context.save();
    context.clip();
    const [x0, y0, x1, y1] = boundsOf(ring);
    stroke(
      sheet,
      [
        [
          [x0, y0],
          [x1, y1],
        ],
        [
          [x0, y1],
          [x1, y0],
        ],
      ],
      look.ink2,
      0.8,
      [],
      false,
    );
    context.restore();
  }
  stroke(sheet, [plan.outline, ...plan.openings.map((each) => each.ring)], look.ink, 1.6);
}

function drawZones(sheet: Sheet, plan: Plan, labels: Labels, layers: Layers): void {
  stroke(
    sheet,
    plan.zones.map((zone) => zone.ring),
    sheet.look.ink,
    1.1,
    [7, 4],
    true,
    1.5,
  );
  if (!layers.labels) return;
  for (const zone of plan.zones) {
    const [x0, , , y1] = boundsOf(zone.ring);
    const [px, py] = pixel(sheet, x0, y1);
    labels.add(`t = ${neat(zone.thickness * 1000)} mm`, [px + 5, py + 11], sheet.look.ink, 3);
  }
}

function drawGround(sheet: Sheet, plan: Plan, labels: Labels, layers: Layers): void {
  const { context, look } = sheet;
  stroke(
    sheet,
    plan.soil_zones.map((each) => each.ring),
    look.soil,
    1.2,
    [2, 4],
  );
  stroke(
    sheet,
    plan.voids.map((each) => each.ring),
    look.soil,
    1.4,
    [4, 3],
    true,
    1.5,
  );
  for (const { name, x, y } of plan.boreholes) {
    const [px, py] = pixel(sheet, x, y);
    // a circle with two of its quarters filled
    context.fillStyle = look.paper;
    context.strokeStyle = look.soil;
    context.lineWidth = 1.4;
    context.beginPath();
    context.arc(px, py, 6, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
    context.fillStyle = look.soil;
    for (const start of [0, Math.PI]) {
      context.beginPath();
      context.moveTo(px, py);
      context.arc(px, py, 6, start, start + Math.PI / 2);
      context.fill();
    }
    if (layers.labels) labels.add(name, [px + 10, py], look.soil, 2);
  }
}

function drawOutput(sheet: Sheet, plan: Plan, labels: Labels, layers: Layers): void {
  const { context, look } = sheet;
  stroke(
    sheet,
    plan.lines.map(({ start, end }) => [start, end]),
    look.section,
    1.2,
    [12, 3, 2, 3],
    false,
    2,
  );
  for (const strip of plan.strips) {
    const [dx, dy] = [strip.end[0] - strip.start[0], strip.end[1] - strip.start[1]];
    const length = Math.hypot(dx, dy) || 1;
    const [nx, ny] = [((-dy / length) * strip.width) / 2, ((dx / length) * strip.width) / 2];
    const ring: Ring = [
      [strip.start[0] + nx, strip.start[1] + ny],
      [strip.end[0] + nx, strip.end[1] + ny],
      [strip.end[0] - nx, strip.end[1] - ny],
      [strip.start[0] - nx, strip.start[1] - ny],
    ];
    stroke(sheet, [ring], look.section, 1, [3, 3], true, 1.5);
  }
  for (const { x, y } of plan.points) {
    const [px, py] = pixel(sheet, x, y);
    context.beginPath();
    context.moveTo(px - 4, py - 4);
    context.lineTo(px + 4, py + 4);
    context.moveTo(px - 4, py + 4);
    context.lineTo(px + 4, py - 4);
    for (const [width, colour] of [
      [4.5, look.halo],
      [1.7, look.section],
    ] as const) {
      context.lineWidth = width;
      context.strokeStyle = colour;
      context.stroke();
    }
  }
  if (!layers.labels) return;
  for (const each of [...plan.lines, ...plan.strips]) {
    const [px, py] = pixel(sheet, ...each.start);
    labels.add(each.name, [px + 5, py - 9], look.section, 2);
  }
  for (const each of plan.points) {
    const [px, py] = pixel(sheet, each.x, each.y);
    labels.add(each.name, [px + 7, py - 8], look.section, 2);
  }
}

function drawLoads(sheet: Sheet, plan: Plan, labels: Labels, layers: Layers, factors: Marks["factors"]): void {
  const { look } = sheet;
  for (const { load, words } of shownLoads(plan.loads, factors)) {
    if (load.kind === "uniform") continue;
    if (load.ring) {
      stroke(sheet, [load.ring, ...(load.holes ?? [])], look.load, 1.4, [5, 4], true, 1.5);
      const [x0, y0, x1, y1] = boundsOf(load.ring);
      const [px, py] = pixel(sheet, (x0 + x1) / 2, (y0 + y1) / 2);
      if (layers.labels) labels.add(plainWords(words), [px, py], look.load, 1.5, "center");
    } else if (load.points && load.points.length > 1) {
      stroke(sheet, [load.points], look.load, 2.4, [], false, 2);
      const [a, b] = [load.points[0]!, load.points[1]!];
      const [px, py] = pixel(sheet, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
      if (layers.labels) labels.add(plainWords(words), [px + 6, py - 10], look.load, 1.5);
    } else if (load.points?.length) {
      if (load.footprint) stroke(sheet, [load.footprint], look.load, 1.1, [4, 3], true, 1.5);
      const [px, py] = pixel(sheet, ...load.points[0]!);
      triangle(sheet, px, py, 6, look.load, false);
      if (layers.labels) labels.add(plainWords(words), [px + 9, py - 9], look.load, 1.5);
    }
  }
}

function drawSupports(sheet: Sheet, plan: Plan, labels: Labels, layers: Layers): void {
  const { look } = sheet;
  for (const support of plan.supports) {
    if (support.kind === "line") {
      stroke(sheet, [support.points], look.support, 4, support.elastic ? [8, 6] : [], false, 2.5);
    } else {
      const [px, py] = pixel(sheet, ...support.points[0]!);
      triangle(sheet, px, py, 7, look.support, true, support.elastic);
    }
    const [px, py] = pixel(sheet, ...support.points[0]!);
    if (layers.labels) labels.add(support.name, [px + 10, py + 9], look.support, 1.2);
  }
}

function drawColumns(sheet: Sheet, plan: Plan, labels: Labels, layers: Layers): void {
  const { context, look } = sheet;
  for (const column of plan.columns) {
    const [px, py] = pixel(sheet, column.x, column.y);
    const [x0, y0, x1, y1] = boundsOf(column.ring);
    context.beginPath();
    trace(sheet, column.ring);
    context.fillStyle = "rgb(20 24 28 / 0.55)";
    context.fill();
    context.lineWidth = 2.6;
    context.strokeStyle = look.halo;
    context.stroke();
    context.lineWidth = 1.3;
    context.strokeStyle = look.ink;
    context.stroke();
    const size = Math.max(x1 - x0, y1 - y0) * sheet.camera.scale;
    if (layers.labels && column.name) labels.add(column.name, [px + size / 2 + 4, py + 9], look.ink, 1.1);
  }
}

function triangle(sheet: Sheet, x: number, y: number, size: number, colour: string, up: boolean, hollow = false): void {
  const { context, look } = sheet;
  const sign = up ? 1 : -1;
  context.beginPath();
  context.moveTo(x, y - sign * size * 0.2);
  context.lineTo(x - size, y + sign * size * 1.4);
  context.lineTo(x + size, y + sign * size * 1.4);
  context.closePath();
  context.fillStyle = hollow ? look.paper : colour;
  context.lineWidth = hollow ? 1.8 : 1.2;
  context.strokeStyle = hollow ? colour : look.paper;
  context.fill();
  context.stroke();
}

function drawExtreme(sheet: Sheet, mark: Marks["extremes"][number], labels: Labels): void {
  const { context, look } = sheet;
  const [px, py] = pixel(sheet, ...mark.point);
  context.beginPath();
  context.arc(px, py, 4, 0, 2 * Math.PI);
  context.fillStyle = mark.largest ? look.ink : look.paper;
  context.lineWidth = 1.6;
  context.fill();
  context.strokeStyle = mark.largest ? look.paper : look.ink;
  context.stroke();
  labels.add(mark.text, [px + 8, py + 1], look.ink, 9);
}

function drawPick(sheet: Sheet, point: Point): void {
  const { context, look } = sheet;
  const [px, py] = pixel(sheet, ...point);
  for (const [width, colour] of [
    [4, look.halo],
    [1.5, look.accent],
  ] as const) {
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.beginPath();
    context.arc(px, py, 7, 0, 2 * Math.PI);
    for (const [dx, dy] of [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ] as const) {
      context.moveTo(px + 3 * dx, py + 3 * dy);
      context.lineTo(px + 12 * dx, py + 12 * dy);
    }
    context.stroke();
  }
}

function drawPlace(sheet: Sheet, point: Point): void {
  const { context, look } = sheet;
  const [px, py] = pixel(sheet, ...point);
  context.beginPath();
  context.arc(px, py, 5, 0, 2 * Math.PI);
  context.fillStyle = look.section;
  context.lineWidth = 2;
  context.strokeStyle = look.paper;
  context.fill();
  context.stroke();
}

function drawSection(sheet: Sheet, [start, end]: [Point, Point]): void {
  const { context, look } = sheet;
  const [ax, ay] = pixel(sheet, ...start);
  const [bx, by] = pixel(sheet, ...end);
  const length = Math.hypot(bx - ax, by - ay) || 1;
  const [nx, ny] = [(-(by - ay) / length) * 6, ((bx - ax) / length) * 6];
  for (const [width, colour] of [
    [4.5, look.halo],
    [2, look.section],
  ] as const) {
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.beginPath();
    context.moveTo(ax, ay);
    context.lineTo(bx, by);
    for (const [x, y] of [
      [ax, ay],
      [bx, by],
    ] as const) {
      context.moveTo(x - nx, y - ny);
      context.lineTo(x + nx, y + ny);
    }
    context.stroke();
  }
}

/** Draw the axes and the scale bar, which stay at the view's edges. */
export function drawAxes(sheet: Sheet): void {
  const { context, camera, width, height, look, font } = sheet;
  const { left, bottom } = AXES;
  context.fillStyle = look.paper;
  context.fillRect(0, 0, left, height);
  context.fillRect(left, height - bottom, width - left, bottom);
  context.strokeStyle = look.ink2;
  context.fillStyle = look.ink2;
  context.lineWidth = 1;
  context.font = `11px ${font}`;
  context.beginPath();
  context.moveTo(left + 0.5, 0);
  context.lineTo(left + 0.5, height - bottom + 0.5);
  context.lineTo(width, height - bottom + 0.5);
  const across = roundTicks(
    camera.x + (left - width / 2) / camera.scale,
    camera.x + width / 2 / camera.scale,
    width / 90,
  );
  const upwards = roundTicks(
    camera.y + (bottom - height / 2) / camera.scale,
    camera.y + height / 2 / camera.scale,
    height / 70,
  );
  context.textAlign = "center";
  context.textBaseline = "top";
  tickTexts(across).forEach((text, i) => {
    const px = Math.round(pixel(sheet, across[i]!, 0)[0]) + 0.5;
    context.moveTo(px, height - bottom);
    context.lineTo(px, height - bottom + 4);
    if (px > left + 14 && px < width - 34) context.fillText(text, px, height - bottom + 7);
  });
  context.textAlign = "right";
  context.textBaseline = "middle";
  tickTexts(upwards).forEach((text, i) => {
    const py = Math.round(pixel(sheet, 0, upwards[i]!)[1]) + 0.5;
    context.moveTo(left - 4, py);
    context.lineTo(left, py);
    if (py > 22 && py < height - bottom - 6) context.fillText(text, left - 7, py);
  });
  context.stroke();
  context.textAlign = "left";
  context.fillText("y [m]", 8, 10);
  context.textAlign = "right";
  context.textBaseline = "top";
  context.fillText("x [m]", width - 4, height - bottom + 7);
  drawScaleBar(sheet);
}

function drawScaleBar(sheet: Sheet): void {
  const { context, camera, width, height, look, font } = sheet;
  const long = roundStep(50 / camera.scale);
  const pixels = long * camera.scale;
  const [right, y] = [width - 12, height - AXES.bottom - 10];
  const text = `${neat(long)} m`;
  context.font = `11px ${font}`;
  const room = Math.max(pixels, context.measureText(text).width) + 12;
  context.fillStyle = look.halo;
  context.fillRect(right - room + 6, y - 17, room, 23);
  context.strokeStyle = look.ink;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(right - pixels, y - 4);
  context.lineTo(right - pixels, y + 2);
  context.lineTo(right, y + 2);
  context.lineTo(right, y - 4);
  context.stroke();
  context.fillStyle = look.ink;
  context.textAlign = "right";
  context.textBaseline = "bottom";
  context.fillText(text, right, y - 3);
}

function boundsOf(ring: readonly Point[]): [number, number, number, number] {
  const [xs, ys] = [ring.map(([x]) => x), ring.map(([, y]) => y)];
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

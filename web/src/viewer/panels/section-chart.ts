// A field along a line through the plate, for one or several combinations.
import uPlot from "uplot";
import { neat, number } from "../data/color-scale";
import { type Choice, choiceName, fieldOf, isEnvelope } from "../data/fields";
import type { Locator } from "../data/point-location";
import type { Point, Scene } from "../data/scene";
import { along, downwards, limits, peaks, type Samples, sample } from "../data/section-sampling";
import { make, symbolText } from "../shared/dom";
import { type Look, look } from "../shared/palette";
import { type Theme, theme } from "../shared/theme";
import "uplot/dist/uPlot.min.css";
import "./section-chart.css";

/** Colours for curves that the colour-blind tell apart (Okabe and Ito 2008), for light and dark paper. */
const CURVES = {
  light: ["#0072b2", "#d55e00", "#00795b", "#b0568c", "#8a6d00", "#2a8fc4", "#5a4fcf", "#6b6b6b"],
  dark: ["#56b4e9", "#f0883e", "#2bc49a", "#e29cc4", "#e6c229", "#9ad0f5", "#a79bff", "#b5b5b5"],
} as const;
/** From the ninth curve on, colours come again, dashed. */
const DASH = [7, 4];
const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "Liberation Sans", "DejaVu Sans", sans-serif';

/** What is drawn: a field of some combinations between two points. */
export interface Section {
  scene: Scene;
  locator: Locator;
  field: string;
  choices: Choice[];
  start: Point;
  end: Point;
  name?: string;
}

type Curve = (number | null)[];

export class SectionChart {
  /** The cursor is over a place of the section [m]; null: it left. */
  onPlace?: (at: Point | null) => void;
  readonly element = make("div", { class: "gs-chart" });
  private plot: uPlot | null = null;
  private section: Section | null = null;
  private samples: Samples | null = null;
  private curves: Curve[] = [];
  private theme: Theme = theme();
  private readonly resized: ResizeObserver;

  constructor(container: HTMLElement) {
    container.append(this.element);
    this.resized = new ResizeObserver(() => this.resize());
    this.resized.observe(this.element);
  }

  /** Draw a section; null: nothing. */
  show(section: Section | null): void {
    const before = this.section;
    this.section = section;
    const same =
      before &&
      section &&
      before.locator === section.locator &&
      String([before.start, before.end]) === String([section.start, section.end]);
    if (!same) this.samples = section ? sample(section.locator, section.start, section.end) : null;
    this.curves =
      section && this.samples
        ? section.choices.map((choice) => along(section.scene, section.locator, choice, section.field, this.samples!))
        : [];
    this.draw();
  }

  setTheme(to: Theme): void {
    this.theme = to;
    this.draw();
  }

  /** Draw the section into a canvas of its own, on white, `ratio` dots per pixel: for paper. Null if there is none. */
  snapshot(width: number, height: number, ratio: number): HTMLCanvasElement | null {
    if (!this.section || !this.samples || !this.crosses()) return null;
    const times = ratio / uPlot.pxRatio;
    const away = make("div", { class: "gs-chart gs-chart-away" });
    document.body.append(away);
    const plot = new uPlot(
      this.options(width * times, height * times, times, "light"),
      [this.samples.s, ...this.curves],
      away,
    );
    plot.batch(() => undefined); // draws at once
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [plot.ctx.canvas.width, plot.ctx.canvas.height];
    canvas.getContext("2d")!.drawImage(plot.ctx.canvas, 0, 0);
    canvas.style.width = `${width}px`;
    plot.destroy();
    away.remove();
    return canvas;
  }

  /** Return the curves' names with their colours, for a legend on paper. */
  names(): { name: string; colour: string }[] {
    const { section } = this;
    return section
      ? section.choices.map((choice, i) => ({
          name: choiceName(section.scene, choice),
          colour: CURVES.light[i % CURVES.light.length]!,
        }))
      : [];
  }

  dispose(): void {
    this.resized.disconnect();
    this.plot?.destroy();
    this.element.remove();
  }

  private crosses(): boolean {
    return this.curves.some((curve) => peaks(this.samples!.s, curve) !== null);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (!this.plot || !width || !height) return;
    this.plot.setSize({ width, height: this.room() });
  }

  private room(): number {
    return Math.max(
      this.element.clientHeight - (this.element.querySelector<HTMLElement>(".u-legend")?.offsetHeight ?? 26),
      90,
    );
  }

  private draw(): void {
    this.plot?.destroy();
    this.plot = null;
    this.element.replaceChildren();
    const { section, samples } = this;
    this.onPlace?.(null);
    if (!section || !samples) return;
    if (!this.crosses()) {
      this.element.append(make("p", { class: "gs-chart-none" }, "The section does not cross the plate."));
      return;
    }
    const width = Math.max(this.element.clientWidth, 200);
    this.plot = new uPlot(
      this.options(width, Math.max(this.element.clientHeight - 26, 90), 1, this.theme),
      [samples.s, ...this.curves],
      this.element,
    );
    this.resize();
  }

  /** Return how uPlot shall draw; `times` enlarges type and lines. */
  private options(width: number, height: number, times: number, dress: Theme): uPlot.Options {
    const { scene, field, choices } = this.section!;
    const info = fieldOf(scene, field);
    const colours = look(dress);
    const font = `${12 * times}px ${FONT}`;
    const axis: uPlot.Axis = {
      stroke: colours.ink,
      font,
      labelFont: font,
      gap: 4 * times,
      grid: { stroke: colours.line, width: 0.7 * times },
      ticks: { stroke: colours.line, width: times, size: 5 * times },
    };
    const curveColours = CURVES[dress];
    return {
      width,
      height,
      scales: {
        x: { time: false, range: () => [0, Math.max(this.length(), 1e-9)] },
        y: { dir: downwards(field) ? -1 : 1, range: (_, low, high) => limits(low, high) },
      },
      axes: [
        {
          ...axis,
          label: "distance s along the section [m]",
          labelSize: 18 * times,
          size: 26 * times,
          space: 60 * times,
          values: (_, ticks) => ticks.map((tick) => neat(tick, 6)),
        },
        {
          ...axis,
          label: `${symbolText(info.symbol)} [${info.unit}]`,
          labelSize: 20 * times,
          size: 50 * times,
          space: 26 * times,
          values: (_, ticks) => ticks.map((tick) => neat(tick, 6)),
        },
      ],
      legend: { show: times === 1 },
      cursor: { drag: { x: false, y: false }, points: { size: 7 } },
      padding: [10 * times, 14 * times, 0, 0],
      series: [
        { label: "s", value: (_, value: number | null) => (value === null ? "–" : `${value.toFixed(2)} m`) },
        ...choices.map(
          (choice, i): uPlot.Series => ({
            label: choiceName(scene, choice) || symbolText(info.symbol),
            stroke: curveColours[i % curveColours.length]!,
            ...(choices.length === 1 ? { fill: `${curveColours[0]}1c` } : {}),
            width: 1.7 * times,
            ...(i >= curveColours.length ? { dash: DASH.map((part) => part * times) } : {}),
            points: { show: false },
            value: (_, value: number | null) => (value === null ? "–" : `${number(value)} ${info.unit}`),
          }),
        ),
      ],
      hooks: {
        draw: [(plot) => this.mark(plot, times, colours)],
        setCursor: [
          (plot) => {
            if (times === 1) this.point(plot);
          },
        ],
      },
    };
  }

  private length(): number {
    const { start, end } = this.section!;
    return Math.hypot(end[0] - start[0], end[1] - start[1]);
  }

  private point(plot: uPlot): void {
    const { idx } = plot.cursor;
    const s = idx === null || idx === undefined ? undefined : this.samples?.s[idx];
    if (s === undefined || (plot.cursor.left ?? -1) < 0) {
      this.onPlace?.(null);
      return;
    }
    const { start, end } = this.section!;
    const part = s / (this.length() || 1);
    this.onPlace?.([start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1])]);
  }

  /** Draw the zero line, and the largest and smallest value of all curves with the number of their combination. */
  private mark(plot: uPlot, times: number, colours: Look): void {
    const { ctx, bbox } = plot;
    const dot = uPlot.pxRatio * times;
    const { scene, choices } = this.section!;
    ctx.save();
    const zero = Math.round(plot.valToPos(0, "y", true));
    if (zero >= bbox.top && zero <= bbox.top + bbox.height) {
      ctx.strokeStyle = colours.ink;
      ctx.lineWidth = dot;
      ctx.beginPath();
      ctx.moveTo(bbox.left, zero);
      ctx.lineTo(bbox.left + bbox.width, zero);
      ctx.stroke();
    }
    let [low, high]: [Peak | null, Peak | null] = [null, null];
    this.curves.forEach((curve, i) => {
      const found = peaks(this.samples!.s, curve);
      if (!found) return;
      if (!low || found.min[1] < low.value) low = { s: found.min[0], value: found.min[1], curve: i };
      if (!high || found.max[1] > high.value) high = { s: found.max[0], value: found.max[1], curve: i };
    });
    ctx.font = `600 ${12 * dot}px ${FONT}`;
    ctx.lineJoin = "round";
    ctx.textAlign = "left";
    ctx.textBaseline = "alphabetic";
    for (const peak of [high, low] as (Peak | null)[]) {
      if (!peak) continue;
      const [x, y] = [plot.valToPos(peak.s, "x", true), plot.valToPos(peak.value, "y", true)];
      ctx.beginPath();
      ctx.arc(x, y, 3.5 * dot, 0, 2 * Math.PI);
      ctx.fillStyle = colours.ink;
      ctx.fill();
      const choice = choices[peak.curve]!;
      const from =
        choices.length > 1 && !isEnvelope(choice) ? ` (${scene.head.combinations[choice]?.number ?? ""})` : "";
      const text = `${peak === high ? "max" : "min"} ${number(peak.value)}${from}`;
      const long = ctx.measureText(text).width;
      const left = x + 8 * dot + long > bbox.left + bbox.width ? x - 8 * dot - long : x + 8 * dot;
      const base = Math.min(Math.max(y - 6 * dot, bbox.top + 12 * dot), bbox.top + bbox.height - 4 * dot);
      ctx.strokeStyle = colours.halo;
      ctx.lineWidth = 3 * dot;
      ctx.strokeText(text, left, base);
      ctx.fillStyle = colours.ink;
      ctx.fillText(text, left, base);
    }
    ctx.restore();
  }
}

interface Peak {
  s: number;
  value: number;
  curve: number;
}

// A field along a line through the plate, for one or several combinations.
import uPlot from "uplot";
import { make, symbolText } from "./dom";
import { type Choice, choiceName, fieldOf } from "./fields";
import type { Locator } from "./locate";
import { look } from "./look";
import { number } from "./scale";
import type { Point, Scene } from "./scene";
import { along, peaks, sample } from "./section";
import { type Theme, theme } from "./theme";
import "uplot/dist/uPlot.min.css";
import "./section-chart.css";

/** Colours for curves that the colour-blind tell apart (Okabe and Ito 2008), dark enough for thin lines. */
const CURVES = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b58900", "#56b4e9", "#7f5fbf", "#8a8a8a"];

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

export class SectionChart {
  /** The cursor is over a place of the section [m]; null: it left. */
  onPlace?: (at: Point | null) => void;
  readonly element = make("div", { class: "gs-chart" });
  private plot: uPlot | null = null;
  private section: Section | null = null;
  private theme: Theme = theme();
  private readonly resized: ResizeObserver;

  constructor(container: HTMLElement) {
    container.append(this.element);
    this.resized = new ResizeObserver(() => {
      const { clientWidth: width, clientHeight: height } = this.element;
      if (this.plot && width && height) this.plot.setSize({ width, height: Math.max(height - this.below(), 80) });
    });
    this.resized.observe(this.element);
  }

  /** Draw a section; null: nothing. */
  show(section: Section | null): void {
    this.section = section;
    this.draw();
  }

  setTheme(to: Theme): void {
    this.theme = to;
    this.draw();
  }

  dispose(): void {
    this.resized.disconnect();
    this.plot?.destroy();
    this.element.remove();
  }

  private below(): number {
    return this.element.querySelector<HTMLElement>(".u-legend")?.offsetHeight ?? 24;
  }

  private draw(): void {
    this.plot?.destroy();
    this.plot = null;
    this.element.replaceChildren();
    const { section } = this;
    if (!section) return;
    const { scene, locator, field, choices, start, end } = section;
    const info = fieldOf(scene, field);
    const samples = sample(locator, start, end);
    const curves = choices.map((choice) => along(scene, locator, choice, field, samples));
    if (!curves.some((curve) => peaks(samples.s, curve))) {
      this.element.append(make("p", { class: "gs-chart-none" }, "The section does not cross the plate."));
      return;
    }
    const colours = look(this.theme);
    const axis = { stroke: colours.ink2, grid: { stroke: colours.line, width: 1 }, ticks: { stroke: colours.line, width: 1 } };
    const options: uPlot.Options = {
      width: Math.max(this.element.clientWidth, 200),
      height: Math.max(this.element.clientHeight - 24, 120),
      scales: { x: { time: false }, y: { dir: downwards(info.name) ? -1 : 1 } },
      axes: [
        { ...axis, label: "s [m]", labelSize: 18, size: 32 },
        { ...axis, label: `${symbolText(info.symbol)} [${info.unit}]`, labelSize: 20, size: 54 },
      ],
      series: [
        { label: "s [m]", value: (_, value) => (value === null ? "–" : number(value)) },
        ...choices.map((choice, i): uPlot.Series => ({
          label: choiceName(scene, choice) || symbolText(info.symbol),
          stroke: CURVES[i % CURVES.length]!,
          width: 1.6,
          points: { show: false },
          value: (_, value) => (value === null ? "–" : `${number(value)} ${info.unit}`),
        })),
      ],
      hooks: { draw: [(plot) => this.marks(plot, curves, samples.s)] },
    };
    this.plot = new uPlot(options, [samples.s, ...curves], this.element);
  }

  private marks(plot: uPlot, curves: (number | null)[][], s: number[]): void {
    const { ctx } = plot;
    const colours = look(this.theme);
    ctx.save();
    const zero = plot.valToPos(0, "y", true);
    if (zero > plot.bbox.top && zero < plot.bbox.top + plot.bbox.height) {
      ctx.strokeStyle = colours.ink2;
      ctx.lineWidth = 1.2 * uPlot.pxRatio;
      ctx.beginPath();
      ctx.moveTo(plot.bbox.left, zero);
      ctx.lineTo(plot.bbox.left + plot.bbox.width, zero);
      ctx.stroke();
    }
    ctx.font = `${12 * uPlot.pxRatio}px sans-serif`;
    curves.forEach((curve, i) => {
      const found = peaks(s, curve);
      if (!found) return;
      for (const [at, value] of [found.max, found.min]) {
        const [x, y] = [plot.valToPos(at, "x", true), plot.valToPos(value, "y", true)];
        ctx.fillStyle = CURVES[i % CURVES.length]!;
        ctx.beginPath();
        ctx.arc(x, y, 3.5 * uPlot.pxRatio, 0, 2 * Math.PI);
        ctx.fill();
        ctx.fillStyle = colours.ink;
        ctx.fillText(number(value), x + 6 * uPlot.pxRatio, y - 5 * uPlot.pxRatio);
      }
    });
    ctx.restore();
  }
}

/** Settlements and moments are drawn downwards, as the plate settles and where its face is in tension. */
export function downwards(field: string): boolean {
  return field === "settlement" || field.startsWith("moment") || /^(m_|bottom|top)/.test(field);
}

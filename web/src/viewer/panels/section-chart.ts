// A field along a line through the plate, for one or several combinations.

import uPlot from "uplot";
import { type Choice, choiceName, fieldOf, isEnvelope } from "../data/fields";
import { lengthsOf } from "../data/lengths";
import { formatNumber, formatShort } from "../data/numbers";
import type { Locator } from "../data/point-location";
import { distanceBetween, pointBetween } from "../data/points";
import type { Point, Scene } from "../data/scene";
import {
  axisLimits,
  findPeaks,
  pointsDownward,
  type Samples,
  sampleField,
  sampleLine,
  sampleStrip,
} from "../data/section-sampling";
import { h } from "../shared/dom";
import { say, translate } from "../shared/language";
import { FONT, type Palette, paletteOf } from "../shared/palette";
import { symbolText } from "../shared/symbols";
import { currentTheme, type Theme } from "../shared/theme";
import "uplot/dist/uPlot.min.css";
import "./section-chart.css";

/** Colors of curves that color-blind readers can tell apart (Okabe and Ito 2008), for light and dark paper. */
const CURVES: Record<Theme, readonly string[]> = {
  light: ["#0072b2", "#d55e00", "#00795b", "#b0568c", "#8a6d00", "#2a8fc4", "#5a4fcf", "#6b6b6b"],
  dark: ["#56b4e9", "#f0883e", "#2bc49a", "#e29cc4", "#e6c229", "#9ad0f5", "#a79bff", "#b5b5b5"],
};
/** From the ninth curve on, colors repeat, dashed. */
const DASH = [7, 4];

/** What is drawn: a field of some combinations between two points. */
export interface Section {
  scene: Scene;
  locator: Locator;
  field: string;
  choices: Choice[];
  start: Point;
  end: Point;
  width?: number | undefined; // over which the field is averaged
}

interface Peak {
  s: number;
  value: number;
  choice: Choice;
}

function samplesOf({ locator, start, end, width }: Section): Samples {
  return width ? sampleStrip(locator, start, end, width) : sampleLine(locator, start, end);
}

export class SectionChart {
  /** The cursor is over a place of the section [m]; null: it left. */
  onPlace?: (at: Point | null) => void;
  readonly element = h("div", { class: "gs-chart" });
  private plot: uPlot | null = null;
  private section: Section | null = null;
  private samples: Samples | null = null;
  private curves: (number | null)[][] = [];
  private theme: Theme = currentTheme();

  constructor(container: HTMLElement) {
    container.append(this.element);
    new ResizeObserver(() => this.resize()).observe(this.element);
  }

  /** Draw a section; null: nothing. */
  show(section: Section | null): void {
    this.section = section;
    this.samples = section && samplesOf(section);
    const sample = ({ scene, locator, field, choices }: Section) =>
      choices.map((choice) => sampleField(scene, locator, choice, field, this.samples!));
    this.curves = section ? sample(section) : [];
    this.draw();
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
    this.draw();
  }

  /** Draw the section into a canvas of its own, on white, `ratio` dots per pixel: for paper. Null if there is none. */
  snapshot(width: number, height: number, ratio: number): HTMLCanvasElement | null {
    if (!this.section || !this.samples || !this.crossesPlate()) return null;
    const times = ratio / uPlot.pxRatio;
    const away = h("div", { class: "gs-chart gs-chart-away" });
    document.body.append(away);
    const plot = this.makePlot(away, width * times, height * times, times, "light");
    plot.batch(() => undefined); // draws at once
    const source = plot.ctx.canvas;
    const canvas = h("canvas", { width: source.width, height: source.height, style: `width:${width}px` });
    canvas.getContext("2d")!.drawImage(source, 0, 0);
    plot.destroy();
    away.remove();
    return canvas;
  }

  /** Return the curves' names with their colors on paper. */
  names(): { name: string; color: string }[] {
    const { section } = this;
    return (section?.choices ?? []).map((choice, i) => ({
      name: choiceName(section!.scene, choice),
      color: CURVES.light[i % CURVES.light.length]!,
    }));
  }

  private crossesPlate(): boolean {
    return this.curves.some((curve) => findPeaks(this.samples!.s, curve) !== null);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight } = this.element;
    if (!this.plot || !width || !clientHeight) return;
    const legend = this.element.querySelector<HTMLElement>(".u-legend")?.offsetHeight ?? 26;
    this.plot.setSize({ width, height: Math.max(clientHeight - legend, 90) });
  }

  private draw(): void {
    this.plot?.destroy();
    this.plot = null;
    this.element.replaceChildren();
    this.onPlace?.(null);
    if (!this.section) return;
    if (!this.crossesPlate()) {
      this.element.append(h("p", { class: "gs-chart-none" }, "The section does not cross the plate."));
      return;
    }
    const { clientWidth, clientHeight } = this.element;
    this.plot = this.makePlot(this.element, Math.max(clientWidth, 200), Math.max(clientHeight - 26, 90), 1, this.theme);
    this.resize();
  }

  /** Make a plot; `times` enlarges type and lines. */
  private makePlot(place: HTMLElement, width: number, height: number, times: number, theme: Theme): uPlot {
    const { scene, field, choices } = this.section!;
    const info = fieldOf(scene, field);
    const { unit, per_meter: per } = lengthsOf(scene.head.plan);
    const palette = paletteOf(theme);
    const options: uPlot.Options = {
      width,
      height,
      scales: {
        x: { time: false, range: () => [0, Math.max(this.length() * per, 1e-9)] },
        y: { dir: pointsDownward(field) ? -1 : 1, range: (_, low, high) => axisLimits(low, high) },
      },
      axes: makeAxes(unit, `${symbolText(info.symbol)} [${info.unit}]`, times, palette),
      legend: { show: times === 1 },
      cursor: { drag: { x: false, y: false }, points: { size: 7 } },
      padding: [10 * times, 14 * times, 0, 0],
      series: [
        {
          label: "s",
          value: (_, value: number | null) => (value === null ? "–" : translate(`${value.toFixed(2)} ${unit}`)),
        },
        ...choices.map(
          (choice, i): uPlot.Series => ({
            ...makeStroke(i, times, CURVES[theme]),
            ...(choices.length === 1 ? { fill: `${CURVES[theme][0]}1c` } : {}),
            label: choiceName(scene, choice) || symbolText(info.symbol),
            value: (_, value: number | null) => (value === null ? "–" : `${formatNumber(value)} ${info.unit}`),
          }),
        ),
      ],
      hooks: {
        draw: [(plot) => this.drawPeaks(plot, times, palette)],
        setCursor: times === 1 ? [(plot) => this.pointAt(plot)] : [],
      },
    };
    return new uPlot(options, [this.samples!.s.map((s) => s * per), ...this.curves], place);
  }

  private length(): number {
    const { start, end } = this.section!;
    return distanceBetween(start, end);
  }

  private pointAt(plot: uPlot): void {
    const { idx, left } = plot.cursor;
    const s = typeof idx === "number" && (left ?? -1) >= 0 ? this.samples?.s[idx] : undefined;
    if (s === undefined) return this.onPlace?.(null);
    const { start, end } = this.section!;
    const part = s / (this.length() || 1);
    this.onPlace?.(pointBetween(start, end, part));
  }

  /** Draw the zero line, and minimum and maximum of all curves with the number of their combination. */
  private drawPeaks(plot: uPlot, times: number, palette: Palette): void {
    const { ctx, bbox } = plot;
    ctx.save();
    const zero = Math.round(plot.valToPos(0, "y", true));
    if (zero >= bbox.top && zero <= bbox.top + bbox.height) {
      ctx.strokeStyle = palette.ink;
      ctx.lineWidth = uPlot.pxRatio * times;
      ctx.beginPath();
      ctx.moveTo(bbox.left, zero);
      ctx.lineTo(bbox.left + bbox.width, zero);
      ctx.stroke();
    }
    const found = this.curves.flatMap((curve, i) => {
      const ends = findPeaks(this.samples!.s, curve);
      const choice = this.section!.choices[i]!;
      return ends ? [ends.min, ends.max].map(([s, value]): Peak => ({ s, value, choice })) : [];
    });
    const findPeak = (sign: 1 | -1) => found.reduce((a, b) => (sign * b.value > sign * a.value ? b : a));
    if (found.length > 0) {
      this.drawPeak(plot, "max", findPeak(1), times, palette);
      this.drawPeak(plot, "min", findPeak(-1), times, palette);
    }
    ctx.restore();
  }

  private drawPeak({ ctx, bbox, valToPos }: uPlot, word: string, peak: Peak, times: number, palette: Palette): void {
    const { scene, choices } = this.section!;
    const dot = uPlot.pxRatio * times;
    const [x, y] = [
      valToPos(peak.s * lengthsOf(scene.head.plan).per_meter, "x", true),
      valToPos(peak.value, "y", true),
    ];
    const number = isEnvelope(peak.choice) ? undefined : scene.head.combinations[peak.choice]?.number;
    const from = choices.length > 1 && number !== undefined ? ` (${number})` : "";
    const text = `${translate(word)} ${translate(formatNumber(peak.value))}${from}`;
    ctx.font = `600 ${12 * dot}px ${FONT}`;
    ctx.lineJoin = "round";
    ctx.textAlign = "left";
    ctx.textBaseline = "alphabetic";
    ctx.fillStyle = palette.ink;
    ctx.strokeStyle = palette.halo;
    ctx.lineWidth = 3 * dot;
    ctx.beginPath();
    ctx.arc(x, y, 3.5 * dot, 0, 2 * Math.PI);
    ctx.fill();
    const length = ctx.measureText(text).width;
    const left = x + 8 * dot + length > bbox.left + bbox.width ? x - 8 * dot - length : x + 8 * dot;
    const base = Math.min(Math.max(y - 6 * dot, bbox.top + 12 * dot), bbox.top + bbox.height - 4 * dot);
    ctx.strokeText(text, left, base);
    ctx.fillText(text, left, base);
  }
}

function makeAxes(unit: string, label: string, times: number, palette: Palette): uPlot.Axis[] {
  const font = `${12 * times}px ${FONT}`;
  const makeAxis = (label: string, labelSize: number, size: number, space: number): uPlot.Axis => ({
    stroke: palette.ink,
    font,
    labelFont: font,
    gap: 4 * times,
    grid: { stroke: palette.line, width: 0.7 * times },
    ticks: { stroke: palette.line, width: times, size: 5 * times },
    label,
    labelSize: labelSize * times,
    size: size * times,
    space: space * times,
    values: (_, ticks) => ticks.map((tick) => translate(formatShort(tick, 6))),
  });
  return [makeAxis(say("distance s along the section [{unit}]", { unit }), 18, 26, 60), makeAxis(label, 20, 50, 26)];
}

function makeStroke(i: number, times: number, colors: readonly string[]): uPlot.Series {
  return {
    stroke: colors[i % colors.length]!,
    width: 1.7 * times,
    ...(i >= colors.length ? { dash: DASH.map((part) => part * times) } : {}),
    points: { show: false },
  };
}

// Labels on a plan: which come first, the places that they could have, and the texts of those that have space.
import { type LabelWish, placeLabels, type TakenBoxes } from "../data/label-placement";
import type { Point } from "../data/scene";
import { svg } from "../shared/dom";
import { FONT } from "../shared/palette";
import type { Camera } from "./camera";
import { RULER } from "./rulers";
import type { Kind } from "./symbols";

export type LabelKind = Kind | "extreme" | "number";

/** A text that wants a place on a plan. */
export interface Label {
  kind: LabelKind;
  text: string;
  at: Point; // where its line begins, or its middle or end, or the middle of its box [px]
  align: "" | "middle" | "end" | "over";
}

/** Kinds whose labels get a place first; those that are not named come before numbers. */
const ORDER: readonly LabelKind[] = [
  "axis",
  "extreme",
  "reaction",
  "bars",
  "zone",
  "borehole",
  "strip",
  "section line",
  "output point",
  "load",
  "support",
];
const HEIGHT = 15; // px: of a label with its halo
const [ABOVE, BESIDE] = [11, 2]; // px: from its upper left corner to where the letters begin
const CORNER: Point = [112, RULER.bottom + 30]; // px: that the scale bar takes
const widths = new Map<string, number>();
let context: CanvasRenderingContext2D | null | undefined;

/** Draw the labels that have space, a group for each kind; they cover neither each other nor rulers and scale bar. */
export function drawLabels(labels: readonly Label[], { width, height }: Camera, taken: TakenBoxes): SVGElement[] {
  taken.add([width - CORNER[0], height - CORNER[1], width, height]);
  const seen = labels.filter(({ at: [x, y], text }) => text !== "" && x > 0 && y > 0 && x < width + 20 && y < height);
  const order = seen.sort((a, b) => rankOf(a) - rankOf(b));
  const limits = [RULER.left + 2, 2, width - 2, height - RULER.bottom - 2] as const;
  const places = placeLabels(order.map(wishOf), [...limits], taken);
  const groups = new Map<string, SVGElement>();
  for (const [n, { kind, text }] of order.entries()) {
    const place = places[n];
    if (!place) continue;
    const group = groups.get(kind) ?? svg("g", { class: `symbol ${kind.replaceAll(" ", "-")}` });
    groups.set(kind, group);
    const [x, y] = [(place[0] + BESIDE).toFixed(1), (place[1] + ABOVE).toFixed(1)];
    const element = svg("text", { class: "label", x, y });
    element.textContent = text;
    group.append(element);
  }
  return [...groups.values()];
}

function rankOf({ kind }: Label): number {
  const position = ORDER.indexOf(kind);
  if (position >= 0) return position;
  return ORDER.length + (kind === "number" ? 1 : 0);
}

function wishOf({ kind, text, at: [x, y], align }: Label): LabelWish {
  const length = textWidth(text);
  const left = align === "" ? x : align === "end" ? x - length : x - length / 2;
  const size: Point = [length + 2 * BESIDE, HEIGHT];
  const corner = (dx: number, dy: number): Point => [left - BESIDE + dx, y - ABOVE + dy];
  if (align === "over") return { size, places: [corner(0, 4)] };
  if (kind === "axis") return { size, places: [corner(0, 0)] }; // in its bubble, or nowhere
  if (kind === "bars") return { size, places: [0, 14, 28, 42, -14, -28].map((dy) => corner(0, dy)) };
  const other = align === "middle" ? 0 : -length - 16;
  const places = [corner(0, 0), corner(other, 0), corner(0, -14), corner(0, 14), corner(other, -14), corner(other, 14)];
  return { size, places, kept: kind === "extreme" };
}

/** Return the width of a text in the font of labels [px]. */
export function textWidth(text: string): number {
  const known = widths.get(text);
  if (known !== undefined) return known;
  context ??= document.createElement("canvas").getContext("2d");
  if (context) context.font = `600 11px ${FONT}`;
  const width = context?.measureText(text).width ?? 6.5 * text.length;
  if (widths.size > 5000) widths.clear();
  widths.set(text, width);
  return width;
}

// The layers of the ground, to scale in depth: what the lists beside it say, at one glance.

import { fill, setRead, svg } from "../../viewer/shared/dom";
import { say, together } from "../../viewer/shared/language";
import { isTable, listAt, type Path, type Table, tableAt, valueAt } from "../model/paths";
import { parseLength } from "../model/quantities";
import type { Part } from "../model/schema";
import type { FormContext, Widget } from "./context";
import { shortValue } from "./labels";

/** Size of the picture, width of the column in it, least height of a layer with a label, height of what goes on. */
const [WIDTH, HEIGHT, COLUMN, LEAST, BELOW] = [260, 132, 56, 14, 24];

interface Layer {
  label: string;
  height: number;
  endless: boolean;
}

/** Whether a part is ground of layers that a picture can show. */
export function hasLayers(part: Part | null): boolean {
  return ["Vlasov", "Layered", "Continuum", "ConstrainedModulus"].includes(part?.name ?? "");
}

/** The picture of the layers of the ground at a path. */
export function layersPicture(ctx: FormContext, path: Path): Widget {
  const element = svg("svg", { class: "layers", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img" });
  const update = () => {
    const layers = layersToDraw(tableAt(ctx.data(), path));
    element.toggleAttribute("hidden", layers.length === 0);
    setRead(
      element,
      "aria-label",
      say("layers, from the top: {layers}", {
        layers: together(
          layers.map(({ label }) => label),
          "; ",
        ),
      }),
    );
    fill(element, ...layers.flatMap(drawLayer));
    if (layers.length > 0 && !layers.at(-1)?.endless) element.append(drawBase());
  };
  return { element: element as unknown as HTMLElement, update, reveal: () => false };
}

/** Return the layers with their heights in the picture; none if a thickness is not known. */
export function layersToDraw(ground: Table): Layer[] {
  const layers = listAt(ground, ["layers"]).filter(isTable);
  const thickness = layers.map((layer) => parseLength(layer.thickness));
  const depth = thickness.reduce<number>((sum, each) => sum + (each ?? Number.NaN), 0);
  if (Number.isNaN(depth)) return [];
  const below = tableAt(ground, ["half_space"]);
  const endless = valueAt(ground, ["half_space"]) !== undefined;
  const space = HEIGHT - BELOW;
  const found = layers.map((layer, index) => ({
    label: [moduliOf(layer), shortValue(layer.thickness)].join(", "),
    height: (space * (thickness[index] ?? 0)) / depth,
    endless: false,
  }));
  const last = {
    label: say("{moduli}, half-space", { moduli: moduliOf(below) }),
    height: layers.length > 0 ? BELOW : HEIGHT,
    endless: true,
  };
  return endless ? [...found, last] : found;
}

function moduliOf(layer: Table): string {
  const [from, to] = [shortValue(layer.E), layer.E_bottom];
  return `E = ${to === undefined ? from : say("{from} to {to}", { from, to: shortValue(to) })}`;
}

function drawLayer(layer: Layer, index: number, all: readonly Layer[]): SVGElement[] {
  const y = all.slice(0, index).reduce((sum, each) => sum + each.height, 0);
  const { height, endless } = layer;
  const rectangle = svg("rect", { x: 1, y, width: COLUMN, height, class: endless ? "endless" : `layer-${index % 2}` });
  if (height < LEAST) return [rectangle];
  return [rectangle, svg("text", { x: COLUMN + 10, y: y + height / 2 + 4 }, layer.label)];
}

function drawBase(): SVGElement {
  return svg("line", { x1: 0, y1: HEIGHT - BELOW, x2: COLUMN + 2, y2: HEIGHT - BELOW, class: "base" });
}

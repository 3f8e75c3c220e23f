// A small picture of a drawing, a path for each layer.

import { svg } from "../../viewer/shared/dom";
import { boundsOfLayers, type Layer, pointsOf, type Survey } from "../model/survey";

const SIZE = 1000; // of the picture, in its own units
const MARGIN = 30;
const MOST_DOTS = 500; // points of a layer that are drawn

/** Return the picture, and what marks a layer in it; `mark` with null marks none. */
export function drawPreview(survey: Survey): { element: SVGSVGElement; mark: (layer: Layer | null) => void } {
  const [x0, y0, x1, y1] = boundsOfLayers(survey.layers) ?? [0, 0, 1, 1];
  const scale = (SIZE - 2 * MARGIN) / Math.max(x1 - x0, y1 - y0, 1e-9);
  const place = (point: readonly [number, number]) => {
    const [u, v] = [(point[0] - (x0 + x1) / 2) * scale, (point[1] - (y0 + y1) / 2) * scale];
    return `${(SIZE / 2 + u).toFixed(1)} ${(SIZE / 2 - v).toFixed(1)}`;
  };
  const groups = new Map(survey.layers.map((layer) => [layer, drawLayer(layer, place)]));
  const attributes = {
    class: "drawing-preview",
    viewBox: `0 0 ${SIZE} ${SIZE}`,
    role: "img",
    "aria-label": "the drawing",
  };
  const element = svg("svg", attributes, ...groups.values());
  const mark = (marked: Layer | null) => {
    for (const [layer, group] of groups) group.classList.toggle("marked", layer === marked);
  };
  return { element, mark };
}

function drawLayer(layer: Layer, place: (point: readonly [number, number]) => string): SVGGElement {
  const d = [...layer.lines, ...layer.curves].map((line) => `M${pointsOf(line).map(place).join("L")}`).join("");
  // a line without length with round ends is a dot
  const dots = pointsOf(layer.points).slice(0, MOST_DOTS);
  const dotted = dots.map((point) => `M${place(point)}h0`).join("");
  return svg("g", { "data-layer": layer.name }, svg("path", { d }), svg("path", { d: dotted, class: "dots" }));
}

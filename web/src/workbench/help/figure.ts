// Parts of small drawings: lines, arrows, dimensions, each for the keys that it explains.
import { svg } from "../../viewer/shared/dom";
import { symbolText } from "../../viewer/shared/symbols";

export const [WIDTH, HEIGHT] = [184, 104];

/** A part of a drawing; one that explains keys is highlighted while one of them has the focus. */
export interface Mark {
  keys: readonly string[];
  elements: readonly SVGElement[];
}

/** Return a part that explains no key. */
export function still(...elements: SVGElement[]): Mark {
  return { keys: [], elements };
}

/** Return a part that explains some keys, separated by spaces. */
export function mark(keys: string, ...elements: SVGElement[]): Mark {
  return { keys: keys.split(" "), elements };
}

export function box(kind: string, x: number, y: number, width: number, height: number): SVGElement {
  return svg("rect", { class: kind, x, y, width, height });
}

export function path(d: string, kind = "line"): SVGElement {
  return svg("path", { class: kind, d });
}

/** Return a letter such as `L_x`, its subscript written small. */
export function letter(x: number, y: number, text: string, anchor = "middle"): SVGElement {
  const [stem = text, subscript] = text.split("_");
  const tail = subscript ? svg("tspan", { dy: 3, class: "subscript" }, subscript) : null;
  return svg("text", { x, y, "text-anchor": anchor }, symbolText(stem), tail);
}

/** Return an arrow from a place to another one. */
export function arrow(x0: number, y0: number, x1: number, y1: number): SVGElement {
  return path(`M${x0} ${y0}L${x1} ${y1}${tip(x0, y0, x1, y1)}`);
}

/** Return an arrow with two tips and its letter: above one that lies, to the left of one that stands. */
export function dimension(x0: number, y0: number, x1: number, y1: number, text: string): SVGElement[] {
  const line = path(`M${x0} ${y0}L${x1} ${y1}${tip(x0, y0, x1, y1)}${tip(x1, y1, x0, y0)}`);
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  return [line, y0 === y1 ? letter(x, y - 4, text) : letter(x - 5, y + 4, text, "end")];
}

/** Return several arrows downwards between two places, and the line above them. */
export function pressure(x0: number, x1: number, top: number, bottom: number, topEnd = top): SVGElement[] {
  const count = Math.max(2, Math.round((x1 - x0) / 14));
  const places = Array.from({ length: count + 1 }, (_, n) => n / count);
  const arrows = places.map((share) => {
    const [x, y] = [x0 + share * (x1 - x0), top + share * (topEnd - top)];
    return arrow(x, y, x, bottom - 1);
  });
  return [path(`M${x0} ${top}L${x1} ${topEnd}`), ...arrows];
}

/** Return a spring that stands between two heights. */
export function spring(x: number, top: number, bottom: number): SVGElement {
  const [lead, turns] = [(bottom - top) / 5, 6];
  const step = (bottom - top - 2 * lead) / turns;
  const zigzag = Array.from({ length: turns }, (_, n) => `L${x + (n % 2 ? -4 : 4)} ${top + lead + (n + 0.5) * step}`);
  return path(`M${x} ${top}V${top + lead}${zigzag.join("")}L${x} ${bottom - lead}V${bottom}`);
}

/** Return a base that does not give way. */
export function base(x0: number, x1: number, y: number): SVGElement {
  const hatches = Array.from({ length: Math.floor((x1 - x0) / 6) }, (_, n) => `M${x0 + 6 * n + 5} ${y}l-5 5`);
  return path(`M${x0} ${y}H${x1}${hatches.join("")}`, "line thin");
}

/** Return the axes of the plan with their origin at a place. */
export function axes(x: number, y: number): Mark {
  const lines = [arrow(x - 4, y, x + 26, y), arrow(x, y + 4, x, y - 26)];
  return still(...lines, letter(x + 32, y + 4, "x"), letter(x - 7, y - 22, "y"));
}

function tip(x0: number, y0: number, x1: number, y1: number): string {
  const angle = Math.atan2(y1 - y0, x1 - x0);
  const [size, spread] = [4.5, 0.42];
  const at = (turn: number) => {
    const x = x1 - size * Math.cos(angle + turn);
    return `${x.toFixed(1)} ${(y1 - size * Math.sin(angle + turn)).toFixed(1)}`;
  };
  return `M${at(-spread)}L${x1} ${y1}L${at(spread)}`;
}

// What a plan leaves out where it is crowded: arrows of point loads, which become dots, and texts over texts.
import type { Box } from "../data/boxes";
import { TakenBoxes } from "../data/label-placement";
import type { Camera } from "./camera";
import { textWidth } from "./labels";
import type { PlanSymbol } from "./symbols";

const CROWD = 26; // px: point loads so near to another one have no arrow
const [ABOVE, BELOW] = [9, 3]; // px: of a text over and under its line

/** Return the symbols, point loads that crowd others as dots, but for those that are to stay. */
export function thinLoads(
  symbols: readonly PlanSymbol[],
  camera: Camera,
  stays: (index: number) => boolean = () => false,
): PlanSymbol[] {
  const taken = new Set<string>();
  return symbols.map((symbol, index) => {
    if (symbol.kind !== "load" || symbol.shape !== "point" || symbol.hidden) return symbol;
    const [x, y] = camera.toPixel(symbol.points[0]!);
    const [i, j] = [Math.round(x / CROWD), Math.round(y / CROWD)];
    const near = [-1, 0, 1].flatMap((di) => [-1, 0, 1].map((dj) => `${i + di} ${j + dj}`));
    const isCrowded = !stays(index) && near.some((key) => taken.has(key));
    if (!isCrowded) taken.add(`${i} ${j}`);
    return isCrowded ? { ...symbol, crowded: true } : symbol;
  });
}

/** Hide the texts of drawn elements that would cover another one; earlier elements come first. */
export function thinTexts(elements: readonly Element[]): void {
  const taken = new TakenBoxes();
  for (const text of elements.flatMap((element) => [...element.querySelectorAll<SVGTextElement>(":scope > text")])) {
    const box = boxOf(text);
    const isFree = taken.isFree(box);
    if (isFree) taken.add(box);
    text.classList.toggle("crowded", !isFree);
  }
}

function boxOf(text: SVGTextElement): Box {
  const [x, y] = [Number(text.getAttribute("x")), Number(text.getAttribute("y"))];
  const width = textWidth(text.textContent ?? "");
  const { classList } = text;
  const left = classList.contains("middle") ? x - width / 2 : classList.contains("end") ? x - width : x;
  return [left, y - ABOVE, left + width, y + BELOW];
}

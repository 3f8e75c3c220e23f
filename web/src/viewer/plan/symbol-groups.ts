// Symbols drawn together: what looks alike is one path, so that hundreds of them are moved and painted as one.
import { svg } from "../shared/dom";
import type { Camera } from "./camera";
import type { Label, LabelKind } from "./labels";
import { drawSymbol, type PlanSymbol } from "./symbols";

/** Kinds whose paths look different by their order. */
const SINGLE: ReadonlySet<string> = new Set(["section line"]);

/** Draw elements with a halo below them, so that they are seen on every color. */
export function drawGroup(kind: string, elements: readonly SVGElement[]): SVGGElement {
  const halo = svg("g", { class: "halo" }, ...elements.map((element) => element.cloneNode() as SVGElement));
  return svg("g", { class: `symbol ${kind.replaceAll(" ", "-")}`, "data-kind": kind }, halo, ...elements);
}

/** Draw symbols, one group for each kind, the paths of a class joined; their texts are labels that want a place. */
export function drawJoined(camera: Camera, symbols: readonly PlanSymbol[]): { groups: SVGGElement[]; labels: Label[] } {
  const labels: Label[] = [];
  const kinds = new Map<string, SVGElement[]>();
  const paths = new Map<string, { element: SVGElement; parts: string[] }>();
  for (const symbol of symbols) {
    const { kind } = symbol;
    const elements = kinds.get(kind) ?? [];
    kinds.set(kind, elements);
    for (const element of drawSymbol(camera, symbol)) {
      if (element.tagName === "text") {
        labels.push(labelFrom(kind, element));
        continue;
      }
      const key = `${kind} ${element.getAttribute("class") ?? ""}`;
      const before = paths.get(key);
      const part = element.getAttribute("d");
      if (part !== null && before && !SINGLE.has(kind)) before.parts.push(part);
      else {
        elements.push(element);
        if (part !== null) paths.set(key, { element, parts: [part] });
      }
    }
  }
  for (const { element, parts } of paths.values()) element.setAttribute("d", parts.join(""));
  return { groups: [...kinds].map(([kind, elements]) => drawGroup(kind, elements)), labels };
}

/** Return the label that a text is. */
function labelFrom(kind: LabelKind, text: SVGElement): Label {
  const align = (["middle", "end"] as const).find((each) => text.classList.contains(each)) ?? "";
  return {
    kind,
    text: text.textContent ?? "",
    at: [Number(text.getAttribute("x")), Number(text.getAttribute("y"))],
    align,
  };
}

// Icons of buttons, drawn with lines of 16 x 16; the button's label gives their meaning.
import { h, svg } from "../../viewer/shared/dom";

const PATHS = {
  copy: "M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3",
  remove: "M4 4l8 8M12 4l-8 8",
  add: "M8 3v10M3 8h10",
  undo: "M6 3L2.5 6.5 6 10M3 6.5h6.5a3.5 3.5 0 0 1 0 7H6",
  redo: "M10 3l3.5 3.5L10 10M13 6.5H6.5a3.5 3.5 0 0 0 0 7H10",
  theme:
    "M8 1.5v1.5M8 13v1.5M1.5 8H3M13 8h1.5M3.4 3.4l1 1M11.6 11.6l1 1M12.6 3.4l-1 1M4.4 11.6l-1 1M8 5a3 3 0 1 0 .01 0",
} as const;

export function icon(name: keyof typeof PATHS): SVGSVGElement {
  return lineIcon(PATHS[name]);
}

/** An icon of a path. */
export function lineIcon(d: string): SVGSVGElement {
  const attributes = { viewBox: "0 0 16 16", width: 16, height: 16, class: "icon-line", "aria-hidden": "true" };
  return svg("svg", attributes, svg("path", { d }));
}

/** A button with an icon; inside a summary it does not open or close it. */
export function iconButton(name: keyof typeof PATHS, title: string, label: string, action: () => void): HTMLElement {
  const onclick = (event: MouseEvent) => {
    event.preventDefault();
    event.stopPropagation();
    action();
  };
  return h("button", { type: "button", class: "icon", title, "aria-label": label, onclick }, icon(name));
}

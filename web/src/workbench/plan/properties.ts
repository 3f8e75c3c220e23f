// The selected thing's properties below the drawing; the slab's where nothing is selected.

import type { Change } from "../client/api";
import type { FormContext, Widget } from "../form/context";
import { shapeEdits } from "../form/plate-shape";
import { partWidget } from "../form/section";
import { titleAt } from "../model/items";
import { type Path, pathKey, valueAt } from "../model/paths";
import { removal } from "../model/references";
import { fill, h } from "../shell/elements";
import { duplicateOf } from "./tools";

export interface Properties {
  readonly element: HTMLElement;
  /** Show the thing at a path; null: the slab. */
  show(path: Path | null): void;
  update(): void;
  reveal(path: Path): boolean;
}

export interface PropertyActions {
  push(change: Change): void;
  select(path: Path | null): void;
  /** By how much a copy lies beside the original [m]. */
  step(): number;
}

const INSIDE_PLATE = ["openings", "zones", "edges"]; // of the slab: drawn as things of their own, or in the form

/** The panel of properties. */
export function properties(ctx: FormContext, actions: PropertyActions): Properties {
  const title = h("h3", {});
  const buttons = h("div", { class: "property-acts" });
  const body = h("div", { class: "property-body" });
  const element = h(
    "section",
    { class: "properties", "aria-label": "properties" },
    h("div", { class: "property-head" }, title, buttons),
    body,
  );
  let shown = "";
  let widget: Widget | null = null;

  const act = (words: string, run: () => void, hint: string) =>
    h("button", { type: "button", class: "small", title: hint, onclick: run }, words);
  const show = (path: Path | null) => {
    const isSlab = path === null || (path[0] === "plate" && path.length < 3);
    const at: Path = isSlab ? ["plate"] : path;
    const found = ctx.schema.nodeAt(at, ctx.data());
    const key = pathKey(at);
    const there = found !== null && (isSlab || valueAt(ctx.data(), at) !== undefined);
    if (!there) {
      shown = "";
      widget = null;
      fill(title);
      fill(buttons);
      fill(body, h("p", { class: "empty" }, "Nothing is selected."));
      return;
    }
    if (key === shown) return update();
    shown = key;
    widget = partWidget(ctx, at, found.node, isSlab ? INSIDE_PLATE : []);
    fill(body, widget.element);
    fill(buttons, ...(isSlab ? slabActs() : thingActs(at)));
    update();
    element.scrollTop = 0;
  };
  const slabActs = () => [
    act(
      "Change into polygon",
      () => actions.push({ edits: shapeEdits(ctx, "Polygon"), text: "change the slab into a polygon" }),
      "Draw the outline by its corners, so that they can be moved one by one",
    ),
  ];
  const thingActs = (path: Path) => [
    act(
      "Duplicate",
      () => {
        const step = actions.step();
        const made = duplicateOf(ctx.data(), path, titleAt(ctx.data(), path), hasPlace(path) ? [step, step] : [0, 0]);
        if (!made) return;
        actions.push(made.change);
        actions.select(made.path);
      },
      "Make a copy beside it (Ctrl+D)",
    ),
    act(
      "Remove",
      () => {
        actions.push(removal(ctx.data(), path));
        actions.select(null);
      },
      "Remove it (Delete)",
    ),
  ];
  const hasPlace = (path: Path) => typeof valueAt(ctx.data(), [...path, "column"]) !== "string";
  const update = () => {
    if (!widget) return;
    const at = JSON.parse(shown) as Path;
    const isSlab = at.length === 1;
    title.textContent = isSlab ? "Slab" : titleAt(ctx.data(), at);
    const sides = valueAt(ctx.data(), ["plate", "outline"]) === undefined;
    if (isSlab)
      for (const button of buttons.children)
        if (button instanceof HTMLElement)
          button.hidden = !sides && valueAt(ctx.data(), ["plate", "outline", "kind"]) === "polygon";
    widget.update();
  };
  return { element, show, update, reveal: (path) => widget?.reveal(path) ?? false };
}

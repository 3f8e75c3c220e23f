// The selected items' properties and actions below the drawing; the slab's where nothing is selected.

import { button, fill, h, setText } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import type { FormContext, Widget } from "../form/context";
import { shapeEdits } from "../form/plate-shape";
import { partWidget } from "../form/section";
import type { Change } from "../model/edits";
import { titleOfAll } from "../model/items";
import { type Path, pathKey, valueAt } from "../model/paths";
import { commonProperties } from "./common-properties";

export interface PropertyPanel extends Widget {
  /** Show the items at some paths; none: the slab. */
  show(paths: readonly Path[]): void;
}

const INSIDE_PLATE = ["openings", "zones", "edges"]; // of the slab: items of their own, or in the form

/** `dialog` takes the place of the fields while it is shown; `acts` are the buttons of the actions on what is selected. */
export function propertyPanel(
  ctx: FormContext,
  push: (change: Change) => void,
  dialog: HTMLElement,
  acts: readonly HTMLElement[],
): PropertyPanel {
  const title = h("h3");
  const buttons = h("div", { class: "property-acts", role: "toolbar", "aria-label": "actions on the selection" });
  const body = h("div", { class: "property-body" });
  const head = h("div", { class: "property-head" }, title, buttons);
  const element = h("section", { class: "properties", "aria-label": "properties" }, head, dialog, body);
  let shown: readonly Path[] = [];
  let widget: Widget | null = null;
  let hasActs = false; // of what is selected; none of the slab that is shown where nothing is
  const toPolygon = button(
    "Convert to polygon",
    "Define the outline by its corners, so that each can be moved",
    () => push({ edits: shapeEdits(ctx, "Polygon"), text: "convert the slab to a polygon" }),
    "small",
  );
  const makeWidget = (paths: readonly Path[], isSlab: boolean): Widget | null => {
    if (paths.length > 1) return commonProperties(ctx, paths);
    const found = ctx.schema.nodeAt(paths[0]!, ctx.data());
    return found && partWidget(ctx, paths[0]!, found.node, isSlab ? INSIDE_PLATE : []);
  };
  const show = (selected: readonly Path[]) => {
    const [first] = selected;
    const isSlab = selected.length < 2 && (!first || (first[0] === "plate" && first.length < 3));
    const paths: readonly Path[] = isSlab ? [["plate"]] : selected;
    const exists = isSlab || paths.every((path) => valueAt(ctx.data(), path) !== undefined);
    const isSame = paths.map(pathKey).join() === shown.map(pathKey).join() && hasActs === Boolean(first);
    if (exists && isSame) return update();
    widget = exists ? makeWidget(paths, isSlab) : null;
    shown = widget ? paths : [];
    fill(title);
    fill(body, widget?.element ?? h("p", { class: "empty" }, "Nothing is selected."));
    hasActs = Boolean(first && widget);
    fill(buttons, ...(isSlab ? [toPolygon] : []), ...(hasActs ? acts : []));
    update();
    element.scrollTop = 0;
  };
  const update = () => {
    const [first] = shown;
    if (!widget || !first) return;
    const isPlate = shown.length === 1 && first.length === 1;
    const words = isPlate ? "Slab" : titleOfAll(ctx.data(), shown);
    setText(title, shown.length > 1 ? say("{items} selected", { items: words }) : words);
    toPolygon.hidden = valueAt(ctx.data(), ["plate", "outline", "kind"]) === "polygon";
    widget.update();
  };
  return { element, show, update, reveal: (path) => widget?.reveal(path) ?? false };
}

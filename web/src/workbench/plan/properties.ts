// The selected item's properties below the drawing; the slab's where nothing is selected.
import { button, fill, h } from "../../viewer/shared/dom";
import type { FormContext, Widget } from "../form/context";
import { shapeEdits } from "../form/plate-shape";
import { partWidget } from "../form/section";
import type { Change } from "../model/changes/edits";
import { duplicateItem } from "../model/changes/new-items";
import { removeItem } from "../model/changes/references";
import { titleAt } from "../model/items";
import { type Path, pathKey, valueAt } from "../model/paths";

export interface PropertyPanel extends Widget {
  /** Show the item at a path; null: the slab. */
  show(path: Path | null): void;
}

const INSIDE_PLATE = ["openings", "zones", "edges"]; // of the slab: items of their own, or in the form

/** `step`: by how much a copy lies beside the original [m]. */
export function propertyPanel(
  ctx: FormContext,
  push: (change: Change) => void,
  select: (path: Path | null) => void,
  step: () => number,
): PropertyPanel {
  const title = h("h3");
  const buttons = h("div", { class: "property-acts" });
  const body = h("div", { class: "property-body" });
  const head = h("div", { class: "property-head" }, title, buttons);
  const element = h("section", { class: "properties", "aria-label": "properties" }, head, body);
  let shown: Path | null = null;
  let widget: Widget | null = null;
  const toPolygon = button(
    "Convert to polygon",
    "Draw the outline by its corners, so that they can be moved one by one",
    () => push({ edits: shapeEdits(ctx, "Polygon"), text: "convert the slab to a polygon" }),
    "small",
  );
  const duplicate = (path: Path) => {
    const isPlaced = typeof valueAt(ctx.data(), [...path, "column"]) !== "string";
    const addition = duplicateItem(ctx.data(), path, isPlaced ? [step(), step()] : [0, 0]);
    if (!addition) return;
    push(addition.change);
    select(addition.path);
  };
  const remove = (path: Path) => {
    push(removeItem(ctx.data(), path));
    select(null);
  };
  const show = (path: Path | null) => {
    const isSlab = path === null || (path[0] === "plate" && path.length < 3);
    const at: Path = isSlab ? ["plate"] : path;
    const found = isSlab || valueAt(ctx.data(), at) !== undefined ? ctx.schema.nodeAt(at, ctx.data()) : null;
    if (found && shown && pathKey(at) === pathKey(shown)) return update();
    shown = found && at;
    widget = found && partWidget(ctx, at, found.node, isSlab ? INSIDE_PLATE : []);
    fill(title);
    fill(body, widget?.element ?? h("p", { class: "empty" }, "Nothing is selected."));
    const itemButtons = [
      button("Duplicate", "Make a copy beside it (Ctrl+D)", () => duplicate(at), "small"),
      button("Remove", "Remove it (Delete)", () => remove(at), "small"),
    ];
    fill(buttons, ...(found ? (isSlab ? [toPolygon] : itemButtons) : []));
    update();
    element.scrollTop = 0;
  };
  const update = () => {
    if (!widget || !shown) return;
    title.textContent = shown.length === 1 ? "Slab" : titleAt(ctx.data(), shown);
    toPolygon.hidden = valueAt(ctx.data(), ["plate", "outline", "kind"]) === "polygon";
    widget.update();
  };
  return { element, show, update, reveal: (path) => widget?.reveal(path) ?? false };
}

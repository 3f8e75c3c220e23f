// The slab's outline: a rectangle about the origin, or a shape that is drawn where it lies.

import { h, newId } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import { outlineEdits } from "../model/changes/new-items";
import { defaultPlacement } from "../model/changes/variants";
import type { Edit } from "../model/edits";
import { readSides } from "../model/geometry";
import { type Path, pathKey, startsWith, tableAt } from "../model/paths";
import { formatLength } from "../model/quantities";
import type { FormContext, Widget } from "./context";
import { valueField } from "./inputs/value-field";

/** Keys of the plate that this element shows in place of the plain list of fields. */
export const SHAPE_KEYS = ["length_x", "length_y", "outline"] as const;
const SIDES = "sides";
export const SHAPES = ["Rectangle", "Polygon", "Circle"] as const;

export const OUTLINE: Path = ["plate", "outline"];

/** The choice of the outline, and the sides of a rectangle about the origin. */
export function plateShape(ctx: FormContext): Widget {
  const options = [
    h("option", { value: SIDES }, "rectangle centered on the origin"),
    ...SHAPES.map((name) =>
      h("option", { value: name }, name === "Rectangle" ? "rectangle at any position" : name.toLowerCase()),
    ),
  ];
  const select = h("select", { id: newId("input") }, ...options);
  const plate = ctx.schema.part("Plate");
  const sides = plate.fields
    .filter((field) => field.name === "length_x" || field.name === "length_y")
    .map((field) => valueField(ctx, ["plate", field.name], field));
  const row = h(
    "div",
    { class: "field", "data-path": pathKey(OUTLINE) },
    h("label", { class: "label needed", for: select.id }, "outline"),
    select,
  );
  const element = h("div", { class: "plate-shape" }, row, ...sides.map((side) => side.element));
  select.addEventListener("change", () => {
    const edits = select.value === SIDES ? sidesEdits(ctx) : shapeEdits(ctx, select.value);
    const name = select.value === SIDES ? "rectangle centered on the origin" : select.value.toLowerCase();
    ctx.change({ edits, text: say("change the slab's outline to a {shape}", { shape: name }) });
  });
  const update = () => {
    const table = tableAt(ctx.data(), ["plate"]);
    const chosen = table.outline === undefined ? null : ctx.schema.chooseKind(SHAPES, tableAt(ctx.data(), OUTLINE));
    select.value = table.outline === undefined ? SIDES : (chosen?.name ?? "");
    // a length beside an outline is shown, so that its issue is
    sides.forEach((side, n) => {
      side.element.hidden = table.outline !== undefined && table[n === 0 ? "length_x" : "length_y"] === undefined;
    });
    for (const side of sides) side.update();
  };
  return { element, update, reveal: (target) => sides.some((side) => side.reveal(target)) };
}

/** The measures of an outline that is drawn where it lies. */
export function plateOutline(ctx: FormContext, inner: Widget): Widget {
  inner.element.classList.add("without-kind");
  const update = () => {
    inner.element.hidden = tableAt(ctx.data(), ["plate"]).outline === undefined;
    inner.update();
  };
  return { element: inner.element, update, reveal: (target) => startsWith(target, OUTLINE) && inner.reveal(target) };
}

/** The edits that draw the slab as a shape where it lies now. */
export function shapeEdits(ctx: Pick<FormContext, "schema" | "data">, name: string): Edit[] {
  const data = ctx.data();
  return outlineEdits(data, defaultPlacement(data, OUTLINE, ctx.schema.part(name), tableAt(data, OUTLINE)));
}

/** The edits that make the slab a rectangle about the origin, as large as it was. */
function sidesEdits(ctx: FormContext): Edit[] {
  const data = ctx.data();
  const box = defaultPlacement(data, OUTLINE, ctx.schema.part("Rectangle"), tableAt(data, OUTLINE));
  const size = (key: "x" | "y") => {
    const [from, to] = (box[key] as string[]).map((each) => parseFloat(each));
    return (to ?? 3) - (from ?? -3);
  };
  const old = readSides(data) ?? { x: size("x"), y: size("y") };
  return [
    { op: "remove", path: OUTLINE },
    { op: "set", path: ["plate", "length_x"], value: formatLength(old.x) },
    { op: "set", path: ["plate", "length_y"], value: formatLength(old.y) },
  ];
}

// What the field with the focus means: a panel at the foot of the form or of the drawing.
import { fill, h, newId } from "../../viewer/shared/dom";
import { verbatim } from "../../viewer/shared/language";
import { readStored, writeStored } from "../../viewer/shared/storage";
import { symbolElement } from "../../viewer/shared/symbols";
import type { FormContext } from "../form/context";
import type { Path, Table } from "../model/paths";
import { drawPart } from "./drawings";
import { anchorOf, type FieldAt, factsOf, findField, meaningOf, titleOf } from "./facts";
import "./help.css";

const SHOWN = "groundslab-field-help";

/** Whether the meaning of fields is shown. */
export const showsFieldHelp = () => readStored(SHOWN) !== "off";

/** Show field help, or not, and keep that. */
export function setFieldHelp(shown: boolean): void {
  writeStored(SHOWN, shown ? "on" : "off");
}

/** Return the path of the field that an element belongs to, null if it is in none. */
export function pathOf(target: EventTarget | null): Path | null {
  const row = target instanceof Element ? target.closest<HTMLElement>("[data-path]") : null;
  return row?.dataset.path ? (JSON.parse(row.dataset.path) as Path) : null;
}

/** Return a panel that explains the field with the focus within an element; `open` opens the documentation at an anchor. */
export function fieldHelp(ctx: FormContext, watched: HTMLElement, open: (anchor: string) => void): HTMLElement {
  const element = h("div", { class: "field-help", role: "note", id: newId("help"), hidden: true });
  let described: { input: Element; before: string | null } | null = null;
  const leave = () => {
    if (described?.before == null) described?.input.removeAttribute("aria-describedby");
    else described.input.setAttribute("aria-describedby", described.before);
    described = null;
  };
  const hide = () => {
    leave();
    element.hidden = true;
  };
  const close = () => {
    setFieldHelp(false);
    hide();
  };
  const show = (input: Element, path: Path, about: FieldAt) => {
    leave();
    const before = input.getAttribute("aria-describedby");
    described = { input, before };
    // the panel says what the hint beside the field says
    const others = before?.split(" ").filter((id) => !id.startsWith("hint-")) ?? [];
    input.setAttribute("aria-describedby", [`${element.id}-text`, ...others].join(" "));
    fill(element, ...contents(element.id, path, about, ctx.data(), () => open(anchorOf(ctx.data(), path)), close));
    element.hidden = false;
    input.scrollIntoView({ block: "nearest" });
  };
  watched.addEventListener("focusin", ({ target }) => {
    if (target instanceof Node && element.contains(target)) return;
    const path = showsFieldHelp() ? pathOf(target) : null;
    const about = path && findField(ctx.schema, ctx.data(), path);
    if (target instanceof Element && target.matches("input, select, textarea") && path && about)
      show(target, path, about);
    else hide();
  });
  watched.addEventListener("focusout", ({ relatedTarget }) => {
    if (!(relatedTarget instanceof Node) || !watched.contains(relatedTarget)) hide();
  });
  return element;
}

function contents(
  id: string,
  path: Path,
  about: FieldAt,
  data: Table,
  open: () => void,
  close: () => void,
): HTMLElement[] {
  const { field, part } = about;
  const symbol = field.symbol && !field.symbol.includes(",") ? symbolElement(field.symbol) : null;
  const key = h("code", {}, path.filter((step) => typeof step === "string").join("."));
  const facts = factsOf(about, data).flatMap(([name, value]) => [
    h("dt", {}, name),
    h("dd", {}, name === "default" && !about.field.needed ? verbatim(value) : value),
  ]);
  const link = h("button", { type: "button", class: "link", tabindex: -1, onclick: open }, "Documentation (F1)");
  const text = h(
    "div",
    { class: "field-meaning", id: `${id}-text` },
    h("p", { class: "field-title" }, h("strong", {}, titleOf(about)), " ", symbol, " ", key),
    h("p", {}, meaningOf(about)),
    h("dl", {}, ...facts),
  );
  const figure = drawPart(part?.name ?? "", field.name);
  const attributes = { type: "button", class: "icon", "aria-label": "hide field help", tabindex: -1 };
  const end = h("div", { class: "field-acts" }, h("button", { ...attributes, onclick: close }, "×"), link);
  return [text, h("div", { class: "field-figure" }, figure), end];
}

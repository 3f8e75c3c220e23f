// Elements of a page, made in one call. Texts are messages, which are shown in the language of the page.

import { Verbatim } from "./catalogue";
import { type Text, translate } from "./language";

type Attribute = Text | number | boolean | null | undefined | ((event: never) => void);
export type Child = Node | Text | null | undefined | false;
const SVG = "http://www.w3.org/2000/svg";
/** Attributes that are read. */
const READ: ReadonlySet<string> = new Set(["title", "aria-label", "aria-roledescription", "placeholder", "label"]);
/** Elements whose text is of the user or for a computer. */
const CODE: ReadonlySet<string> = new Set(["code", "pre", "textarea"]);

/** Return what is shown of a text. */
export function shown(text: Text): string {
  return typeof text === "string" ? translate(text) : text.text;
}

/** Make an HTML element: attributes by name, `onclick` and the like as listeners, then its children. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, Attribute> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  return build(document.createElement(tag), attributes, children);
}

/** Make an SVG element. */
export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Record<string, Attribute> = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  return build(document.createElementNS(SVG, tag), attributes, children);
}

function build<E extends HTMLElement | SVGElement>(
  element: E,
  attributes: Record<string, Attribute>,
  children: readonly Child[],
): E {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(name.slice(2), value as EventListener);
    // pages forbid style attributes, but not styles that a script sets
    else if (name === "style") element.style.cssText = String(value);
    else if (READ.has(name) && typeof value !== "boolean") setRead(element, name, textOf(value));
    else element.setAttribute(name, value === true ? "" : value instanceof Verbatim ? value.text : String(value));
  }
  append(element, children);
  return element;
}

const textOf = (value: Text | number): Text => (typeof value === "number" ? String(value) : value);

function append(element: Element, children: readonly Child[]): void {
  const isCode = CODE.has(element.localName);
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    if (child instanceof Node) element.append(child);
    else element.append(isCode && typeof child === "string" ? child : shown(child));
  }
}

/** Set an attribute that is read, such as a title. */
export function setRead(element: Element, name: string, text: Text): void {
  element.setAttribute(name, shown(text));
}

/** Replace the children of an element. */
export function fill(element: Element, ...children: Child[]): void {
  element.replaceChildren();
  append(element, children);
}

/** Replace the children of an element; those that stay are not touched. */
export function keepChildren(element: Element, children: readonly Element[]): void {
  const kept = new Set(children);
  for (const child of [...element.children]) if (!kept.has(child)) child.remove();
  let next = element.firstElementChild;
  for (const child of children)
    if (child === next) next = next.nextElementSibling;
    else element.insertBefore(child, next);
}

/** Set a text only if it differs, so that screen readers do not read it twice. */
export function setText(element: Element, text: Text): void {
  const words = shown(text);
  if (element.textContent !== words) element.textContent = words;
}

/** A button with a text, and a tooltip if it is not empty. */
export function button(text: Text, title: Text, onclick: () => void, className?: string): HTMLButtonElement {
  return h("button", { type: "button", class: className, title: title || null, onclick }, text);
}

const usualTitles = new WeakMap<Element, string>();

/** Let a control act, or disable it and say why it cannot in place of its title; `why` is empty where it can. */
export function allow(control: HTMLButtonElement | HTMLInputElement | HTMLSelectElement, why: Text): void {
  const usual = usualTitles.get(control) ?? control.title;
  usualTitles.set(control, usual);
  control.disabled = why !== "";
  control.title = why ? shown(why) : usual;
}

type Option = readonly [value: string, text: Text];
const writtenOptions = new WeakMap<Element, string>();

/** Fill a list with options unless it has them already: the browser would read and lay out the page anew. */
export function setOptions(list: Element, options: readonly Option[]): void {
  const written = JSON.stringify(options.map(([value, text]) => [value, shown(text)]));
  if (writtenOptions.get(list) === written) return;
  writtenOptions.set(list, written);
  fill(list, ...options.map(([value, text]) => h("option", { value }, text)));
}

/** Fill a list with options; the chosen one stays chosen if it is still there. */
export function fillOptions(select: HTMLSelectElement, options: readonly Option[]): void {
  const before = select.value;
  setOptions(select, options);
  if (select.value !== before && options.some(([value]) => value === before)) select.value = before;
}

/** Mark one of several buttons as pressed. */
export function press<K extends string>(buttons: Record<K, HTMLButtonElement>, pressed: K): void {
  for (const [name, each] of Object.entries<HTMLButtonElement>(buttons))
    each.setAttribute("aria-pressed", String(name === pressed));
}

let lastId = 0;

/** Return an id that no other element has, to tie labels and messages to fields. */
export function newId(stem: string): string {
  lastId += 1;
  return `${stem}-${lastId}`;
}

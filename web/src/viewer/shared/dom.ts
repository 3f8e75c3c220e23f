// Elements of a page, made in one call.

type Attribute = string | number | boolean | null | undefined | ((event: never) => void);
export type Child = Node | string | null | undefined | false;
const SVG = "http://www.w3.org/2000/svg";

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
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  append(element, children);
  return element;
}

function append(element: Element, children: readonly Child[]): void {
  for (const child of children) if (child !== null && child !== undefined && child !== false) element.append(child);
}

/** Replace the children of an element. */
export function fill(element: Element, ...children: Child[]): void {
  element.replaceChildren();
  append(element, children);
}

/** Set a text only if it differs, so that screen readers do not read it twice. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** A button with a text, and a tooltip if it is not empty. */
export function button(text: string, title: string, onclick: () => void, className?: string): HTMLButtonElement {
  return h("button", { type: "button", class: className, title: title || null, onclick }, text);
}

/** Fill a list with options (value, text); the chosen one stays chosen if it is still there. */
export function fillOptions(select: HTMLSelectElement, options: readonly (readonly [string, string])[]): void {
  const before = select.value;
  fill(select, ...options.map(([value, text]) => h("option", { value }, text)));
  if (options.some(([value]) => value === before)) select.value = before;
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

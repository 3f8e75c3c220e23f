// Making elements without ceremony.

type Attributes = Record<string, string | number | boolean | ((event: Event) => void)>;

/** Make an HTML element: attributes (functions become listeners, false leaves out), then children. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    // pages forbid style attributes; what a script sets they allow
    else if (name === "style") element.style.cssText = String(value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false) element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}

/** Write a symbol with its subscript: m_x becomes m<sub>x</sub>. */
export function symbol(text: string): HTMLElement {
  const element = make("span", { class: "gs-symbol" });
  const [, letter, below, rest] = /^(\w+?)_(\w+)(.*)$/.exec(text) ?? [null, text, "", ""];
  element.append(make("i", {}, GREEK[letter!] ?? letter!));
  if (below) element.append(make("sub", {}, below));
  if (rest) element.append(rest);
  return element;
}

/** The same as plain text for canvases and lists: m_x becomes mx, as there are no small letters for all of them. */
export function symbolText(text: string): string {
  const [, letter, below, rest] = /^(\w+?)_(\w+)(.*)$/.exec(text) ?? [null, text, "", ""];
  return `${GREEK[letter!] ?? letter!}${below!}${rest!}`;
}

/** Return words with all symbols in them as plain text. */
export function plainWords(text: string): string {
  return text.replace(/\b[A-Za-z]+_[A-Za-z0-9]+/g, symbolText);
}

const GREEK: Record<string, string> = { beta: "\u03b2", gamma: "\u03b3", phi: "\u03c6" };

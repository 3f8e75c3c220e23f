// Symbols with subscripts and Greek letters, as elements and as plain text.
import { h } from "./dom";

const GREEK: Record<string, string> = {
  alpha: "α",
  beta: "β",
  gamma: "γ",
  delta: "δ",
  kappa: "κ",
  nu: "ν",
  psi: "ψ",
  mu: "μ",
  phi: "φ",
  rho: "ρ",
};

/** Return a symbol such as `m_x`, or several with commas between, as an element with subscripts. */
export function symbolElement(text: string): HTMLElement {
  const element = h("span", { class: "gs-symbol" });
  text.split(", ").forEach((each, i) => {
    const { letter, subscript, rest } = split(each);
    if (i) element.append(", ");
    element.append(h("i", {}, letter));
    if (subscript) element.append(h("sub", {}, subscript));
    element.append(rest);
  });
  return element;
}

/** Return a symbol as plain text: `m_x` becomes mx, since not every letter has a small form. */
export function symbolText(text: string): string {
  const { letter, subscript, rest } = split(text);
  return letter + subscript + rest;
}

/** Return a text with all symbols in it as plain text. */
export function plainSymbols(text: string): string {
  return text.replace(/\b[A-Za-z]+_[A-Za-z0-9]+/g, symbolText);
}

function split(text: string): { letter: string; subscript: string; rest: string } {
  const [, letter = text, subscript = "", rest = ""] = /^(\w+?)_(\w+)(.*)$/.exec(text) ?? [];
  return { letter: GREEK[letter] ?? letter, subscript: GREEK[subscript] ?? subscript, rest };
}

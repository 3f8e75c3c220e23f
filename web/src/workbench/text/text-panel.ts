// The case file as text: editable, coloured, faults beside their lines.

import type { Fault } from "../client/api";
import type { Store } from "../client/store";
import type { Path } from "../model/paths";
import { fill, h, later } from "../shell/elements";
import { type Token, tokens } from "./highlighting";
import { lineOf, linesOf } from "./toml-positions";

const QUIET = 500; // ms without a key until the text is sent

export interface TextPanel {
  readonly element: HTMLElement;
  /** Go to the line of a path. */
  reveal(path: Path, line?: number): void;
  /** Draw it, once it is seen. */
  refresh(): void;
  /** Send what has been typed. */
  flush(): void;
}

/** The text, kept the same as the server's unless someone is typing. */
export function textPanel(store: Store, push: (text: string, typedOn: boolean) => void): TextPanel {
  const area = h("textarea", {
    class: "code-input",
    spellcheck: "false",
    autocapitalize: "off",
    autocomplete: "off",
    wrap: "off",
    "aria-label": "case file as text",
  });
  const colours = h("pre", { class: "code-colours", "aria-hidden": "true" });
  const gutter = h("pre", { class: "code-gutter", "aria-hidden": "true" });
  const element = h("div", { class: "code" }, gutter, h("div", { class: "code-box" }, colours, area));
  let typed = false;
  let sent = 0; // edits since the text has had the keyboard
  let drawn = "";

  const send = () => {
    typed = false;
    push(area.value, sent > 0);
    sent += 1;
  };
  const soon = later(QUIET, send);
  const draw = () => {
    if (element.closest("[hidden]")) return;
    const faults = new Map<number, Fault[]>();
    const lines = linesOf(area.value);
    for (const fault of typed ? [] : (store.doc?.faults ?? [])) {
      const line = fault.line ?? lineOf(lines, fault.path) ?? 1;
      faults.set(line, [...(faults.get(line) ?? []), fault]);
    }
    const key = JSON.stringify([area.value, [...faults]]);
    if (key === drawn) return;
    drawn = key;
    const rows = coloured(area.value);
    fill(colours, ...rows.flatMap((row, n) => [lineElement(row, faults.get(n + 1) ?? []), "\n"]));
    fill(
      gutter,
      ...rows.flatMap((_, n) => [h("span", { class: faults.has(n + 1) ? "bad" : "" }, String(n + 1)), "\n"]),
    );
    scrolled();
  };
  const scrolled = () => {
    colours.style.transform = `translate(${-area.scrollLeft}px, ${-area.scrollTop}px)`;
    gutter.style.transform = `translateY(${-area.scrollTop}px)`;
  };
  const update = () => {
    const text = store.waitingText ?? store.doc?.text ?? "";
    if (!typed && area.value !== text) {
      const [from, to, top] = [area.selectionStart, area.selectionEnd, area.scrollTop];
      area.value = text;
      if (document.activeElement === area) area.setSelectionRange(from, to);
      area.scrollTop = top;
    }
    draw();
  };
  area.addEventListener("input", () => {
    typed = true;
    draw();
    soon();
  });
  area.addEventListener("focus", () => (sent = 0));
  area.addEventListener("scroll", scrolled);
  area.addEventListener("blur", () => soon.flush());
  area.addEventListener("keydown", (event) => {
    if (event.key !== "Tab" || event.shiftKey || event.ctrlKey || event.altKey) return;
    // two spaces; Escape first lets Tab leave the text
    if (element.dataset.leave === "yes") return;
    event.preventDefault();
    area.setRangeText("  ", area.selectionStart, area.selectionEnd, "end");
    area.dispatchEvent(new Event("input"));
  });
  area.addEventListener("keyup", (event) => {
    if (event.key === "Escape") element.dataset.leave = "yes";
    else if (event.key !== "Tab") delete element.dataset.leave;
  });
  store.on(["doc", "waiting"], update);
  const reveal = (path: Path, line?: number) => {
    const target = line ?? lineOf(linesOf(area.value), path) ?? 1;
    const rows = area.value.split("\n");
    const start = rows.slice(0, target - 1).reduce((sum, row) => sum + row.length + 1, 0);
    area.focus();
    area.setSelectionRange(start, start + (rows[target - 1]?.length ?? 0));
    const height = parseFloat(getComputedStyle(area).lineHeight) || 18;
    area.scrollTop = Math.max(0, (target - 4) * height);
    scrolled();
  };
  return { element, reveal, refresh: draw, flush: () => soon.flush() };
}

/** The pieces of a text, line by line. */
function coloured(text: string): { text: string; style: string }[][] {
  const rows: { text: string; style: string }[][] = [[]];
  const all = tokens(text);
  let header = false; // whether the line is [a.b]
  let fresh = true; // whether nothing has stood on the line yet
  all.forEach((token, n) => {
    if (fresh && token.kind !== "space") header = token.text === "[";
    fresh = token.kind === "end" || (fresh && token.kind === "space");
    const style = styleOf(token, all[n + 1]?.kind === "space" ? all[n + 2] : all[n + 1], header);
    token.text.split("\n").forEach((piece, k) => {
      if (k > 0) rows.push([]);
      if (piece) rows.at(-1)?.push({ text: piece, style });
    });
  });
  return rows;
}

function styleOf(token: Token, next: Token | undefined, header: boolean): string {
  if (token.kind === "comment" || token.kind === "sign") return token.kind;
  if (header) return "header";
  if (next?.text === "=") return "key";
  return token.kind === "word" && /^[-+.\d]/.test(token.text) ? "figure" : token.kind;
}

function lineElement(row: readonly { text: string; style: string }[], faults: readonly Fault[]): HTMLElement {
  const words = faults
    .map((fault) => `got ${fault.got}, expected ${fault.expected}${fault.mend ? ` — ${fault.mend}` : ""}`)
    .join("; ");
  return h(
    "span",
    { class: faults.length > 0 ? "line bad" : "line" },
    ...row.map((piece) => h("span", { class: `t-${piece.style}` }, piece.text)),
    words ? h("span", { class: "line-fault" }, `   ◂ ${words}`) : null,
  );
}

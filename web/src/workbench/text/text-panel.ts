// The case file as text: editable, colored, issues beside their lines.
import { fill, h } from "../../viewer/shared/dom";
import { verbatim } from "../../viewer/shared/language";
import { debounce } from "../client/debounce";
import type { Store } from "../client/store";
import type { Issue } from "../model/issues";
import { issueText } from "../model/issues";
import { highlight, type Piece } from "./highlighting";
import "./text-panel.css";

const QUIET = 500; // ms without a key until the text is sent

/** The text, kept in step with the server's unless someone is typing. */
export class TextPanel {
  readonly element: HTMLElement;
  private readonly area = h("textarea", {
    class: "code-input",
    spellcheck: "false",
    autocapitalize: "off",
    autocomplete: "off",
    wrap: "off",
    "aria-label": "case file as text",
  });
  private readonly colors = h("pre", { class: "code-colors", "aria-hidden": "true" });
  private readonly gutter = h("pre", { class: "code-gutter", "aria-hidden": "true" });
  private typed = false;
  private sent = 0; // edits since the text has had the focus
  private drawn = "";
  private readonly send = debounce(QUIET, () => {
    this.typed = false;
    this.push(this.area.value, this.sent > 0);
    this.sent += 1;
  });

  constructor(
    private readonly store: Store,
    private readonly push: (text: string, continued: boolean) => void,
  ) {
    const { area } = this;
    this.element = h("div", { class: "code" }, this.gutter, h("div", { class: "code-box" }, this.colors, area));
    area.addEventListener("input", () => {
      this.typed = true;
      this.draw();
      this.send();
    });
    area.addEventListener("focus", () => {
      this.sent = 0;
    });
    area.addEventListener("scroll", () => this.scroll());
    area.addEventListener("blur", () => this.flush());
    area.addEventListener("keydown", (event) => this.indent(event));
    area.addEventListener("keyup", (event) => {
      if (event.key === "Escape") this.element.dataset.leave = "yes";
      else if (event.key !== "Tab") delete this.element.dataset.leave;
    });
    store.on(["doc", "waiting"], () => this.update());
  }

  /** Send what has been typed. */
  flush(): void {
    this.send.flush();
  }

  /** Go to a line. */
  reveal(line: number): void {
    const { area } = this;
    const rows = area.value.split("\n");
    const start = rows.slice(0, line - 1).reduce((sum, row) => sum + row.length + 1, 0);
    area.focus();
    area.setSelectionRange(start, start + (rows[line - 1]?.length ?? 0));
    const height = Number.parseFloat(getComputedStyle(area).lineHeight) || 18;
    area.scrollTop = Math.max(0, (line - 4) * height);
    this.scroll();
  }

  /** Draw the text if it is visible and has changed. */
  draw(): void {
    if (this.element.closest("[hidden]")) return;
    const issues = new Map<number, Issue[]>();
    for (const issue of this.typed ? [] : (this.store.doc?.issues ?? []))
      issues.set(issue.line ?? 1, [...(issues.get(issue.line ?? 1) ?? []), issue]);
    const key = JSON.stringify([this.area.value, [...issues]]);
    if (key === this.drawn) return;
    this.drawn = key;
    const rows = highlight(this.area.value);
    const makeNumber = (line: number) => h("span", { class: issues.has(line) ? "bad" : "" }, String(line));
    fill(this.colors, ...rows.flatMap((row, n) => [makeLine(row, issues.get(n + 1) ?? []), "\n"]));
    fill(this.gutter, ...rows.flatMap((_, n) => [makeNumber(n + 1), "\n"]));
    this.scroll();
  }

  private update(): void {
    const { area } = this;
    const text = this.store.waitingText ?? this.store.doc?.text ?? "";
    if (!this.typed && area.value !== text) {
      const [from, to, top] = [area.selectionStart, area.selectionEnd, area.scrollTop];
      area.value = text;
      if (document.activeElement === area) area.setSelectionRange(from, to);
      area.scrollTop = top;
    }
    this.draw();
  }

  private scroll(): void {
    const { scrollLeft, scrollTop } = this.area;
    this.colors.style.transform = `translate(${-scrollLeft}px, ${-scrollTop}px)`;
    this.gutter.style.transform = `translateY(${-scrollTop}px)`;
  }

  /** Tab inserts two spaces; after Escape it leaves the text. */
  private indent(event: KeyboardEvent): void {
    if (event.key !== "Tab" || event.shiftKey || event.ctrlKey || event.altKey) return;
    if (this.element.dataset.leave === "yes") return;
    event.preventDefault();
    this.area.setRangeText("  ", this.area.selectionStart, this.area.selectionEnd, "end");
    this.area.dispatchEvent(new Event("input"));
  }
}

function makeLine(row: readonly Piece[], issues: readonly Issue[]): HTMLElement {
  const text = issues.map(issueText).join("; ");
  return h(
    "span",
    { class: issues.length > 0 ? "line bad" : "line" },
    ...row.map((piece) => h("span", { class: `t-${piece.style}` }, verbatim(piece.text))),
    text ? h("span", { class: "line-issue" }, `   ◂ ${text}`) : null,
  );
}

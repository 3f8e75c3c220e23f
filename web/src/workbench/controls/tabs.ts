// Tabs: one panel of several is shown.

import { h, newId, setText } from "../../viewer/shared/dom";
import { scrollingBar } from "./scrolling-bar";

export interface Tab {
  name: string;
  label: string;
  panel: HTMLElement;
  /** Whether it scrolls and holds nothing that takes the focus. */
  scrolls?: boolean;
}

export interface Tabs {
  readonly bar: HTMLElement;
  readonly current: () => string;
  show(name: string): void;
  /** Put a badge on a tab, such as a number; empty for none. */
  mark(name: string, text: string, bad?: boolean): void;
  /** Offer a tab, or hide it; if it was the current one, the first is shown. */
  offer(name: string, offered: boolean): void;
}

/** A bar of tabs over panels that are in the page already; `onChange` is called with another one. */
export function tabs(all: readonly Tab[], label: string, onChange: (name: string) => void = () => undefined): Tabs {
  let current = all[0]?.name ?? "";
  const buttons = all.map((tab) => {
    tab.panel.id ||= newId("panel");
    tab.panel.setAttribute("role", "tabpanel");
    if (tab.scrolls) tab.panel.tabIndex = 0; // so that keys can scroll it
    const button = h(
      "button",
      { type: "button", role: "tab", "aria-controls": tab.panel.id, id: newId("tab"), onclick: () => show(tab.name) },
      tab.label,
      h("span", { class: "badge" }),
    );
    tab.panel.setAttribute("aria-labelledby", button.id);
    return button;
  });
  const show = (name: string) => {
    current = name;
    all.forEach((tab, n) => {
      const on = tab.name === name;
      tab.panel.hidden = !on;
      buttons[n]?.setAttribute("aria-selected", String(on));
      buttons[n]?.setAttribute("tabindex", on ? "0" : "-1");
      if (on) buttons[n]?.scrollIntoView?.({ block: "nearest", inline: "nearest" });
    });
    onChange(name);
  };
  const list = h("div", { class: "tabs", role: "tablist", "aria-label": label }, ...buttons);
  const bar = scrollingBar(list, () => buttons.find((button) => button.getAttribute("aria-selected") === "true"));
  list.addEventListener("keydown", (event) => {
    const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (step === 0) return;
    event.preventDefault(); // else the browser scrolls the bar, too, after the tab has been shown
    const offered = all.filter((_, n) => !buttons[n]?.hidden);
    const next = (offered.findIndex((tab) => tab.name === current) + step + offered.length) % offered.length;
    show(offered[next]?.name ?? current);
    buttons[all.findIndex((tab) => tab.name === current)]?.focus();
  });
  const mark = (name: string, text: string, bad = false) => {
    const badge = buttons[all.findIndex((tab) => tab.name === name)]?.querySelector(".badge");
    if (!badge) return;
    setText(badge, text);
    badge.classList.toggle("bad", bad);
  };
  const offer = (name: string, offered: boolean) => {
    const button = buttons[all.findIndex((tab) => tab.name === name)];
    if (button) button.hidden = !offered;
    if (!offered && current === name) show(all[0]?.name ?? "");
  };
  show(current);
  return { bar, current: () => current, show, mark, offer };
}

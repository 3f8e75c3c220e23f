// A bar between two parts of the page that can be dragged, or moved by arrow keys.

import { h } from "./elements";

const STEP = 0.02;

/** Let a share (0 to 1) of an element be changed by dragging; it stands in a variable of its style, and is remembered. */
export function splitter(
  parent: HTMLElement,
  variable: string,
  axis: "x" | "y",
  at: number,
  range: readonly [number, number],
  label: string,
): HTMLElement {
  const key = `groundslab${variable}`;
  const bar = h("div", {
    class: `splitter ${axis}`,
    role: "separator",
    tabindex: 0,
    "aria-label": label,
    "aria-orientation": axis === "x" ? "vertical" : "horizontal",
  });
  let share = remembered(key) ?? at;
  const set = (to: number) => {
    share = Math.min(range[1], Math.max(range[0], to));
    parent.style.setProperty(variable, `${(share * 100).toFixed(2)}%`);
    bar.setAttribute("aria-valuenow", String(Math.round(share * 100)));
    remember(key, share);
  };
  bar.addEventListener("pointerdown", (event) => {
    bar.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  bar.addEventListener("pointermove", (event) => {
    if (!bar.hasPointerCapture(event.pointerId)) return;
    const box = parent.getBoundingClientRect();
    set(axis === "x" ? (event.clientX - box.left) / box.width : (event.clientY - box.top) / box.height);
  });
  bar.addEventListener("keydown", (event) => {
    const back = axis === "x" ? "ArrowLeft" : "ArrowUp";
    const on = axis === "x" ? "ArrowRight" : "ArrowDown";
    if (event.key !== back && event.key !== on) return;
    event.preventDefault();
    set(share + (event.key === on ? STEP : -STEP));
  });
  bar.addEventListener("dblclick", () => set(at));
  set(share);
  return bar;
}

/** A number that an earlier visit has left, null if there is none. */
function remembered(key: string): number | null {
  try {
    const value = Number(localStorage.getItem(key) ?? "x");
    return Number.isFinite(value) && value > 0 ? value : null;
  } catch {
    return null;
  }
}

function remember(key: string, value: number): void {
  try {
    localStorage.setItem(key, String(value));
  } catch {
    // without storage the page forgets
  }
}

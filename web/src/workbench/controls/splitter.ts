// A bar between two parts of the page that can be dragged, or moved by arrow keys.
import { h } from "../../viewer/shared/dom";
import { readStored, writeStored } from "../../viewer/shared/storage";

const STEP = 0.02;

/**
 * Let a share (0 to 1) of an element be changed by dragging. It is a variable of the element's style, and is stored.
 */
export function splitter(
  parent: HTMLElement,
  variable: string,
  axis: "x" | "y",
  initial: number,
  [least, most]: readonly [number, number],
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
  let share = Number(readStored(key)) || initial;
  const set = (value: number) => {
    share = Math.min(most, Math.max(least, value));
    parent.style.setProperty(variable, `${(share * 100).toFixed(2)}%`);
    bar.setAttribute("aria-valuenow", String(Math.round(share * 100)));
    writeStored(key, String(share));
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
  bar.addEventListener("dblclick", () => set(initial));
  set(share);
  return bar;
}

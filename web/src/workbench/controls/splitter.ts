// A bar between two parts of the page that can be dragged, or moved by arrow keys.
import { h } from "../../viewer/shared/dom";
import { readStored, writeStored } from "../../viewer/shared/storage";

const STEP = 0.02;

/**
 * Let a share (0 to 1) of an element be changed by dragging. It is a variable of the element's style, and is stored
 * once it has been changed; `initial` may depend on the height of the window.
 */
export function splitter(
  parent: HTMLElement,
  variable: string,
  axis: "x" | "y",
  initial: number | (() => number),
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
  const begin = typeof initial === "number" ? () => initial : initial;
  let isChosen = readStored(key) !== null;
  let share = Number(readStored(key)) || begin();
  const set = (value: number) => {
    share = Math.min(most, Math.max(least, value));
    parent.style.setProperty(variable, `${(share * 100).toFixed(2)}%`);
    bar.setAttribute("aria-valuenow", String(Math.round(share * 100)));
  };
  const choose = (value: number) => {
    set(value);
    isChosen = true;
    writeStored(key, String(share));
  };
  bar.addEventListener("pointerdown", (event) => {
    bar.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  bar.addEventListener("pointermove", (event) => {
    if (!bar.hasPointerCapture(event.pointerId)) return;
    const box = parent.getBoundingClientRect();
    choose(axis === "x" ? (event.clientX - box.left) / box.width : (event.clientY - box.top) / box.height);
  });
  bar.addEventListener("keydown", (event) => {
    const back = axis === "x" ? "ArrowLeft" : "ArrowUp";
    const on = axis === "x" ? "ArrowRight" : "ArrowDown";
    if (event.key !== back && event.key !== on) return;
    event.preventDefault();
    choose(share + (event.key === on ? STEP : -STEP));
  });
  bar.addEventListener("dblclick", () => choose(begin()));
  set(share);
  addEventListener("resize", () => isChosen || set(begin()));
  return bar;
}

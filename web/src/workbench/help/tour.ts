// A tour of five steps, shown at the first start: a box beside each control, with what it is for.

import { button, h, newId, setText } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import { readStored, writeStored } from "../../viewer/shared/storage";
import { closeDialog, openDialog } from "../controls/dialogs";
import { type Box, placeBeside } from "./placement";
import "./help.css";

const TAKEN = "groundslab-tour";

/** A step: what it is about, and the control that it points at. */
export interface Step {
  title: string;
  text: string;
  /** A selector of the control; the first that is found counts. */
  target: string;
  /** The view of the model that has the control. */
  view?: "plan" | "form";
}

export const STEPS: readonly Step[] = [
  {
    title: "Draw the slab",
    text: "Choose Slab and drag a rectangle, or click the corners one by one. Draw columns, openings and zones of different thickness the same way; enter exact values in the properties below the drawing.",
    target: '.tool[data-tool="slab"]',
    view: "plan",
  },
  {
    title: "Describe the ground",
    text: "Springs, soil layers, a half-space: the form has one section for each part of the case. Help for the focused field appears at the bottom of the form; press F1 to open its documentation.",
    target: '.section[data-section="ground"] > summary',
    view: "form",
  },
  {
    title: "Add loads",
    text: "Place point, line and area loads on the plan. A load on a column moves with the column. Define load cases and combinations in the form.",
    target: '.tool[data-tool="point load"]',
    view: "plan",
  },
  {
    title: "Solve and review the results",
    text: "With Autosolve on, every change is solved automatically; otherwise click Solve or press F9. Settlements, pressures, moments, checks and tables appear on the right.",
    target: ".solve",
  },
  {
    title: "Save and export",
    text: "Export saves the report, tables, figures, drawings and files for other programs. Save (Ctrl+S) writes the case file; unsaved work is backed up automatically. Click “?” for this tour, keyboard shortcuts and the documentation.",
    target: ".top .export",
  },
];

/** Whether the tour has been taken or skipped in this browser. */
export const isTourTaken = () => readStored(TAKEN) !== null;

/** Show the tour; `show` shows a view of the model. */
export function startTour(show: (view: "plan" | "form") => void): void {
  writeStored(TAKEN, "taken");
  const before = document.activeElement;
  const [titleId, textId] = [newId("tour"), newId("tour")];
  const title = h("h2", { id: titleId });
  const text = h("p", { id: textId });
  const count = h("span", { class: "quiet" });
  const spot = h("div", { class: "tour-spot" });
  let now = 0;
  const close = () => {
    removeEventListener("resize", place);
    closeDialog(dialog);
    if (before instanceof HTMLElement) before.focus();
  };
  const back = button("Back", "", () => go(now - 1));
  const next = button("Next", "", () => (now === STEPS.length - 1 ? close() : go(now + 1)), "main");
  const skip = button("Skip tour", "", close, "quiet");
  const answers = h("div", { class: "answers" }, skip, count, back, next);
  const box = h("div", { class: "tour-box" }, h("div", { "aria-live": "polite" }, title, text), answers);
  const attributes = { class: "tour", "aria-labelledby": titleId, "aria-describedby": textId };
  const dialog = h("dialog", attributes, spot, box);
  const place = () => {
    const control = document.querySelector(STEPS[now]?.target ?? "");
    const around = control?.getBoundingClientRect() ?? null;
    spot.hidden = around === null;
    if (around) setBox(spot, [around.left - 4, around.top - 4, around.width + 8, around.height + 8]);
    const [left, top] = placeBeside(around, [box.offsetWidth, box.offsetHeight], [innerWidth, innerHeight]);
    Object.assign(box.style, { left: `${left}px`, top: `${top}px` });
  };
  const go = (step: number) => {
    now = Math.min(STEPS.length - 1, Math.max(0, step));
    const { title: name, text: words, view, target } = STEPS[now]!;
    if (view) show(view);
    document.querySelector(target)?.scrollIntoView({ block: "nearest" });
    setText(title, name);
    setText(text, words);
    setText(count, say("{number} of {count}", { number: now + 1, count: STEPS.length }));
    setText(next, now === STEPS.length - 1 ? "Done" : "Next");
    back.disabled = now === 0;
    skip.hidden = now === STEPS.length - 1;
    place();
    next.focus();
  };
  dialog.addEventListener("keydown", ({ key }) => {
    if (key === "ArrowRight") go(now + 1);
    if (key === "ArrowLeft") go(now - 1);
  });
  addEventListener("resize", place);
  openDialog(dialog, close);
  go(0);
}

function setBox(element: HTMLElement, [left, top, width, height]: Box): void {
  Object.assign(element.style, { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` });
}

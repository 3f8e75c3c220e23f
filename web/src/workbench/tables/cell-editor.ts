// The field over a cell that edits it.
import { h, newId } from "../../viewer/shared/dom";
import { referencedNames } from "../model/changes/references";
import type { Path, Table } from "../model/paths";
import type { Column } from "./columns";

/** What ends editing: the cell stays, or the next one in a direction becomes active. */
export type After = "stay" | "down" | "up" | "right" | "left" | "next" | "previous";

export interface EditorHooks {
  /** Take what was typed, and go on. */
  commit(text: string, after: After): void;
  /** Editing has ended, with or without a result; `stays`: the keyboard is still here. */
  close(stays: boolean): void;
}

/** Return a field over a cell; `typing` is one that was opened by typing, in which arrow keys lead to other cells. */
export function cellEditor(
  cell: HTMLElement,
  label: string,
  text: string,
  options: readonly string[],
  typing: boolean,
  hooks: EditorHooks,
): HTMLInputElement {
  const list =
    options.length > 0
      ? h("datalist", { id: newId("names") }, ...options.map((value) => h("option", { value })))
      : null;
  const input = h("input", {
    type: "text",
    class: "cell-editor",
    autocomplete: "off",
    spellcheck: "false",
    "aria-label": label,
    list: list?.id,
    style: `left:${cell.offsetLeft}px;top:${cell.offsetTop}px;width:${cell.offsetWidth}px;height:${cell.offsetHeight}px`,
  });
  input.value = typing ? "" : text;
  if (list) cell.ownerDocument.body.append(list);
  let isOpen = true;
  const close = (stays = true) => {
    if (!isOpen) return;
    isOpen = false;
    list?.remove();
    hooks.close(stays);
    input.remove();
  };
  const commit = (after: After, stays = true) => {
    if (!isOpen) return;
    const typed = input.value;
    close(stays);
    hooks.commit(typed, after);
  };
  input.addEventListener("keydown", (event) => {
    const after = keyAfter(event, typing && !list);
    if (event.key === "Escape") close();
    else if (after) commit(after);
    else return;
    event.preventDefault();
  });
  // the page asks for what is typed before it saves; the browser's own event comes with a loss of the focus
  input.addEventListener("change", (event) => {
    if (!event.isTrusted) commit("stay");
  });
  input.addEventListener("blur", () => commit("stay", false));
  return input;
}

function keyAfter({ key, shiftKey }: KeyboardEvent, typing: boolean): After | null {
  if (key === "Enter") return shiftKey ? "up" : "down";
  if (key === "Tab") return shiftKey ? "previous" : "next";
  const arrows: Record<string, After> = { ArrowDown: "down", ArrowUp: "up", ArrowLeft: "left", ArrowRight: "right" };
  return typing ? (arrows[key] ?? null) : null;
}

/** Return what a cell may hold: options of a choice, or the names that it may call. */
export function optionsFor(data: Table, column: Column, item: Path): readonly string[] {
  if (column.node.is === "choice") return column.node.options;
  return referencedNames(data, [...item, ...column.path]) ?? [];
}

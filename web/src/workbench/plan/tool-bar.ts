// The tools beside the drawing, with names and keys.
import { h, verbatim } from "../../viewer/shared/dom";
import { translate } from "../../viewer/shared/language";
import type { Generator } from "./generators/generator";
import { GENERATORS } from "./generators/generators";
import { toolIcon } from "./tool-icons";
import { type Tool, type ToolName, toolOf } from "./tools";

export interface ToolBar {
  readonly element: HTMLElement;
  current(): Tool;
  choose(name: ToolName): void;
}

const GROUPS: readonly (readonly ToolName[])[] = [
  ["select"],
  ["slab", "opening", "zone", "column", "wall", "edge wall", "beam", "plate", "joint"],
  ["point load", "line load", "area load"],
  ["support", "line support"],
  ["borehole", "soil zone", "void"],
  ["section line", "strip", "refinement"],
];

/** Make the tool bar; `onChange` is called with every tool that is chosen, `onGenerate` with a generator. */
export function toolBar(onChange: (tool: Tool) => void, onGenerate: (generator: Generator) => void): ToolBar {
  let current = toolOf("select");
  const groups = GROUPS.map((names) => names.map((name) => makeButton(toolOf(name), () => choose(name))));
  const generators = GENERATORS.map((each) => makeButton(each, () => onGenerate(each)));
  const buttons = [...groups.flat(), ...generators];
  const mark = () => {
    for (const each of groups.flat()) {
      const isCurrent = each.dataset.tool === current.name;
      each.setAttribute("aria-pressed", String(isCurrent));
      each.tabIndex = isCurrent ? 0 : -1;
    }
  };
  const choose = (name: ToolName) => {
    current = toolOf(name);
    mark();
    onChange(current);
  };
  mark();
  for (const each of generators) each.tabIndex = -1;
  const attributes = { class: "tools", role: "toolbar", "aria-label": "drawing tools", "aria-orientation": "vertical" };
  const element = h(
    "div",
    attributes,
    ...[...groups, generators].map((group) => h("div", { class: "tool-group" }, ...group)),
  );
  element.addEventListener("keydown", (event) => {
    const by = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    if (by === 0) return;
    event.preventDefault();
    const now = buttons.indexOf(document.activeElement as HTMLButtonElement);
    buttons[(now + by + buttons.length) % buttons.length]?.focus();
  });
  return { element, current: () => current, choose };
}

function makeButton({ name, label, key, hint }: Tool | Generator, choose: () => void): HTMLButtonElement {
  const attributes = {
    type: "button",
    class: "tool",
    title: verbatim(`${translate(label)}${key && ` (${key})`}. ${translate(hint)}`),
    "aria-keyshortcuts": key || null,
    "data-tool": name,
    onclick: choose,
  };
  return h("button", attributes, toolIcon(name), h("span", {}, label), key ? h("kbd", {}, key) : "");
}

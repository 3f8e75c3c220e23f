// The tools beside the drawing, with names and keys.

import { h, setText } from "../shell/elements";
import { toolIcon } from "./tool-icons";
import { TOOLS, type Tool, type ToolName, toolOf } from "./tools";

export interface ToolBar {
  readonly element: HTMLElement;
  current(): Tool;
  choose(name: ToolName): void;
}

const GROUPS: readonly (readonly ToolName[])[] = [
  ["select"],
  ["slab", "opening", "zone", "column"],
  ["point load", "line load", "area load"],
  ["support", "wall"],
  ["borehole", "soil zone", "void"],
  ["section line"],
];

/** The tool bar; `changed` hears of another tool. */
export function toolBar(changed: (tool: Tool) => void): ToolBar {
  const buttons = new Map<ToolName, HTMLButtonElement>();
  let current = toolOf("select");
  const choose = (name: ToolName) => {
    current = toolOf(name);
    for (const [each, button] of buttons) {
      button.setAttribute("aria-pressed", String(each === name));
      button.tabIndex = each === name ? 0 : -1;
    }
    changed(current);
  };
  const make = (tool: Tool) => {
    const button = h(
      "button",
      {
        type: "button",
        class: "tool",
        title: `${tool.label} (${tool.key}). ${tool.hint}`,
        "aria-pressed": tool.name === "select",
        "aria-keyshortcuts": tool.key,
        "data-tool": tool.name,
        onclick: () => choose(tool.name),
      },
      toolIcon(tool.name),
      h("span", {}, tool.label),
      h("kbd", {}, tool.key),
    );
    button.setAttribute("aria-pressed", String(tool.name === current.name));
    button.tabIndex = tool.name === current.name ? 0 : -1;
    buttons.set(tool.name, button);
    return button;
  };
  const element = h(
    "div",
    { class: "tools", role: "toolbar", "aria-label": "drawing tools", "aria-orientation": "vertical" },
    ...GROUPS.map((names) => h("div", { class: "tool-group" }, ...names.map((name) => make(toolOf(name))))),
  );
  element.addEventListener("keydown", (event) => {
    const by = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    if (by === 0) return;
    event.preventDefault();
    const all = [...buttons.values()];
    all[(all.findIndex((button) => button === document.activeElement) + by + all.length) % all.length]?.focus();
  });
  return { element, current: () => current, choose };
}

/** The tool of a key, null if no tool has it. */
export function toolForKey(key: string): ToolName | null {
  return TOOLS.find((tool) => tool.key.toLowerCase() === key.toLowerCase())?.name ?? null;
}

/** Say what to do now below the drawing. */
export function hintLine(): { element: HTMLElement; say(words: string): void } {
  const element = h("p", { class: "drawing-hint", role: "status" });
  return { element, say: (words) => setText(element, words) };
}

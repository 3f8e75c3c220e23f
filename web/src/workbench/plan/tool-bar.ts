// The tools beside the drawing, with names and keys.
import { allow, h } from "../../viewer/shared/dom";
import { type Text, translate, verbatim } from "../../viewer/shared/language";
import type { Generator, GeneratorName } from "./generators/generator";
import { GENERATORS } from "./generators/generators";
import { toolIcon } from "./tool-icons";
import { type Tool, type ToolName, toolOf } from "./tools";

export interface ToolBar {
  readonly element: HTMLElement;
  current(): Tool;
  choose(name: ToolName): void;
  /** Let those act that can, and the others say why they cannot. */
  update(): void;
  whyNot: ToolHooks["whyNot"];
}

export interface ToolHooks {
  /** A tool has been chosen. */
  onChange(tool: Tool): void;
  onGenerate(generator: Generator): void;
  /** A tool that can do nothing now has been asked for. */
  onRefuse(why: string): void;
  /** Return why a tool can do nothing now, empty if it can. */
  whyNot(name: ToolName | GeneratorName): string;
}

const GROUPS: readonly (readonly ToolName[])[] = [
  ["select"],
  ["slab", "opening", "zone", "column", "wall", "edge wall", "beam", "plate", "joint"],
  ["point load", "line load", "area load"],
  ["support", "line support"],
  ["borehole", "soil zone", "void"],
  ["section line", "strip", "refinement"],
];

export function toolBar({ onChange, onGenerate, onRefuse, whyNot }: ToolHooks): ToolBar {
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
    const why = whyNot(name);
    if (why) return onRefuse(why);
    current = toolOf(name);
    mark();
    onChange(current);
  };
  const update = () => {
    const all = [...GROUPS.flat().map(toolOf), ...GENERATORS];
    for (const [n, each] of all.entries()) {
      const why = whyNot(each.name);
      allow(buttons[n]!, why && titleOf(each, why));
    }
    if (whyNot(current.name)) choose("select");
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
    const free = buttons.filter((each) => !each.disabled);
    const now = free.indexOf(document.activeElement as HTMLButtonElement);
    free[(now + by + free.length) % free.length]?.focus();
  });
  return { element, current: () => current, choose, update, whyNot };
}

function titleOf({ label, key }: Tool | Generator, what: string): Text {
  return verbatim(`${translate(label)}${key && ` (${key})`}. ${translate(what)}`);
}

function makeButton(tool: Tool | Generator, choose: () => void): HTMLButtonElement {
  const { name, label, key, hint } = tool;
  const attributes = {
    type: "button",
    class: "tool",
    title: titleOf(tool, hint),
    "aria-keyshortcuts": key || null,
    "data-tool": name,
    onclick: choose,
  };
  return h("button", attributes, toolIcon(name), h("span", {}, label), key ? h("kbd", {}, key) : "");
}

// Elements that edit one value of the case file, by what the value is.

import { h, newId, setOptions, setRead } from "../../../viewer/shared/dom";
import { say, translate, verbatim } from "../../../viewer/shared/language";
import { symbolText } from "../../../viewer/shared/symbols";
import { debounce } from "../../client/debounce";
import { referencedNames } from "../../model/changes/references";
import { issuesAt } from "../../model/issues";
import { type Json, type Path, pathKey, sameValue, startsWith, type Table, valueAt } from "../../model/paths";
import { parseInput, unitIn } from "../../model/quantities";
import { exampleOf, type Field, type Node } from "../../model/schema";
import { type FormContext, isSentWhenComplete, setValue, type Widget } from "../context";
import { showIssues } from "../errors";
import { defaultText } from "../labels";

export const QUIET = 350; // ms without a key until what was typed is sent

/** An element that edits a value. `focus` is what takes the keyboard. */
export interface Input {
  readonly element: HTMLElement;
  readonly focus: HTMLElement;
  update(): void;
}

/** Return a value as the text of an input. */
function inputText(value: Json | undefined): string {
  if (value === undefined || value === null) return "";
  return typeof value === "object" ? JSON.stringify(value) : String(value);
}

export interface TextOptions {
  label?: string;
  /** What stands there while it is empty, in the language of the page. */
  placeholder?: () => string;
  /** Another way to write the value, for cells of lists. */
  write?: (value: Json | undefined, typing: boolean) => void;
}

/** A line of text for a quantity, a number or a text. */
export function textInput(ctx: FormContext, path: Path, node: Node, options: TextOptions = {}): Input {
  const input = h("input", {
    type: "text",
    autocomplete: "off",
    spellcheck: "false",
    "aria-label": options.label,
    class: node.is === "text" ? "wide" : "number",
    inputmode: node.is === "number" || node.is === "integer" ? "decimal" : null,
  });
  const write = options.write ?? ((value: Json | undefined, typing: boolean) => setValue(ctx, path, value, typing));
  let typed = false;
  let sent = 0; // edits since the field has had the keyboard
  let unit = ""; // of the value that stood there, which a bare number takes
  const send = () => {
    typed = false;
    write(parseInput(node, input.value, unit), sent > 0);
    sent += 1;
  };
  const soon = debounce(QUIET, send);
  const atEnd = isSentWhenComplete(path);
  input.addEventListener("focus", () => {
    sent = 0;
    unit = unitIn(valueAt(ctx.data(), path)) || unit;
  });
  input.addEventListener("input", () => {
    typed = true;
    if (!atEnd) soon();
  });
  const end = () => {
    soon.flush();
    if (typed) send();
  };
  input.addEventListener("change", end);
  input.addEventListener("blur", () => {
    end();
    update(); // with the point and the unit that were taken
  });
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") end();
  });
  const words = node.is === "quantity" || node.is === "number" || node.is === "integer" ? node.options : [];
  const names = () => referencedNames(ctx.data(), path) ?? words;
  const isNamed = words.length > 0 || referencedNames(ctx.data(), path) !== null;
  const known = isNamed ? h("datalist", { id: newId("names") }) : null;
  if (known) input.setAttribute("list", known.id);
  const update = () => {
    if (known)
      setOptions(
        known,
        names().map((name) => [name, ""]),
      );
    input.placeholder = options.placeholder?.() ?? "";
    const value = valueAt(ctx.data(), path);
    if (typed || (document.activeElement === input && parseInput(node, input.value, unit) === value)) return;
    if (input.value !== inputText(value)) input.value = inputText(value);
  };
  return { element: known ? h("span", { class: "with-names" }, input, known) : input, focus: input, update };
}

/** A choice of one option; the default is shown faintly where nothing is chosen. */
function choiceInput(ctx: FormContext, path: Path, words: readonly string[], standard: Json | undefined): Input {
  const select = h("select", {});
  const optionOf = (word: string) => [word, word === "" ? "choose …" : verbatim(word)] as const;
  const update = () => {
    const value = valueAt(ctx.data(), path);
    const chosen = inputText(value ?? standard);
    setOptions(select, (words.includes(chosen) ? words : [chosen, ...words]).map(optionOf));
    if (select.value !== chosen) select.value = chosen;
    select.classList.toggle("by-default", value === undefined);
    setRead(select, "title", value === undefined && standard !== undefined ? "default" : "");
  };
  select.addEventListener("change", () => setValue(ctx, path, select.value === "" ? undefined : select.value));
  return { element: select, focus: select, update };
}

/** Yes or no. */
function flagInput(ctx: FormContext, path: Path, standard: Json | undefined): Input {
  const box = h("input", { type: "checkbox", class: "flag" });
  const update = () => {
    const value = valueAt(ctx.data(), path) ?? standard;
    box.checked = value === true;
    box.indeterminate = typeof value !== "boolean";
  };
  box.addEventListener("change", () => setValue(ctx, path, box.checked));
  return { element: box, focus: box, update };
}

/** A choice of several options. */
function choicesInput(ctx: FormContext, path: Path, words: readonly string[], standard: Json | undefined): Input {
  const boxes = words.map((word) => h("input", { type: "checkbox", value: word }));
  const group = h(
    "span",
    { class: "checks", role: "group" },
    ...boxes.map((box) => h("label", {}, box, verbatim(box.value))),
  );
  const update = () => {
    const value = valueAt(ctx.data(), path) ?? standard;
    for (const box of boxes) box.checked = Array.isArray(value) && value.includes(box.value);
  };
  group.addEventListener("change", () => {
    const chosen = boxes.filter((box) => box.checked).map((box) => box.value);
    setValue(ctx, path, chosen);
  });
  return { element: group, focus: boxes[0] ?? group, update };
}

/** A fixed number of values side by side. */
export function tupleInput(
  ctx: FormContext,
  path: Path,
  each: Node,
  length: number,
  labels: readonly string[],
  standard: Json | undefined,
): Input {
  const write = (n: number) => (value: Json | undefined, typing: boolean) => {
    const old = valueAt(ctx.data(), path);
    const elementAt = (k: number) => (Array.isArray(old) ? old[k] : undefined) ?? defaultElement(standard, k);
    const list = Array.from({ length }, (_, k) => elementAt(k));
    list[n] = value ?? "";
    const isUsual = (item: Json, k: number) => item === "" || sameValue(item, defaultElement(standard, k));
    const empty = value === undefined && list.every(isUsual);
    setValue(ctx, path, empty ? undefined : list, typing);
  };
  const cells = Array.from({ length }, (_, n) =>
    textInput(ctx, [...path, n], each, {
      label: labels[n] ?? String(n + 1),
      placeholder: () => (Array.isArray(standard) ? defaultText(standard[n]) : translate(labels[n] ?? "")),
      write: write(n),
    }),
  );
  const element = h("span", { class: "tuple" }, ...cells.map((cell) => cell.element));
  const update = () => {
    for (const cell of cells) cell.update();
  };
  return { element, focus: cells[0]?.focus ?? element, update };
}

/** Return the default of a tuple's value, with a unit. */
export function defaultElement(standard: Json | undefined, n: number): Json {
  return (Array.isArray(standard) ? standard[n] : undefined) ?? "";
}

/** Names of the values of a tuple: what its members are, or its symbols. */
export function tupleLabels(field: Field, { members, length }: Extract<Node, { is: "tuple" }>): string[] {
  const names = members.length === length ? members : field.symbol.split(", ");
  return names.length === length ? names.map((name) => (name.includes("_") ? symbolText(name) : name)) : [];
}

/** Numbers with commas between. */
function valuesInput(ctx: FormContext, path: Path, each: Node): Input {
  const write = (value: Json | undefined, typing: boolean) => {
    const texts = typeof value === "string" || typeof value === "number" ? String(value).split(",") : [];
    const list = texts.map((text) => parseInput(each, text)).filter((item) => item !== undefined);
    setValue(ctx, path, list.length > 0 ? list : undefined, typing);
  };
  const input = textInput(ctx, path, { is: "text" }, { placeholder: () => "0, 0, …", write });
  const element = input.focus as HTMLInputElement;
  const update = () => {
    const value = valueAt(ctx.data(), path);
    if (document.activeElement !== element)
      element.value = Array.isArray(value) ? value.map(inputText).join(", ") : inputText(value);
  };
  return { ...input, update };
}

/** An input that cannot be emptied, with a button that puts an optional key back to its default. */
function withReset(ctx: FormContext, path: Path, { needed, default: standard }: Field, input: Input): Input {
  if (needed) return input;
  const written = defaultText(standard);
  const title = written ? say("Back to the default: {written}", { written }) : "Back to no value";
  const reset = h("button", { type: "button", class: "icon reset", title, "aria-label": title }, verbatim("↺"));
  reset.addEventListener("click", () => {
    setValue(ctx, path, undefined);
    input.focus.focus();
  });
  const update = () => {
    input.update();
    reset.hidden = valueAt(ctx.data(), path) === undefined;
  };
  return { ...input, element: h("span", { class: "with-reset" }, input.element, reset), update };
}

/** What stands in an empty field: its default, else an example. */
function placeholderOf({ node, default: standard }: Field, data: Table): string {
  const written = defaultText(standard);
  if (written) return `${translate("default")} ${written}`;
  const example = exampleOf(node, data);
  return example && `${translate("e.g.")} ${example}`;
}

/** The element for a node that is a single value. */
export function inputFor(ctx: FormContext, path: Path, field: Field): Input {
  const { node } = field;
  switch (node.is) {
    case "choice":
      return withReset(ctx, path, field, choiceInput(ctx, path, node.options, field.default));
    case "boolean":
      return withReset(ctx, path, field, flagInput(ctx, path, field.default));
    case "choices":
      return withReset(ctx, path, field, choicesInput(ctx, path, node.options, field.default));
    case "tuple":
      return tupleInput(ctx, path, node.each, node.length, tupleLabels(field, node), field.default);
    case "values":
      return valuesInput(ctx, path, node.each);
    default:
      return textInput(ctx, path, node, { placeholder: () => placeholderOf(field, ctx.data()) });
  }
}

/** Return a widget of an input within an element: it shows what is wrong with the value at a path, and leads to it. */
export function inputWidget(
  ctx: FormContext,
  path: Path,
  input: Input,
  element: HTMLElement,
  messages: HTMLElement,
): Widget {
  const update = () => {
    input.update();
    const issues = issuesAt(ctx.issues(), path);
    element.classList.toggle("faulty", issues.length > 0);
    if (issues.length > 0) input.focus.setAttribute("aria-invalid", "true");
    else input.focus.removeAttribute("aria-invalid");
    showIssues(messages, issues, ctx.change);
  };
  const reveal = (target: Path) => {
    if (!startsWith(target, path)) return false;
    element.scrollIntoView({ block: "nearest" });
    input.focus.focus();
    return true;
  };
  return { element, update, reveal };
}

/** Return a widget of an input alone, for a cell of a table. */
export function inputCell(ctx: FormContext, path: Path, input: Input): Widget {
  const messages = h("div", { class: "messages", id: newId("issue") });
  input.focus.setAttribute("aria-describedby", messages.id);
  const element = h("div", { class: "cell", "data-path": pathKey(path) }, input.element, messages);
  return inputWidget(ctx, path, input, element, messages);
}

// The case file as a form: one section that folds for each key at the top of the file.

import { h, setText } from "../../viewer/shared/dom";
import { counted, type Text, verbatim } from "../../viewer/shared/language";
import { issuesOfPart } from "../model/issues";
import { isTable, type Json, type Path, type Table } from "../model/paths";
import type { Field } from "../model/schema";
import type { FormContext, Widget } from "./context";
import { showIssues } from "./errors";
import { heading, shortValue } from "./labels";
import { foldedWidget } from "./lists/folded-rows";
import "./form.css";
import { doesNothingUnlessThere, nodeWidget } from "./section";

/** The sections: what there is, what acts, what is output, how it is computed. */
const GROUPS: readonly { title: string; keys: readonly string[] }[] = [
  { title: "", keys: ["title"] },
  { title: "Slab", keys: ["plate", "axes", "columns", "walls", "cores", "beams", "building", "supports"] },
  { title: "Ground", keys: ["ground", "soil_zones", "boreholes", "beyond", "contact"] },
  { title: "Loads", keys: ["cases", "loads", "patterns", "moves", "combinations", "combine"] },
  { title: "Results", keys: ["output", "reinforcement", "floor"] },
  { title: "Analysis", keys: ["mesh", "analysis"] },
];
const HEADINGS: Record<string, string> = {
  plate: "Slab",
  axes: "Axes of the building",
  building: "Building above",
  cases: "Load cases",
  patterns: "Vehicles and racks",
  moves: "Positions and paths",
  floor: "Industrial floor",
  combine: "Combinations to EN 1990",
  beyond: "Ground beyond the slab",
  output: "Points, lines and strips",
};
const OPEN_AT_FIRST = ["plate", "ground"];

/** Return the title of a key at the top of the file. */
export function sectionTitle(key: string): string {
  return HEADINGS[key] ?? heading(key);
}

/** The form, and how to get to one of its fields. */
export function formPanel(
  ctx: FormContext,
  openKeys: { read(): string[] | null; write(keys: string[]): void },
): Widget {
  const root = ctx.schema.part("");
  const named = new Set(GROUPS.flatMap((group) => group.keys));
  const others = root.fields.filter((field) => !named.has(field.name)).map((field) => field.name);
  const messages = h("div", { class: "messages" });
  const element = h("div", { class: "form", role: "region", "aria-label": "form" }, messages);
  const open = new Set(openKeys.read() ?? OPEN_AT_FIRST);
  const sections: Widget[] = [];
  const opened = (key: string, isOpen: boolean) => {
    if (isOpen) open.add(key);
    else open.delete(key);
    openKeys.write([...open]);
  };
  for (const group of [...GROUPS, { title: "More", keys: others }]) {
    const fields = group.keys.flatMap((key) => root.fields.find((field) => field.name === key) ?? []);
    if (fields.length > 0 && group.title) element.append(h("h3", { class: "group-title" }, group.title));
    for (const field of fields) {
      const widget = isSimple(field)
        ? nodeWidget(ctx, [field.name], field)
        : foldedSection(ctx, field, open.has(field.name), opened);
      sections.push(widget);
      element.append(widget.element);
    }
  }
  const update = () => {
    for (const each of sections) each.update();
    showIssues(messages, issuesOfPart(ctx.issues(), [], root), ctx.change);
  };
  const reveal = (target: Path) => sections.some((each) => each.reveal(target));
  return { element, update, reveal };
}

function isSimple(field: Field): boolean {
  return !["part", "kinds", "list"].includes(field.node.is);
}

function foldedSection(
  ctx: FormContext,
  field: Field,
  open: boolean,
  opened: (key: string, open: boolean) => void,
): Widget {
  const path: Path = [field.name];
  const title = h("span", { class: "section-title" }, sectionTitle(field.name));
  const digest = h("span", { class: "digest" });
  const makeBody = () => {
    const body = nodeWidget(ctx, path, field, true);
    return { ...body, element: h("div", { class: "section-body" }, body.element) };
  };
  const attributes = { class: "section", "data-section": field.name, open };
  const { element, update, reveal } = foldedWidget(ctx, path, attributes, [title, digest], makeBody, () =>
    setText(digest, digestOf(field, ctx.data(), isOptional(ctx, field))),
  );
  element.addEventListener("toggle", () => opened(field.name, element.open));
  return { element, update, reveal: (target) => target[0] === field.name && reveal(target) };
}

/** Whether a section does nothing unless it is there. */
function isOptional(ctx: FormContext, { needed, node }: Field): boolean {
  return !needed && node.is === "part" && doesNothingUnlessThere(ctx.schema.part(node.part));
}

/** What a section holds, in a few words; `optional` is one that does nothing unless it is there. */
function digestOf(field: Field, data: Table, optional: boolean): Text {
  const value: Json | undefined = data[field.name];
  if (field.node.is === "list" && value === undefined) return "none";
  if (Array.isArray(value)) return value.length > 0 ? String(value.length) : "none";
  if (!isTable(value)) return field.needed ? "missing" : optional ? "not used" : "default";
  if (field.name === "plate") {
    const outline = isTable(value.outline)
      ? String(value.outline.kind ?? "outline")
      : [value.length_x, value.length_y].map(shortValue).join(" × ");
    return verbatim([outline, `t = ${shortValue(value.thickness)}`].filter(Boolean).join(", "));
  }
  if (field.name === "output") {
    const counts = Object.entries(value).map(([key, list]) => `${Array.isArray(list) ? list.length : 0} ${key}`);
    return verbatim(counts.join(", "));
  }
  const layers = Array.isArray(value.layers) ? counted(value.layers.length, "{count} layer", "{count} layers") : "";
  const simple = Object.entries(value).filter(
    ([key, each]) => key !== "kind" && !isTable(each) && !(Array.isArray(each) && isTable(each[0])),
  );
  const pieces = simple.slice(0, 3).map(([key, each]) => `${key.replaceAll("_", " ")} ${shortValue(each)}`);
  const all = [typeof value.kind === "string" ? value.kind : "", layers, ...pieces].filter(Boolean);
  return all.length > 0 ? verbatim(all.join(", ")) : "default";
}

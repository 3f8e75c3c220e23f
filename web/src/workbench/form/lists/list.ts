// A list of tables: as rows of a table where its tables are flat, else as items that fold.

import { button, fill, h, setText } from "../../../viewer/shared/dom";
import { say } from "../../../viewer/shared/language";
import { defaultPlacement } from "../../model/changes/variants";
import { defaultsFor } from "../../model/defaults";
import { issuesOfList } from "../../model/issues";
import { freeName, takenNames } from "../../model/names";
import { isTable, type Json, listAt, type Path, pathKey, startsWith, type Table } from "../../model/paths";
import type { Node, Part } from "../../model/schema";
import type { FormContext, Widget } from "../context";
import { showIssues } from "../errors";
import { kindChoice, kindText } from "../kind-choice";
import { foldedRows } from "./folded-rows";
import { tableRows } from "./table-rows";

const MAX_COLUMNS = 9;
const FLAT = new Set(["quantity", "number", "integer", "choice", "boolean", "text", "tuple", "factors"]);

/** A list with what adds, copies and removes its items; `bare` without its title. */
export function listWidget(
  ctx: FormContext,
  path: Path,
  of: Node,
  title: string,
  about: string,
  makeItem: (path: Path) => Widget,
  bare = false,
): Widget {
  const names = of.is === "kinds" ? of.parts : of.is === "part" ? [of.part] : [];
  const parts = names.map((name) => ctx.schema.part(name));
  const hasKinds = parts.some((part) => part.kind);
  const messages = h("div", { class: "messages" });
  const count = h("span", { class: "count" });
  const rows = h("div");
  const options = parts.map((part) => h("option", { value: part.name }, kindText(part)));
  const kind = h("select", { "aria-label": say("kind of the new item of {title}", { title }) }, ...options);
  const offersKinds = hasKinds && parts.length > 1;
  // layers are all given by the same keys: one choice for the entire list
  const given = !hasKinds && parts.length > 1 ? listKindChoice(ctx, path, names) : null;
  const one = singular(title);
  let part: Part | null | undefined;
  let shown: Widget = foldedRows(ctx, path, of, makeItem);
  const insert = () => {
    const chosen = offersKinds ? ctx.schema.part(kind.value) : (part ?? parts[0]);
    if (!chosen) return;
    const value = newItem(ctx.data(), path, chosen);
    ctx.change({ edits: [{ op: "add", path, value }], text: say("add {item}", { item: one.toLowerCase() }) });
  };
  const add = button(offersKinds ? "Add" : say("Add {item}", { item: one }), "", insert, "small");
  const hint = h("span", { class: "hint" }, about);
  const head = h("div", { class: "sub-head" }, bare ? hint : h("h4", { title: about }, title, " ", count, hint));
  const foot = h("div", { class: "list-foot" }, offersKinds ? kind : null, add);
  const element = h("div", { class: "list", "data-part": pathKey(path) }, head, given?.element, messages, rows, foot);
  const update = () => {
    const items = listAt(ctx.data(), path);
    const now = hasKinds ? null : ctx.schema.partOf(of, isTable(items[0]) ? items[0] : {});
    if (now !== part) {
      part = now;
      shown = part && isFlat(part) ? tableRows(ctx, path, part) : foldedRows(ctx, path, of, makeItem);
      fill(rows, shown.element);
    }
    setText(count, items.length > 0 ? String(items.length) : "");
    given?.update();
    shown.update();
    showIssues(messages, issuesOfList(ctx.issues(), path), ctx.change);
  };
  const reveal = (target: Path) => {
    if (!startsWith(target, path)) return false;
    if (!shown.reveal(target)) add.focus();
    return true;
  };
  return { element, update, reveal };
}

/** Return one item's name, from the list's: `Columns` to `column`. */
export function singular(title: string): string {
  const lower = title.charAt(0).toLowerCase() + title.slice(1);
  return lower.endsWith("s") && !lower.endsWith("axes") ? lower.slice(0, -1) : lower;
}

function isFlat(part: Part): boolean {
  return part.fields.length <= MAX_COLUMNS && part.fields.every((field) => FLAT.has(field.node.is));
}

/** Return what a new item starts with. */
export function newItem(data: Table, path: Path, part: Part): Table {
  const kind = part.kind ? { kind: part.kind } : {};
  const value: Table = { ...kind, ...defaultsFor(part.name, data), ...defaultPlacement(data, [...path, 0], part) };
  const isNamed = part.fields.some((field) => field.name === "name" && field.needed);
  if (!isNamed && !part.name.endsWith("Support") && part.name !== "Borehole") return value;
  const stems: Record<string, string> = { Column: "C1", Borehole: "BH1" };
  const stem = stems[part.name] ?? `${String(path.at(-1)).replace(/s$/, "")} 1`;
  return { name: freeName(takenNames(data, path), stem), ...value };
}

/** The choice of the keys by which all items of a list are given. */
function listKindChoice(ctx: FormContext, path: Path, names: readonly string[]): Widget {
  return kindChoice(ctx, [...path, 0], names, (from, to) => {
    const old = listAt(ctx.data(), path);
    if (from) ctx.memory.set(pathKey([...path, from.name]), { items: old });
    const known = ctx.memory.get(pathKey([...path, to.name]))?.items;
    const isKnown = Array.isArray(known) && known.length === old.length;
    const value: Json = isKnown ? known : old.map(() => defaultsFor(to.name, ctx.data()));
    ctx.change({ edits: [{ op: "set", path, value }], text: say("define layers by {kind}", { kind: kindText(to) }) });
  });
}

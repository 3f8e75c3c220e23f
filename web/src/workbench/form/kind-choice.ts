// The choice between the kinds of a table.
import { h, newId, setOptions, setText } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import { switchGround } from "../model/changes/ground";
import { switchKind } from "../model/changes/variants";

import { titleAt } from "../model/items";
import { type Path, pathKey, samePath, tableAt } from "../model/paths";
import type { Part } from "../model/schema";
import type { FormContext, Widget } from "./context";
import { inputWidget } from "./inputs/inputs";

/** `change` is called with the kind that is chosen; by default the table at the path becomes of that kind. */
export function kindChoice(
  ctx: FormContext,
  path: Path,
  names: readonly string[],
  change: (from: Part | null, to: Part) => void = (from, to) => {
    const data = ctx.data();
    const isGround = samePath(path, ["ground"]);
    const { edits, notice } = isGround
      ? switchGround(data, from, to, ctx.memory)
      : { edits: switchKind(data, path, from, to, ctx.memory), notice: "" };
    if (edits.length > 0)
      ctx.change({
        edits,
        text: say("change {item} to {kind}", { item: titleAt(ctx.data(), path), kind: kindText(to) }),
      });
    if (notice) ctx.notify?.(notice);
  },
): Widget {
  const parts = names.map((name) => ctx.schema.part(name));
  const hasKinds = parts.some((part) => part.kind);
  const own: Path = [...path, "kind"];
  const messages = h("div", { class: "messages", id: newId("issue") });
  const select = h("select", { id: newId("input"), "aria-describedby": messages.id });
  const hint = h("span", { class: "hint" });
  const label = h("label", { class: "label needed", for: select.id }, hasKinds ? "kind" : "defined by");
  const element = h("div", { class: "field kind", "data-path": pathKey(own) }, label, select, hint, messages);
  select.addEventListener("change", () => {
    const to = parts.find((part) => part.name === select.value);
    const from = ctx.schema.chooseKind(names, tableAt(ctx.data(), path));
    if (to && to !== from) change(from, to);
  });
  const update = () => {
    const table = tableAt(ctx.data(), path);
    const chosen = ctx.schema.chooseKind(names, table);
    const unknown = ["", typeof table.kind === "string" ? verbatim(table.kind) : "choose …"] as const;
    const options = parts.map((part) => [part.name, kindText(part)] as const);
    setOptions(select, chosen ? options : [unknown, ...options]);
    select.value = chosen?.name ?? "";
    setText(hint, chosen ? kindHint(chosen) : "");
  };
  return inputWidget(ctx, own, { element: select, focus: select, update }, element, messages);
}

/** Return what a kind is called in a choice. */
export function kindText(part: Part): string {
  return part.kind || part.fields.flatMap((field) => (field.needed ? [field.name] : [])).join(", ");
}

function kindHint(part: Part): string {
  return part.fields.find((field) => field.node.is === "tag")?.hint ?? part.about;
}

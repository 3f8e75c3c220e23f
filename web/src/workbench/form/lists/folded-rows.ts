// The items of a list that fold, each with a summary.
import { h, setRead, setText } from "../../../viewer/shared/dom";
import { verbatim } from "../../../viewer/shared/language";
import { issueCount, issuesAt } from "../../model/issues";
import { titleAt } from "../../model/items";
import { listAt, type Path, pathKey, tableAt } from "../../model/paths";
import type { Node } from "../../model/schema";
import type { FormContext, Widget } from "../context";
import { summaryOf } from "../labels";
import { itemButtons } from "./item-buttons";

export function foldedRows(ctx: FormContext, path: Path, of: Node, makeItem: (path: Path) => Widget): Widget {
  const element = h("div", { class: "items" });
  const items: Widget[] = [];
  const update = () => {
    const count = listAt(ctx.data(), path).length;
    while (items.length > count) items.pop()?.element.remove();
    while (items.length < count) {
      const item = foldedItem(ctx, [...path, items.length], of, makeItem);
      items.push(item);
      element.append(item.element);
    }
    for (const item of items) item.update();
  };
  const reveal = (target: Path) => items[Number(target[path.length])]?.reveal(target) ?? false;
  return { element, update, reveal };
}

function foldedItem(ctx: FormContext, path: Path, of: Node, makeItem: (path: Path) => Widget): Widget {
  const title = h("span", { class: "item-title" });
  const attributes = { class: "item", "data-item": pathKey(path) };
  const folded = foldedWidget(
    ctx,
    path,
    attributes,
    [title],
    () => makeItem(path),
    () => {
      const table = tableAt(ctx.data(), path);
      const summary = summaryOf(table, ctx.schema.partOf(of, table));
      setText(title, summary ? verbatim(summary) : titleAt(ctx.data(), path));
    },
  );
  // beside the summary, which is a button itself and must hold no others
  const buttons = h("span", { class: "item-buttons" }, ...itemButtons(ctx, path));
  return { ...folded, element: h("div", { class: "item-row" }, folded.element, buttons) };
}

/** A part that folds, with a badge of its issues in its head; what is inside is made when it is first opened. */
export function foldedWidget(
  ctx: FormContext,
  path: Path,
  attributes: Record<string, string | boolean>,
  before: readonly HTMLElement[],
  makeBody: () => Widget,
  updateHead: () => void,
): Widget & { element: HTMLDetailsElement } {
  const badge = h("span", { class: "badge" });
  const element = h("details", attributes, h("summary", {}, ...before, badge));
  let body: Widget | null = null;
  const build = () => {
    if (!element.open || body) return;
    body = makeBody();
    element.append(body.element);
    body.update();
  };
  element.addEventListener("toggle", build);
  const update = () => {
    updateHead();
    const count = issuesAt(ctx.issues(), path).length;
    setText(badge, count > 0 ? String(count) : "");
    setRead(badge, "title", issueCount(count));
    if (body) body.update();
    else build();
  };
  const reveal = (target: Path) => {
    element.open = true;
    build();
    return body?.reveal(target) ?? false;
  };
  return { element, update, reveal };
}

// Why tools and actions can do nothing now, in words for users.
import { say, verbatim } from "../../../viewer/shared/language";
import type { Store } from "../../client/store";
import { tablesAt, whyNotCopied } from "../../model/changes/copies";
import type { Item } from "../../model/items";
import { listAt, type Path } from "../../model/paths";
import type { GeneratorName } from "../generators/generator";
import type { ToolName } from "../tools";
import type { ActionName } from "./forms";

export type SelectionAction = ActionName | "duplicate" | "remove";

/** Why nothing can be changed while the text cannot be read. */
export const TEXT_FIRST = "Correct the text first.";

const ONE_SLAB: Partial<Record<SelectionAction, string>> = {
  array: "There is one slab. Draw further plates to have more.",
  duplicate: "There is one slab. Draw further plates to have more.",
  remove: "The slab itself cannot be removed. Choose Slab (B) to redraw it.",
};
/** Tools that need no slab. */
const WITHOUT_SLAB: ReadonlySet<ToolName | GeneratorName> = new Set(["select", "slab", "axes"]);

/** Return why an item cannot be moved by itself. */
export function whyFixed(item: Item): string {
  if (item.kind === "slab")
    return "A rectangle defined by its side lengths is centered on the origin. Drag its edges, or convert it to a polygon to move it.";
  if (item.kind === "joint") return "It is where its plates meet and moves with them.";
  if (item.kind === "load") {
    const { wall, core, column } = item.table;
    const [host] = [
      ...(wall ? [say("wall {name}", { name: verbatim(String(wall)) })] : []),
      ...(core ? [say("core {name}", { name: verbatim(String(core)) })] : []),
      say("column {name}", { name: verbatim(String(column)) }),
    ];
    return say("It is attached to {host} and moves with it.", { host });
  }
  if (item.kind === "wall") return "It stands along the slab's edge and moves with it.";
  return "It cannot be moved right now.";
}

/** Return why an action can do nothing with what is selected, items of which are drawn; empty if it can. */
export function whyNotDone(store: Store, items: readonly Item[], action: SelectionAction): string {
  const { data, selected } = store;
  if (store.broken) return TEXT_FIRST;
  if (selected.every(isSlab)) return ONE_SLAB[action] ?? "";
  if (action === "duplicate" || action === "remove") return "";
  const [first] = items;
  if (!first) return selected.every(isLoad) ? "It acts on the entire slab, without a position on the plan." : "";
  if (action === "array") return whyNotCopied(tablesAt(data, selected)) ? whyFixed(first) : "";
  // forces of loads on columns turn, though not their places
  const isFixed = items.every(({ movable, kind }) => !movable && (action === "move" || kind !== "load"));
  return isFixed ? whyFixed(first) : "";
}

/** Return why a tool or a generator can do nothing now, empty if it can. */
export function whyNotDrawn(store: Store, hasSlab: boolean, name: ToolName | GeneratorName): string {
  if (name === "select") return "";
  if (store.broken) return TEXT_FIRST;
  if (!hasSlab && !WITHOUT_SLAB.has(name)) return "Draw the slab first.";
  const isAlone = name === "joint" && listAt(store.data, ["plates"]).length === 0;
  return isAlone ? "Draw a further plate first: joints are where two plates meet." : "";
}

const isLoad = ([list]: Path) => list === "loads";

/** Whether a path is of the slab itself, not of its openings and zones. */
function isSlab(path: Path): boolean {
  return path[0] === "plate" && path.length < 3;
}

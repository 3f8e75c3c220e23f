// What is done with the selected items: moved, turned, mirrored, repeated, duplicated, copied, pasted, removed.
import { counted, say } from "../../../viewer/shared/language";
import type { Store } from "../../client/store";
import {
  type Additions,
  addCopies,
  type ListedTable,
  tablesAt,
  transformItems,
  whyNotCopied,
} from "../../model/changes/copies";
import { applyOptimistic } from "../../model/changes/optimistic-edits";
import { removeItems } from "../../model/changes/references";
import { Impossible } from "../../model/changes/transform";
import type { Change } from "../../model/edits";
import type { Point } from "../../model/geometry";
import { type Isometry, translation } from "../../model/isometry";
import { boundsOfItems, type Item, itemsOf, titleOfAll } from "../../model/items";
import { pathKey, sameValue, type Table } from "../../model/paths";
import { readTables, writeTables } from "../../model/toml";
import type { Canvas } from "../canvas";
import type { ActionField, Values } from "../fields";
import { casesToChoose, type Generator } from "../generators/generator";
import { type ActionForm, FORMS } from "./forms";
import { type SelectionAction, whyNotDone } from "./why-not";

export class Actions {
  constructor(
    private readonly canvas: Canvas,
    private readonly store: Store,
    private readonly push: (change: Change) => void,
    private readonly showHint: (text: string) => void,
  ) {}

  /** Return the change that an action makes of the selection, or a generator of nothing; throws Impossible. */
  plan(form: ActionForm | Generator, values: Values): Additions {
    const { data, selected } = this.store;
    if ("generate" in form) return form.generate(data, values);
    const center = middleOf(this.canvas.selectedItems);
    const { isometries, copies } = form.plan(values, center);
    const title = titleOfAll(data, selected);
    if (!copies) {
      const change = transformItems(data, selected, isometries[0]!, form.label.toLowerCase());
      return { change, paths: [...selected] };
    }
    const tables = tablesAt(data, selected);
    const why = whyNotCopied(tables);
    if (why) throw new Impossible(why);
    const what = { action: form.name, items: title };
    const text = counted(isometries.length, "{action}: copy {items}", "{action}: {count} copies of {items}", what);
    return addCopies(data, tables, isometries, text);
  }

  /** Return the items that a change makes or moves. */
  preview(change: Change): Item[] {
    const { data, doc } = this.store;
    const before = new Map(this.canvas.items.map((item) => [pathKey(item.path), item]));
    const after = change.edits.reduce<Table>((state, edit) => applyOptimistic(state, edit), data);
    return itemsOf(after, doc?.plan ?? null).filter((item) => {
      const old = before.get(pathKey(item.path));
      return !old || !sameValue(geometryOf(old), geometryOf(item));
    });
  }

  /** Make a change, and select what it is about. */
  make({ change, paths }: Additions): void {
    if (this.store.broken) return;
    this.push(change);
    this.store.selectAll(paths);
  }

  /** Add copies of the selected items beside them; loads on columns stand where they do. */
  duplicate(): void {
    const { data, selected } = this.store;
    const tables = tablesAt(data, selected);
    if (tables.length === 0) return;
    this.addCopiesAt(tables, this.besides(), say("duplicate {items}", { items: titleOfAll(data, selected) }));
  }

  /** Return the load cases to choose from, and the one that new loads are in. */
  casesFor({ imposed }: ActionField): { all: string[]; active: string } {
    const all = casesToChoose(this.store.data, imposed);
    return { all, active: all.includes(this.canvas.loadCase) ? this.canvas.loadCase : all[0]! };
  }

  /** Return why an action can do nothing with what is selected, empty if it can. */
  whyNot(action: SelectionAction): string {
    return whyNotDone(this.store, this.canvas.selectedItems, action);
  }

  remove(): void {
    const paths = this.store.selected.filter((path) => path[0] !== "plate" || path.length > 2);
    const why = this.store.selected.length > 0 ? this.whyNot("remove") : "";
    if (why) this.showHint(why);
    if (paths.length === 0 || why) return;
    this.push(removeItems(this.store.data, paths));
    this.store.select(null);
    this.canvas.element.focus({ preventScroll: true }); // the button that was pressed is gone
  }

  /** Return the selected tables as text for the clipboard, empty if none can be copied. */
  copy(): string {
    const tables = tablesAt(this.store.data, this.store.selected);
    if (tables.length > 0)
      this.showHint(say("{items} copied.", { items: titleOfAll(this.store.data, this.store.selected) }));
    return writeTables(tables);
  }

  /** Add the tables of a text from the clipboard, about a place or beside where they were; returns whether it has any. */
  paste(text: string, at: Point | null): boolean {
    const tables = readTables(text);
    if (!tables || tables.length === 0 || this.store.broken) return false;
    const pasted = tables.reduce<Table>(
      (data, { list, table }) => applyOptimistic(data, { op: "add", path: list, value: table }),
      {},
    );
    const placed = itemsOf(pasted, null);
    const center = middleOf(placed);
    const shift = at && placed.length > 0 ? translation([at[0] - center[0], at[1] - center[1]]) : this.besides();
    const title = titleOfAll(pasted, pathsOf(tables));
    return this.addCopiesAt(tables, shift, say("paste {items}", { items: title }));
  }

  private addCopiesAt(tables: readonly ListedTable[], shift: Isometry, text: string): boolean {
    try {
      this.make(addCopies(this.store.data, tables, [shift], text));
    } catch (error) {
      if (!(error instanceof Impossible)) throw error;
      this.showHint(say("Cannot copy: {why}.", { why: error.message }));
    }
    return true;
  }

  private besides(): Isometry {
    return translation([this.canvas.step * 2, this.canvas.step * 2]);
  }
}

/** Return the form of a key, null if none has it. */
export function formForKey(key: string): ActionForm | null {
  return FORMS.find((form) => form.key === key.toUpperCase()) ?? null;
}

function pathsOf(tables: readonly ListedTable[]) {
  const counts = new Map<string, number>();
  return tables.map(({ list }) => {
    const key = pathKey(list);
    const n = counts.get(key) ?? 0;
    counts.set(key, n + 1);
    return [...list, n];
  });
}

function geometryOf({ geometry, foot }: Item) {
  return JSON.stringify([{ ...geometry, at: null }, foot]);
}

/** Return the middle of the rectangle around some items; the origin if there are none. */
export function middleOf(items: readonly Item[]): Point {
  const [x0, y0, x1, y1] = boundsOfItems(items) ?? [0, 0, 0, 0];
  return [(x0 + x1) / 2, (y0 + y1) / 2];
}

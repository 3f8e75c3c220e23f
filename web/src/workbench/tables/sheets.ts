// The tables: one for each list of the case file that engineers keep in spreadsheets, and for each kind in it.
import { sectionTitle } from "../form/form-panel";
import { isTable, listAt, type Path, type Table } from "../model/paths";
import type { Part, Schema } from "../model/schema";

export interface Sheet {
  /** Its key among all of them. */
  readonly id: string;
  /** The key of its list at the top of the file. */
  readonly list: string;
  readonly part: Part;
  /** The list's title: `Loads`. */
  readonly group: string;
  /** Its own: `point loads`. */
  readonly title: string;
}

const LISTS = ["columns", "walls", "beams", "loads", "cases", "combinations", "supports", "boreholes"];

/**
 * Return all tables.
 *
 * Items of several kinds are one table for each kind: the kinds share few keys, so that a common table would be mostly
 * empty, and spreadsheets keep them apart as well.
 */
export function sheetsOf(schema: Schema): Sheet[] {
  const { fields } = schema.part("");
  return LISTS.flatMap((list) => {
    const node = fields.find((field) => field.name === list)?.node;
    const of = node?.is === "list" ? node.of : null;
    const names = of?.is === "kinds" ? of.parts : of?.is === "part" ? [of.part] : [];
    const group = sectionTitle(list);
    return names.map((name): Sheet => {
      const part = schema.part(name);
      const title = part.kind ? `${part.kind} ${group.toLowerCase()}` : group;
      return { id: `${list} ${part.kind}`.trim(), list, part, group, title };
    });
  });
}

/** Return the positions of a table's items in their list. */
export function positionsIn(data: Table, { list, part }: Sheet): number[] {
  return listAt(data, [list]).flatMap((item, n) =>
    isTable(item) && (part.kind === "" || item.kind === part.kind) ? [n] : [],
  );
}

/** Return the table that shows the item at a path, or a value within it. */
export function sheetAt(sheets: readonly Sheet[], data: Table, path: Path): Sheet | null {
  const [list, position] = path;
  const item = typeof position === "number" ? listAt(data, [list as string])[position] : undefined;
  if (!isTable(item)) return null;
  return (
    sheets.find((sheet) => sheet.list === list && (sheet.part.kind === "" || sheet.part.kind === item.kind)) ?? null
  );
}

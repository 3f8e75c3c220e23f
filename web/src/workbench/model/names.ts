// Names in lists of tables, such as columns and load cases.
import { isTable, type Json, listAt, type Path, type Table } from "./paths";

/** Return the names in a list of tables. */
export function namesIn(list: readonly Json[]): string[] {
  return list.flatMap((each) => (isTable(each) && typeof each.name === "string" && each.name ? [each.name] : []));
}

/** Lists whose items are not called the same either: their names stand side by side in plans and reports. */
const APART = ["columns", "boreholes"];

/** Return the names that a new item of a list cannot have. */
export function takenNames(data: Table, list: Path): string[] {
  const lists = list.length === 1 && APART.includes(String(list[0])) ? APART.map((each): Path => [each]) : [list];
  return lists.flatMap((each) => namesIn(listAt(data, each)));
}

/** Return a name like `first` that is not taken: its number grows. */
export function freeName(taken: readonly string[], first: string): string {
  if (!taken.includes(first)) return first;
  const [, stem = `${first} `, from = 2] = /^(.*?)(\d+)$/.exec(first) ?? [];
  let number = Number(from);
  while (taken.includes(`${stem}${number}`)) number += 1;
  return `${stem}${number}`;
}

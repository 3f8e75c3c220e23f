// Names in lists of tables, such as columns and load cases.
import { isTable, type Json } from "./paths";

/** Return the names in a list of tables. */
export function namesIn(list: readonly Json[]): string[] {
  return list.flatMap((each) => (isTable(each) && typeof each.name === "string" && each.name ? [each.name] : []));
}

/** Return a name like `first` that is not taken: its number grows. */
export function freeName(taken: readonly string[], first: string): string {
  if (!taken.includes(first)) return first;
  const [, stem = `${first} `, from = 2] = /^(.*?)(\d+)$/.exec(first) ?? [];
  let number = Number(from);
  while (taken.includes(`${stem}${number}`)) number += 1;
  return `${stem}${number}`;
}

// What is known of a field: its meaning, unit, range and default, from the schema of the case file.
import { either, say, translate } from "../../viewer/shared/language";
import { defaultText, hintOf, labelOf } from "../form/labels";
import { type Json, type Path, type Table, valueAt } from "../model/paths";
import { exampleOf, type Field, type Node, type Part, type Schema } from "../model/schema";

/** A field of the case file, and the part that it is in. */
export interface FieldAt {
  field: Field;
  part: Part | null;
}

/** Return the field at a path, null if the schema knows none. */
export function findField(schema: Schema, data: Table, path: Path): FieldAt | null {
  const key = path.findLastIndex((step) => typeof step === "string");
  const found = key < 0 ? null : schema.nodeAt(path.slice(0, key + 1), data);
  if (!found?.field) return null;
  const above = path.slice(0, key);
  const outer = schema.nodeAt(above, data);
  const table = valueAt(data, above);
  const isTable = typeof table === "object" && table !== null && !Array.isArray(table);
  return { field: found.field, part: outer ? schema.partOf(outer.node, isTable ? (table as Table) : {}) : null };
}

/** Return what a field is called. */
export function titleOf({ field }: FieldAt): string {
  return labelOf(field) || field.name;
}

/** Return the meaning of a field as a sentence, and what its part is where it is the part's kind. */
export function meaningOf({ field, part }: FieldAt): string {
  const text = translate(field.node.is === "tag" && part ? part.about : field.hint);
  const sentence = text.charAt(0).toUpperCase() + text.slice(1);
  return sentence && !/[.?!]$/.test(sentence) ? `${sentence}.` : sentence;
}

/** Return the facts about a field, each with its name. */
export function factsOf({ field }: FieldAt, data: Table): [name: string, value: string][] {
  const { node } = field;
  const facts: [string, string][] = [[node.is === "quantity" ? "unit" : "value", kindOfValue(node, data)]];
  if (field.range && hintOf(field) !== field.hint) facts.push(["range", field.range]);
  facts.push(["default", field.needed ? "none (required)" : writtenDefault(field.default)]);
  return facts.filter(([, value]) => value !== "");
}

function writtenDefault(value: Json | undefined): string {
  return typeof value === "boolean" ? String(value) : defaultText(value);
}

/** Return what values a field takes: a dimension with an example, words, a number. */
function kindOfValue(node: Node, data: Table): string {
  switch (node.is) {
    case "quantity":
      return either([
        say("{dimension}, such as {example}", { dimension: node.dimension, example: exampleOf(node, data) }),
        ...node.options,
      ]);
    case "choice":
      return node.options.join(", ");
    case "choices":
      return say("any of {options}", { options: node.options.join(", ") });
    case "number":
      return either(["number", ...node.options]);
    case "integer":
      return either(["whole number", ...node.options]);
    case "boolean":
      return "true or false";
    case "tuple":
      return say("{count} values: {values}", { count: node.length, values: kindOfValue(node.each, data) });
    case "values":
    case "points":
      return say("list: {values}", { values: kindOfValue(node.each, data) });
    case "factors":
      return "a number for each load case";
    default:
      return "";
  }
}

/** Return the anchor of a field in the reference of the input: its keys, then the kinds of the tables above it. */
export function anchorOf(data: Table, path: Path): string {
  const keys = path.filter((step) => typeof step === "string");
  const kinds = path.flatMap((_, n) => {
    const kind = valueAt(data, [...path.slice(0, n), "kind"]);
    return n > 0 && typeof kind === "string" ? [kind.replaceAll(" ", "-")] : [];
  });
  return ["key", ...keys, ...kinds].join("-");
}

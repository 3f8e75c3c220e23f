// The JSON schema of the case file, read into what a form needs of it.

import { say } from "../../viewer/shared/language";
import { isTable, type Json, listAt, type Table, tableAt } from "./paths";

/** What a value is, and so which element edits it. */
export type Node =
  | { is: "quantity"; dimension: string; examples: readonly string[]; options: readonly string[] }
  | { is: "number"; options: readonly string[] }
  | { is: "integer"; options: readonly string[] }
  | { is: "choice"; options: readonly string[] }
  | { is: "boolean" }
  | { is: "text" }
  | { is: "tag"; value: string }
  | { is: "tuple"; each: Node; length: number; members: readonly string[] }
  | { is: "points"; each: Node }
  | { is: "values"; each: Node }
  | { is: "choices"; options: readonly string[] }
  | { is: "factors" }
  | { is: "part"; part: string }
  | { is: "kinds"; parts: readonly string[] }
  | { is: "list"; of: Node; least: number };

/** One key of a part. */
export interface Field {
  name: string;
  node: Node;
  symbol: string;
  hint: string;
  range: string;
  needed: boolean;
  default: Json | undefined;
  /** The values of other keys with which alone it means something. */
  onlyIf: Table;
}

/** A table of the case file: its keys. */
export interface Part {
  name: string;
  about: string;
  /** The value of `kind`, empty where the part has none. */
  kind: string;
  fields: readonly Field[];
}

/** All parts of a schema, by name; "" is the file itself. */
export class Schema {
  private readonly parts = new Map<string, Part>();

  constructor(private readonly root: Table) {}

  /** The part of a name, "" for the file itself. */
  part(name: string): Part {
    const known = this.parts.get(name);
    if (known) return known;
    const definitions = isTable(this.root.definitions) ? this.root.definitions : {};
    const source = name === "" ? this.root : definitions[name];
    const part = readPart(name, isTable(source) ? source : {});
    this.parts.set(name, part);
    return part;
  }

  /** The part that a table is out of several: by its kind, else by its keys; null if its kind is none of them. */
  chooseKind(parts: readonly string[], table: Table): Part | null {
    const all = parts.map((name) => this.part(name));
    if (all.some((part) => part.kind)) return all.find((part) => part.kind === table.kind) ?? null;
    const score = (part: Part) => part.fields.filter((field) => field.name in table).length;
    return all.reduce<Part | null>((best, part) => (best && score(best) >= score(part) ? best : part), null);
  }

  /** The node at a path in the file, null if the schema knows none. */
  nodeAt(path: readonly (string | number)[], data: Json): { node: Node; field: Field | null } | null {
    let node: Node = { is: "part", part: "" };
    let field: Field | null = null;
    let value: Json | undefined = data;
    for (const step of path) {
      if (typeof step === "number") {
        if (node.is === "list") node = node.of;
        else if (node.is === "tuple" || node.is === "values" || node.is === "points") node = node.each;
        else return null;
        value = Array.isArray(value) ? value[step] : undefined;
        continue;
      }
      const part: Part | null = this.partOf(node, isTable(value) ? value : {});
      field = part?.fields.find((each) => each.name === step) ?? null;
      if (!field) return null;
      node = field.node;
      value = isTable(value) ? value[step] : undefined;
    }
    return { node, field };
  }

  /** The part that a node holds for a table, null if it holds none. */
  partOf(node: Node, table: Table): Part | null {
    if (node.is === "part") return this.part(node.part);
    return node.is === "kinds" ? this.chooseKind(node.parts, table) : null;
  }
}

/** Return why a field means nothing in a table of a part, empty if it means something. */
export function whyIdle(part: Part, field: Field, table: Table): string {
  const needed = Object.entries(field.onlyIf).find(([key, value]) => {
    const other = part.fields.find(({ name }) => name === key);
    return (table[key] ?? other?.default) !== value;
  });
  return needed ? say("Only where {field} is {value}.", { field: needed[0], value: String(needed[1]) }) : "";
}

function readPart(name: string, source: Table): Part {
  const properties = isTable(source.properties) ? source.properties : {};
  // of keys one of which follows from the other, those that are usually given
  const usual = listAt(source, ["allOf"]).flatMap((choice) => listAt(choice, ["anyOf", 0, "required"]));
  const needed = [...listAt(source, ["required"]), ...usual];
  const fields = Object.entries(properties).flatMap(([key, value]) =>
    isTable(value) ? [readField(key, value, needed.includes(key))] : [],
  );
  const tag = fields.find((field) => field.node.is === "tag");
  return { name, about: text(source.description), kind: tag?.node.is === "tag" ? tag.node.value : "", fields };
}

function readField(name: string, source: Table, needed: boolean): Field {
  const symbol = text(source["x-symbol"]);
  const about = text(source.description);
  const hint = symbol && about.startsWith(`${symbol}: `) ? about.slice(symbol.length + 2) : about;
  const items = isTable(source.items) ? source.items : {};
  const own = valueSchema(source);
  const range = text(own["x-range"]) || text(items["x-range"]) || rangeOf(own);
  const onlyIf = tableAt(source, ["x-only-if"]);
  return { name, node: readNode(source), symbol, hint, range, needed, default: source.default, onlyIf };
}

/** Return an example of a quantity in the units of the file: the first is in SI units, the last in those customary in the United States. */
export function exampleOf(node: Node, data: Table): string {
  if (node.is !== "quantity") return "";
  const isCustomary = isTable(data.project) && data.project.units === "US";
  return node.examples.at(isCustomary ? -1 : 0) ?? "";
}

function text(value: Json | undefined): string {
  return typeof value === "string" ? value : "";
}

function strings(value: Json | undefined): string[] {
  return Array.isArray(value) ? value.filter((each) => typeof each === "string") : [];
}

function reference(value: Json | undefined): string | null {
  const target = isTable(value) ? text(value.$ref) : "";
  return target.startsWith("#/definitions/") ? target.slice("#/definitions/".length) : null;
}

/** The schema of a value that may be a word instead, else the schema itself. */
function valueSchema(source: Table): Table {
  const first = Array.isArray(source.anyOf) ? source.anyOf[0] : source;
  return isTable(first) ? first : source;
}

function readNode(source: Table): Node {
  const own = reference(source) ?? (Array.isArray(source.allOf) ? reference(source.allOf[0]) : null);
  if (own !== null) return { is: "part", part: own };
  if (Array.isArray(source.oneOf)) {
    return { is: "kinds", parts: source.oneOf.flatMap((each) => reference(each) ?? []) };
  }
  if (typeof source.const === "string") return { is: "tag", value: source.const };
  if (Array.isArray(source.enum)) return { is: "choice", options: strings(source.enum) };
  if (Array.isArray(source.anyOf)) {
    const options = source.anyOf.flatMap((each) => (isTable(each) ? strings(each.enum) : []));
    const node = readNode(valueSchema(source));
    return node.is === "quantity" || node.is === "number" || node.is === "integer" ? { ...node, options } : node;
  }
  switch (source.type) {
    case "array":
      return readArray(source);
    case "object":
      return { is: "factors" };
    case "boolean":
      return { is: "boolean" };
    case "integer":
      return { is: "integer", options: [] };
    case "number":
      return { is: "number", options: [] };
    default:
      return typeof source["x-dimension"] === "string"
        ? { is: "quantity", dimension: source["x-dimension"], examples: strings(source.examples), options: [] }
        : { is: "text" };
  }
}

function readArray(source: Table): Node {
  const each = isTable(source.items) ? readNode(source.items) : ({ is: "text" } as const);
  if (each.is === "part" || each.is === "kinds") return { is: "list", of: each, least: number(source.minItems) ?? 0 };
  if (each.is === "choice" && source.uniqueItems === true) return { is: "choices", options: each.options };
  const length = number(source.maxItems);
  const members = strings(source["x-members"]);
  if (length !== null && length === number(source.minItems)) return { is: "tuple", each, length, members };
  return each.is === "tuple" ? { is: "points", each } : { is: "values", each };
}

function number(value: Json | undefined): number | null {
  return typeof value === "number" ? value : null;
}

function rangeOf(source: Table): string {
  const signs = [
    ["exclusiveMinimum", ">"],
    ["minimum", "≥"],
    ["exclusiveMaximum", "<"],
    ["maximum", "≤"],
  ] as const;
  return signs
    .flatMap(([key, sign]) => {
      const limit = number(source[key]);
      return limit === null || limit === 2147483647 ? [] : [`${sign} ${limit}`];
    })
    .join(", ");
}

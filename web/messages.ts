// Finds the messages in the sources of a page: the texts that people read, with {name} where something is put in.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { parseSync } from "vite";

interface Node {
  type: string;
  [key: string]: unknown;
}

const words = (text: string): ReadonlySet<string> => new Set(text.trim().split(/\s+/));

/** Properties and variables whose strings are read, even if they are single words. */
const READ = words("title aria-label placeholder label hint text word words note meaning textContent");
/** Properties whose strings are for the program. */
const INTERNAL = words(`
  class className id type role key name kind op is style href rel target for value d points transform list path below
  method headers fill stroke font viewBox initial
`);
/** Functions whose strings are for the program. */
const CODE = words(`
  querySelector querySelectorAll closest matches addEventListener removeEventListener getElementById getAttribute
  removeAttribute hasAttribute toggleAttribute createElement createElementNS getContext setProperty getPropertyValue
  newId on add remove toggle contains startsWith endsWith includes split join indexOf replace replaceAll RegExp svg fetch
  matchMedia URL postMessage part partNamed line path freeName defaultsFor verbatim RangeError
`);
/** Functions whose strings are read, even if they are single words; how many arguments before them are not. */
const SHOWING: Readonly<Record<string, number>> = {
  h: 1,
  button: 0,
  setText: 1,
  setRead: 2,
  translate: 0,
  force: 1,
  length: 1,
  count: 1,
  angle: 1,
  makeIconButton: 1,
};
/** Functions that messages with named holes are said by: which of their arguments these are. */
const SAYING = new Map<string, readonly [number, number]>([
  ["say", [0, 1]],
  ["counted", [1, 3]],
  ["refuse", [0, 1]],
]);
const HOLES = /\{\w+\}/g;
/** Files without messages: pictures with letters, values that new items begin with, selectors. */
const SILENT =
  /renderer\/|help\/(drawings|figure)\.ts|model\/defaults\.ts|shared\/(language|palette|theme)\.ts|controls\/focus\.ts/;
/** What looks like a message: quantities, paths and transformations of SVG, parts of the schema, names of headers. */
const OTHERS =
  /^[\d.]+ \S+$|^M\{|^(translate|rotate|matrix)\(|^[A-Z][a-z]+([A-Z][a-z]+)+$|^Content-|^groundslab |^\w+ = |^[0-9a-f]{6} /;
/** The same: classes of elements, and what only the program reads. */
const NO_MESSAGES: ReadonlySet<string> = new Set([
  ...[
    "ACI 318",
    "Vlasov",
    "axis-label middle",
    "band crossing",
    "chain-length middle",
    "dimension end",
    "dimension middle",
    "dx",
  ],
  ...["dy", "entry folder", "field tall", "figure too-large", "grid fine", "groundslab", "label needed", "label {}"],
  ...["line bad", "main", "plates {}", "slab.toml", "tip end", "verdict bad", "verdict doubtful", "{} kN"],
  ...["{}{} – groundslab", "factor of {}", "factor {}", "point {} {}"],
]);
/** Single words that are read, where nothing near them tells. */
const SINGLE = words(`
  bottom contact content corner difference end entities errors extremes ground labels layer middle now output range
  single supports top value values variable zones e.g. solve duplicate certificate certified constants required tilt
  steps storeys envelope building reinforcement mesh checks strips points joints beams walls
`);

/** Return the messages in the sources of some folders, sorted. */
export function messagesOf(folders: readonly string[]): string[] {
  const files = folders.flatMap((folder) =>
    readdirSync(folder, { recursive: true, encoding: "utf8" }).map((name) => join(folder, name).replaceAll("\\", "/")),
  );
  const sources = files.filter((file) => file.endsWith(".ts") && !SILENT.test(file));
  return [...new Set(sources.flatMap((file) => messagesIn(readFileSync(file, "utf8"), file)))].sort();
}

/** Return the messages in a source. */
export function messagesIn(source: string, name = "source.ts"): string[] {
  const found: string[] = [];
  walk(parseSync(name, source).program, false, found);
  return found;
}

/** Gather the messages in a node; `isRead`: whether its strings are read whatever they look like. */
function walk(node: unknown, isRead: boolean, found: string[]): void {
  if (Array.isArray(node)) return node.forEach((each) => void walk(each, isRead, found));
  if (!isNode(node) || /^(TS(?!As|NonNull|Satisfies)|Import|ExportAll)/.test(node.type)) return;
  const templates = SAYING.get(node.type === "CallExpression" ? String((node.callee as Node).name) : "");
  if (templates) {
    const all = node.arguments as Node[];
    found.push(
      ...all
        .slice(...templates)
        .flatMap(stringsOf)
        .filter((each) => /\p{L}/u.test(each.replace(HOLES, ""))),
    );
    return walk(all.slice(templates[1]), false, found);
  }
  const string = stringOf(node);
  if (string !== null && isMessage(string, isRead)) found.push(string.trim());
  for (const [child, isChildRead] of childrenOf(node, isRead)) walk(child, isChildRead, found);
}

/** Return the nodes within a node whose strings may be read, and whether they are. */
function childrenOf(node: Node, isRead: boolean): [unknown, boolean][] {
  switch (node.type) {
    case "TemplateLiteral":
      return (node.expressions as Node[]).filter((each) => stringsOf(each).length === 0).map((each) => [each, false]);
    case "BinaryExpression":
      return [node.left, node.right]
        .filter((each) => node.operator === "+" || !isString(each))
        .map((each) => [each, false]);
    case "SwitchCase":
      return [[node.consequent, false]];
    case "MemberExpression":
      return [[node.object, false], ...(isString(node.property) ? [] : [[node.property, false] as [unknown, boolean]])];
    case "Property":
    case "PropertyDefinition":
    case "VariableDeclarator":
      return valueParts(nameOf(node.key ?? node.id), node.value ?? node.init);
    case "AssignmentExpression":
      return valueParts(nameOf(node.left), node.right);
    case "CallExpression":
    case "NewExpression":
      return argumentsOf(node);
    case "ConditionalExpression":
      return [
        [node.test, false],
        [[node.consequent, node.alternate], isRead],
      ];
    case "LogicalExpression":
      return [[[node.left, node.right], isRead]];
    case "ArrayExpression":
      return [[node.elements, isRead]];
    case "TSAsExpression":
    case "TSNonNullExpression":
    case "TSSatisfiesExpression":
      return [[node.expression, isRead]];
    default:
      return Object.entries(node).map(([key, child]) => [key === "typeAnnotation" ? null : child, false]);
  }
}

function valueParts(name: string, value: unknown): [unknown, boolean][] {
  return INTERNAL.has(name) && isString(value) ? [] : [[value, READ.has(name)]];
}

function argumentsOf({ callee, arguments: all }: Node): [unknown, boolean][] {
  const [name, given] = [nameOf(callee), all as Node[]];
  const isSilent = CODE.has(name);
  const first = isSilent ? given.length : name === "setAttribute" ? 1 : (SHOWING[name] ?? 0);
  const last = name === "button" ? 3 : given.length; // its class
  return [
    [callee, false],
    ...given.flatMap((each, n): [unknown, boolean][] =>
      (n < first || n >= last) && isString(each) ? [] : [[each, name in SHOWING && !isSilent]],
    ),
  ];
}

/** Return the string that a literal is, null for others. */
function stringOf(node: unknown): string | null {
  if (!isNode(node)) return null;
  if (node.type === "Literal") return typeof node.value === "string" ? node.value : null;
  const quasis = node.type === "TemplateLiteral" ? (node.quasis as { value: { cooked: string } }[]) : null;
  return quasis?.map(({ value }) => value.cooked).join("{}") ?? null;
}

/** Return the strings that a node is or chooses between. */
function stringsOf(node: unknown): string[] {
  const string = stringOf(node);
  if (string !== null) return [string];
  return isNode(node) && node.type === "ConditionalExpression"
    ? [node.consequent, node.alternate].flatMap(stringsOf)
    : [];
}

function isString(node: unknown): boolean {
  return isNode(node) && (node.type === "TemplateLiteral" || stringOf(node) !== null);
}

function isMessage(text: string, isRead: boolean): boolean {
  if (SINGLE.has(text)) return true;
  if (!/\p{L}{2}/u.test(text) || OTHERS.test(text) || NO_MESSAGES.has(text)) return false;
  return isRead || /^[A-Z][a-z]/.test(text) || /\p{L}[:;,.]? | \p{L}{2}/u.test(text);
}

/** Return the name of a variable, a property or a function; of `a.b` that is b. */
function nameOf(node: unknown): string {
  if (!isNode(node)) return "";
  if (node.type === "MemberExpression") return nameOf(node.property);
  return String(node.type === "Literal" ? node.value : (node.name ?? ""));
}

function isNode(value: unknown): value is Node {
  return typeof value === "object" && value !== null && "type" in value;
}

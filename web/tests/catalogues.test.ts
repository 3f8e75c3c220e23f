// Every message of the pages, and every word that they take from the schema, is in each catalogue: untranslated is an error.
import { describe, expect, it } from "vitest";
import schemaText from "../../docs/groundslab.schema.json?raw";
import { messagesIn, messagesOf } from "../messages";
import { sectionTitle } from "../src/workbench/form/form-panel";
import { heading, labelOf } from "../src/workbench/form/labels";
import { singular } from "../src/workbench/form/lists/list";
import { ITEM_WORDS, severalOf } from "../src/workbench/model/items";
import { FORMS } from "../src/workbench/plan/actions/forms";
import { sheetsOf } from "../src/workbench/tables/sheets";
import { schema } from "./workbench/schema";

const TEXTS = import.meta.glob<string>("../../src/groundslab/languages/static/*.json", {
  query: "?raw",
  import: "default",
  eager: true,
});
const catalogues = Object.entries(TEXTS).map(([path, text]) => {
  const messages = Object.entries(JSON.parse(text) as Record<string, string>);
  return { language: path.slice(-7, -5), messages: new Map(messages) };
});

/** Models that are called by a name or a number everywhere. */
const PROPER = /^(ACI 360|TR34|Winkler|Vlasov|Pasternak|Selvadurai)$/i;

/** Return the words that the form and the tables take from the schema: labels, headings, kinds, dimensions, meanings. */
function wordsOfSchema(): string[] {
  const { definitions } = JSON.parse(schemaText) as { definitions: Record<string, unknown> };
  const parts = ["", ...Object.keys(definitions)].map((name) => schema.part(name));
  const fields = parts.flatMap((part) => part.fields);
  const words = [
    ...parts.flatMap((part) => [part.about, heading(part.kind), part.kind]),
    ...fields.flatMap((field) => [labelOf(field), field.symbol ? `${field.symbol}: ${field.hint}` : field.hint]),
    ...fields.flatMap((field) => (field.node.is === "list" ? [singular(heading(labelOf(field) || field.name))] : [])),
    ...fields.flatMap(({ name, node }) => (["part", "kinds", "list"].includes(node.is) ? [heading(name)] : [])),
    ...fields.flatMap(({ node }) => (node.is === "quantity" ? [node.dimension] : [])),
    ...fields.flatMap(({ node }) => (node.is === "tuple" ? node.members.filter((each) => !each.includes("_")) : [])),
    ...schema.part("").fields.map((field) => sectionTitle(field.name)),
    ...sheetsOf(schema).flatMap(({ title }) => [title, title.toLowerCase()]),
  ];
  return words.filter((word) => word.length > 2 && !PROPER.test(word));
}

/** Return what items are called: one alone, by its name, and several. */
function wordsOfItems(): string[] {
  const loads = schema
    .part("")
    .fields.flatMap(({ name, node }) =>
      (name === "loads" || name === "supports") && node.is === "list" && node.of.is === "kinds"
        ? node.of.parts.map((part) => `${schema.part(part).kind} ${name.slice(0, -1)}`)
        : [],
    );
  const counted = ITEM_WORDS.flatMap((word) => [`{count} ${word}`, `{count} ${severalOf(word)}`]);
  return [...counted, ...[...ITEM_WORDS, ...loads].map((word) => `${word} {name}`)];
}

describe("the catalogues", () => {
  it("are those of all languages but English", () => {
    expect(catalogues.map(({ language }) => language).sort()).toEqual(["de", "es", "fr", "pl"]);
  });

  const messages = [
    ...new Set(
      [
        ...messagesOf(["src"]),
        ...wordsOfSchema(),
        ...wordsOfItems(),
        ...FORMS.flatMap(({ name, label }) => [label.toLowerCase(), ...(name === "array" ? [] : [`${name} {items}`])]),
      ].map((each) => each.trim()),
    ),
  ];
  it.each(catalogues)("have every message of the pages: $language", ({ messages: known }) => {
    expect(messages.filter((message) => !known.has(message))).toEqual([]);
  });

  it.each(catalogues)("have the gaps of every message: $language", ({ messages: known }) => {
    const gaps = (text: string) => text.match(/\{\w*\}/g)?.length ?? 0;
    expect([...known].filter(([message, translation]) => gaps(message) !== gaps(translation))).toEqual([]);
  });
});

describe("the messages of a source", () => {
  it("are the texts that are shown, with holes for what is put in", () => {
    const source = `
      import { h } from "./not read";
      h("p", { class: "not read", title: "Undo", "data-kind": kind === "not read" ? "x" : "y" }, "slab");
      button("Save", "", () => {}, "not read");
      const words: "not read" = element.querySelector("not read")["not read"];
      say(isNew ? "add {what}" : "change {what}", { what: counted(n, "{count} pile", "{count} piles", { n: "a" }) });
      throw new Impossible(\`\${legs} legs are too many\`);
    `;
    expect(messagesIn(source)).toEqual([
      "Undo",
      "slab",
      "Save",
      "add {what}",
      "change {what}",
      "{count} pile",
      "{count} piles",
      "{} legs are too many",
    ]);
  });
});

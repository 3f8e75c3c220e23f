// The language of the page: which one it is, and what translates messages into it.
import { Catalogue, filled, type Messages, type Values, Verbatim } from "./catalogue";
import { readStored, writeStored } from "./storage";

/** The languages, each by its own name. */
export const LANGUAGES: Readonly<Record<string, string>> = {
  en: "English",
  de: "Deutsch",
  fr: "Français",
  es: "Español",
  pl: "Polski",
};

const KEY = "groundslab-language";

let catalogue: Catalogue | null = null; // none of English

/** Return a message in the language of the page. */
export function translate(text: string): string {
  return catalogue ? catalogue.translate(text) : text;
}

/** A message, or a text that stays as it is. */
export type Text = string | Verbatim;

/** Return a text that stays as it is in every language. */
export function verbatim(text: string): Verbatim {
  return new Verbatim(text);
}

/** Return a message with values in its named holes, as in `{count} rows of {name}`, in the language of the page. */
export function say(template: string, values: Values): string {
  return catalogue ? catalogue.say(template, values) : filled(template, values, String);
}

/** Return the message about one thing or that about several; each may have a hole for their `count`. */
export function counted(count: number, one: string, many: string, values: Values = {}): string {
  return say(count === 1 ? one : many, { count, ...values });
}

/** Return a text that is put together of what was said, which stays as it is. */
export function keep(text: string): string {
  return catalogue ? catalogue.keep(text) : text;
}

/** Return messages, those that are not empty, one after another. */
export function together(texts: readonly string[], mark = " "): string {
  return keep(texts.filter(Boolean).map(translate).join(mark));
}

/** Return the language of the page, which the server answers in. */
export function pageLanguage(): string {
  return globalThis.document?.documentElement.lang || "en";
}

/** Return several possibilities: "a or b". */
export function either(texts: readonly string[]): string {
  return texts.reduce((one, other) => say("{one} or {other}", { one, other }));
}

/** Take the messages of the page's language, null for English; call before the page is built. */
export function setMessages(messages: Messages | null): void {
  catalogue = messages && new Catalogue(messages);
  document.documentElement.lang = messages?.language ?? "en";
}

/** The combination of a case that names none. */
export const ALL_LOADS = "all loads";
const names = new Map<"case" | "result", string[]>();

/** Let the names in a case, or in the head of the scene of a result, stay as they are. */
export function keepNames(of: "case" | "result", value: unknown): void {
  if (!catalogue) return;
  names.set(
    of,
    namesIn(value).filter((name) => name !== ALL_LOADS),
  );
  catalogue.setNames(new Set([...names.values()].flat()));
}

/** Return the language that the user has chosen, else that of the case, else English. */
export function chosenLanguage(ofCase: unknown): string {
  const known = [readStored(KEY), ofCase].find((each) => typeof each === "string" && Object.hasOwn(LANGUAGES, each));
  return typeof known === "string" ? known : "en";
}

/** Store the language that the user chooses. */
export function storeLanguage(language: string): void {
  writeStored(KEY, language);
}

function namesIn(value: unknown): string[] {
  if (typeof value !== "object" || value === null) return [];
  return Object.entries(value).flatMap(([key, part]) =>
    key === "name" && typeof part === "string" ? [part] : namesIn(part),
  );
}

// Tables of the case file as TOML text for the clipboard, and back.
import { isTable, type Json, type Path, type Table } from "./paths";

/** A table with the keys of the list that it belongs to. */
interface Listed {
  list: Path;
  table: Table;
}

/** Return tables as TOML text, each below the header of its list. */
export function writeTables(tables: readonly Listed[]): string {
  const write = ({ list, table }: Listed) => {
    const lines = Object.entries(table).map(([key, value]) => `${writeKey(key)} = ${writeValue(value)}`);
    return [`[[${list.map((step) => writeKey(String(step))).join(".")}]]`, ...lines, ""].join("\n");
  };
  return tables.map(write).join("\n");
}

function writeKey(key: string): string {
  return /^[A-Za-z0-9_-]+$/.test(key) ? key : JSON.stringify(key);
}

function writeValue(value: Json): string {
  if (Array.isArray(value)) return `[${value.map(writeValue).join(", ")}]`;
  if (!isTable(value)) return JSON.stringify(value);
  const pairs = Object.entries(value).map(([key, each]) => `${writeKey(key)} = ${writeValue(each)}`);
  return `{${pairs.join(", ")}}`;
}

/** Return the lists of tables in a TOML text; null if it is none, or has anything but such tables. */
export function readTables(text: string): Listed[] | null {
  try {
    return new Reader(text).readTables();
  } catch (error) {
    if (error instanceof SyntaxError) return null;
    throw error;
  }
}

const BLANK = /(?:[\s\uFEFF]|#[^\n]*)*/y;
const BASIC = /"(?:[^"\\\n]|\\.)*"/y;
const LITERAL = /'[^'\n]*'/y;
const BARE = /[A-Za-z0-9_-]+/y;
const ATOM = /[A-Za-z0-9_+.-]+/y;

/** Reads the part of TOML that tables of a case file use: no dates, no texts of several lines. */
class Reader {
  private at = 0;

  constructor(private readonly text: string) {}

  readTables(): Listed[] {
    const tables: Listed[] = [];
    let target: Table | null = null;
    for (this.skip(); this.at < this.text.length; this.skip()) {
      if (this.takes("[[")) {
        const list = this.readKeys();
        this.expect("]]");
        target = this.openInner(tables, list) ?? this.openTable(tables, list);
      } else if (this.takes("[")) {
        const keys = this.readKeys();
        this.expect("]");
        target = this.openPart(tables, keys);
      } else if (target) this.readPair(target);
      else throw new SyntaxError();
    }
    return tables;
  }

  private openTable(tables: Listed[], list: readonly string[]): Table {
    const table: Table = {};
    tables.push({ list, table });
    return table;
  }

  /** Return a new table of a list within the last table, null if the keys do not lead into it. */
  private openInner(tables: readonly Listed[], keys: readonly string[]): Table | null {
    const last = tables.at(-1);
    if (!last || keys.length <= last.list.length || last.list.some((step, n) => step !== keys[n])) return null;
    const parent = walk(last.table, keys.slice(last.list.length, -1));
    const name = keys.at(-1)!;
    const inner = Array.isArray(parent[name]) ? parent[name] : [];
    const table: Table = {};
    parent[name] = [...inner, table];
    return table;
  }

  private openPart(tables: readonly Listed[], keys: readonly string[]): Table {
    const last = tables.at(-1);
    if (!last || last.list.some((step, n) => step !== keys[n])) throw new SyntaxError();
    return walk(last.table, keys.slice(last.list.length));
  }

  private readPair(table: Table): void {
    const keys = this.readKeys();
    this.expect("=");
    const value = this.readValue();
    const name = keys.at(-1)!;
    const parent = walk(table, keys.slice(0, -1));
    if (Object.hasOwn(parent, name)) throw new SyntaxError();
    parent[name] = value;
  }

  private readKeys(): string[] {
    const keys: string[] = [];
    do {
      this.skip();
      const quoted = this.match(BASIC);
      const literal = quoted ?? this.match(LITERAL);
      const key = quoted ? unquote(quoted) : (literal?.slice(1, -1) ?? this.match(BARE));
      if (key === null || key === "__proto__") throw new SyntaxError();
      keys.push(key);
      this.skip();
    } while (this.takes("."));
    return keys;
  }

  private readValue(): Json {
    this.skip();
    if (this.takes("[")) return this.readList();
    if (this.takes("{")) {
      const table: Table = {};
      while (!this.takesAfterBlank("}")) {
        this.readPair(table);
        this.skip();
        if (!this.takes(",") && this.text[this.at] !== "}") throw new SyntaxError();
      }
      return table;
    }
    const quoted = this.match(BASIC);
    if (quoted !== null) return unquote(quoted);
    const literal = this.match(LITERAL);
    return literal !== null ? literal.slice(1, -1) : readAtom(this.match(ATOM));
  }

  private readList(): Json[] {
    const list: Json[] = [];
    while (!this.takesAfterBlank("]")) {
      list.push(this.readValue());
      this.skip();
      if (!this.takes(",") && this.text[this.at] !== "]") throw new SyntaxError();
    }
    return list;
  }

  private skip(): void {
    this.match(BLANK);
  }

  private match(pattern: RegExp): string | null {
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text)?.[0] ?? null;
    this.at += found?.length ?? 0;
    return found;
  }

  private takes(sign: string): boolean {
    const fits = this.text.startsWith(sign, this.at);
    if (fits) this.at += sign.length;
    return fits;
  }

  private takesAfterBlank(sign: string): boolean {
    this.skip();
    return this.takes(sign);
  }

  private expect(sign: string): void {
    if (!this.takesAfterBlank(sign)) throw new SyntaxError();
  }
}

/** Return the table at keys within a table, made where it is missing; the last one of a list. */
function walk(table: Table, keys: readonly string[]): Table {
  let found = table;
  for (const key of keys) {
    if (found[key] === undefined) found[key] = {};
    const next: Json = found[key];
    const inner: Json | undefined = Array.isArray(next) ? next.at(-1) : next;
    if (!isTable(inner)) throw new SyntaxError();
    found = inner;
  }
  return found;
}

/** Return the text of a basic string: TOML's escapes are JSON's, but for \U and \e. */
function unquote(quoted: string): string {
  const text = quoted.replace(/\\U([0-9A-Fa-f]{8})/g, (_, code) => String.fromCodePoint(Number.parseInt(code, 16)));
  const value: unknown = JSON.parse(text.replaceAll("\t", "\\t"));
  return String(value);
}

function readAtom(word: string | null): Json {
  if (word === "true" || word === "false") return word === "true";
  const number = word === null ? Number.NaN : Number(word.replaceAll("_", ""));
  if (!Number.isFinite(number)) throw new SyntaxError();
  return number;
}

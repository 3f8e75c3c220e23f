// On which line of the text a path stands.

import { type Path, pathKey } from "../model/paths";
import { type Token, tokens } from "./highlighting";

/** The line of each path that the text states, by `pathKey`. */
export function linesOf(text: string): Map<string, number> {
  return new Reader(tokens(text)).read();
}

/** The line of a path, or of the nearest thing above it that stands in the text; null if nothing does. */
export function lineOf(lines: ReadonlyMap<string, number>, path: Path): number | null {
  for (let length = path.length; length > 0; length -= 1) {
    const line = lines.get(pathKey(path.slice(0, length)));
    if (line !== undefined) return line;
  }
  return null;
}

class Reader {
  private readonly lines = new Map<string, number>();
  private readonly counts = new Map<string, number>();
  private readonly tokens: Token[];
  private at = 0;

  constructor(all: readonly Token[]) {
    this.tokens = all.filter((token) => token.kind !== "comment" && token.kind !== "space");
  }

  read(): Map<string, number> {
    let table: Path = [];
    while (this.at < this.tokens.length) {
      const token = this.tokens[this.at] as Token;
      if (token.kind === "end") this.at += 1;
      else if (token.text === "[") table = this.header(token.line);
      else {
        this.pair(table);
        this.skipLine();
      }
    }
    return this.lines;
  }

  /** `[a.b]` or `[[a.b]]`: the path of the table that follows. */
  private header(line: number): Path {
    this.at += 1;
    const many = this.tokens[this.at]?.text === "[";
    if (many) this.at += 1;
    const path = this.below([], this.key());
    this.skipLine();
    if (!many) return this.note(path, line);
    const key = pathKey(path);
    const position = this.counts.get(key) ?? 0;
    this.counts.set(key, position + 1);
    this.note(path, line);
    return this.note([...path, position], line);
  }

  /** A path with the positions of the lists on its way: the last table of each. */
  private below(start: Path, keys: readonly string[]): Path {
    let path: Path = start;
    keys.forEach((key, n) => {
      path = [...path, key];
      const count = this.counts.get(pathKey(path));
      if (count !== undefined && n < keys.length - 1) path = [...path, count - 1];
    });
    return path;
  }

  private note(path: Path, line: number): Path {
    const key = pathKey(path);
    if (!this.lines.has(key)) this.lines.set(key, line);
    return path;
  }

  private key(): string[] {
    let text = "";
    const keys: string[] = [];
    for (
      let token = this.tokens[this.at];
      token && (token.kind === "word" || token.kind === "string");
      token = this.tokens[++this.at]
    ) {
      if (token.kind === "string") text += token.text.slice(1, -1).replaceAll(".", "\u0000");
      else text += token.text;
    }
    for (const each of text.split(".")) keys.push(each.replaceAll("\u0000", "."));
    return keys;
  }

  /** `key = value`, in a table or in braces. */
  private pair(table: Path): void {
    const line = this.tokens[this.at]?.line ?? 1;
    const before = this.at;
    const path = this.below(table, this.key());
    if (this.tokens[this.at]?.text !== "=") {
      if (this.at === before) this.at += 1;
      return;
    }
    this.at += 1;
    this.note(path, line);
    this.value(path);
  }

  private value(path: Path): void {
    const token = this.tokens[this.at];
    if (token?.text === "[") this.list(path);
    else if (token?.text === "{") this.braces(path);
    else if (token && token.kind !== "end") this.at += 1;
  }

  private list(path: Path): void {
    this.at += 1;
    let position = 0;
    for (let token = this.tokens[this.at]; token; token = this.tokens[this.at]) {
      if (token.text === "]") {
        this.at += 1;
        return;
      }
      if (token.text === ",") position += 1;
      if (token.text === "," || token.kind === "end" || token.text === "=" || token.text === "}") {
        this.at += 1;
        continue;
      }
      this.value(this.note([...path, position], token.line));
    }
  }

  private braces(path: Path): void {
    this.at += 1;
    for (let token = this.tokens[this.at]; token; token = this.tokens[this.at]) {
      if (token.text === "}") {
        this.at += 1;
        return;
      }
      if (token.text === "," || token.kind === "end") this.at += 1;
      else if (token.kind === "sign") return;
      else this.pair(path);
    }
  }

  private skipLine(): void {
    while (this.at < this.tokens.length && this.tokens[this.at]?.kind !== "end") this.at += 1;
  }
}

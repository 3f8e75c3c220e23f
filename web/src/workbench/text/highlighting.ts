// The text of a case file in pieces: enough to color it, also while it is broken.

export interface Token {
  kind: "comment" | "string" | "word" | "sign" | "space" | "end";
  text: string;
}

/** A part of a line, and how it is colored. */
export interface Piece {
  text: string;
  style: string;
}

const PATTERN =
  /(?<comment>#[^\n]*)|(?<string>"""[\s\S]*?(?:"""|$)|'''[\s\S]*?(?:'''|$)|"(?:[^"\\\n]|\\.)*"?|'[^'\n]*'?)|(?<end>\n)|(?<space>[^\S\n]+)|(?<sign>[[\]{}=,])|(?<word>[^\s[\]{}=,#"']+)/g;

/** Cut a text into tokens; together they are the text. */
export function tokenize(text: string): Token[] {
  return Array.from(text.matchAll(PATTERN), (match): Token => {
    const kind = Object.entries(match.groups ?? {}).find(([, found]) => found !== undefined)?.[0] as Token["kind"];
    return { kind, text: match[0] };
  });
}

/** Return the pieces of a text, line by line. */
export function highlight(text: string): Piece[][] {
  const rows: Piece[][] = [[]];
  const tokens = tokenize(text);
  let isHeader = false; // whether the line is [a.b]
  let isStart = true; // whether nothing has stood on the line yet
  tokens.forEach((token, n) => {
    if (isStart && token.kind !== "space") isHeader = token.text === "[";
    isStart = token.kind === "end" || (isStart && token.kind === "space");
    const next = tokens[n + 1]?.kind === "space" ? tokens[n + 2] : tokens[n + 1];
    const style = styleOf(token, next, isHeader);
    token.text.split("\n").forEach((piece, k) => {
      if (k > 0) rows.push([]);
      if (piece) rows.at(-1)?.push({ text: piece, style });
    });
  });
  return rows;
}

function styleOf(token: Token, next: Token | undefined, isHeader: boolean): string {
  if (token.kind === "comment" || token.kind === "sign") return token.kind;
  if (isHeader) return "header";
  if (next?.text === "=") return "key";
  return token.kind === "word" && /^[-+.\d]/.test(token.text) ? "figure" : token.kind;
}

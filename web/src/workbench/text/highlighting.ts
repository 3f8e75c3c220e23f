// The text of a case file in pieces: enough to colour it and to find where things stand, also while it is broken.

export interface Token {
  kind: "comment" | "string" | "word" | "sign" | "space" | "end";
  text: string;
  /** The line it starts on, from 1. */
  line: number;
}

const PIECES =
  /(?<comment>#[^\n]*)|(?<string>"""[\s\S]*?(?:"""|$)|'''[\s\S]*?(?:'''|$)|"(?:[^"\\\n]|\\.)*"?|'[^'\n]*'?)|(?<end>\n)|(?<space>[^\S\n]+)|(?<sign>[[\]{}=,])|(?<word>[^\s[\]{}=,#"']+)/g;

/** Cut a text into pieces; together they are the text. */
export function tokens(text: string): Token[] {
  let line = 1;
  return Array.from(text.matchAll(PIECES), (match): Token => {
    const kind = Object.entries(match.groups ?? {}).find(([, found]) => found !== undefined)?.[0] as Token["kind"];
    const token: Token = { kind, text: match[0], line };
    line += match[0].split("\n").length - 1;
    return token;
  });
}

// The page's own words in other languages, by the English ones; what the server says is in the language already.

/** The messages of a language by their English text. */
export interface Messages {
  language: string;
  messages: Readonly<Record<string, string>>;
}

/** A text that stays as it is in every language: a name, a value of the case, what the server says. */
export class Verbatim {
  constructor(readonly text: string) {}

  toString(): string {
    return this.text;
  }
}

/** What fills the holes of a message, by their names: words are translated, numbers have decimal commas. */
export type Values = Readonly<Record<string, string | number | Verbatim>>;

/** So many texts that stay are known at most, as figures change with every move of the pointer. */
const MOST_KNOWN = 20_000;

/** Units and letters that are written as words. */
const NO_WORDS =
  "MPa|kPa|GPa|kNm|MNm|kip|psi|psf|pcf|pci|ksi|ksf|lbf|rad|mrad|alpha|beta|gamma|eta|theta|lambda|mu|nu|xi|rho|sigma|" +
  "tau|phi|omega|[A-Z]{2,3}";
/** A text without any of these is a figure. */
const WORD = new RegExp(
  String.raw`(?<![\p{L}\p{N}_^,])(?!(?:${NO_WORDS})(?![\p{L}\p{N}_]))\p{L}{3,}(?![\p{L}\p{N}_])`,
  "u",
);
const ONE = String.raw`[+−-]?(?:[0-9]{1,40}(?:\.[0-9]{0,40})?|\.[0-9]{1,40})(?:[eE][+−-]?[0-9]{1,3})?`;
const PLACES = new RegExp(String.raw`[(\[]${ONE}(?:, ${ONE})+[)\]]`, "g");
const FRACTION = /(?<![\p{L}\p{N}_.,])([+−-]?\d*)\.(\d+(?:[eE][+−-]?\d+)?)(?![\p{L}\p{N}_.(])/gu;

/** The words of a page in a language. */
export class Catalogue {
  private readonly whole = new Map<string, string>();
  /** What is in the language already. */
  private readonly said = new Set<string>();

  /** `names`: of things of a case, which stay. */
  constructor(
    { messages }: Messages,
    private names: ReadonlySet<string> = new Set(),
  ) {
    for (const [message, translation] of Object.entries(messages)) this.add(message, translation);
  }

  /** Take a message; what a symbol means is known without the symbol, too: `k_j: shear per length`. */
  private add(message: string, translation: string): void {
    this.whole.set(message, translation);
    const [symbol] = /^[^:]{1,30}: /.exec(message) ?? [];
    if (symbol === undefined || !translation.startsWith(symbol)) return;
    const meaning = message.slice(symbol.length);
    if (!this.whole.has(meaning)) this.whole.set(meaning, translation.slice(symbol.length));
  }

  /** Take other names of things that stay. */
  setNames(names: ReadonlySet<string>): void {
    this.names = names;
  }

  /** Return words in the language, and a figure with decimal commas; all else stays. */
  translate(text: string): string {
    const bare = text.trim();
    if (!bare || this.said.has(bare) || this.names.has(bare)) return text;
    const whole = this.whole.get(bare);
    if (whole !== undefined) return text.replace(bare, () => whole);
    return WORD.test(bare) ? text : withCommas(text);
  }

  /** Return a message by the translation of its template, its values in the language. */
  say(template: string, values: Values): string {
    const write = (value: Values[string]) => (value instanceof Verbatim ? value.text : this.translate(String(value)));
    return this.keep(filled(this.whole.get(template) ?? template, values, write));
  }

  /** Return a text in the language, which stays as it is from now on. */
  keep(text: string): string {
    if (this.said.size >= MOST_KNOWN) this.said.clear();
    this.said.add(text.trim());
    return text;
  }
}

/** Return a text with values in its named holes. */
export function filled(text: string, values: Values, write: (value: Values[string]) => string): string {
  return text.replace(/\{([a-z]\w*)\}/gi, (hole, name: string) => (name in values ? write(values[name]!) : hole));
}

/** Return a figure with decimal commas, the numbers of a place apart by semicolons. */
function withCommas(text: string): string {
  return text.replace(PLACES, (place) => place.replaceAll(", ", "; ")).replace(FRACTION, "$1,$2");
}

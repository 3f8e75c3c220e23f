// Messages in other languages, by the English text that the program makes: the rules of groundslab.languages.catalogue.

/** The messages of a language by their English text, and the marks between those of a list as they are in it. */
export interface Messages {
  language: string;
  messages: Readonly<Record<string, string>>;
  marks: Readonly<Record<string, string>>;
}

/** A text that stays as it is in every language: a name that the user gave, a value of the case. */
export class Verbatim {
  constructor(readonly text: string) {}

  toString(): string {
    return this.text;
  }
}

/** What fills the holes of a message, by their names: texts are translated, numbers have decimal commas. */
export type Values = Readonly<Record<string, string | number | Verbatim>>;

/** A message with gaps, and its translation. */
interface Template {
  /** What stands before, between and behind the gaps. */
  pieces: readonly string[];
  translation: string;
  /** How many letters of its own it has. */
  letters: number;
}

/** A template, and what fills its gaps in a text. */
type Fit = readonly [template: Template, fillings: readonly string[]];

/** A template of fewer letters is tried last. */
const FEW_LETTERS = 6;
/** Of a text no more parts in each other are looked at than this. */
const DEEPEST = 8;
/** So many texts are known at most, as figures change with every move of the pointer. */
const MOST_KNOWN = 20_000;

const GAP = /\{(\d*)\}/g;
const SENTENCES = /(?<=[.!?]) (?=(?![a-z])\p{L})/u;
const QUOTED = /^"[^"]*"(?: \.\.\.)?$/;
const WHOLE_WORDS = /(?<![\0\p{L}\p{N}_])\p{L}+(?![\0\p{L}\p{N}_])/gu;
const WORDS = /\p{L}+/gu;
/** Units and letters that are written as words. */
const NO_WORDS =
  "MPa|kPa|GPa|kNm|MNm|kip|psi|psf|pcf|pci|ksi|ksf|lbf|rad|mrad|alpha|beta|gamma|eta|theta|lambda|mu|nu|xi|rho|sigma|" +
  "tau|phi|omega|cos|sin|tan|exp|sqrt|pardiso|[A-Z]{2,3}|ASCE";
/** A text without any of these needs no translation, as symbols, units and clauses do not. */
const WORD = new RegExp(
  String.raw`(?<![\p{L}\p{N}_^,])(?!(?:${NO_WORDS})(?![\p{L}\p{N}_]))\p{L}{3,}(?![\p{L}\p{N}_])` +
    String.raw`|(?<![\p{L}\p{N}_.])(?:as|at|by|in|is|no|of|on|or|to)(?![\p{L}\p{N}_.,])`,
  "u",
);
const ONE = String.raw`[+−-]?(?:[0-9]{1,40}(?:\.[0-9]{0,40})?|\.[0-9]{1,40})(?:[eE][+−-]?[0-9]{1,3})?`;
/** A place, or a number with a fraction that is none of a clause such as `6.4.4(2)`. */
const PLACE = String.raw`[(\[]${ONE}(?:, ${ONE})+[)\]]`;
const PLACES = new RegExp(PLACE, "g");
const FRACTION = /(?<![\p{L}\p{N}_.,])([+−-]?\d*)\.(\d+(?:[eE][+−-]?\d+)?)(?![\p{L}\p{N}_.(])/gu;
/** Clauses: of three parts, in brackets but for places, or behind a code. */
const CLAUSE =
  /\d+(?:\.\d+){2,}(?:\(\d+\))?|\d+\.\d+\(\d+\)|\((?:Table )?\d+\.\d+(?:, \d+\.\d+)*\)(?! ?(?:m\b|ft\b|\*))|\b(?:EN|ACI|TR|DIN|BS|ASCE)[\s\d.:()/-]*/g;
/** One or several clauses as what stands in brackets. */
const CLAUSES = /^(?:Table )?[\d.]+(?:\(\d+\))?(?:(?:, | and | to )[\d.]+(?:\(\d+\))?)*$/;
/** Numbers alone, with signs between them or a unit behind. */
const NUMBERS = new RegExp(
  String.raw`^(?:${PLACE}|${ONE})(?:(?: x | / | \.\. |/| [<>]=? )${ONE})*(?: ?\p{L}[\p{L}\p{N}_]*(?:/[\p{L}\p{N}_]+)?| %)?$`,
  "u",
);

/** The messages of a language: whole ones by their text, those with gaps by a word that they have. */
export class Catalogue {
  private readonly whole = new Map<string, string>();
  private readonly templates = new Map<string, Template[]>();
  private readonly known = new Map<string, string | null>();
  /** What is in the language already. */
  private readonly said = new Set<string>();
  private readonly marks: readonly (readonly [string, string])[];

  /** `names`: of things of a case, which stay. */
  constructor(
    { messages, marks }: Messages,
    private names: ReadonlySet<string> = new Set(),
  ) {
    this.marks = Object.entries(marks);
    for (const [message, translation] of Object.entries(messages)) {
      const pieces = message.split(/\{\d*\}/);
      if (pieces.length === 1) this.addWhole(message, translation);
      else {
        const word = longestWord(pieces);
        const letters = pieces.join("").match(/\p{L}/gu)?.length ?? 0;
        this.templates.set(word, [...(this.templates.get(word) ?? []), { pieces, translation, letters }]);
      }
    }
  }

  /** Take a message without gaps; what a symbol means is known without the symbol, too: `k_j: shear per length`. */
  private addWhole(message: string, translation: string): void {
    this.whole.set(message, translation);
    const [symbol] = /^[^:]{1,30}: /.exec(message) ?? [];
    if (symbol === undefined || !translation.startsWith(symbol)) return;
    const meaning = message.slice(symbol.length);
    if (!this.whole.has(meaning)) this.whole.set(meaning, translation.slice(symbol.length));
  }

  /** Take other names of things that stay. */
  setNames(names: ReadonlySet<string>): void {
    if (names.size === this.names.size && [...names].every((name) => this.names.has(name))) return;
    this.names = names;
    this.known.clear();
  }

  /** Return a text in the language; what has no translation stays. */
  translate(text: string): string {
    if (this.known.size >= MOST_KNOWN) this.known.clear();
    return this.translateWithin(text, 0);
  }

  /** Return a message by the translation of its template, its values in the language. */
  say(template: string, values: Values): string {
    const write = (value: Values[string]) => (value instanceof Verbatim ? value.text : this.translate(String(value)));
    return this.keep(filled(this.whole.get(template) ?? template, values, write));
  }

  /** Return a text in the language, which stays as it is from now on. */
  keep(text: string): string {
    if (this.said.size >= MOST_KNOWN) this.said.clear();
    this.said.add(text);
    return text;
  }

  private translateWithin(text: string, depth: number): string {
    const found = this.find(text, depth);
    if (found !== null) return found;
    const sentences = text.split(SENTENCES);
    if (sentences.length > 1) return sentences.map((each) => this.translateWithin(each, depth + 1)).join(" ");
    const bare = text.trim();
    const [fit] = depth < DEEPEST ? this.fitting(bare) : [];
    if (!fit) return text;
    const [template, fillings] = fit;
    const said = fillWith(
      template,
      fillings.map((each) => this.translateWithin(each, depth + 1)),
    );
    return text.replace(bare, () => said);
  }

  /** Return the translation of a text, null if a part of it has none. */
  private find(text: string, depth: number): string | null {
    let known = this.known.get(text);
    if (known === undefined && depth <= DEEPEST) {
      known = this.look(text, depth);
      this.known.set(text, known);
    }
    return known ?? null;
  }

  private look(text: string, depth: number): string | null {
    const bare = text.trim();
    if (!bare || this.said.has(bare) || this.names.has(bare) || QUOTED.test(bare)) return text;
    const whole = this.whole.get(bare);
    if (whole !== undefined) return text.replace(bare, () => whole);
    if (!WORD.test(bare)) return withCommas(text);
    const space = bare.indexOf(" ");
    const [factor, name] = [bare.slice(0, space), bare.slice(space + 1)];
    if (space > 0 && this.names.has(name) && NUMBERS.test(factor)) return `${withCommas(factor)} ${name}`;
    const fits = this.fitting(bare);
    const found =
      this.join(bare.split(SENTENCES), " ", depth) ??
      this.findBy(
        fits.filter(([{ letters }]) => letters >= FEW_LETTERS),
        depth,
      ) ??
      this.findParts(bare, depth) ??
      this.findBy(
        fits.filter(([{ letters }]) => letters < FEW_LETTERS),
        depth,
      );
    if (found !== null) return text.replace(bare, () => found);
    return NUMBERS.test(bare) ? withCommas(text) : null;
  }

  /** Return the templates that a text fits with what fills them, those with most letters of their own first. */
  private fitting(bare: string): Fit[] {
    const words = new Set(["", ...(bare.match(WORDS) ?? [])]);
    const candidates = [...words].flatMap((word) => this.templates.get(word) ?? []);
    const fits = candidates.flatMap((template): Fit[] => {
      const fillings = fillingsOf(template.pieces, bare);
      return fillings ? [[template, fillings]] : [];
    });
    return fits.sort(([a], [b]) => b.letters - a.letters);
  }

  /** Return what the first template says all of whose fillings are known; null if there is none. */
  private findBy(fits: readonly Fit[], depth: number): string | null {
    for (const [template, fillings] of fits) {
      const known = this.findAll(fillings, depth);
      if (!known) continue;
      const said = known.map((each, gap) => (hasClause(template, gap, fillings[gap]!) ? fillings[gap]! : each));
      return fillWith(template, said);
    }
    return null;
  }

  /** Return a text that is a list of messages; null if one of them is not known. */
  private findParts(bare: string, depth: number): string | null {
    for (const [mark, other] of this.marks) {
      const joined = this.join(splitOutside(bare, mark), other, depth);
      if (joined !== null) return joined;
    }
    return null;
  }

  /** Return parts of a text, joined; null if there is one alone, or one of them is not known. */
  private join(parts: readonly string[], between: string, depth: number): string | null {
    return parts.length > 1 ? (this.findAll(parts, depth)?.join(between) ?? null) : null;
  }

  /** Return the translations of all texts, null if one of them has none. */
  private findAll(texts: readonly string[], depth: number): string[] | null {
    const known: string[] = [];
    for (const text of texts) {
      const found = this.find(text, depth + 1);
      if (found === null) return null;
      known.push(found);
    }
    return known;
  }
}

/** Return a text with values in its named holes. */
export function filled(text: string, values: Values, write: (value: Values[string]) => string): string {
  return text.replace(/\{([a-z]\w*)\}/gi, (hole, name: string) => (name in values ? write(values[name]!) : hole));
}

/** Return the longest word that each text which fits pieces has as a whole; empty if there is none. */
function longestWord(pieces: readonly string[]): string {
  const words = pieces.join("\0").match(WHOLE_WORDS) ?? []; // what fills a gap may go on with a word that ends there
  return words.reduce((longest, word) => (word.length > longest.length ? word : longest), "");
}

/** Return what fills the gaps between pieces in a text, each as short as can be; null if the text does not fit. */
function fillingsOf(pieces: readonly string[], text: string): string[] | null {
  const [first, last] = [pieces[0]!, pieces.at(-1)!];
  if (text.length < first.length + last.length || !text.startsWith(first) || !text.endsWith(last)) return null;
  const filled: string[] = [];
  let at = first.length;
  const end = text.length - last.length;
  for (const piece of pieces.slice(1, -1)) {
    const found = text.indexOf(piece, at);
    if (found < 0 || found + piece.length > end) return null;
    filled.push(text.slice(at, found));
    at = found + piece.length;
  }
  filled.push(text.slice(at, end));
  return filled.every(isBalanced) ? filled : null;
}

/** Return the translation of a template with its gaps filled. */
function fillWith({ translation }: Template, fillings: readonly string[]): string {
  let next = 0;
  return translation.replace(GAP, (_, n: string) => fillings[n ? Number(n) - 1 : next++] ?? "");
}

/** Whether what fills a gap is one clause or several, in brackets. */
function hasClause({ pieces }: Template, gap: number, filling: string): boolean {
  return pieces[gap]!.endsWith("(") && pieces[gap + 1]!.startsWith(")") && CLAUSES.test(filling);
}

/** Return a text without words, its numbers with decimal commas, those of places apart by semicolons; clauses stay. */
function withCommas(text: string): string {
  if (text.trim().replace(PLACES, "") === "") return commas(text);
  const clauses = text.match(CLAUSE) ?? [];
  return text
    .split(CLAUSE)
    .map((piece, n) => commas(piece) + (clauses[n] ?? ""))
    .join("");
}

function commas(text: string): string {
  return text.replace(PLACES, (place) => place.replaceAll(", ", "; ")).replace(FRACTION, "$1,$2");
}

/** Return a text parted at a mark, but not within brackets or quotes. */
function splitOutside(text: string, mark: string): string[] {
  if (!text.includes(mark)) return [text];
  const parts: string[] = [];
  let [start, depth, isQuoted] = [0, 0, false];
  for (let at = 0; at < text.length; at += 1) {
    if (depth === 0 && !isQuoted && at >= start && text.startsWith(mark, at)) {
      parts.push(text.slice(start, at));
      start = at + mark.length;
    }
    depth += depthOf(text[at]!);
    if (text[at] === '"') isQuoted = !isQuoted;
  }
  return [...parts, text.slice(start)];
}

/** Whether brackets and quotes that open in a text close in it, and no others do. */
function isBalanced(text: string): boolean {
  let depth = 0;
  for (const letter of text) {
    depth += depthOf(letter);
    if (depth < 0) return false;
  }
  return depth === 0 && text.split('"').length % 2 === 1;
}

const depthOf = (letter: string) => Number("([".includes(letter)) - Number(")]".includes(letter));

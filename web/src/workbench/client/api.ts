// The server's HTTP interface.

import type { Messages } from "../../viewer/shared/catalogue";
import { pageLanguage, say } from "../../viewer/shared/language";
import type { CaseSums, UsualFactors } from "../model/changes/load-cases";
import type { Change } from "../model/edits";
import { type Issue, issueLine, type Remark } from "../model/issues";
import { isTable, type Json, type Table, tableAt } from "../model/paths";
import type { ReactionChanges, ReactionChoice } from "../model/reactions";
import type { DrawingChoice, Survey } from "../model/survey";

/** What can be compared of a run: ground models, or alternatives to the design; the names of their tables. */
export type ComparisonKind = "comparison" | "alternatives";

/** Unsaved work that an earlier run of the server has kept. */
export interface Offer {
  file: string | null;
  when: string;
  kept: string;
  /** Whether the file is no longer the one that the work builds on. */
  changed?: boolean;
}

export interface DocState {
  version: number;
  text: string;
  /** Null while the text is not TOML, or not read yet. */
  data: Table | null;
  /** Those of the last text that could be read, while there are no data of this one. */
  readable?: Table | null;
  /** Whether the server is still reading the text: issues are not known yet, the plan is the previous one. */
  checking?: boolean;
  issues: Issue[];
  /** Remarks on a case that has no issues, such as loads that act in no combination. */
  remarks?: Remark[];
  plan: Table | null;
  /** Sums of load cases and the combinations that are made; null while there are issues or they are not known yet. */
  cases?: CaseSums | null;
  /** The factors of actions where the case gives none. */
  factors?: UsualFactors;
  file: string | null;
  /** Where results that are only looked at are from; the page then edits and solves nothing. */
  view?: string;
  dirty: boolean;
  can_undo: boolean;
  can_redo: boolean;
  undo_text: string;
  redo_text: string;
  offer: Offer | null;
  autosolve?: boolean;
  /** The accuracy that runs ask for, empty for that of the case. */
  accuracy?: Accuracy;
  run?: { run: number; version: number } | null;
  /** Why unsaved work cannot be written to the disk, empty if it can. */
  unkept?: string;
  /** Whether another program has changed the file since it was read. */
  outside?: boolean;
}

/** An accuracy that a run can ask for; empty: that of the case. */
export type Accuracy = "" | "draft" | "normal" | "strict";

/** What a run takes: unknowns of the last of its meshes, combinations, seconds. */
export interface Cost {
  unknowns: number;
  meshes: number;
  combinations: number;
  seconds: number;
}

export type Costs = Partial<Record<Accuracy, Cost>>;

/** How a file differs from the text of the page: lines of a unified diff, and both merged, null if they cannot be. */
export interface FileChanges {
  digest: string;
  lines: string[];
  merged: string | null;
}

/** Which text counts from now on: that of the file, that of the page, or both merged. */
export type Which = "theirs" | "mine" | "merged";

export interface Folder {
  folder: string;
  parent: string | null;
  folders: string[];
  files: string[];
  drawings?: string[];
  buildings?: string[];
  tables?: string[];
}

/** A slab of a SAF file or a building: height of its top and extent along x and y [m], null where it cannot be read. */
export interface SlabInFile {
  id: string;
  name: string;
  height: number | null;
  sides: [number, number] | null;
  /** Of SAF files. */
  on_ground?: boolean;
  /** Of buildings: the storey, what stands on the slab, and why it cannot be read. */
  storey?: string;
  columns?: number;
  walls?: number;
  problem?: string;
}

/** Which slab is opened; of a building, whether its middle is the origin and whether it is turned along x or y. */
export interface SlabChoice {
  slab: string;
  centered?: boolean;
  aligned?: boolean;
}

/** A case made from a drawing: the report of what was read, and the place of the drawing [m] that is the origin. */
export interface OpenedDrawing {
  state: DocState;
  report: string;
  origin: [number, number];
}

/** What a file is of: a field of a combination, or of an envelope over those of one limit state. */
export interface OfResult {
  field: string;
  combination: string;
  envelope: string;
  subtracted?: Subtracted | null;
}

/** What is subtracted: a combination by its name, "" for that of the same name, of the results or of the run kept. */
export interface Subtracted {
  minus: string;
  reference: number | null;
}

/** A file that the server has made; what it does not hold, or in another way than the case. */
export interface MadeFile {
  name: string;
  content: Blob;
  notes: string[];
}

/** An example that the server has, with what its picture shows. */
export interface Example {
  name: string;
  title: string;
  about: string;
  data: Table;
}

export interface SummaryRow {
  label: string;
  symbol: string;
  value: string | number | null;
  unit: string;
  note: string;
}

export interface CombinationSummary {
  name: string;
  refused: string | null;
  certificate: Table | null;
  sections: { title: string; rows: SummaryRow[]; notes: string[] }[];
}

export interface DesignCheck {
  name: string;
  status: "fails" | "attention" | "switched off" | "no failure found" | "not checked";
  words: string;
  utilization: number | null;
  /** The least and the greatest utilization within the discretization error; null where none is told. */
  between: [number, number | null] | null;
  /** The status, and whether it hangs on the discretization error. */
  verdict: string;
}

export interface Summary {
  /** The checks; missing where they and the tables follow later. */
  design?: { status: DesignCheck["status"]; headline: string; checks: DesignCheck[] };
  combinations: CombinationSummary[];
  /** That the mesh is too coarse, in words; empty where it is not. */
  coarse?: string;
  /** Whether it is so coarse that this is the whole verdict. */
  unknown?: boolean;
}

/** What stands above a column of a table, and the columns that say where its values are and of which combination. */
export interface TableHead {
  text: string;
  unit: string;
  number: boolean;
  symbol: string;
  place: [x: number, y: number] | null;
  combination: number | null;
  field: string | null;
}

/** A text, or with it what is under it and what it is. */
export type TableCell = string | [text: string, under: string, kind: string];

export interface ResultTable {
  name: string;
  title: string;
  heads: TableHead[];
  rows: TableCell[][];
  /** The field that each row is of, null where no column names one. */
  fields: (string | null)[] | null;
  /** The list of the case that a column names items of. */
  item: { list: string; column: number } | null;
  notes: string[];
}

/** The connection is lost. */
export abstract class Lost extends Error {}

/** The server is not responding. */
export class Unreachable extends Lost {}

/** The server answers, but does not know this page: another server, or a restarted one. */
export class Unauthorized extends Lost {}

/** The edit was made on an older version; `state` is the present one. */
export class Outdated extends Error {
  constructor(readonly state: DocState) {
    super("the document has changed in the meantime");
  }
}

/** The server refuses; the message is for users. `kind` names the obstacle, `url` another workbench. */
export class Refused extends Error {
  constructor(
    message: string,
    readonly status: number,
    readonly kind = "",
    readonly url = "",
  ) {
    super(message);
  }
}

const PATIENCE = 15_000; // ms until a server that does not answer counts as gone
const READING = 200_000; // the same while it reads a file of another program

/** The interface over HTTP, every call with the token. */
export class HttpApi {
  constructor(private token: string) {}

  /** Use another token, because the server was restarted. */
  setToken(token: string): void {
    this.token = token;
  }

  state = () => this.json<DocState>("state");
  schema = () => this.json<Table>("schema");
  /** The messages of the page in a language. */
  messages = (language: string) => this.json<Messages>(`languages/${language}`);
  edit = (change: Change, base: number) => this.json<DocState>("edits", { ...change, base });
  undo = () => this.json<DocState>("undo", {});
  redo = () => this.json<DocState>("redo", {});
  save = (file: string | null, over: boolean) => this.json<DocState>("save", file === null ? { over } : { file, over });
  open = (file: string) => this.json<DocState>("open", { file });
  surveyDrawing = (file: string) => this.json<Survey>(`drawing?file=${encodeURIComponent(file)}`, undefined, READING);
  openDrawing = (file: string, choice: DrawingChoice) =>
    this.json<OpenedDrawing>("drawing", { file, ...choice }, READING);
  /** The slabs of a SAF file or a building, none of another workbook. */
  slabs = (file: string) =>
    this.json<{ slabs: SlabInFile[] }>(`slabs?file=${encodeURIComponent(file)}`, undefined, READING);
  openSlab = (file: string, choice: SlabChoice) =>
    this.json<{ state: DocState; report: string }>("slabs", { file, ...choice }, READING);
  /** What a table of reactions changes. */
  reactions = (file: string, choice: ReactionChoice) =>
    this.json<ReactionChanges>("reactions", { file, ...choice }, READING);
  /** Take a table of reactions into a version of the document. */
  takeReactions = (file: string, choice: ReactionChoice, base: number) =>
    this.json<ReactionChanges & { state: DocState }>("reactions", { file, ...choice, base }, READING);
  createCase = () => this.json<DocState>("new", {});
  examples = () => this.json<Example[]>("examples");
  openExample = (name: string) => this.json<DocState>("examples", { name });
  restore = (take: boolean) => this.json<DocState>("restore", { take });
  files = (folder: string | null) =>
    this.json<Folder>(folder === null ? "files" : `files?folder=${encodeURIComponent(folder)}`);
  solve = async () => (await this.json<{ run: number }>("solve", {})).run;
  cancel = async () => void (await this.json("cancel", {}));
  autosolve = async (on: boolean) => void (await this.json("autosolve", { on }));
  setAccuracy = async (accuracy: Accuracy) => void (await this.json("accuracy", { accuracy }));
  costs = () => this.json<Costs>("cost", undefined, READING);
  /** Whether another program has changed the file. */
  fileChanged = () => this.json<{ outside: boolean }>("file");
  fileChanges = () => this.json<FileChanges>("file/changes");
  /** Let the text of the file, that of the page, or both merged count from now on. */
  takeFile = (which: Which, digest: string) => this.json<DocState>("file", { which, digest });
  summary = (run: number) => this.json<Summary>(`results/${run}/summary`);
  tables = (run: number) => this.json<string[]>(`results/${run}/tables`);
  table = (run: number, name: string) => this.json<ResultTable>(`results/${run}/tables/${name}`, undefined, 120_000);
  compare = async (run: number, kind: ComparisonKind) => void (await this.json(`results/${run}/${kind}`, {}));
  alternatives = (run: number) => this.json<Record<string, string>>(`results/${run}/alternatives`);
  cancelComparison = async () => void (await this.json("comparison/cancel", {}));
  scene = async (run: number) => (await this.request(`results/${run}/scene`, undefined, 120_000)).arrayBuffer();
  /** The scene of the results of a run minus others. */
  difference = async (run: number, subtracted: Subtracted) => {
    const query = new URLSearchParams(queryOf(subtracted));
    return (await this.request(`results/${run}/difference?${query}`, undefined, 120_000)).arrayBuffer();
  };
  /** Have the results of a run kept, so that they can be subtracted from others. */
  keepReference = async (run: number) => void (await this.json(`results/${run}/reference`, {}, 120_000));
  preview = async (run: number) => (await this.request(`results/${run}/preview`, undefined, 120_000)).arrayBuffer();
  setShown = async (combination: string | null) => void (await this.json("shown", { combination }));
  /** The text of the case with bars that its results ask for. */
  proposeBars = async (run: number) => (await this.request(`results/${run}/bars`, undefined, 120_000)).text();
  report = (run: number) => this.file(`results/${run}/report`);
  archive = (run: number) => this.file(`results/${run}/archive`);
  /** A file made of the results of a run, of what is shown of them. */
  exported = (run: number, file: string, shown: OfResult | null) => {
    const { field = "", combination = "", envelope = "", subtracted = null } = shown ?? {};
    const query = new URLSearchParams({ field, combination, envelope, ...queryOf(subtracted) });
    return this.file(`results/${run}/exports/${file}?${query}`);
  };
  /** The case as it is now as a SAF file. */
  saf = () => this.file("saf");
  eventsAddress = () => `api/events?${new URLSearchParams({ token: this.token, language: pageLanguage() })}`;

  /** A file with the name that the server gives it, and what it says of it; making it may take minutes. */
  private async file(name: string): Promise<MadeFile> {
    const response = await this.request(name, undefined, 600_000);
    const about = response.headers.get("Content-Disposition") ?? "";
    const given = /filename\*=UTF-8''([^;]+)/.exec(about)?.[1];
    const notes = JSON.parse(decodeURIComponent(response.headers.get("X-Groundslab-Notes") ?? "[]")) as string[];
    return { name: given ? decodeURIComponent(given) : "export", content: await response.blob(), notes };
  }

  private async json<T>(name: string, body?: object, patience = PATIENCE): Promise<T> {
    return (await (await this.request(name, body, patience)).json()) as T;
  }

  private async request(name: string, body?: object, patience = PATIENCE): Promise<Response> {
    const headers = new Headers({ "X-Groundslab-Token": this.token, "X-Groundslab-Language": pageLanguage() });
    if (body) headers.set("Content-Type", "application/json");
    const content = body ? { method: "POST", body: JSON.stringify(body) } : {};
    const signal = AbortSignal.timeout(patience);
    const response = await fetch(`api/${name}`, { headers, signal, ...content }).catch((error: unknown) => {
      throw new Unreachable(String(error));
    });
    if (!response.ok) throw await refusal(response);
    return response;
  }
}

/** What the page asks of the server. */
export type Api = Omit<HttpApi, "setToken">;

function queryOf(subtracted: Subtracted | null): Record<string, string> {
  if (!subtracted) return {};
  const { minus, reference } = subtracted;
  return reference === null ? { minus } : { minus, reference: String(reference) };
}

/** Return the error of an answer. */
async function refusal(response: Response): Promise<Error> {
  const { status } = response;
  if ([401, 403].includes(status)) return new Unauthorized("the server does not recognize this page");
  if ([502, 503, 504].includes(status)) return new Unreachable(say("status {status}", { status }));
  const body = (await response.json().catch(() => null)) as Json;
  if (status === 409 && isTable(body) && "version" in body && "text" in body)
    return new Outdated(body as unknown as DocState);
  const { kind, url } = tableAt(body, ["error"]);
  return new Refused(
    messageOf(body) ?? say("the server answered {status}", { status }),
    status,
    String(kind ?? ""),
    String(url ?? ""),
  );
}

/** Return the message of a refusal: {"error": {...}} with an issue's parts or a message, or {"detail": ...}. */
export function messageOf(body: unknown): string | null {
  if (typeof body === "string") return body;
  if (Array.isArray(body)) return body.flatMap((each) => messageOf(each) ?? []).join("; ") || null;
  if (!isTable(body as Json)) return null;
  const table = body as Table;
  if (typeof table.found === "string" && typeof table.expected === "string")
    return issueLine(table as unknown as Issue);
  return messageOf(table.error ?? table.message ?? table.msg ?? table.detail ?? table.issues ?? null);
}

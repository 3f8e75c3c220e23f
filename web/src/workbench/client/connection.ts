// The connection to the server: its events, and reconnecting.

import type { Change } from "../model/edits";
import type { Issue } from "../model/issues";
import { type Accuracy, type Api, type DocState, Lost, Unauthorized } from "./api";
import type { EditQueue } from "./edit-queue";
import type { Comparison, Making, Preview, Run, Solved, Store } from "./store";

/** What to do about the document when the server is back. */
export type Reconciliation = "same" | "adopt" | "offer" | "differs";

export interface ConnectionHooks {
  /** The server has kept unsaved work of an earlier run: ask, and return the state after the answer. */
  resolveOffer(state: DocState): Promise<DocState>;
  /** The server holds another text than this page: ask which of them to keep. */
  askWhichText(server: DocState, own: string): Promise<"page" | "server">;
}

const FIRST_WAIT = 400; // ms until the first new attempt
const LONGEST_WAIT = 4000;
const CHECK_WAIT = 100; // ms until the next question while the server reads the text; its answer takes a little, too

export class Connection {
  private source: EventSource | null = null;
  private wait = FIRST_WAIT;
  private retrying = false;
  private isNewServer = false; // whether the server is not the one that the page has known
  private timer: ReturnType<typeof setTimeout> | null = null;
  private checking: ReturnType<typeof setTimeout> | null = null;

  constructor(
    private readonly api: Api,
    private readonly store: Store,
    private readonly queue: EditQueue,
    private readonly hooks: ConnectionHooks,
    private readonly events: (address: string) => EventSource = (address) => new EventSource(address),
  ) {
    store.on(["doc"], () => this.pollWhileChecking());
  }

  /** While the server is still reading the text, ask for the result. */
  private pollWhileChecking(): void {
    if (!this.store.doc?.checking || this.checking !== null) return;
    this.checking = setTimeout(() => {
      this.checking = null;
      void this.refresh(-1);
    }, CHECK_WAIT);
  }

  /** Ask for everything and listen; tries again until the server answers. */
  async start(): Promise<void> {
    try {
      this.store.schema ??= await this.api.schema();
      const state = await this.api.state();
      await this.reconcile(state);
      this.listen();
      this.store.set("connection", "ok");
      this.wait = FIRST_WAIT;
    } catch (error) {
      if (!(error instanceof Lost)) throw error;
      this.handleLoss(error);
    }
  }

  /** The server did not answer, or does not know this page: try until it does. */
  handleLoss(error: Lost): void {
    this.queue.hold();
    this.close();
    this.store.set("connection", error instanceof Unauthorized ? "unauthorized" : "away");
    this.scheduleRetry();
  }

  /** Try at once; `another`: whether it is a new server. */
  retry(another = false): void {
    this.isNewServer ||= another;
    this.wait = FIRST_WAIT;
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
    void this.attempt();
  }

  private scheduleRetry(): void {
    if (this.timer !== null || this.retrying) return;
    this.timer = setTimeout(() => {
      this.timer = null;
      void this.attempt();
    }, this.wait);
    this.wait = Math.min(LONGEST_WAIT, this.wait * 1.6);
  }

  private async attempt(): Promise<void> {
    if (this.retrying) return;
    this.retrying = true;
    await this.start().finally(() => {
      this.retrying = false;
    });
    if (this.store.connection !== "ok") this.scheduleRetry();
  }

  /** Take a state after a pause, without losing what either side holds. */
  private async reconcile(state: DocState): Promise<void> {
    const own = this.store.doc;
    const what = compareStates(own, state, this.isNewServer, this.queue.waiting.length > 0);
    let taken = state;
    if (state.offer) {
      this.queue.hold();
      taken = await this.hooks.resolveOffer(state);
    } else if (what === "differs" && own) {
      this.queue.hold();
      if ((await this.hooks.askWhichText(state, own.text)) === "page") {
        const change: Change = { edits: [{ op: "text", value: own.text }], text: "keep the page's text" };
        taken = await this.api.edit(change, state.version);
      } else this.queue.clear();
    }
    if (this.isNewServer) this.store.set("solved", null);
    this.isNewServer = false;
    if (own && own.text !== taken.text) this.queue.rebase(taken);
    this.store.setDoc(taken);
    await this.queue.release();
  }

  private listen(): void {
    this.close();
    const source = this.events(this.api.eventsAddress());
    this.source = source;
    const on = <T = unknown>(name: string, take: (about: T) => void) =>
      source.addEventListener(name, (event) => take(JSON.parse((event as MessageEvent<string>).data) as T));
    const setRun = (run: Run) => {
      // of a run that was canceled the preview stays, as long as nothing newer is there
      if (run.kind === "idle" || run.kind === "refused") this.store.set("preview", null);
      this.store.set("run", run);
    };
    on<{ version: number }>("state", ({ version }) => void this.refresh(version));
    on("saved", () => void this.refresh(-1));
    on<{ accuracy: Accuracy }>("accuracy", ({ accuracy }) => {
      if (this.store.doc) this.store.setDoc({ ...this.store.doc, accuracy });
    });
    on("opened", () => this.store.forgetResults());
    on<{ run: number; version: number }>("solving", ({ run, version }) =>
      setRun({ kind: "solving", run, version, text: "", share: null }),
    );
    on<{ run: number; text: string; share: number | null; details: string }>("progress", ({ run, ...told }) => {
      const now = this.store.run;
      if (now.kind === "solving" && now.run === run) setRun({ ...now, ...told });
    });
    on<Preview>("preview", ({ run, version, words, figures }) =>
      this.store.set("preview", { run, version, words, figures }),
    );
    const setSolved = ({ run, version, seconds, design, provisional, update }: Solved) => {
      this.store.set("preview", null);
      this.store.set("solved", { run, version, seconds, design, provisional, update });
    };
    on<Solved>("provisional", setSolved);
    on<Solved>("solved", (solved) => {
      setRun({ kind: "idle" });
      setSolved(solved);
    });
    on<{ version: number; message: string; issues: Issue[] }>("refused", ({ version, message, issues }) =>
      setRun({ kind: "refused", version, message, issues }),
    );
    on<Making>("making", (making) => {
      if (this.store.report?.run === making.run) this.store.set("report", making);
    });
    const setComparison = (comparison: Comparison) => this.store.set("comparison", comparison);
    type Told = Pick<Comparison, "kind" | "run">;
    on<Told & { text: string; share: number }>("comparing", (about) => setComparison({ ...about, state: "running" }));
    on<Told>("compared", (about) => setComparison({ ...about, state: "done", text: "", share: 1 }));
    on<Told & { message: string }>("not compared", ({ kind, run, message }) =>
      setComparison({ kind, run, state: "failed", text: message, share: 0 }),
    );
    on("cancelled", () => setRun({ kind: "cancelled" }));
    source.addEventListener("error", () => {
      if (this.source !== source) return;
      // a stream may end without reason: only a request without an answer counts
      this.close();
      this.retry();
    });
  }

  private async refresh(version: number): Promise<void> {
    if (this.queue.waiting.length > 0 || version === this.store.doc?.version) return;
    try {
      const state = await this.api.state();
      if (this.queue.waiting.length === 0) this.store.setDoc(state);
    } catch (error) {
      if (error instanceof Lost) this.handleLoss(error);
    }
  }

  private close(): void {
    this.source?.close();
    this.source = null;
  }
}

/** Compare the server's state with what the page last knew; `another`: whether the server was started since. */
export function compareStates(
  own: DocState | null,
  server: DocState,
  another: boolean,
  waiting: boolean,
): Reconciliation {
  if (server.offer) return "offer";
  if (!own) return "adopt";
  if (own.text === server.text) return "same";
  return another && (waiting || own.dirty) ? "differs" : "adopt";
}

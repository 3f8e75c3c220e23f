// The connection to the server: its events, and reconnecting.

import { type Api, type DocState, Unauthorized, Unreachable } from "./api";
import type { EditQueue } from "./edit-queue";
import type { Store } from "./store";

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
      this.store.setConnection("ok");
      this.wait = FIRST_WAIT;
    } catch (error) {
      if (!(error instanceof Unreachable || error instanceof Unauthorized)) throw error;
      this.handleLoss(error);
    }
  }

  /** The server did not answer, or does not know this page: try until it does. */
  handleLoss(error: Unreachable | Unauthorized): void {
    this.queue.hold();
    this.close();
    this.store.setConnection(error instanceof Unauthorized ? "unauthorized" : "away");
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
        taken = await this.api.edit(
          { edits: [{ op: "text", value: own.text }], text: "keep the page's text" },
          state.version,
        );
      } else this.queue.clear();
    }
    if (this.isNewServer) this.store.setSolved(null);
    this.isNewServer = false;
    if (own && own.text !== taken.text) this.queue.rebase(taken);
    this.store.setDoc(taken);
    await this.queue.release();
  }

  private listen(): void {
    this.close();
    const source = this.events(this.api.eventsAddress());
    this.source = source;
    const on = (name: string, take: (about: Record<string, unknown>) => void) =>
      source.addEventListener(name, (event) =>
        take(JSON.parse((event as MessageEvent<string>).data) as Record<string, unknown>),
      );
    on("state", (about) => void this.refresh(Number(about.version)));
    on("saved", () => void this.refresh(-1));
    on("solving", (about) =>
      this.store.setRun({
        kind: "solving",
        run: Number(about.run),
        version: Number(about.version),
        text: "",
        share: null,
      }),
    );
    on("progress", (about) => this.progress(about));
    on("solved", (about) => {
      this.store.setRun({ kind: "idle" });
      this.store.setSolved({
        run: Number(about.run),
        version: Number(about.version),
        seconds: Number(about.seconds),
        design: String(about.design ?? ""),
      });
    });
    on("refused", (about) => {
      const issues = Array.isArray(about.issues)
        ? (about.issues as { location: string; found: string; expected: string; hint: string }[])
        : [];
      this.store.setRun({
        kind: "refused",
        version: Number(about.version),
        message: String(about.message ?? ""),
        issues,
      });
    });
    on("cancelled", () => this.store.setRun({ kind: "cancelled" }));
    source.addEventListener("error", () => {
      if (this.source !== source) return;
      // a stream may end without reason: only a request without an answer counts
      this.close();
      this.retry();
    });
  }

  private progress(about: Record<string, unknown>): void {
    const { run } = this.store;
    if (run.kind !== "solving" || run.run !== Number(about.run)) return;
    const share = typeof about.share === "number" ? about.share : null;
    this.store.setRun({ ...run, text: String(about.text ?? ""), share });
  }

  private async refresh(version: number): Promise<void> {
    if (this.queue.waiting.length > 0 || version === this.store.doc?.version) return;
    try {
      const state = await this.api.state();
      if (this.queue.waiting.length === 0) this.store.setDoc(state);
    } catch (error) {
      if (error instanceof Unreachable || error instanceof Unauthorized) this.handleLoss(error);
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

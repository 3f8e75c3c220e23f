// Keeping in touch with the server: its events, its silence, its return.

import { type Api, type DocState, Stranger, Unreachable } from "./api";
import type { EditQueue } from "./edit-queue";
import type { Store } from "./store";

/** What to do about the document when the server is there again. */
export type Return = "same" | "adopt" | "offer" | "differs";

export interface ConnectionHooks {
  /** The server has kept unsaved work of an earlier run: ask, and return the state after the answer. */
  offered(state: DocState): Promise<DocState>;
  /** The server holds another text than this page: ask which of them counts. */
  differs(server: DocState, own: string): Promise<"page" | "server">;
}

const FIRST_WAIT = 400; // ms until the first new attempt
const LONGEST_WAIT = 4000;
const CHECK_WAIT = 100; // ms until the next question while the server reads the text; its answer waits a little, too

export class Connection {
  private source: EventSource | null = null;
  private wait = FIRST_WAIT;
  private retrying = false;
  private another = false; // whether the server is not the one that the page has known
  private timer: ReturnType<typeof setTimeout> | null = null;
  private checking: ReturnType<typeof setTimeout> | null = null;

  constructor(
    private readonly api: Api,
    private readonly store: Store,
    private readonly queue: EditQueue,
    private readonly hooks: ConnectionHooks,
    private readonly events: (address: string) => EventSource = (address) => new EventSource(address),
  ) {
    store.on(["doc"], () => this.askAgain());
  }

  /** While the server is still reading the text, ask for what it has found. */
  private askAgain(): void {
    if (!this.store.doc?.checking || this.checking !== null) return;
    this.checking = setTimeout(() => {
      this.checking = null;
      void this.refreshFrom(-1);
    }, CHECK_WAIT);
  }

  /** Ask for everything and listen; tries again until the server answers. */
  async start(): Promise<void> {
    try {
      this.store.schema ??= await this.api.schema();
      const state = await this.api.state();
      await this.welcome(state);
      this.listen();
      this.store.setConnection("ok");
      this.wait = FIRST_WAIT;
    } catch (error) {
      if (!(error instanceof Unreachable || error instanceof Stranger)) throw error;
      this.lost(error);
    }
  }

  /** The server did not answer, or does not know this page: try until it does. */
  lost(error: Unreachable | Stranger): void {
    this.queue.hold();
    this.close();
    this.store.setConnection(error instanceof Stranger ? "stranger" : "away");
    this.again();
  }

  /** Try at once; `another` tells that it is a new server. */
  retry(another = false): void {
    this.another ||= another;
    this.wait = FIRST_WAIT;
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
    void this.attempt();
  }

  private again(): void {
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
    if (this.store.connection !== "ok") this.again();
  }

  /** Take a state after a pause, without losing what either side holds. */
  private async welcome(state: DocState): Promise<void> {
    const own = this.store.doc;
    const what = comparison(own, state, this.another, this.queue.waiting.length > 0);
    let taken = state;
    if (state.offer) {
      this.queue.hold();
      taken = await this.hooks.offered(state);
    } else if (what === "differs" && own) {
      this.queue.hold();
      if ((await this.hooks.differs(state, own.text)) === "page") {
        taken = await this.api.edit(
          { edits: [{ op: "text", value: own.text }], text: "keep the page's text" },
          state.version,
        );
      } else this.queue.clear();
    }
    if (this.another) this.store.setSolved(null);
    this.another = false;
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
    on("state", (about) => void this.refreshFrom(Number(about.version)));
    on("saved", () => void this.refreshFrom(-1));
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
      const faults = Array.isArray(about.faults)
        ? (about.faults as { where: string; got: string; expected: string; mend: string }[])
        : [];
      this.store.setRun({
        kind: "refused",
        version: Number(about.version),
        message: String(about.message ?? ""),
        faults,
      });
    });
    on("cancelled", () => this.store.setRun({ kind: "cancelled" }));
    source.addEventListener("error", () => {
      if (this.source !== source) return;
      // a stream may end without reason: only silence on a question counts
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

  private async refreshFrom(version: number): Promise<void> {
    if (this.queue.waiting.length > 0 || version === this.store.doc?.version) return;
    try {
      const state = await this.api.state();
      if (this.queue.waiting.length === 0) this.store.setDoc(state);
    } catch (error) {
      if (error instanceof Unreachable || error instanceof Stranger) this.lost(error);
    }
  }

  private close(): void {
    this.source?.close();
    this.source = null;
  }
}

/** How the server's state compares with what the page last knew; `another` is a server that was started since. */
export function comparison(own: DocState | null, server: DocState, another: boolean, waiting: boolean): Return {
  if (server.offer) return "offer";
  if (!own) return "adopt";
  if (own.text === server.text) return "same";
  return another && (waiting || own.dirty) ? "differs" : "adopt";
}

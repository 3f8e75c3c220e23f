// The server's silence and return, its words of refusal, and what the page says of results.
import { beforeEach, describe, expect, it, vi } from "vitest";
import { type Api, type DocState, messageOf, type Offer } from "../../../src/workbench/client/api";
import { Connection, compareStates } from "../../../src/workbench/client/connection";
import { EditQueue } from "../../../src/workbench/client/edit-queue";
import { Store } from "../../../src/workbench/client/store";
import { sameValue, type Table, valueAt } from "../../../src/workbench/model/paths";
import { freshness } from "../../../src/workbench/result/standing";
import { statusText } from "../../../src/workbench/result/status";
import { FakeApi } from "../fake-api";

class FakeEvents {
  static readonly all: FakeEvents[] = [];
  closed = false;
  private readonly listeners = new Map<string, (event: unknown) => void>();

  constructor() {
    FakeEvents.all.push(this);
  }

  addEventListener(name: string, listener: (event: unknown) => void): void {
    this.listeners.set(name, listener);
  }

  close(): void {
    this.closed = true;
  }

  send(name: string, about: object = {}): void {
    this.listeners.get(name)?.({ data: JSON.stringify(about) });
  }
}

class WholeApi extends FakeApi {
  offer: Offer | null = null;
  schema = () => Promise.resolve({});
  eventsAddress = () => "";
  override present(): DocState {
    return { ...super.present(), offer: this.offer };
  }
}

function page(api: WholeApi, answers: { take?: boolean; counts?: "page" | "server" } = {}) {
  const store = new Store();
  const refused: string[] = [];
  const asked: string[] = [];
  const queue: EditQueue = new EditQueue(api, {
    base: () => store.doc?.version ?? 0,
    adopt: (state, waiting) => store.setDoc(state, waiting),
    fits: (change, state) =>
      change.edits.every(
        (edit) =>
          !("path" in edit) ||
          sameValue(valueAt(store.doc?.data ?? undefined, edit.path), valueAt(state.data ?? undefined, edit.path)),
      ),
    onRefused: (change) => refused.push(change.text),
    onLost: (error) => connection.handleLoss(error),
    onChange: () => store.setWaiting(queue.waiting),
  });
  const connection: Connection = new Connection(
    api as unknown as Api,
    store,
    queue,
    {
      resolveOffer: async (state) => {
        asked.push("offer");
        api.offer = null;
        return answers.take ? api.present() : state;
      },
      askWhichText: async () => {
        asked.push("differs");
        return answers.counts ?? "page";
      },
    },
    () => new FakeEvents() as unknown as EventSource,
  );
  return { store, queue, connection, refused, asked, events: () => FakeEvents.all.at(-1)! };
}

const set = (key: string, value: string) => ({
  edits: [{ op: "set" as const, path: ["plate", key], value }],
  text: `change ${key}`,
});
const settle = () => vi.advanceTimersByTimeAsync(20_000);
const DATA: Table = { plate: { E: "30 GPa", nu: "0.2" } };

beforeEach(() => void vi.useFakeTimers());

describe("the connection", () => {
  it("keeps what is typed while the server is away, shows it at once, and sends it on return", async () => {
    const api = new WholeApi(DATA);
    const { store, queue, connection } = page(api);
    await connection.start();
    api.away = true;
    queue.push(set("E", "31 GPa"));
    await settle();
    expect(store.connection).toBe("away");
    expect(valueAt(store.data, ["plate", "E"])).toBe("31 GPa");
    api.away = false;
    await settle();
    expect(store.connection).toBe("ok");
    expect(api.data).toEqual({ plate: { E: "31 GPa", nu: "0.2" } });
    expect(store.waitingCount).toBe(0);
  });

  it("takes the end of the stream of events for silence only if the server does not answer either", async () => {
    const api = new WholeApi(DATA);
    const { store, connection, events } = page(api);
    await connection.start();
    const changes: string[] = [];
    store.on(["connection"], () => changes.push(store.connection));
    const first = events();
    first.send("error");
    await settle();
    expect(changes).toEqual([]);
    expect(first.closed).toBe(true);
    expect(events()).not.toBe(first);
  });

  it("reports which edits no longer make sense after someone else has changed the same part", async () => {
    const api = new WholeApi(DATA);
    const { queue, connection, refused } = page(api);
    await connection.start();
    api.away = true;
    queue.push(set("E", "31 GPa"));
    queue.push(set("nu", "0.3"));
    await settle();
    api.elsewhere(set("E", "25 GPa"));
    api.away = false;
    await settle();
    expect(refused).toEqual(["change E"]);
    expect(api.data).toEqual({ plate: { E: "25 GPa", nu: "0.3" } });
  });

  it("asks about unsaved work before it sends what was typed since, which builds on it", async () => {
    const api = new WholeApi(DATA);
    const { queue, connection, asked } = page(api, { take: true });
    await connection.start();
    api.away = true;
    queue.push(set("nu", "0.3"));
    await settle();
    api.offer = { file: "case.toml", when: "2026-01-01T12:00:00+00:00", kept: ".case.toml.unsaved" };
    api.away = false;
    connection.retry(true);
    await settle();
    expect(asked).toEqual(["offer"]);
    expect(valueAt(api.data, ["plate", "nu"])).toBe("0.3");
  });

  it("follows the solver by its events", async () => {
    const api = new WholeApi(DATA);
    const { store, connection, events } = page(api);
    await connection.start();
    events().send("solving", { run: 3, version: 1 });
    events().send("progress", { run: 3, text: "mesh 1", share: 0.25 });
    events().send("progress", { run: 2, text: "of an older run", share: 0.9 });
    expect(store.run).toMatchObject({ kind: "solving", text: "mesh 1", share: 0.25 });
    const figures = { name: "ULS 1", refused: null, certificate: null, sections: [] };
    events().send("preview", { run: 3, version: 1, words: "on a coarse mesh", figures });
    expect(store.preview).toEqual({ run: 3, version: 1, words: "on a coarse mesh", figures });
    const words = "Provisional: mesh 1 is still to be refined.";
    events().send("provisional", { run: 3, version: 1, seconds: 1, provisional: words, update: 0 });
    expect(store.preview).toBeNull();
    expect(store.run).toMatchObject({ kind: "solving", text: "mesh 1" });
    expect(store.solved).toMatchObject({ run: 3, provisional: words, update: 0 });
    events().send("solved", { run: 3, version: 1, seconds: 2, provisional: "", update: 1 });
    expect(store.preview).toBeNull();
    expect([store.run.kind, store.solved?.run]).toEqual(["idle", 3]);
    expect(freshness(store.solved, store)).toBe("fresh");
    expect(freshness(store.solved, { doc: store.doc, waitingCount: 1 })).toBe("stale");
  });
});

describe("a text that takes long to read", () => {
  it("is asked about until it has been read; what could be read before is shown meanwhile", async () => {
    vi.useFakeTimers();
    const api = new WholeApi({ plate: { nu: 0.2 } });
    const { store, connection } = page(api);
    await connection.start();
    api.unread = 3;
    connection.retry();
    await vi.waitFor(() => expect(store.doc?.checking).toBe(true));
    expect([store.broken, store.data]).toEqual([false, { plate: { nu: 0.2 } }]);
    await vi.waitFor(() => expect(store.doc?.checking).toBe(false));
    expect(store.doc?.data).toEqual({ plate: { nu: 0.2 } });
    vi.useRealTimers();
  });
});

describe("two texts", () => {
  const state = (text: string, dirty = false): DocState => ({ ...new FakeApi({}).present(), text, dirty });

  it("are asked about only if the server is another one and the page has what it has not", () => {
    expect(compareStates(null, state("a"), false, false)).toBe("adopt");
    expect(compareStates(state("a", true), state("a"), true, true)).toBe("same");
    expect(compareStates(state("a", true), state("b"), true, false)).toBe("differs");
    expect(compareStates(state("a"), state("b"), true, false)).toBe("adopt");
    expect(compareStates(state("a", true), state("b"), false, true)).toBe("adopt");
  });
});

describe("words", () => {
  it("of a refusal are found in what the server answers", () => {
    expect(
      messageOf({ error: { location: "the edit", found: "a list", expected: "a table", hint: "edit the text" } }),
    ).toBe("the edit: found a list, expected a table — edit the text");
    expect(messageOf({ error: { message: "no such file" } })).toBe("no such file");
    expect(messageOf({ detail: [{ msg: "field required" }, { msg: "too long" }] })).toBe("field required; too long");
    expect(messageOf({})).toBeNull();
  });

  it("say whether the results are those of the model", () => {
    const solved = { run: 1, version: 1, seconds: 12.4, design: "", provisional: "", update: 0 };
    expect(statusText("fresh", { kind: "idle" }, solved, true, 0)).toBe("Solved in 12 s.");
    const failing = { ...solved, design: "DESIGN FAILS: 1 of 4 checks by EN 1992-1-1 fails." };
    expect(statusText("fresh", { kind: "idle" }, failing, true, 0)).toBe(
      "DESIGN FAILS: 1 of 4 checks by EN 1992-1-1 fails. Solved in 12 s.",
    );
    expect(statusText("stale", { kind: "idle" }, solved, true, 2)).toContain("Fix the errors");
    expect(statusText("fresh", { kind: "cancelled" }, solved, true, 0)).toContain("canceled");
    expect(statusText("stale", { kind: "cancelled" }, solved, false, 0)).toContain("canceled");
    expect(statusText("stale", { kind: "cancelled" }, solved, true, 0)).not.toContain("canceled"); // by an edit
    expect(
      statusText("stale", { kind: "solving", run: 2, version: 2, text: "", share: null }, solved, true, 0),
    ).toMatch(/earlier version of the model.*Solving/);
    expect(
      statusText("none", { kind: "refused", version: 1, message: "no equilibrium", issues: [] }, null, false, 0),
    ).toBe("Not solved: no equilibrium");
  });
});

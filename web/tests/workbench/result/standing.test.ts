// What is in the picture belongs to the present model, or says that it does not, after every kind of edit.
import { beforeEach, expect, it } from "vitest";
import type { Api } from "../../../src/workbench/client/api";
import { Connection } from "../../../src/workbench/client/connection";
import { EditQueue } from "../../../src/workbench/client/edit-queue";
import { Store } from "../../../src/workbench/client/store";
import { standingOf } from "../../../src/workbench/result/standing";
import { FakeApi } from "../fake-api";

const listeners = new Map<string, (event: unknown) => void>();
const send = (name: string, about: object) => listeners.get(name)?.({ data: JSON.stringify(about) });

class Events {
  addEventListener(name: string, listener: (event: unknown) => void): void {
    listeners.set(name, listener);
  }
  close(): void {}
}

class WholeApi extends FakeApi {
  schema = () => Promise.resolve({});
  eventsAddress = () => "";
}

const MODEL = {
  plate: { thickness: "250 mm" },
  cases: { G: { kind: "permanent" } },
  columns: [{ name: "A1" }, { name: "A2" }],
};

let api: WholeApi;
let store: Store;
let queue: EditQueue;
let run: number;

/** Solve the present model: the server tells of a run, and what comes of it. */
function begin(): object {
  run += 1;
  const about = { run, version: store.doc?.version };
  send("solving", about);
  return about;
}

/** Draw what the panel of results would draw. */
function draw(): void {
  const { preview, solved } = store;
  if (preview) store.set("drawn", { run: preview.run, isPreview: true });
  else store.set("drawn", solved && { run: solved.run, isPreview: false });
}

beforeEach(async () => {
  run = 0;
  api = new WholeApi(MODEL);
  store = new Store();
  queue = new EditQueue(api, {
    base: () => store.doc?.version ?? 0,
    adopt: (state, waiting) => store.setDoc(state, waiting),
    fits: () => true,
    onRefused: () => {},
    onLost: () => {},
    onChange: () => store.setWaiting(queue.waiting),
  });
  const hooks = { resolveOffer: async () => api.present(), askWhichText: async () => "page" as const };
  const events = () => new Events() as unknown as EventSource;
  const connection = new Connection(api as unknown as Api, store, queue, hooks, events);
  await connection.start();
  store.on(["solved", "preview"], draw);
  send("solved", { ...begin(), provisional: "", update: 0 });
  expect(standingOf(store)).toBe("current");
});

const set = (path: (string | number)[], value: unknown) => ({ op: "set" as const, path, value: value as never });

it.each([
  ["a new case", [set(["cases", "Q"], { kind: "variable" })]],
  ["combinations", [set(["combine"], { by: "EN 1990" })]],
  ["a new name", [{ op: "rename" as const, path: ["cases", "G"], value: "permanent" }]],
  ["a deleted item", [{ op: "remove" as const, path: ["columns", 1] }]],
  ["an error in the text", [{ op: "text" as const, value: "[plate" }]],
])(
  "after %s the result before is outdated until a preview or a result of the present model is there",
  async (_, edits) => {
    queue.push({ edits, text: "edit" });
    expect(standingOf(store)).toBe("outdated"); // at once, before the server has answered
    await queue.run();
    expect(standingOf(store)).toBe("outdated");
    const about = begin();
    expect(standingOf(store)).toBe("outdated");
    send("preview", { ...about, words: "on a coarse mesh", figures: {} });
    expect(standingOf(store)).toBe("preview");
    send("provisional", { ...about, provisional: "mesh 1", update: 0 });
    expect(standingOf(store)).toBe("provisional");
    send("solved", { ...about, provisional: "", update: 1 });
    expect(standingOf(store)).toBe("current");
  },
);

it("shows a preview of a model that is edited further as outdated, and one whose run was canceled as what it is", async () => {
  const about = begin();
  send("preview", { ...about, words: "on a coarse mesh", figures: {} });
  send("cancelled", { run });
  expect(standingOf(store)).toBe("preview");
  queue.push({ edits: [set(["plate", "thickness"], "300 mm")], text: "edit" });
  await queue.run();
  expect(standingOf(store)).toBe("outdated");
});

it("shows the result again after what was edited is undone, which the server recognizes", async () => {
  queue.push({ edits: [set(["plate", "thickness"], "300 mm")], text: "edit" });
  await queue.run();
  expect(standingOf(store)).toBe("outdated");
  store.setDoc({ ...api.present(), version: 3 }); // the answer to undo
  send("solved", { run, version: 3, provisional: "", update: 0 });
  expect(standingOf(store)).toBe("current");
});

it.each(["a result", "a preview"])("after New, or when another file is opened, even elsewhere, %s is gone", (what) => {
  if (what === "a preview") {
    store.forgetResults();
    send("preview", { ...begin(), words: "on a coarse mesh", figures: {} });
    send("cancelled", { run });
  }
  expect(standingOf(store)).not.toBe("empty");
  send("opened", {});
  expect([store.solved, store.preview]).toEqual([null, null]);
  expect(standingOf(store)).toBe("empty");
});

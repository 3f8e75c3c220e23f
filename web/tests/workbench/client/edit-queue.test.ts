// Edits on their way: in order, joined while typing, kept while the server is away.
import { describe, expect, it } from "vitest";
import type { DocState } from "../../../src/workbench/client/api";
import { canMerge, EditQueue } from "../../../src/workbench/client/edit-queue";
import type { Change } from "../../../src/workbench/model/edits";
import { sameValue, valueAt } from "../../../src/workbench/model/paths";
import { FakeApi } from "../fake-api";

const set = (key: string, value: string, merge = false): Change => ({
  edits: [{ op: "set", path: ["plate", key], value }],
  text: `change ${key}`,
  ...(merge ? { merge } : {}),
});

function queueOn(api: FakeApi) {
  let state = api.present();
  const refused: string[] = [];
  const lost: unknown[] = [];
  const queue = new EditQueue(api, {
    base: () => state.version,
    adopt: (next) => (state = next),
    fits: (change, next: DocState) =>
      change.edits.every(
        (edit) =>
          !("path" in edit) ||
          sameValue(valueAt(state.data ?? undefined, edit.path), valueAt(next.data ?? undefined, edit.path)),
      ),
    onRefused: (change, why) => refused.push(`${change.text}: ${why}`),
    onLost: (error) => lost.push(error),
    onChange: () => undefined,
  });
  return { queue, refused, lost, state: () => state };
}

describe("the queue of edits", () => {
  it("sends edits one after the other, each on the version that the one before has made", async () => {
    const api = new FakeApi({ plate: { E: "30 GPa" } });
    const { queue, state } = queueOn(api);
    queue.push(set("E", "31 GPa"));
    queue.push(set("thickness", "200 mm"));
    await queue.run();
    expect(api.received.map((each) => each.text)).toEqual(["change E", "change thickness"]);
    expect(state().version).toBe(3);
  });

  it("joins what is typed on in one field while it waits, but not with the step before the field was entered", async () => {
    const api = new FakeApi({ plate: {} });
    const { queue } = queueOn(api);
    queue.push(set("E", "1"));
    queue.push(set("nu", "0.2"));
    queue.push(set("nu", "0.21", true));
    queue.push(set("nu", "0.215", true));
    await queue.run();
    expect(api.received.map((each) => each.edits[0])).toEqual([set("E", "1").edits[0], set("nu", "0.215").edits[0]]);
    expect(api.received[1]?.merge).toBeUndefined();
  });

  it("never joins edits of two fields", () => {
    expect(canMerge(set("E", "1"), { ...set("nu", "2", true), text: "change E" })).toBe(false);
  });

  it("keeps edits while the server is away and sends them in order when it is back", async () => {
    const api = new FakeApi({ plate: {} });
    const { queue, lost } = queueOn(api);
    api.away = true;
    queue.push(set("E", "31 GPa"));
    await queue.run();
    queue.push(set("nu", "0.3"));
    expect(lost).toHaveLength(1);
    expect(queue.waiting).toHaveLength(2);
    api.away = false;
    await queue.release();
    expect(queue.waiting).toHaveLength(0);
    expect(api.data).toEqual({ plate: { E: "31 GPa", nu: "0.3" } });
  });

  it("does not do an edit twice whose answer was lost", async () => {
    const api = new FakeApi({ loads: [] });
    const { queue } = queueOn(api);
    api.deaf = true;
    queue.push({ edits: [{ op: "add", path: ["loads"], value: { kind: "point" } }], text: "add point load" });
    await queue.run();
    api.deaf = false;
    await queue.release();
    expect(api.data).toEqual({ loads: [{ kind: "point" }] });
    expect(queue.waiting).toHaveLength(0);
  });

  it("does an edit on a newer version where its part is untouched, and reports where it is not", async () => {
    const api = new FakeApi({ plate: { E: "30 GPa", nu: 0.2 } });
    const { queue, refused } = queueOn(api);
    api.elsewhere(set("E", "25 GPa"));
    queue.push(set("nu", "0.3"));
    await queue.run();
    expect(api.data).toEqual({ plate: { E: "25 GPa", nu: "0.3" } });
    api.elsewhere(set("E", "20 GPa"));
    queue.push(set("E", "35 GPa"));
    await queue.run();
    expect(refused).toHaveLength(1);
    expect(valueAt(api.data, ["plate", "E"])).toBe("20 GPa");
  });
});

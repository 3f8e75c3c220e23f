// @vitest-environment happy-dom
// Whatever cannot act now is disabled and says why: every tool and every action, one by one.
import { describe, expect, it, vi } from "vitest";
import type { Api } from "../../src/workbench/client/api";
import { type Solved, Store } from "../../src/workbench/client/store";
import { itemsOf } from "../../src/workbench/model/items";
import type { Path, Table } from "../../src/workbench/model/paths";
import { FORMS } from "../../src/workbench/plan/actions/forms";
import { type SelectionAction, TEXT_FIRST, whyNotDone, whyNotDrawn } from "../../src/workbench/plan/actions/why-not";
import { GENERATORS } from "../../src/workbench/plan/generators/generators";
import { toolBar } from "../../src/workbench/plan/tool-bar";
import { TOOLS } from "../../src/workbench/plan/tools";
import { barsBar } from "../../src/workbench/result/bars-bar";
import { ALTERNATIVES, comparisonBar, GROUNDS } from "../../src/workbench/result/comparison-bar";
import { whyNotMade } from "../../src/workbench/result/standing";
import { exportButton } from "../../src/workbench/shell/export-button";

const DATA: Table = {
  plate: { length_x: "6 m", length_y: "4 m" },
  columns: [{ name: "A1", x: "0 m", y: "0 m" }],
  loads: [
    { kind: "self weight" },
    { kind: "point", column: "A1", P: "1 kN" },
    { kind: "point", x: "1 m", y: "0 m", P: "1 kN" },
  ],
};
const ACTIONS: readonly SelectionAction[] = [...FORMS.map(({ name }) => name), "duplicate", "remove"];
const SOLVED: Solved = { run: 1, version: 1, seconds: 1, design: "", provisional: "", update: 0 };

function storeOf(data: Table, selected: readonly Path[] = [], broken = false): Store {
  const store = new Store();
  store.data = data;
  store.selected = selected;
  vi.spyOn(store, "broken", "get").mockReturnValue(broken);
  return store;
}

/** Return the actions that can do nothing with what is selected. */
function refused(...selected: Path[]): SelectionAction[] {
  const store = storeOf(DATA, selected);
  const items = itemsOf(DATA, null).filter(({ path }) => store.isSelected(path));
  const whys = ACTIONS.map((action) => [action, whyNotDone(store, items, action)] as const);
  for (const [, why] of whys) expect(why === "" || /^[A-Z].*\.$/.test(why)).toBe(true);
  return whys.filter(([, why]) => why !== "").map(([action]) => action);
}

describe("actions on what is selected", () => {
  it("need a position on the plan, unless they copy or remove", () => {
    expect(refused(["loads", 0])).toEqual(["move", "rotate", "mirror", "array"]);
    expect(refused(["columns", 0])).toEqual([]);
    expect(refused(["loads", 2])).toEqual([]);
    expect(refused(["loads", 0], ["loads", 2])).toEqual([]);
    expect(refused(["axes", 0])).toEqual([]);
  });

  it("turn the forces of a load on a column, and move neither it nor copies of it away", () => {
    expect(refused(["loads", 1])).toEqual(["move", "array"]);
  });

  it("neither copy nor remove the slab", () => {
    expect(refused(["plate"])).toEqual(["array", "duplicate", "remove"]);
  });

  it("wait for a text that can be read", () => {
    const whys = ACTIONS.map((action) => whyNotDone(storeOf(DATA, [["columns", 0]], true), [], action));
    expect(new Set(whys)).toEqual(new Set([TEXT_FIRST]));
  });
});

describe("tools", () => {
  const bar = (store: Store, hasSlab: boolean) => {
    const [onChange, onRefuse] = [vi.fn(), vi.fn()];
    const whyNot = (name: Parameters<typeof whyNotDrawn>[2]) => whyNotDrawn(store, hasSlab, name);
    const tools = toolBar({ onChange, onGenerate: vi.fn(), onRefuse, whyNot });
    tools.update();
    const buttons = [...tools.element.querySelectorAll("button")];
    expect(buttons).toHaveLength(TOOLS.length + GENERATORS.length);
    const free = buttons.filter((each) => !each.disabled).map((each) => each.dataset.tool);
    const whys = new Set(
      buttons.filter((each) => each.disabled).map((each) => each.title.split(". ").slice(1).join(". ")),
    );
    return { tools, free, whys, onChange, onRefuse };
  };

  it("need a slab, joints a further plate too", () => {
    const { tools, free, whys, onChange, onRefuse } = bar(storeOf({}), false);
    expect(free).toEqual(["select", "slab", "axes"]);
    expect(whys).toEqual(new Set(["Draw the slab first."]));
    tools.choose("column"); // by its key
    expect(onRefuse).toHaveBeenCalledWith("Draw the slab first.");
    expect(onChange).not.toHaveBeenCalled();
    expect([...bar(storeOf(DATA), true).whys]).toEqual([expect.stringContaining("further plate first")]);
    expect(bar(storeOf({ ...DATA, plates: [{ name: "B" }] }), true).whys.size).toBe(0);
  });

  it("wait for a text that can be read, and are put down", () => {
    const store = storeOf(DATA);
    const { tools } = bar(store, true);
    tools.choose("column");
    vi.spyOn(store, "broken", "get").mockReturnValue(true);
    tools.update();
    expect(tools.current().name).toBe("select");
    expect(tools.element.querySelectorAll("button:not(:disabled)")).toHaveLength(1);
  });
});

describe("what is made of results", () => {
  it("waits for results of the present model on the last mesh", () => {
    const known = { drawn: null, preview: null, solved: SOLVED, doc: { version: 1 }, waitingCount: 0 };
    expect(whyNotMade({ ...known, solved: null })).toBe("Solve first: there are no results yet.");
    expect(whyNotMade({ ...known, waitingCount: 1 })).toBe("Solve first: the case has changed since.");
    expect(whyNotMade({ ...known, solved: { ...SOLVED, provisional: "mesh 1" } })).toContain("being refined");
    expect(whyNotMade(known)).toBe("");
  });

  it("is offered by buttons that say so while there is none", () => {
    const store = new Store();
    const api = {} as Api;
    const elements = [
      barsBar(store, api, vi.fn()),
      comparisonBar(GROUNDS, store, api, vi.fn()),
      comparisonBar(ALTERNATIVES, store, api, vi.fn()),
      exportButton(store, api, vi.fn()),
    ];
    store.emitAll();
    const buttons = elements.map((each) => (each instanceof HTMLButtonElement ? each : each.querySelector("button")!));
    expect(buttons.map(({ disabled }) => disabled)).toEqual([true, true, true, true]);
    expect(buttons.map(({ title }) => title.split(":")[0])).toEqual([
      "Solve first",
      "Solve first",
      "Solve first",
      "There is nothing to export",
    ]);
  });
});

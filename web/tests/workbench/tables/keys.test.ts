// @vitest-environment happy-dom
import { expect, it } from "vitest";
import { type KeyTarget, keyHandler } from "../../../src/workbench/tables/keys";
import { type Block, blockAt, boundsOfBlock, clampBlock } from "../../../src/workbench/tables/selection";

/** A table of 4 rows (the last one empty) and 3 columns, and what its keys did. */
const makeTable = () => {
  const done: string[] = [];
  const act = (name: string) => () => done.push(name);
  let block: Block = blockAt(0, 0);
  const target = (): KeyTarget => ({
    block,
    rows: 4,
    columns: 3,
    page: 2,
    choose: (next) => {
      block = clampBlock(next, 4, 3);
    },
    edit: (typing) => done.push(typing ? "type" : "edit"),
    empty: act("empty"),
    add: act("add"),
    duplicate: act("duplicate"),
    remove: act("remove"),
  });
  const handle = keyHandler(target);
  const press = (key: string, keys: KeyboardEventInit = {}) => handle(new KeyboardEvent("keydown", { key, ...keys }));
  return { press, done, cell: () => [block.active.row, block.active.column], bounds: () => boundsOfBlock(block) };
};

it("arrows go from cell to cell and stop at the edges; with Ctrl they go there", () => {
  const { press, cell } = makeTable();
  for (const key of ["ArrowDown", "ArrowRight", "ArrowUp", "ArrowUp"]) press(key);
  expect(cell()).toEqual([0, 1]);
  press("End", { ctrlKey: true });
  expect(cell()).toEqual([3, 2]);
  press("Home");
  press("PageUp");
  expect(cell()).toEqual([1, 0]);
  press("ArrowDown", { ctrlKey: true });
  expect(cell()).toEqual([3, 0]);
});

it("Shift chooses a block, Shift and the space bar its rows, Ctrl+A all rows but the empty one", () => {
  const { press, bounds } = makeTable();
  press("ArrowDown", { shiftKey: true });
  press("ArrowRight", { shiftKey: true });
  expect(bounds()).toEqual({ top: 0, bottom: 1, left: 0, right: 1 });
  press(" ", { shiftKey: true });
  expect(bounds()).toEqual({ top: 0, bottom: 1, left: 0, right: 2 });
  press("a", { ctrlKey: true });
  expect(bounds()).toEqual({ top: 0, bottom: 2, left: 0, right: 2 });
});

it("Tab goes on in reading order, and leaves at the ends and after Escape", () => {
  const { press, cell } = makeTable();
  expect(press("Tab", { shiftKey: true })).toBe(false);
  for (let n = 0; n < 4; n += 1) expect(press("Tab")).toBe(true);
  expect(cell()).toEqual([1, 1]);
  press("Escape");
  expect(press("Tab")).toBe(false);
  press("End", { ctrlKey: true });
  expect(press("Tab")).toBe(false);
});

it("letters type, F2 edits, and the other keys do what they are for; ? stays with the page", () => {
  const { press, done } = makeTable();
  press("F2");
  expect(press("5")).toBe(false);
  expect(press("?")).toBe(false);
  press("Delete");
  for (const key of ["d", "-", "+"]) expect(press(key, { ctrlKey: true })).toBe(true);
  expect(press("c", { ctrlKey: true })).toBe(false);
  expect(done).toEqual(["edit", "type", "empty", "duplicate", "remove", "add"]);
});

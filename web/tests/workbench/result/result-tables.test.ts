// @vitest-environment happy-dom
// A table that is being made says so, one that cannot be made why; no tab is blank.
import { expect, it, vi } from "vitest";
import { Refused, type ResultTable, Unreachable } from "../../../src/workbench/client/api";
import { ResultTables } from "../../../src/workbench/result/result-tables";

const TABLE: ResultTable = { name: "extremes", title: "", heads: [], rows: [], fields: null, item: null, notes: [] };
const NAMES = ["combinations", "extremes"];

function page(table: (run: number, name: string) => Promise<ResultTable>) {
  const onError = vi.fn();
  const tables = new ResultTables({ table }, vi.fn(), onError);
  const panel = tables.tabs.find(({ name }) => name === "combinations")!.panel;
  document.body.replaceChildren(panel);
  tables.set(1, 0, NAMES, vi.fn());
  const words = panel.querySelector<HTMLElement>(".table-words")!;
  const rows = panel.querySelector<HTMLElement>(".table-scroller")!;
  return { tables, words, rows, onError, choice: panel.querySelector("select")! };
}

it("says what is being made until it is there", async () => {
  let answer: (table: ResultTable) => void = () => undefined;
  const { tables, words, rows, choice } = page(() => new Promise((resolve) => (answer = resolve)));
  const seen = tables.see("combinations");
  expect([words.hidden, words.textContent, rows.hidden]).toEqual([
    false,
    "The table is being made: all combinations …",
    true,
  ]);
  expect(choice.hidden).toBe(false); // another one can be chosen meanwhile
  answer(TABLE);
  await seen;
  expect([words.hidden, rows.hidden]).toEqual([true, false]);
});

it("says why it cannot be made, and a lost connection elsewhere", async () => {
  const refusal = new Refused("it takes too long", 422);
  const { tables, words, onError } = page(() => Promise.reject(refusal));
  await tables.see("combinations");
  expect(words.textContent).toBe("The table could not be made: it takes too long");
  expect(onError).not.toHaveBeenCalled();
  const lost = page(() => Promise.reject(new Unreachable()));
  await lost.tables.see("combinations");
  expect(lost.onError).toHaveBeenCalledOnce();
});

it("says that tables follow while the checks are made", () => {
  const { tables, words } = page(() => Promise.resolve(TABLE));
  tables.wait();
  expect([words.hidden, words.textContent]).toEqual([false, "The tables are being made …"]);
  tables.set(1, 1, NAMES, vi.fn());
  expect(words.hidden).toBe(true);
});

// @vitest-environment happy-dom
// The list below the model: issues, or remarks on a case without any.
import { expect, test, vi } from "vitest";
import type { DocState } from "../../../src/workbench/client/api";
import { Store } from "../../../src/workbench/client/store";
import { countText } from "../../../src/workbench/model/issues";
import { issueList } from "../../../src/workbench/shell/diagnostics";
import { FakeApi } from "../fake-api";

const WORDS = 'case "G" acts in no combination: its load is left out';
const REMARK = { location: "cases[1]", path: ["cases", 0], words: WORDS, doubtful: true };

function shown(about: Partial<DocState>) {
  const [store, onChoose] = [new Store(), vi.fn()];
  const { element } = issueList(store, onChoose, vi.fn());
  store.setDoc({ ...new FakeApi({}).present(), ...about });
  return { element, onChoose, count: element.querySelector(".issue-count")?.textContent };
}

test("a remark is listed and leads to its place", () => {
  const { element, onChoose, count } = shown({ remarks: [REMARK] });
  expect(count).toBe("No errors, 1 remark");
  expect(element.querySelector(".first-issue")?.textContent).toBe(WORDS);
  expect([...element.classList]).toEqual(["issue-list", "doubtful", "filled"]);
  const row = element.querySelector<HTMLButtonElement>("li button");
  expect(row?.textContent).toBe(`Remark: ${WORDS}`);
  row?.click();
  expect(onChoose).toHaveBeenCalledWith(REMARK);
});

test("without any there is nothing to open", () => {
  const { element, count } = shown({ remarks: [] });
  expect(count).toBe("No errors");
  expect([...element.classList]).toEqual(["issue-list"]);
});

test("errors come first, and alone in the count", () => {
  expect([countText(2, 1), countText(0, 2), countText(0, 0)]).toEqual([
    "2 errors",
    "No errors, 2 remarks",
    "No errors",
  ]);
});

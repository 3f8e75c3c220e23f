// @vitest-environment happy-dom
// Paper has no way to open what is folded: printing does, and folds it again.

import { expect, test } from "vitest";
import { openOnPaper } from "../../src/report/paper";

test("what is folded is open while the page is printed, and as it was afterwards", () => {
  document.body.innerHTML = `<details class="folded"></details><details class="folded" open></details>`;
  openOnPaper(document);
  const states = () => [...document.querySelectorAll("details")].map((each) => each.open);
  window.dispatchEvent(new Event("beforeprint"));
  expect(states()).toEqual([true, true]);
  window.dispatchEvent(new Event("afterprint"));
  expect(states()).toEqual([false, true]);
});

// @vitest-environment happy-dom
// The key that gives the results the entire width, and where it is a letter like others.
import { expect, it } from "vitest";
import { h } from "../../../src/viewer/shared/dom";
import { takesLetter } from "../../../src/workbench/result/wide";

it("is a letter in texts, and in a choice by keys of which an option begins with it", () => {
  const select = h("select", {}, h("option", {}, "ULS"), h("option", {}, "frequent"));
  document.documentElement.dataset.input = "keys";
  expect(["f", "F", "s"].map((key) => takesLetter(select, key))).toEqual([true, true, false]);
  document.documentElement.dataset.input = "pointer";
  expect(takesLetter(select, "f")).toBe(false);
  const inputs = ["text", "search", "checkbox", "range"].map((type) => h("input", { type }));
  expect(inputs.map((input) => takesLetter(input, "f"))).toEqual([true, true, false, false]);
  expect([h("textarea"), h("button")].map((each) => takesLetter(each, "f"))).toEqual([true, false]);
});

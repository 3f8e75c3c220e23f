// Load cases in one place: the list of them with their sums, a way to add one, and combinations as a matrix.
import { button, fillOptions, h, setText } from "../../viewer/shared/dom";
import { verbatim } from "../../viewer/shared/language";
import type { Store } from "../client/store";
import type { FormContext } from "../form/context";
import { CASE_TYPES, type CaseSums, caseOf, lacksVariable, meaningOf, usualName } from "../model/changes/load-cases";
import { addLoadCase, countUncased } from "../model/changes/new-items";
import { freeName, namesIn } from "../model/names";
import { listAt } from "../model/paths";
import { CaseList } from "./case-list";
import { Matrix } from "./matrix";
import { afterPress } from "./refill";
import "./cases.css";

const NONE_VARIABLE = "No case is variable: live loads would have the factors of permanent ones.";

export interface CasesPanel {
  readonly element: HTMLElement;
  update(): void;
}

/** The panel of load cases and combinations. */
export function casesPanel(store: Store, ctx: FormContext): CasesPanel {
  const list = new CaseList(store, ctx, () => update());
  const matrix = new Matrix(store, ctx, () => update());
  const adding = addForm(store, ctx);
  const warning = h("p", { class: "cases-warning", role: "status" });
  const element = h(
    "div",
    { class: "cases" },
    h("div", { class: "cases-bar" }, h("h3", {}, "Load cases"), adding.element),
    adding.meaning,
    warning,
    list.element,
    matrix.element,
  );
  // sums of before stay while the server reads the text
  let known: CaseSums | null = null;
  const update = afterPress(element, () => {
    const { doc } = store;
    if (doc && !doc.checking) known = doc.cases ?? null;
    setText(warning, lacksVariable(store.data) ? NONE_VARIABLE : "");
    warning.hidden = !lacksVariable(store.data);
    adding.update();
    list.update(known);
    matrix.update(known);
  });
  return { element, update };
}

/** The fields of a new case, and what its type means. */
function addForm(store: Store, ctx: FormContext) {
  const name = h("input", {
    type: "text",
    "aria-label": "name of a new case",
    placeholder: "name",
    spellcheck: "false",
  });
  const type = h("select", { "aria-label": "type of a new case" });
  fillOptions(
    type,
    CASE_TYPES.map(({ id, label }) => [id, label] as const),
  );
  const others = h("select", { "aria-label": "where loads without a case go" });
  fillOptions(others, [
    ["in it", "loads so far: in this case"],
    ["apart", "loads so far: in a separate permanent case"],
  ]);
  const meaning = h("p", { class: "case-meaning quiet" });
  const update = () => {
    others.hidden = countUncased(store.data) === 0;
    setText(meaning, meaningOf(type.value, store.data, store.doc?.factors));
  };
  const add = () => {
    const names = namesIn(listAt(store.data, ["cases"]));
    const own = freeName(names, name.value.trim() || usualName(store.data, type.value));
    const owner = !others.hidden && others.value === "apart" ? freeName([own], "permanent") : own;
    ctx.change(addLoadCase(store.data, own, caseOf(type.value), owner));
    name.value = "";
    name.focus();
  };
  type.addEventListener("change", update);
  name.addEventListener("keydown", (event) => {
    if (event.key === "Enter") add();
  });
  const plus = button(verbatim("+"), "Add a load case of this name and type", add, "small");
  const element = h("span", { class: "case-add" }, name, type, others, plus);
  return { element, meaning, update };
}

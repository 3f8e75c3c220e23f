// All issues of the case file below the model, and remarks on one without any; each leads to its field.

import { fill, h, setText } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import type { Store } from "../client/store";
import { type Push, repairButtons } from "../form/repairs";
import type { Issue, Remark } from "../model/issues";
import { countText, issueLine } from "../model/issues";

export interface IssueList {
  readonly element: HTMLElement;
  open(): void;
}

/** The line with the number of issues, and the list that it opens; `onChoose` is called with an issue or a remark that is clicked, `push` with a repair. */
export function issueList(store: Store, onChoose: (chosen: Issue | Remark) => void, push: Push): IssueList {
  const count = h("span", { class: "issue-count" });
  const rows = h("ul");
  const first = h("span", { class: "first-issue" });
  const summary = h("summary", {}, count, first);
  const element = h("details", { class: "issue-list" }, summary, rows);
  const makeRow = (issue: Issue) => {
    const text = h("button", { type: "button", class: "issue", onclick: () => onChoose(issue) }, issueLine(issue));
    return h(
      "li",
      {},
      text,
      repairButtons(issue, push, () => summary.focus()),
    );
  };
  const makeRemark = (remark: Remark) => {
    const attributes = { type: "button", class: "issue remark", onclick: () => onChoose(remark) } as const;
    return h("li", {}, h("button", attributes, say("Remark: {remark}", { remark: remark.words })));
  };
  let isEmpty = true;
  store.on(["doc"], () => {
    const { issues = [], remarks = [] } = store.doc ?? {};
    isEmpty = issues.length + remarks.length === 0;
    element.classList.toggle("bad", issues.length > 0);
    element.classList.toggle("doubtful", issues.length === 0 && remarks.some((remark) => remark.doubtful));
    element.classList.toggle("filled", !isEmpty);
    setText(count, store.doc?.checking ? "Checking …" : countText(issues.length, remarks.length));
    setText(first, issues[0] ? issueLine(issues[0]) : (remarks[0]?.words ?? ""));
    if (isEmpty) element.open = false;
    fill(rows, ...issues.map(makeRow), ...remarks.map(makeRemark));
  });
  element.addEventListener("click", (event) => {
    // nothing to open
    const isRow = event.target instanceof Node && rows.contains(event.target);
    if (isEmpty && !isRow) event.preventDefault();
  });
  const open = () => {
    element.open = true;
  };
  return { element, open };
}

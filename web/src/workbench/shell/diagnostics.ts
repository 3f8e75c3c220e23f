// All issues of the case file below the model; each leads to its field.
import { fill, h } from "../../viewer/shared/dom";
import type { Store } from "../client/store";
import { type Push, repairButtons } from "../form/repairs";
import type { Issue } from "../model/issues";
import { issueCount, issueLine } from "../model/issues";

export interface IssueList {
  readonly element: HTMLElement;
  open(): void;
}

/** The line with the number of issues, and the list that it opens; `onChoose` is called with an issue that is clicked, `push` with a repair. */
export function issueList(store: Store, onChoose: (issue: Issue) => void, push: Push): IssueList {
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
  store.on(["doc"], () => {
    const issues = store.doc?.issues ?? [];
    element.classList.toggle("bad", issues.length > 0);
    count.textContent = store.doc?.checking ? "Checking …" : issueCount(issues.length) || "No errors";
    first.textContent = issues[0] ? issueLine(issues[0]) : "";
    if (issues.length === 0) element.open = false;
    fill(rows, ...issues.map(makeRow));
  });
  element.addEventListener("click", (event) => {
    // nothing to open
    const isRow = event.target instanceof Node && rows.contains(event.target);
    if (store.doc?.issues.length === 0 && !isRow) event.preventDefault();
  });
  const open = () => {
    element.open = true;
  };
  return { element, open };
}

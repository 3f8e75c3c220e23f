// Issues of the case file: which field they belong to, and what they say.
import { fill, h } from "../../viewer/shared/dom";
import type { Fault } from "../client/api";
import { type Path, startsWith } from "../model/paths";
import type { Part } from "../model/schema";

/** Return the issues of a value: at its path or below. */
export function issuesAt(issues: readonly Fault[], path: Path): Fault[] {
  return issues.filter((issue) => startsWith(issue.path, path));
}

/** Return the issues of a table that none of its fields shows: of the table itself, and of unknown keys. */
export function issuesOfPart(issues: readonly Fault[], path: Path, part: Part | null): Fault[] {
  const names = new Set<string | number>(part?.fields.map((field) => field.name) ?? ["kind"]);
  return issuesAt(issues, path).filter((issue) => {
    const next = issue.path[path.length];
    return next === undefined || (typeof next === "string" && !names.has(next));
  });
}

/** Return the issues of a list itself. */
export function issuesOfList(issues: readonly Fault[], path: Path): Fault[] {
  return issuesAt(issues, path).filter((issue) => typeof issue.path[path.length] !== "number");
}

/** What an issue says, without its place. */
export type IssueText = Pick<Fault, "got" | "expected" | "mend">;

/** Return what is wrong. */
export function issueText({ got, expected, mend }: IssueText): string {
  return `found ${got}, expected ${expected}${mend ? ` — ${mend}` : ""}`;
}

/** Return what is wrong as a sentence. */
export function issueSentence(issue: IssueText): string {
  const text = issueText(issue);
  return `${text.charAt(0).toUpperCase()}${text.slice(1)}${/[.?!]$/.test(text) ? "" : "."}`;
}

/** Return where and what is wrong. */
export function issueLine(issue: IssueText & Pick<Fault, "where">): string {
  return `${issue.where}: ${issueText(issue)}`;
}

/** Return how many issues there are, empty for none. */
export function issueCount(count: number): string {
  return count === 0 ? "" : count === 1 ? "1 error" : `${count} errors`;
}

/** Show issues below what they are about. */
export function showIssues(messages: HTMLElement, issues: readonly Fault[]): void {
  const sentences = issues.map(issueSentence);
  if (messages.textContent !== sentences.join("")) fill(messages, ...sentences.map((each) => h("p", {}, each)));
}

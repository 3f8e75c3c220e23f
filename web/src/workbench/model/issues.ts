// Issues of the case file: which field they belong to, and what they say.
import { counted, keep, say, together } from "../../viewer/shared/language";
import type { Edit } from "./edits";
import { type Path, startsWith } from "./paths";
import type { Part } from "./schema";

/** A way to repair an issue: what it does, and the edits that do it. */
export interface Repair {
  label: string;
  edits: Edit[];
}

/** Something wrong in the case file; the names of its parts are the server's. */
export interface Issue {
  location: string;
  path: Path;
  found: string;
  expected: string;
  hint: string;
  repairs?: readonly Repair[];
  line?: number;
}

/** What a reader should know of a case that is right. */
export interface Remark {
  location: string;
  path: Path;
  words: string;
  /** Whether no design should pass before somebody has looked at it. */
  doubtful: boolean;
  line?: number;
}

/** Return the issues of a value: at its path or below. */
export function issuesAt(issues: readonly Issue[], path: Path): Issue[] {
  return issues.filter((issue) => startsWith(issue.path, path));
}

/** Return the issues of a table that none of its fields shows: of the table itself, and of unknown keys. */
export function issuesOfPart(issues: readonly Issue[], path: Path, part: Part | null): Issue[] {
  const names = new Set<string | number>(part?.fields.map((field) => field.name) ?? ["kind"]);
  return issuesAt(issues, path).filter((issue) => {
    const next = issue.path[path.length];
    return next === undefined || (typeof next === "string" && !names.has(next));
  });
}

/** Return the issues of a list itself. */
export function issuesOfList(issues: readonly Issue[], path: Path): Issue[] {
  return issuesAt(issues, path).filter((issue) => typeof issue.path[path.length] !== "number");
}

/** What an issue says, without its place. */
export type IssueText = Pick<Issue, "found" | "expected" | "hint">;

/** Return what is wrong. */
export function issueText({ found, expected, hint }: IssueText): string {
  if (found === "nothing" && expected === "a table [ground]") return "choose a kind";
  if (found === "nothing")
    return hint ? say("not given yet — {hint}", { hint }) : say("not given yet; expected {expected}", { expected });
  const values = { found, expected, hint };
  return say(hint ? "found {found}, expected {expected} — {hint}" : "found {found}, expected {expected}", values);
}

/** Return what is wrong as a sentence. */
export function issueSentence(issue: IssueText): string {
  const text = issueText(issue);
  return keep(`${text.charAt(0).toUpperCase()}${text.slice(1)}${/[.?!]$/.test(text) ? "" : "."}`);
}

/** Return where and what is wrong. */
export function issueLine(issue: IssueText & Pick<Issue, "location">): string {
  return together([issue.location, issueText(issue)], ": ");
}

/** Return how many issues there are, empty for none. */
export function issueCount(count: number): string {
  return count === 0 ? "" : counted(count, "1 error", "{count} errors");
}

/** Return how many issues and remarks there are. */
export function countText(issues: number, remarks: number): string {
  const words = counted(remarks, "1 remark", "{count} remarks");
  return issueCount(issues) || (remarks > 0 ? say("No errors, {remarks}", { remarks: words }) : "No errors");
}

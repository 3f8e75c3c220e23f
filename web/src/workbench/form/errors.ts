// Issues shown in the form.
import { fill, h } from "../../viewer/shared/dom";
import { type Issue, issueSentence } from "../model/issues";
import { type Push, repairButtons } from "./repairs";

const shown = new WeakMap<HTMLElement, string>();

/** Show issues below what they are about, with buttons that repair them. */
export function showIssues(messages: HTMLElement, issues: readonly Issue[], push: Push): void {
  const now = JSON.stringify(issues.map((each) => [issueSentence(each), each.repairs]));
  if ((shown.get(messages) ?? "[]") === now) return;
  shown.set(messages, now);
  const focusField = () => messages.parentElement?.querySelector<HTMLElement>("input, select, textarea")?.focus();
  fill(messages, ...issues.map((each) => h("p", {}, issueSentence(each), repairButtons(each, push, focusField))));
}

// Issues shown in the form.
import { fill, h } from "../../viewer/shared/dom";
import { type Issue, issueSentence } from "../model/issues";

/** Show issues below what they are about. */
export function showIssues(messages: HTMLElement, issues: readonly Issue[]): void {
  const sentences = issues.map(issueSentence);
  if (messages.textContent !== sentences.join("")) fill(messages, ...sentences.map((each) => h("p", {}, each)));
}

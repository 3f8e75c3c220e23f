// Controls that are made anew: the one with the keyboard keeps it, and what is being typed is never lost.
import { type Child, fill } from "../../viewer/shared/dom";

/** Whether a text in an element is being typed, and not taken yet. */
export function isTyping(element: Element): boolean {
  const { activeElement } = document;
  return (
    activeElement instanceof HTMLInputElement &&
    activeElement.type === "text" &&
    element.contains(activeElement) &&
    activeElement.value !== activeElement.defaultValue
  );
}

/** Replace the children of an element; the control with the same `data-key` as the one with the focus gets it. */
export function refill(element: Element, children: readonly Child[], key = focusKey(element)): void {
  fill(element, ...children);
  if (key) element.querySelector<HTMLElement>(`[data-key="${CSS.escape(key)}"]`)?.focus({ preventScroll: true });
}

/** Return the key of the control with the focus in an element. */
function focusKey(element: Element): string | undefined {
  const { activeElement } = document;
  return activeElement instanceof HTMLElement && element.contains(activeElement)
    ? activeElement.dataset.key
    : undefined;
}

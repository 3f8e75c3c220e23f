// Controls that are made anew: the one with the keyboard keeps it, and what is being typed is never lost.

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

/** Replace the children of an element that differ; the control with the same `data-key` as the one with the focus gets it. */
export function refill(element: Element, children: readonly (Element | null)[]): void {
  const key = focusKey(element);
  const isSelected = isAllSelected();
  const old = [...element.children];
  const made = children.filter((child) => child !== null);
  made.forEach((child, n) => {
    const before = old[n];
    if (!before) element.append(child);
    else if (!before.isEqualNode(child)) before.replaceWith(child);
  });
  for (const child of old.slice(made.length)) child.remove();
  if (!key || element.contains(document.activeElement)) return;
  const again = element.querySelector<HTMLElement>(`[data-key="${CSS.escape(key)}"]`);
  again?.focus({ preventScroll: true });
  if (isSelected && again instanceof HTMLInputElement) again.select();
}

/** Return whether all of the field with the focus is selected, so that typing replaces it. */
function isAllSelected(): boolean {
  const { activeElement: field } = document;
  return field instanceof HTMLInputElement && field.selectionStart === 0 && field.selectionEnd === field.value.length;
}

/** Return whether a change of a control in an element is being handled, whose focus has not moved yet; `call` follows. */
export function duringChange(element: Element, call: () => void): () => boolean {
  let isChanging = false;
  const begin = () => {
    isChanging = true;
    setTimeout(() => {
      isChanging = false;
      call();
    });
  };
  element.addEventListener("change", begin, { capture: true });
  return () => isChanging;
}

/** Return what calls a function, but never between press and release of a button, which would get lost; later then. */
export function afterPress(element: Element, call: () => void): () => void {
  let isPressed = false;
  let waits = false;
  const release = () => {
    if (!isPressed) return;
    // the click comes after the release
    setTimeout(() => {
      isPressed = false;
      if (waits) call();
      waits = false;
    });
  };
  element.addEventListener("pointerdown", () => {
    isPressed = true;
  });
  for (const type of ["pointerup", "pointercancel"]) document.addEventListener(type, release);
  return () => {
    if (isPressed) waits = true;
    else call();
  };
}

/** Return the key of the control with the focus in an element. */
function focusKey(element: Element): string | undefined {
  const { activeElement } = document;
  return activeElement instanceof HTMLElement && element.contains(activeElement)
    ? activeElement.dataset.key
    : undefined;
}

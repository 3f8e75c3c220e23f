// The keyboard's place in the page: it moves between areas, and when the control that has it goes, to one nearby.

const CONTROLS = "button, input, select, textarea, summary, a[href], [tabindex]:not([tabindex='-1'])";

/** Where the focus is, as the page was when it got there. */
interface Place {
  control: HTMLElement;
  /** What it is in, from the inside out; within a dialog no further than that. */
  boxes: readonly Element[];
  /** All controls of the page. */
  order: readonly HTMLElement[];
  dialog: Element | null;
}

function placeOf(control: HTMLElement): Place {
  const dialog = control.closest("dialog");
  const boxes: Element[] = [];
  for (let box: Element = control; box !== dialog && box.parentElement; box = box.parentElement)
    boxes.push(box.parentElement);
  return { control, boxes, order: [...document.querySelectorAll<HTMLElement>(CONTROLS)], dialog };
}

/** Whether a control can have the focus. */
function isUsable(control: Element): boolean {
  return control.isConnected && !control.matches(":disabled") && control.closest("[hidden], [inert]") === null;
}

/** Whether Tab may reach a control. */
function isReached(control: HTMLElement): boolean {
  return control.tabIndex >= 0 && isUsable(control) && control.checkVisibility();
}

/** Return the control nearest to a place: the next one in the innermost box that has any, else the one before. */
function nearest({ control, boxes, order }: Place): HTMLElement | undefined {
  const at = order.indexOf(control);
  for (const box of boxes.filter(isUsable)) {
    const isNear = (other: HTMLElement) => box.contains(other) && isReached(other);
    const near =
      order.slice(at + 1).find(isNear) ??
      order.slice(0, Math.max(0, at)).findLast(isNear) ??
      [...box.querySelectorAll<HTMLElement>(CONTROLS)].find(isNear);
    if (near) return near;
  }
  return undefined;
}

/** Give the focus to a control nearby when the one that has it is removed, hidden or disabled. */
export function keepFocus(): void {
  let places: readonly Place[] = []; // of the page, and of each dialog over it
  document.addEventListener("focusin", ({ target }) => {
    if (!(target instanceof HTMLElement)) return;
    const place = placeOf(target);
    places = [...places.filter(({ dialog }) => dialog !== place.dialog && dialog?.isConnected !== false), place];
  });
  const keep = () => {
    const { activeElement } = document;
    if (activeElement && activeElement !== document.body && isUsable(activeElement)) return;
    const last = places.at(-1);
    if (!last || isUsable(last.control)) return; // left on purpose
    const open = places.findLast(({ dialog }) => dialog?.isConnected !== false);
    if (open) (isUsable(open.control) ? open.control : nearest(open))?.focus();
  };
  const attributeFilter = ["hidden", "disabled", "inert"];
  new MutationObserver(keep).observe(document, { childList: true, subtree: true, attributeFilter });
}

/** Return what moves the focus to the next of some areas, or with -1 to the previous one: where it was in it last. */
export function areaKeys(areas: readonly HTMLElement[]): (by: 1 | -1) => void {
  const last = new Map<HTMLElement, HTMLElement | SVGElement>();
  const areaOf = (target: EventTarget | null) =>
    target instanceof Node ? areas.find((area) => area.contains(target)) : undefined;
  document.addEventListener("focusin", ({ target }) => {
    const area = areaOf(target);
    if (area && (target instanceof HTMLElement || target instanceof SVGElement)) last.set(area, target);
  });
  return (by) => {
    const now = areaOf(document.activeElement);
    const at = now ? areas.indexOf(now) : -1;
    const others = areas.map((_, n) => areas.at((at + by * (n + 1)) % areas.length)!);
    for (const area of others) {
      const before = last.get(area);
      const isThere = before && isUsable(before) && before.checkVisibility();
      const control = isThere ? before : [...area.querySelectorAll<HTMLElement>(CONTROLS)].find(isReached);
      if (control) return control.focus();
    }
  };
}

// Results over the entire width of the page, the model hidden.
import { button } from "../../viewer/shared/dom";

/** Inputs that no letters are typed into. */
const CHOSEN: readonly string[] = ["checkbox", "radio", "range", "button"];

/** Make the button that gives the results the entire width, or half of it again; so does the key F. */
export function wideButton(result: HTMLElement): HTMLButtonElement {
  const toggle = () => {
    const isWide = result.classList.toggle("wide");
    made.setAttribute("aria-pressed", String(isWide));
  };
  const made = button("Full width", "Show the results alone, or beside the model (F)", toggle);
  made.setAttribute("aria-pressed", "false");
  document.addEventListener("keydown", (event) => {
    const { key, target } = event;
    if (key.toLowerCase() !== "f" || event.ctrlKey || event.metaKey || event.altKey || !made.checkVisibility()) return;
    if (!(target instanceof Element) || takesLetter(target, key)) return;
    if (target.closest(".model") || target.closest("dialog")) return;
    event.preventDefault(); // a choice would look for an option of that letter
    toggle();
  });
  return made;
}

/** Whether a letter means something where it is typed: in a choice that keys are used in, if an option begins with it. */
export function takesLetter(target: Element, key: string): boolean {
  if (target instanceof HTMLInputElement) return !CHOSEN.includes(target.type);
  if (!(target instanceof HTMLSelectElement)) return target.localName === "textarea";
  const isByKeys = document.documentElement.dataset.input !== "pointer";
  return isByKeys && [...target.options].some(({ text }) => text.toLowerCase().startsWith(key.toLowerCase()));
}

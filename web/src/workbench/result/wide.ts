// Results over the entire width of the page, the model hidden.
import { button } from "../../viewer/shared/dom";

/** Elements that letters are typed into. */
const TYPED: readonly string[] = ["input", "select", "textarea"];

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
    if (!(target instanceof Element)) return;
    const isOther = TYPED.includes(target.localName) || target.closest(".model") || target.closest("dialog");
    if (!isOther) toggle();
  });
  return made;
}

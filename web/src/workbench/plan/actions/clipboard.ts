// The system's clipboard while the plan has the focus.
import type { Point } from "../../model/geometry";
import type { Actions } from "./actions";

/** Copy, cut and paste as TOML text; `pointer` is the place below the pointer, null while it is elsewhere. */
export function useClipboard(element: Element, actions: Actions, pointer: () => Point | null): void {
  const handle = (event: ClipboardEvent) => {
    if (document.activeElement !== element || !event.clipboardData) return;
    if (event.type === "paste") {
      if (actions.paste(event.clipboardData.getData("text/plain"), pointer())) event.preventDefault();
      return;
    }
    const text = actions.copy();
    if (!text) return;
    event.clipboardData.setData("text/plain", text);
    event.preventDefault();
    if (event.type === "cut") actions.remove();
  };
  for (const type of ["copy", "cut", "paste"] as const) document.addEventListener(type, handle);
}

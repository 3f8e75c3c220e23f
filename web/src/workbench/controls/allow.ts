// Controls that cannot act now are disabled and say why.
import { setRead, type Text } from "../../viewer/shared/dom";

/** Let a control act, or disable it and say why it cannot: `why` is empty where it can, `title` says what it does. */
export function allow(control: HTMLButtonElement | HTMLInputElement | HTMLSelectElement, why: Text, title: Text): void {
  control.disabled = why !== "";
  setRead(control, "title", why || title);
}

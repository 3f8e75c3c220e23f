// The documentation, which the server of this page hands out as well.
import type { Path, Table } from "../model/paths";
import { anchorOf } from "./facts";
import { pathOf } from "./field-help";

/** Open the documentation in another tab: the reference of the input at an anchor, or its start. */
export function openDocumentation(anchor = ""): void {
  const page = anchor ? `docs/input#${anchor}` : "docs/";
  window.open(new URL(page, location.href), "_blank", "noopener");
}

/** Open what the documentation says of the field with the focus, or its start. */
export function openFieldDocumentation(target: EventTarget | null, data: Table): void {
  const path: Path | null = pathOf(target);
  openDocumentation(path ? anchorOf(data, path) : "");
}

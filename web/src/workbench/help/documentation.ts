// The documentation, which the server of this page hands out as well.

/** Open the reference of the input in another tab, at an anchor. */
export function openDocumentation(anchor = ""): void {
  const page = anchor ? `docs/input#${anchor}` : "docs/";
  window.open(new URL(page, location.href), "_blank", "noopener");
}

// What is folded on the screen stands open on paper.

/** Open what is folded while the page is printed: paper has no way to open it. */
export function openOnPaper(page: Document): void {
  const opened: HTMLDetailsElement[] = [];
  window.addEventListener("beforeprint", () => {
    for (const each of page.querySelectorAll<HTMLDetailsElement>("details.folded:not([open])")) {
      each.open = true;
      opened.push(each);
    }
  });
  window.addEventListener("afterprint", () => {
    for (const each of opened.splice(0)) each.open = false;
  });
}

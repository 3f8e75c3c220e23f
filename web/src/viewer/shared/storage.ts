// Texts that the browser keeps between visits; a page without storage, as from file://, forgets them.

export function readStored(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

export function writeStored(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    // the value lasts as long as the page
  }
}

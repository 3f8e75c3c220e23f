// Light and dark: by the system's wish until the user chooses; the choice is kept where the browser allows it.

export type Theme = "light" | "dark";

const KEY = "groundslab-theme";
const DARK = "(prefers-color-scheme: dark)";

/** Return the theme that holds: the user's choice, else the system's. */
export function theme(): Theme {
  const chosen = document.documentElement.dataset["theme"] ?? kept();
  if (chosen === "light" || chosen === "dark") return chosen;
  return matchMedia(DARK).matches ? "dark" : "light";
}

/** Put a theme into force and remember it. */
export function setTheme(to: Theme): void {
  document.documentElement.dataset["theme"] = to;
  try {
    localStorage.setItem(KEY, to);
  } catch {
    // a page from file:// may have no storage: then the choice lasts as long as the page
  }
  for (const tell of LISTENERS) tell(to);
}

/** Call back whenever the theme changes, by the user or by the system; returns what ends it. */
export function onTheme(tell: (theme: Theme) => void): () => void {
  LISTENERS.add(tell);
  const bySystem = () => tell(theme());
  const query = matchMedia(DARK);
  query.addEventListener("change", bySystem);
  return () => {
    LISTENERS.delete(tell);
    query.removeEventListener("change", bySystem);
  };
}

/** Put the kept choice into force; call once when the page starts. */
export function startTheme(): void {
  const chosen = kept();
  if (chosen) document.documentElement.dataset["theme"] = chosen;
}

const LISTENERS = new Set<(theme: Theme) => void>();

function kept(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

// Light and dark: the system's preference until the user chooses; the choice is stored where the browser allows it.
import { readStored, writeStored } from "./storage";

export type Theme = "light" | "dark";

const KEY = "groundslab-theme";
const DARK = "(prefers-color-scheme: dark)";
const listeners = new Set<(theme: Theme) => void>();

/** Return the theme in force: the user's choice, else the system's preference. */
export function currentTheme(): Theme {
  const chosen = document.documentElement.dataset.theme ?? readStored(KEY);
  if (chosen === "light" || chosen === "dark") return chosen;
  return matchMedia(DARK).matches ? "dark" : "light";
}

/** Switch between light and dark, and store the choice. */
export function switchTheme(): void {
  const theme = currentTheme() === "dark" ? "light" : "dark";
  document.documentElement.dataset.theme = theme;
  writeStored(KEY, theme);
  for (const listener of listeners) listener(theme);
}

/** Call back whenever the theme changes, by the user or the system. */
export function onThemeChange(listener: (theme: Theme) => void): void {
  listeners.add(listener);
  matchMedia(DARK).addEventListener("change", () => listener(currentTheme()));
}

/** Apply the stored choice; call once when the page starts. */
export function startTheme(): void {
  const chosen = readStored(KEY);
  if (chosen) document.documentElement.dataset.theme = chosen;
}

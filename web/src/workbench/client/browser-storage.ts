// What the browser remembers between visits: the token of the server, what is unfolded.

const TOKEN = "groundslab-token";
const SECTIONS = "groundslab-sections";

/** The token in the page's address, which is then taken out of it; else the one that this tab had before. */
export function takeToken(): string {
  const address = new URL(location.href);
  const token = address.searchParams.get("token");
  if (token === null) return sessionStorage.getItem(TOKEN) ?? "";
  sessionStorage.setItem(TOKEN, token);
  address.searchParams.delete("token");
  history.replaceState(null, "", address);
  new BroadcastChannel(TOKEN).postMessage(token);
  return token;
}

/** Hear of a token that another tab of the same address has taken: the server was started anew. */
export function tokenFromElsewhere(take: (token: string) => void): void {
  new BroadcastChannel(TOKEN).addEventListener("message", (event: MessageEvent<unknown>) => {
    if (typeof event.data !== "string") return;
    sessionStorage.setItem(TOKEN, event.data);
    take(event.data);
  });
}

/** Which sections of the form are unfolded. */
export const openSections = {
  read(): string[] | null {
    const text = read(SECTIONS);
    return text === null ? null : text.split(" ").filter(Boolean);
  },
  write(keys: string[]): void {
    write(SECTIONS, keys.join(" "));
  },
};

function read(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

function write(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    // without storage the page forgets
  }
}

// What the browser keeps between visits: the server's token, which sections of the form are open.
import { readStored, writeStored } from "../../viewer/shared/storage";

const TOKEN = "groundslab-token";
const SECTIONS = "groundslab-sections";

/** Return the token in the page's address, which is then removed from it; else the one that this tab had before. */
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

/** Call back with a token that another tab of the same address has taken, because the server was restarted. */
export function onTokenElsewhere(listener: (token: string) => void): void {
  new BroadcastChannel(TOKEN).addEventListener("message", (event: MessageEvent<unknown>) => {
    if (typeof event.data !== "string") return;
    sessionStorage.setItem(TOKEN, event.data);
    listener(event.data);
  });
}

/** Which sections of the form are open. */
export const openSections = {
  read: (): string[] | null => readStored(SECTIONS)?.split(" ").filter(Boolean) ?? null,
  write: (keys: string[]): void => writeStored(SECTIONS, keys.join(" ")),
};

// Messages across the page: the server is away, edits wait, something was refused.

import { button, type Child, fill, h } from "../../viewer/shared/dom";
import { counted, say } from "../../viewer/shared/language";
import type { Store } from "../client/store";

/** The banner below the top bar; hidden while there is nothing to report. */
export function banner(store: Store, retry: () => void): HTMLElement {
  const element = h("div", { class: "banner", role: "alert", hidden: true });
  const update = () => {
    const count = store.waitingCount;
    const edits = counted(count, "1 edit is", "{count} edits are");
    const kept =
      count === 0 ? "Nothing is lost." : say("{edits} kept here and will be sent when it responds.", { edits });
    const show = (title: string, ...text: Child[]) =>
      fill(element, h("strong", {}, title), ...text, button("Try now", "", retry, "small"));
    element.hidden = store.connection === "ok";
    if (store.connection === "away") {
      const command = h("code", {}, startCommand(store));
      show(
        "The server is not responding. ",
        say("{kept} If it has stopped, restart it with", { kept }),
        " ",
        command,
        ". ",
      );
    } else if (store.connection === "unauthorized")
      show(
        "A different server is running. ",
        say("{kept} Open the address it printed; this page will then connect to it.", { kept }),
        " ",
      );
  };
  store.on(["connection", "waiting"], update);
  return element;
}

/** Return the command that starts a server to which this page can reconnect. */
function startCommand(store: Store): string {
  const file = store.doc?.file;
  return `groundslab ${store.doc?.view === undefined ? "app" : "view"} --port ${location.port}${file ? ` "${file}"` : ""}`;
}

const NOTICE_TIME = 6000; // ms that a message of success stays

/** A short message at the lower edge, with an action. */
export function notices(store: Store): HTMLElement {
  const element = h("div", { class: "notice", role: "status", hidden: true });
  const close = () => store.set("notice", null);
  let timer: ReturnType<typeof setTimeout> | undefined;
  store.on(["notice"], () => {
    clearTimeout(timer);
    const { notice } = store;
    element.hidden = notice === null;
    if (!notice) return;
    element.className = `notice ${notice.kind}`;
    const act = () => {
      close();
      notice.action?.run();
    };
    fill(
      element,
      h("span", {}, notice.text),
      notice.action && button(notice.action.label, "", act, "small"),
      h("button", { type: "button", class: "icon", "aria-label": "dismiss message", onclick: close }, "×"),
    );
    if (notice.kind === "info") timer = setTimeout(close, NOTICE_TIME);
  });
  return element;
}

// Messages across the page: the server is away, edits wait, something was refused.

import { fill, h } from "../../viewer/shared/dom";
import type { Store } from "../client/store";

/** The banner below the top bar; hidden while there is nothing to report. */
export function banner(store: Store, retry: () => void): HTMLElement {
  const element = h("div", { class: "banner", role: "alert", hidden: true });
  const update = () => {
    const count = store.waitingCount;
    const kept =
      count === 0
        ? "Nothing is lost."
        : count === 1
          ? "1 edit is kept here and sent when it answers."
          : `${count} edits are kept here and sent when it answers.`;
    element.hidden = store.connection === "ok";
    if (store.connection === "away") {
      fill(
        element,
        h("strong", {}, "The server does not answer. "),
        `${kept} If it has ended, start it again with `,
        h("code", {}, startCommand(store)),
        ". ",
        h("button", { type: "button", class: "small", onclick: retry }, "Try now"),
      );
    } else if (store.connection === "unauthorized") {
      fill(
        element,
        h("strong", {}, "Another server has been started. "),
        `${kept} Open the address that it has printed; this page then goes on with it. `,
        h("button", { type: "button", class: "small", onclick: retry }, "Try now"),
      );
    }
  };
  store.on(["connection", "waiting"], update);
  return element;
}

/** Return the command that starts a server to which this page can reconnect. */
function startCommand(store: Store): string {
  const file = store.doc?.file;
  return `groundslab app --port ${location.port}${file ? ` "${file}"` : ""}`;
}

const NOTICE_TIME = 6000; // ms that a message of success stays

/** A short message at the lower edge, with an action. */
export function notices(store: Store): HTMLElement {
  const element = h("div", { class: "notice", role: "status", hidden: true });
  let timer: ReturnType<typeof setTimeout> | null = null;
  store.on(["notice"], () => {
    if (timer !== null) clearTimeout(timer);
    const { notice } = store;
    element.hidden = notice === null;
    if (!notice) return;
    element.className = `notice ${notice.kind}`;
    const { action } = notice;
    fill(
      element,
      h("span", {}, notice.text),
      action
        ? h(
            "button",
            {
              type: "button",
              class: "small",
              onclick: () => {
                store.notify(null);
                action.run();
              },
            },
            action.label,
          )
        : null,
      h(
        "button",
        { type: "button", class: "icon", "aria-label": "close this message", onclick: () => store.notify(null) },
        "×",
      ),
    );
    timer = notice.kind === "info" ? setTimeout(() => store.notify(null), NOTICE_TIME) : null;
  });
  return element;
}

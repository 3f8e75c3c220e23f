// The workbench's page: model on the left, result on the right.
import { chosenLanguage, say } from "../viewer/shared/language";
import { startTheme } from "../viewer/shared/theme";
import "../viewer/shared/theme.css";
import { h, setText } from "../viewer/shared/dom";
import { type DocState, HttpApi } from "./client/api";
import { onTokenElsewhere, takeToken } from "./client/browser-storage";
import { Connection } from "./client/connection";
import { EditQueue } from "./client/edit-queue";
import { Store } from "./client/store";
import { keepFocus } from "./controls/focus";
import { isUntouched } from "./model/changes/optimistic-edits";
import { speak } from "./shell/language-switch";
import { buildPage, buildView } from "./shell/page";
import { askOffer, askWhichText } from "./shell/unsaved-work";

startTheme();
const api = new HttpApi(takeToken());
const store = new Store();
const queue: EditQueue = new EditQueue(api, {
  base: () => store.doc?.version ?? 0,
  adopt: (state, waiting) => store.setDoc(state, waiting),
  fits: (change, state) => isUntouched(change, store.doc?.data ?? {}, state.data ?? {}),
  onRefused: (change, why) =>
    store.set("notice", { kind: "bad", text: say("“{change}” failed: {why}", { change: change.text, why }) }),
  onLost: (error) => connection.handleLoss(error),
  onChange: () => store.setWaiting(queue.waiting),
});
const resolveOffer = (state: DocState) => askOffer(api, state);
const connection: Connection = new Connection(api, store, queue, { resolveOffer, askWhichText });

// while the keyboard is used, the drawing shows that it has the focus
const setInput = (kind: string) => {
  document.documentElement.dataset.input = kind;
};
const onKey = (event: KeyboardEvent) => {
  if (event.key === "Tab" || event.key.startsWith("Arrow")) setInput("keys");
};
document.addEventListener("keydown", onKey, { capture: true });
document.addEventListener("pointerdown", () => setInput("pointer"), { capture: true });
onTokenElsewhere((token) => {
  api.setToken(token);
  connection.retry(true);
});
addEventListener("beforeunload", (event) => {
  // what the server has is kept; what it has not would be lost
  if (store.waitingCount > 0) event.preventDefault();
});
keepFocus();
const stop = store.on(["doc"], () => {
  // the first text may still be being read
  if (store.doc?.data === null && store.doc.checking) return;
  stop();
  void speak(api, store, () => connection.start()).then(() => {
    if (store.doc?.view !== undefined) buildView(api, store, connection);
    else buildPage(api, store, queue, connection, resolveOffer);
  });
});
const cover = h("p", { class: "cover" }, "Loading …");
document.body.replaceChildren(cover);
store.on(["connection"], () => {
  const invalid = "This address is no longer valid. Open the address printed by groundslab app.";
  const silent = "The server is not responding. Start it with: groundslab app";
  setText(cover, store.connection === "unauthorized" ? invalid : silent);
});
document.documentElement.lang = chosenLanguage(null);
await connection.start();

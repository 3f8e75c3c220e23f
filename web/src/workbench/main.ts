// The workbench's page: model on the left, result on the right.

import { startTheme } from "../viewer";
import "../viewer/shared/theme.css";
import { type Change, type DocState, HttpApi, type Stranger, type Unreachable } from "./client/api";
import { openSections, takeToken, tokenFromElsewhere } from "./client/browser-storage";
import { Connection } from "./client/connection";
import { EditQueue } from "./client/edit-queue";
import { Store } from "./client/store";
import type { FormContext } from "./form/context";
import { formPanel } from "./form/form-panel";
import { sameValue, valueAt } from "./model/paths";
import { Schema } from "./model/schema";
import { planEditor } from "./plan/plan-editor";
import { resultPanel } from "./result/result-panel";
import { banner, notices } from "./shell/banner";
import { Actions } from "./shell/commands";
import { faultList } from "./shell/diagnostics";
import { ask } from "./shell/dialogs";
import { h } from "./shell/elements";
import { splitter } from "./shell/splitter";
import { tabs } from "./shell/tabs";
import { topBar } from "./shell/top-bar";
import { textPanel } from "./text/text-panel";
import "./shell/page.css";
import "./plan/plan-editor.css";
import "./form/form.css";
import "./result/result.css";
import "./text/text-panel.css";

startTheme();
const api = new HttpApi(takeToken());
const store = new Store();
const queue: EditQueue = new EditQueue(api, {
  base: () => store.doc?.version ?? 0,
  adopt: (state, waiting) => store.setDoc(state, waiting),
  fits: (change, state) => untouched(change, state),
  refused: (change, why) => store.say({ kind: "bad", text: `“${change.text}” was not done: ${why}` }),
  lost: (error) => connection.lost(error),
  changed: () => store.setWaiting(queue.waiting),
});
const connection: Connection = new Connection(api, store, queue, { offered, differs });
const push = (change: Change) => queue.push(change);
const lost = (error: Unreachable | Stranger) => connection.lost(error);

/** Whether what an edit is about is the same in another state as it was here. */
function untouched(change: Change, state: DocState): boolean {
  return change.edits.every((edit) => {
    if (edit.op === "text") return false;
    const thing = edit.op === "add" ? edit.path : edit.path.slice(0, 2);
    return sameValue(valueAt(store.doc?.data ?? undefined, thing), valueAt(state.data ?? undefined, thing));
  });
}

/** Ask what is to become of unsaved work that the server has found. */
async function offered(state: DocState): Promise<DocState> {
  const { offer } = state;
  if (!offer) return state;
  const changed =
    offer.changed === true
      ? ["The file itself has been changed since by another program; saving asks before it replaces that."]
      : [];
  const of = offer.file === null ? "a case that was never saved" : offer.file;
  const take = await ask(
    "Unsaved work was found",
    [
      `An earlier run ended with changes that were not saved: ${of}, last changed ${moment(offer.when)}.`,
      "Taking them up is a step that can be undone; the file on the disk stays as it is until you save.",
      ...changed,
    ],
    [
      { label: "Put them aside", value: false },
      { label: "Take them up", value: true, main: true },
    ],
    null,
  );
  // there may be more, of still earlier runs
  return offered(await api.restore(take));
}

/** Say what the state warns of: unsaved work that cannot be kept, a file that another program has changed. */
function warnings(actions: Actions): void {
  let told = "";
  store.on(["doc"], () => {
    const { doc } = store;
    const unkept = doc?.unkept ?? "";
    const words = unkept || (doc?.outside ? "Another program has changed the file since it was read." : "");
    if (words === told) return;
    told = words;
    if (unkept) store.say({ kind: "bad", text: `${unkept}. Save soon.` });
    else if (words && doc?.file) {
      const { file } = doc;
      store.say({
        kind: "bad",
        text: words,
        action: { label: "Read it anew", run: () => void actions.openFile(file) },
      });
    }
  });
}

async function differs(server: DocState, _own: string): Promise<"page" | "server"> {
  return ask(
    "Which text counts?",
    [
      `The server now holds another text (${server.file ?? "not saved yet"}) than this page, which has unsaved changes.`,
    ],
    [
      { label: "Take the server's", value: "server" as const },
      { label: "Keep the page's", value: "page" as const, main: true },
    ],
    null,
  );
}

function moment(when: string): string {
  const date = new Date(when);
  return Number.isNaN(date.getTime())
    ? when
    : date.toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" });
}

/** Make the page once schema and document are there. */
function build(): void {
  if (!store.schema || !store.doc) return;
  const ctx: FormContext = {
    schema: new Schema(store.schema),
    memory: new Map(),
    data: () => store.data,
    faults: () => store.doc?.faults ?? [],
    change: push,
  };
  const form = formPanel(ctx, openSections);
  const plan = planEditor(store, ctx, push);
  const text = textPanel(store, (value, typedOn) =>
    push({ edits: [{ op: "text", value }], text: "edit the text", ...(typedOn ? { merge: true } : {}) }),
  );
  const broken = h(
    "p",
    { class: "broken", role: "alert", hidden: true },
    "The text cannot be read at present; mend it under Text, or undo. Form and drawing show what was there before.",
  );
  const planTab = h("div", { class: "panel" }, plan.element);
  const formTab = h("div", { class: "panel scrolls" }, form.element);
  const textTab = h("div", { class: "panel" }, text.element);
  const left = tabs(
    [
      { name: "plan", label: "Plan", panel: planTab },
      { name: "form", label: "Form", panel: formTab },
      { name: "text", label: "Text", panel: textTab },
    ],
    "model",
    (name) => {
      if (name === "form") form.update();
      if (name === "text") text.refresh();
    },
  );
  const faults = faultList(store, (fault) => {
    if (fault.path.length === 0 || left.current() === "text") {
      left.show("text");
      text.reveal(fault.path, fault.line);
    } else if (left.current() !== "plan" || !plan.reveal(fault.path)) {
      left.show("form");
      form.reveal(fault.path);
    }
  });
  const flush = () => {
    const { activeElement } = document;
    if (activeElement instanceof HTMLInputElement) activeElement.dispatchEvent(new Event("change"));
    text.flush();
  };
  const actions = new Actions(api, store, queue, lost, flush, () => faults.open(), offered);
  warnings(actions);
  const model = h(
    "section",
    { class: "model", "aria-label": "model" },
    h("h2", { class: "unseen" }, "Model"),
    left.bar,
    broken,
    planTab,
    formTab,
    textTab,
    faults.element,
  );
  const results = resultPanel(store, api, () => void actions.solve(), lost);
  const page = h("main", { class: "page" });
  page.append(model, splitter(page, "--model-share", "x", 0.5, [0.25, 0.75], "width of the model"), results.element);
  document.body.replaceChildren(
    topBar(store, api, actions),
    banner(store, () => connection.retry()),
    page,
    notices(store),
  );
  // what is not seen is brought up to date when it is
  store.on(["data", "doc"], () => {
    if (left.current() === "form") form.update();
  });
  store.on(["doc"], () => {
    broken.hidden = !store.broken;
    formTab.toggleAttribute("inert", store.broken);
  });
  document.addEventListener("keydown", (event) => keys(event, actions));
  for (const topic of ["doc", "data", "connection", "run", "solved", "selection", "waiting", "autosolve"] as const)
    store.tell(topic);
}

/** Keys that hold everywhere. */
function keys(event: KeyboardEvent, actions: Actions): void {
  const command = event.ctrlKey || event.metaKey;
  const key = event.key.toLowerCase();
  const inText = event.target instanceof HTMLTextAreaElement;
  const run = (action: () => Promise<unknown>) => {
    event.preventDefault();
    void action();
  };
  if (document.querySelector("dialog[open]")) return;
  if (command && key === "s") run(event.shiftKey ? actions.saveAs : actions.save);
  else if (command && key === "o") run(actions.open);
  else if (event.key === "F9" || (command && event.key === "Enter")) run(actions.solve);
  else if (command && key === "z" && !inText) run(event.shiftKey ? actions.redo : actions.undo);
  else if (command && key === "y" && !inText) run(actions.redo);
}

// where the keyboard is in use, the drawing shows that it has it
document.addEventListener(
  "keydown",
  (event) => {
    if (event.key === "Tab" || event.key.startsWith("Arrow")) document.documentElement.dataset.input = "keys";
  },
  { capture: true },
);
document.addEventListener("pointerdown", () => (document.documentElement.dataset.input = "pointer"), { capture: true });
tokenFromElsewhere((token) => {
  api.setToken(token);
  connection.retry(true);
});
addEventListener("beforeunload", (event) => {
  // what the server has is kept; what it has not would be lost
  if (store.waitingCount > 0) event.preventDefault();
});
const stop = store.on(["doc"], () => {
  // the first text may still be being read
  if (store.doc?.data === null && store.doc.checking) return;
  stop();
  build();
});
const cover = h("p", { class: "cover" }, "Loading …");
document.body.replaceChildren(cover);
store.on(["connection"], () => {
  if (!cover.isConnected) return;
  cover.textContent =
    store.connection === "stranger"
      ? "This address is not valid any more. Open the address that groundslab app has printed."
      : "The server does not answer. Start it with: groundslab app";
});
await connection.start();

// The page, made once schema and document are there.

import { h, setText } from "../../viewer/shared/dom";
import { say, together } from "../../viewer/shared/language";
import { casesPanel } from "../cases/cases-panel";
import type { DocState, HttpApi, Which } from "../client/api";
import { openSections } from "../client/browser-storage";
import type { Connection } from "../client/connection";
import type { EditQueue } from "../client/edit-queue";
import type { Store } from "../client/store";
import { areaKeys } from "../controls/focus";
import { splitter } from "../controls/splitter";
import { tabs } from "../controls/tabs";
import type { FormContext } from "../form/context";
import { formPanel } from "../form/form-panel";
import { openDocumentation, openFieldDocumentation } from "../help/documentation";
import { fieldHelp } from "../help/field-help";
import { asksForKeys, showKeys } from "../help/keys";
import { isTourTaken, startTour } from "../help/tour";
import { followAxes } from "../model/changes/axis-references";
import type { Change } from "../model/edits";
import type { Issue, Remark } from "../model/issues";
import type { Path } from "../model/paths";
import { Schema } from "../model/schema";
import { planEditor } from "../plan/plan-editor";
import { TOOLS } from "../plan/tools";
import { ResultPanel } from "../result/result-panel";
import { TablesPanel } from "../tables/tables-panel";
import { TextPanel } from "../text/text-panel";
import { banner, notices } from "./banner";
import { changedFileBanner } from "./changed-file";
import { Commands } from "./commands";
import { issueList } from "./diagnostics";
import { topBar, viewBar } from "./top-bar";
import { showWarnings } from "./unsaved-work";
import "./page.css";

export function buildPage(
  api: HttpApi,
  store: Store,
  queue: EditQueue,
  connection: Connection,
  resolveOffer: (state: DocState) => Promise<DocState>,
): void {
  if (!store.schema || !store.doc) return;
  const push = (change: Change) => queue.push(followAxes(store.data, change));
  const model = modelPanel(store, new Schema(store.schema), push);
  const lost = connection.handleLoss.bind(connection);
  const commands = new Commands(api, store, queue, lost, model.flush, model.openIssues, resolveOffer);
  showWarnings(store);
  const result = new ResultPanel(store, api, lost, {
    solve: () => void commands.solve(),
    push,
  });
  const page = h("main", { class: "page" });
  page.append(
    model.element,
    splitter(page, "--model-share", "x", 0.5, [0.25, 0.75], "model panel width"),
    result.element,
  );
  const takeTour = () => startTour(model.show);
  const help: Help = {
    showKeys: () => showKeys(TOOLS, takeTour),
    open: (target) => openFieldDocumentation(target, store.data),
  };
  const top = topBar(store, api, commands, help.showKeys, lost);
  const toArea = areaKeys([top, model.element, result.element]);
  const take = async (which: Which, digest: string) => void (await commands.takeFile(which, digest));
  document.body.replaceChildren(
    top,
    banner(store, () => connection.retry()),
    changedFileBanner(store, api, { take, onLost: lost }),
    page,
    notices(store),
  );
  document.addEventListener("keydown", (event) => handleKey(event, commands, help, toArea));
  store.emitAll();
  if (!isTourTaken() && !document.querySelector("dialog[open]")) takeTour();
}

/** The page of results that are only looked at. */
export function buildView(api: HttpApi, store: Store, connection: Connection): void {
  const result = new ResultPanel(store, api, connection.handleLoss.bind(connection), null);
  const page = h("main", { class: "page alone" }, result.element);
  document.body.replaceChildren(
    viewBar(store, api),
    banner(store, () => connection.retry()),
    page,
    notices(store),
  );
  store.emitAll();
}

/** The left half: plan, form and text of the model, and its issues. */
function modelPanel(store: Store, schema: Schema, push: (change: Change) => void) {
  const ctx = formContext(store, schema, push);
  const form = formPanel(ctx, openSections);
  const plan = planEditor(store, ctx, push);
  const sheets = new TablesPanel(store, ctx);
  const cases = casesPanel(store, ctx);
  const text = new TextPanel(store, (value, continued) => {
    const change: Change = { edits: [{ op: "text", value }], text: "edit the text" };
    push(continued ? { ...change, merge: true } : change);
  });
  const broken = h("p", { class: "broken", role: "alert", hidden: true });
  const planTab = h("div", { class: "panel plan-help" }, plan.element);
  const formTab = h("div", { class: "panel scrolls" }, form.element);
  const tablesTab = h("div", { class: "panel" }, sheets.element);
  for (const panel of [planTab, formTab]) panel.append(fieldHelp(ctx, panel, openDocumentation));
  const casesTab = h("div", { class: "panel" }, cases.element);
  const textTab = h("div", { class: "panel" }, text.element);
  const views = tabs(
    [
      { name: "plan", label: "Plan", panel: planTab },
      { name: "form", label: "Form", panel: formTab },
      { name: "tables", label: "Tables", panel: tablesTab },
      { name: "cases", label: "Load cases", panel: casesTab },
      { name: "text", label: "Text", panel: textTab },
    ],
    "model",
    (name) => {
      if (name === "form") form.update();
      if (name === "tables") sheets.show();
      if (name === "cases") cases.update();
      if (name === "text") text.draw();
    },
  );
  const shown: Partial<Record<string, { reveal(path: Path): boolean }>> = { plan, tables: sheets };
  const reveal = (issue: Issue | Remark) => {
    if (issue.path.length === 0 || views.current() === "text") {
      views.show("text");
      text.reveal(issue.line ?? 1);
    } else if (!shown[views.current()]?.reveal(issue.path)) {
      views.show("form");
      form.reveal(issue.path);
    }
  };
  const issues = issueList(store, reveal, push);
  store.on(["data", "doc"], () => {
    // what is hidden is updated when it is shown
    if (views.current() === "form") form.update();
    if (views.current() === "tables") sheets.update();
    if (views.current() === "cases") cases.update();
    broken.hidden = !store.broken;
    if (store.broken) setText(broken, brokenText(store.doc?.issues[0]?.line, Object.keys(store.data).length === 0));
    for (const part of [formTab, tablesTab, casesTab, planTab.querySelector(".property-body")])
      part?.toggleAttribute("inert", store.broken);
  });
  const title = h("h2", { class: "unseen" }, "Model");
  const children = [title, views.bar, broken, planTab, formTab, tablesTab, casesTab, textTab, issues.element];
  const flush = () => {
    sendTyped();
    text.flush();
  };
  const element = h("section", { class: "model", "aria-label": "model" }, ...children);
  return { element, flush, openIssues: issues.open, show: views.show };
}

/** What is said of a text that cannot be read, because of one of its lines, and of what is shown meanwhile. */
function brokenText(line: number | undefined, nothingBefore: boolean): string {
  const where =
    line === undefined ? "The text cannot be read." : say("The text cannot be read (line {line}).", { line });
  const shown = nothingBefore ? "There is nothing to draw yet." : "All else shows the last text that could be read.";
  return together([where, shown, "Correct it under Text, or undo."]);
}

function formContext(store: Store, schema: Schema, push: (change: Change) => void): FormContext {
  const memory: FormContext["memory"] = new Map();
  store.on(["opened"], () => memory.clear());
  return {
    schema,
    memory,
    data: () => store.data,
    issues: () => store.doc?.issues ?? [],
    change: push,
    notify: (text) => store.set("notice", { kind: "info", text }),
  };
}

/** Send what is being typed into a field. */
function sendTyped(): void {
  const { activeElement } = document;
  // a box that is ticked has sent its value, and would send it again and again
  const isTyped = activeElement instanceof HTMLInputElement && activeElement.type === "text";
  if (isTyped) activeElement.dispatchEvent(new Event("change"));
}

/** Help by keys: the list of them, and the documentation of the field that has the focus. */
interface Help {
  showKeys(): void;
  open(target: EventTarget | null): void;
}

/** Handle keys that hold everywhere. */
function handleKey(event: KeyboardEvent, commands: Commands, help: Help, toArea: (by: 1 | -1) => void): void {
  const isCommand = event.ctrlKey || event.metaKey;
  const key = event.key.toLowerCase();
  const inText = event.target instanceof HTMLTextAreaElement;
  const run = (command: () => Promise<unknown>) => {
    event.preventDefault();
    void command();
  };
  if (document.querySelector("dialog[open]")) return;
  if (isCommand && key === "s") run(event.shiftKey ? commands.saveAs : commands.save);
  else if (isCommand && key === "o") run(commands.open);
  else if (event.key === "F9" || (isCommand && event.key === "Enter")) run(commands.solve);
  else if (isCommand && key === "z" && !inText) run(event.shiftKey ? commands.redo : commands.undo);
  else if (isCommand && key === "y" && !inText) run(commands.redo);
  else if (event.key === "F6") {
    event.preventDefault();
    toArea(event.shiftKey ? -1 : 1);
  } else if (event.key === "F1") {
    event.preventDefault();
    help.open(event.target);
  } else if (asksForKeys(event)) {
    event.preventDefault();
    help.showKeys();
  }
}

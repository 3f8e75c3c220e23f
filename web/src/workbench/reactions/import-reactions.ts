// Importing a table of reactions: what it changes is shown, then it is taken as one step of undo.

import { button, fill, h, newId, setText } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import type { Api, Refused } from "../client/api";
import type { Store } from "../client/store";
import { closeDialog, openDialog } from "../controls/dialogs";
import {
  choiceOf,
  DECIMALS,
  HORIZONTAL,
  lastReading,
  MOMENTS,
  POSITIVE,
  type ReactionChanges,
  type TypedReactions,
} from "../model/reactions";
import "./reactions.css";

/** What the import of reactions needs. */
export interface ReactionImporter {
  api: Pick<Api, "reactions" | "takeReactions">;
  store: Store;
  /** Do something with the server after all edits have been sent; `known` handles a refusal itself. */
  run(run: () => Promise<void>, known: (error: Refused) => boolean): Promise<boolean>;
}

/** Show what a table changes until it is taken, or the dialog is closed. */
export function importReactions(file: string, importer: ReactionImporter): Promise<void> {
  return new Promise((resolve) => new ReactionDialog(file, importer, resolve).start());
}

class ReactionDialog {
  private readonly texts = {
    newCases: this.area("LIVE = B\nWIND = wind"),
    cases: this.area("DEAD = G"),
    supports: this.area("101 = A"),
    withoutCases: this.area("COMB1"),
    withoutSupports: this.area("105"),
    tolerance: this.line("0.1 m"),
    widthX: this.line("0.4 m"),
    widthY: this.line("0.4 m"),
    force: this.line("kN"),
    moment: this.line("kNm"),
    length: this.line("m"),
    sheet: this.line("Reactions"),
    headings: this.area("support = Pos\nF_z = V max"),
    onlyCase: this.line("G"),
    originX: this.line("0 m"),
    originY: this.line("0 m"),
  };
  private readonly positive = this.choice(POSITIVE);
  private readonly moments = this.choice(MOMENTS);
  private readonly horizontal = this.choice(HORIZONTAL);
  private readonly decimals = this.choice(DECIMALS);
  private readonly mirrored = h("input", { type: "checkbox" });
  private readonly moveColumns = h("input", { type: "checkbox" });
  private readonly message = h("p", { class: "messages", role: "alert" });
  private readonly found = h("div", { class: "reactions-found", tabindex: 0, role: "region", "aria-label": "changes" });
  private readonly take = h("button", { type: "submit", class: "main", disabled: true }, "Import");
  private readonly dialog: HTMLDialogElement;
  private turn = 0; // the latest look; late answers are not shown

  constructor(
    private readonly file: string,
    private readonly importer: ReactionImporter,
    private readonly resolve: () => void,
  ) {
    const title = say("Import reactions from {file}", { file: verbatim(file.replace(/^.*[\\/]/, "")) });
    const form = h(
      "form",
      { method: "dialog", class: "reactions-form" },
      h("h2", {}, title),
      h("div", { class: "reactions-parts" }, this.settings(), this.found),
      this.message,
      h(
        "div",
        { class: "answers" },
        button("Cancel", "", () => this.close()),
        button("Show changes", "Read the table with these settings", () => void this.look()),
        this.take,
      ),
    );
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.accept();
    });
    // what was shown is no longer what would be taken
    form.addEventListener("input", () => this.outdate());
    this.dialog = h("dialog", { class: "reactions-dialog", "aria-label": title }, form);
  }

  start(): void {
    const last = lastReading(this.importer.store.doc?.data ?? null);
    this.positive.value = last.positive;
    this.moments.value = last.moments;
    this.mirrored.checked = last.mirrored;
    this.horizontal.value = last.horizontal;
    openDialog(this.dialog, () => this.close());
    void this.look();
  }

  private close(): void {
    this.turn += 1;
    closeDialog(this.dialog);
    this.resolve();
  }

  private area(placeholder: string): HTMLTextAreaElement {
    return h("textarea", { id: newId("reactions"), rows: 2, placeholder, spellcheck: "false" });
  }

  private line(placeholder: string): HTMLInputElement {
    return h("input", { id: newId("reactions"), placeholder, size: 8, maxlength: 40, spellcheck: "false" });
  }

  private choice(words: readonly string[]): HTMLSelectElement {
    const options = words.map((word) => h("option", { value: word }, word || "as the numbers say"));
    return h("select", { id: newId("reactions") }, ...options);
  }

  private settings(): HTMLElement {
    const { texts } = this;
    const label = (text: string, input: HTMLElement) => h("label", { for: input.id }, text, input);
    return h(
      "div",
      { class: "reactions-settings" },
      label("new load cases and their actions", texts.newCases),
      label("load cases with another name here", texts.cases),
      label("supports with another name here", texts.supports),
      label("load cases left out", texts.withoutCases),
      label("supports left out", texts.withoutSupports),
      label("positive vertical force", this.positive),
      label("moments", this.moments),
      label("horizontal forces act", this.horizontal),
      label("x of the table's origin", texts.originX),
      label("y of it", texts.originY),
      label("same place up to", texts.tolerance),
      label("width of new columns along x", texts.widthX),
      label("along y", texts.widthY),
      label("unit of forces, if none is stated", texts.force),
      label("of moments", texts.moment),
      label("of coordinates", texts.length),
      label("sheet, if several have reactions", texts.sheet),
      label("headings with unusual names", texts.headings),
      label("before decimals", this.decimals),
      label("load case, if the table names none", texts.onlyCase),
      h("label", { class: "check" }, this.mirrored, "y points the other way"),
      h("label", { class: "check" }, this.moveColumns, "move columns to where the table has them"),
    );
  }

  private get typed(): TypedReactions {
    const values = Object.entries(this.texts).map(([name, input]) => [name, input.value]);
    return {
      ...(Object.fromEntries(values) as Record<keyof typeof this.texts, string>),
      positive: this.positive.value,
      moments: this.moments.value,
      horizontal: this.horizontal.value,
      decimals: this.decimals.value,
      mirrored: this.mirrored.checked,
      moveColumns: this.moveColumns.checked,
    };
  }

  private outdate(): void {
    this.turn += 1;
    this.take.disabled = true;
    setText(this.message, "");
    this.found.classList.add("outdated");
  }

  /** Show what the table changes, or why it cannot be read. */
  private async look(): Promise<void> {
    this.outdate();
    const { turn } = this;
    setText(this.message, "Reading the table …");
    let answer: ReactionChanges | null = null;
    let problem = "The table could not be read.";
    await this.importer.run(
      async () => {
        answer = await this.importer.api.reactions(this.file, choiceOf(this.typed));
      },
      (error) => {
        problem = error.message;
        return true;
      },
    );
    if (turn !== this.turn) return;
    const changes = answer as ReactionChanges | null;
    setText(this.message, changes === null ? problem : "");
    this.take.disabled = changes === null;
    this.found.classList.remove("outdated");
    fill(this.found, ...(changes === null ? [] : describeChanges(changes)));
  }

  private async accept(): Promise<void> {
    if (this.take.disabled) return;
    this.take.disabled = true;
    let problem = "The table could not be imported.";
    const isDone = await this.importer.run(
      async () => {
        const { api, store } = this.importer;
        const { state } = await api.takeReactions(this.file, choiceOf(this.typed), store.doc?.version ?? 0);
        store.setDoc(state);
      },
      (error) => {
        problem = error.message;
        return true;
      },
    );
    if (isDone) return this.close();
    setText(this.message, problem);
  }
}

/** The changes, sums and remarks as lists with headings. */
function describeChanges({ changes, sums, remarks }: ReactionChanges): HTMLElement[] {
  const list = (title: string, lines: string[], none: string) => [
    h("h3", {}, title),
    h("ul", {}, ...(lines.length > 0 ? lines : [none]).map((line) => h("li", {}, line))),
  ];
  return [
    ...list("Changes", changes, "none"),
    ...list("Sums by load case, moments about x = y = 0", sums, "none"),
    ...list("Remarks", remarks, "none"),
  ];
}

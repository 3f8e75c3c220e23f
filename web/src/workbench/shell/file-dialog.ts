// Choosing a case file on the server's machine: to open, or to save under a name.

import { button, fill, h, newId, setText } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import { type Api, type Folder, Refused } from "../client/api";
import { ask, closeDialog, openDialog } from "../controls/dialogs";

export interface ChosenFile {
  file: string;
  /** Whether a file of that name exists and may be replaced. */
  over: boolean;
}

/** Ask for a file; null if the user cancels. `present` is the file that is open. */
export function chooseFile(
  api: Pick<Api, "files">,
  purpose: "open" | "save",
  present: string | null,
): Promise<ChosenFile | null> {
  return new Promise((resolve) => new FileDialog(api, purpose, present, resolve).start());
}

class FileDialog {
  private readonly place = h("input", { type: "text", class: "path", "aria-label": "folder", spellcheck: "false" });
  private readonly list = h("div", {
    class: "files",
    role: "listbox",
    "aria-label": "folders and files",
    tabindex: 0,
  });
  private readonly name = h("input", {
    type: "text",
    id: newId("name"),
    spellcheck: "false",
    placeholder: "slab.toml",
  });
  private readonly message = h("p", { class: "messages", role: "alert" });
  private readonly dialog: HTMLDialogElement;
  private folder: Folder | null = null;
  private turn = 0; // the latest request; late answers are not shown

  constructor(
    private readonly api: Pick<Api, "files">,
    private readonly purpose: "open" | "save",
    private readonly present: string | null,
    private readonly resolve: (chosen: ChosenFile | null) => void,
  ) {
    const words = purpose === "open" ? "Open" : "Save";
    const title =
      purpose === "open"
        ? "Open a case file, a drawing, a building, a SAF file or a table of reactions"
        : "Save the case file as";
    const goUp = () => this.folder?.parent && void this.show(this.folder.parent);
    const answers = [
      button("Cancel", "", () => this.close(null)),
      h("button", { type: "submit", class: "main" }, words),
    ];
    const form = h(
      "form",
      { method: "dialog", class: "file-form" },
      h("h2", {}, title),
      h("div", { class: "file-place" }, button("↑ Up", "Parent folder", goUp, "small"), this.place),
      this.list,
      h("div", { class: "file-name" }, h("label", { for: this.name.id }, "Name"), this.name),
      this.message,
      h("div", { class: "answers" }, ...answers),
    );
    this.dialog = h("dialog", { class: "file-dialog", "aria-label": title }, form);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.accept();
    });

    this.place.addEventListener("input", () => (this.turn += 1));
    this.place.addEventListener("keydown", (event) => {
      if (event.key !== "Enter") return;
      event.preventDefault();
      void this.show(this.place.value);
    });
    this.list.addEventListener("keydown", (event) => this.walk(event));
  }

  start(): void {
    openDialog(this.dialog, () => this.close(null));
    const [, folder = "", name = ""] = /^(?:(.*)[\\/])?(.*)$/.exec(this.present ?? "") ?? [];
    this.name.value = name;
    this.name.focus();
    void this.show(folder || null);
  }

  private close(chosen: ChosenFile | null): void {
    closeDialog(this.dialog);
    this.resolve(chosen);
  }

  /** Show what a folder holds; tells whether that is what the dialog stands in now. */
  private async show(folder: string | null): Promise<boolean> {
    this.turn += 1;
    const { turn } = this;
    try {
      const found = await this.api.files(folder);
      if (turn !== this.turn) return false;
      this.folder = found;
    } catch (error) {
      setText(this.message, error instanceof Refused ? error.message : "The server is not responding.");
      return false;
    }
    setText(this.message, "");
    this.place.value = this.folder.folder;
    const { folders } = this.folder;
    const drawings = this.purpose === "open" ? (this.folder.drawings ?? []) : [];
    const tables = this.purpose === "open" ? (this.folder.tables ?? []) : [];
    const buildings = this.purpose === "open" ? (this.folder.buildings ?? []) : [];
    const files = [...this.folder.files, ...drawings, ...buildings, ...tables];
    fill(
      this.list,
      ...folders.map((name) => this.entry(name, true)),
      ...files.map((name) => this.entry(name, false)),
      folders.length + files.length === 0
        ? h(
            "p",
            { class: "empty" },
            this.purpose === "open"
              ? "No case files (*.toml), drawings (*.dxf), buildings (*.ifc), SAF files (*.xlsx) or tables (*.csv, *.xlsx) in this folder."
              : "No case files (*.toml) in this folder.",
          )
        : null,
    );
    return true;
  }

  private entry(name: string, isFolder: boolean): HTMLElement {
    const open = () => (isFolder ? void this.show(this.path(name)) : void this.accept());
    const button = h(
      "button",
      { type: "button", class: isFolder ? "entry folder" : "entry", role: "option", tabindex: -1, ondblclick: open },
      verbatim(isFolder ? `${name}/` : name),
    );
    button.addEventListener("click", () => {
      if (isFolder) return open();
      this.name.value = name;
      for (const each of this.list.children) each.setAttribute("aria-selected", String(each === button));
    });
    return button;
  }

  /** Arrow keys walk through the list. */
  private walk(event: KeyboardEvent): void {
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    event.preventDefault();
    const all = [...this.list.querySelectorAll("button")];
    const now = all.indexOf(document.activeElement as HTMLButtonElement);
    all[Math.min(all.length - 1, Math.max(0, now + (event.key === "ArrowDown" ? 1 : -1)))]?.focus();
  }

  private path(name: string): string {
    const folder = this.folder?.folder ?? "";
    const separator = folder.includes("\\") ? "\\" : "/";
    return folder.endsWith(separator) ? folder + name : folder + separator + name;
  }

  private async accept(): Promise<void> {
    let name = this.name.value.trim();
    if (!name) {
      setText(this.message, "Choose a file or enter a name.");
      return;
    }
    const folder = this.place.value.trim();
    if (folder !== this.folder?.folder && !(await this.show(folder || null))) return; // written, not listed yet
    if (this.purpose === "save" && !/\.[A-Za-z0-9]+$/.test(name)) name += ".toml";
    const file = /^([A-Za-z]:)?[\\/]/.test(name) ? name : this.path(name);
    const there = this.folder?.files.includes(name) === true;
    const over = this.purpose === "save" && there && file !== this.present;
    const answers = [
      { label: "Cancel", value: false, main: true },
      { label: "Replace", value: true },
    ];
    if (
      over &&
      !(await ask("Replace file?", [say("{name} already exists.", { name: verbatim(name) })], answers, false))
    )
      return;
    this.close({ file, over });
  }
}

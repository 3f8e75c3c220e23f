// Opening a file in the Structural Analysis Format: one of its slabs becomes a case.

import { button, h, newId, setText } from "../../viewer/shared/dom";
import type { Api, DocState, Refused, SlabInFile } from "../client/api";
import { closeDialog, openDialog } from "../controls/dialogs";
import { showReport } from "./report";
import "./drawing.css";

/** What the opening of a slab needs. */
export interface SlabOpener {
  api: Pick<Api, "openSlab">;
  /** Ask what to do with unsaved work; returns whether the document may be left. */
  leave(): Promise<boolean>;
  /** Replace the document; `refused` takes the reason if the server refuses. */
  replace(make: () => Promise<DocState>, refused: (error: Refused) => boolean): Promise<boolean>;
}

const MISSING =
  "Ground is read as far as the file has it. The list of errors shows what is still missing, and the lines below what was read in another way or left out.";

/** What is said of a slab where one is chosen. */
export function slabText({ name, height, sides, on_ground }: SlabInFile): string {
  const [x, y] = sides.map((side) => Number(side.toPrecision(4)));
  return `${name}: ${x} m by ${y} m at ${Number(height.toPrecision(4))} m${on_ground ? ", on ground" : ""}`;
}

/** Ask which slab of a file becomes a case until it has, or the dialog is closed. */
export function openSlab(file: string, slabs: readonly SlabInFile[], opener: SlabOpener): Promise<void> {
  return new Promise((resolve) => {
    const name = file.replace(/^.*[\\/]/, "");
    const title = `Open a slab of ${name}`;
    const options = slabs.map((slab) => h("option", { value: slab.name }, slabText(slab)));
    const slab = h("select", { id: newId("slab") }, ...options);
    const message = h("p", { class: "messages", role: "alert" });
    const make = h("button", { type: "submit", class: "main" }, "Create case");
    const close = () => {
      closeDialog(dialog);
      resolve();
    };
    const form = h(
      "form",
      { method: "dialog", class: "drawing-form" },
      h("h2", {}, title),
      h("label", { for: slab.id }, "slab ", slab),
      message,
      h("div", { class: "answers" }, button("Cancel", "", close), make),
    );
    const dialog = h("dialog", { class: "saf-dialog", "aria-label": title }, form);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      if (make.disabled) return;
      make.disabled = true;
      setText(message, "Reading the file …");
      void makeCase(file, name, slab.value, opener).then((problem) => {
        if (problem === "") return close();
        make.disabled = false;
        setText(message, problem);
      });
    });
    openDialog(dialog, close);
    slab.focus();
  });
}

/** Make a case of a slab; returns why it cannot be made, empty if it was. */
async function makeCase(
  file: string,
  name: string,
  slab: string,
  { api, leave, replace }: SlabOpener,
): Promise<string> {
  if (!(await leave())) return "The current case stays open.";
  let problem = "The file could not be read.";
  let report = "";
  const isMade = await replace(
    async () => {
      const made = await api.openSlab(file, slab);
      report = made.report;
      return made.state;
    },
    (error) => {
      problem = error.message;
      return true;
    },
  );
  if (!isMade) return problem;
  showReport(name, MISSING, report);
  return "";
}

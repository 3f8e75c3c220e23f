// Opening a SAF file or a building model (IFC): one of its slabs becomes a case.

import { button, h, newId, setText } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import type { Api, DocState, Refused, SlabChoice, SlabInFile } from "../client/api";
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
const GEOMETRY_ALONE =
  "Building models give geometry alone. The list of errors shows what is still to be filled in, and the lines below what was read in another way or left out.";
/** Lines of a list that are seen at once, at least and at most. */
const LINES = [2, 9] as const;

/** Whether a file is a building model by its name. */
export function isBuilding(file: string): boolean {
  return /\.ifc$/i.test(file);
}

/** What is said of a slab where one is chosen. */
export function slabText(slab: SlabInFile): string {
  const { name, height, sides, problem } = slab;
  if (height === null || sides === null)
    return say("{name} cannot be read: {problem}", { name: verbatim(name), problem: problem ?? "" });
  const [x = 0, y = 0, z = 0] = [...sides, height].map((size) => Number(size.toPrecision(4)));
  const values = { name: verbatim(name), x, y, z };
  if (slab.storey === undefined)
    return say(
      slab.on_ground ? "{name}: {x} m by {y} m at {z} m, on ground" : "{name}: {x} m by {y} m at {z} m",
      values,
    );
  const { columns = 0, walls = 0 } = slab;
  const more = { storey: verbatim(slab.storey || "–"), columns, walls };
  return say("{name}: {x} m by {y} m, top at {z} m, storey: {storey}, columns: {columns}, walls: {walls}", {
    ...values,
    ...more,
  });
}

/** Ask which slab of a file becomes a case until it has, or the dialog is closed. */
export function openSlab(file: string, slabs: readonly SlabInFile[], opener: SlabOpener): Promise<void> {
  return new Promise((resolve) => {
    const name = file.replace(/^.*[\\/]/, "");
    const title = say("Open a slab of {name}", { name: verbatim(name) });
    const options = slabs.map((slab) =>
      h("option", { value: slab.id, disabled: slab.height === null, title: slabText(slab) }, slabText(slab)),
    );
    const size = Math.min(Math.max(slabs.length, LINES[0]), LINES[1]);
    const slab = h("select", { id: newId("slab"), size }, ...options);
    slab.selectedIndex = slabs.findIndex(({ height }) => height !== null);
    const place = isBuilding(file) ? placeFields() : null;
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
      h("label", { for: slab.id }, "slab"),
      slab,
      place?.element ?? null,
      message,
      h("div", { class: "answers" }, button("Cancel", "", close), make),
    );
    const dialog = h("dialog", { class: "slab-dialog", "aria-label": title }, form);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      if (make.disabled || slab.value === "") return;
      make.disabled = true;
      setText(message, "Reading the file …");
      void makeCase(file, name, { slab: slab.value, ...place?.chosen() }, opener).then((problem) => {
        if (problem === "") return close();
        make.disabled = false;
        setText(message, problem);
      });
    });
    openDialog(dialog, close);
    slab.focus();
  });
}

/** The fields for where the plan of a building is measured from, and whether it is turned. */
function placeFields(): { element: HTMLElement; chosen(): Pick<SlabChoice, "centered" | "aligned"> } {
  const origin = h(
    "select",
    { id: newId("origin") },
    h("option", { value: "" }, "same as in the building"),
    h("option", { value: "centered" }, "center of the slab"),
  );
  const turn = h("input", { type: "checkbox" });
  return {
    element: h(
      "div",
      { class: "drawing-settings" },
      h("label", { for: origin.id }, "origin", origin),
      h("label", {}, turn, "Turn the longest edge along x or y"),
    ),
    chosen: () => ({ centered: origin.value === "centered", aligned: turn.checked }),
  };
}

/** Make a case of a slab; returns why it cannot be made, empty if it was. */
async function makeCase(
  file: string,
  name: string,
  choice: SlabChoice,
  { api, leave, replace }: SlabOpener,
): Promise<string> {
  if (!(await leave())) return "The current case stays open.";
  let problem = "The file could not be read.";
  let report = "";
  const isMade = await replace(
    async () => {
      const made = await api.openSlab(file, choice);
      report = made.report;
      return made.state;
    },
    (error) => {
      problem = error.message;
      return true;
    },
  );
  if (!isMade) return problem;
  showReport(name, isBuilding(file) ? GEOMETRY_ALONE : MISSING, report);
  return "";
}

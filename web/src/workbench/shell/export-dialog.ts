// What is exported: the report, tables, figures, drawings, files for other programs, each in one of its formats.

import { button, type Child, h, newId } from "../../viewer/shared/dom";
import { say, translate, verbatim } from "../../viewer/shared/language";
import type { ShownResult, Store } from "../client/store";
import { closeDialog, openDialog } from "../controls/dialogs";
import "./export.css";

/** What can be exported; files are named as the server does, without the name of the case. */
interface Offer {
  label: string;
  note: string;
  formats: readonly (readonly [file: string, format: string])[];
}

const REPORT: Offer = {
  label: "Report",
  note: "the chapters that the case asks for",
  formats: [
    ["report.html", "HTML"],
    ["report.pdf", "PDF"],
  ],
};
const TABLES: Offer = {
  label: "Tables",
  note: "all tables of the results, as one workbook or as CSV files in a ZIP file",
  formats: [
    ["tables.xlsx", "XLSX"],
    ["tables.zip", "CSV"],
  ],
};
const PLAN: Offer = {
  label: "Plan of the field shown",
  note: "",
  formats: [
    ["plan.pdf", "PDF"],
    ["plan.svg", "SVG"],
    ["plan.png", "PNG"],
    ["plan.dxf", "DXF"],
  ],
};
const BARS: Offer = {
  label: "Drawing of the bars provided",
  note: "a plan of each face, with the quantities; as IFC each bar in its place",
  formats: [
    ["bars.dxf", "DXF"],
    ["bars.pdf", "PDF"],
    ["bars.svg", "SVG"],
    ["bars.ifc", "IFC"],
  ],
};
const SHEETS: Offer = {
  label: "Bar drawings on paper",
  note: "a sheet to scale for each layer, for edges and for links, with dimensions and a title block",
  formats: [
    ["bars-a1.pdf", "A1-PDF"],
    ["bars-a2.pdf", "A2-PDF"],
    ["bars-a3.pdf", "A3-PDF"],
    ["bars-a1.dxf", "A1-DXF"],
    ["bars-a2.dxf", "A2-DXF"],
    ["bars-a3.dxf", "A3-DXF"],
  ],
};
const SCHEDULE: Offer = {
  label: "Bending schedule",
  note: "bars and links as they are cut and bent, with their masses; without welded meshes",
  formats: [
    ["bars.xlsx", "XLSX"],
    ["bars.csv", "CSV"],
    ["bars.abs", "BVBS"],
  ],
};
const SAF: Offer = {
  label: "Model for structural programs (SAF)",
  note: "the case as it is now, with section forces along edges if it has been solved; what the format has no place for is listed",
  formats: [["saf.xlsx", "XLSX"]],
};
const FIELDS: Offer = {
  label: "Field values on the mesh (ParaView)",
  note: "all fields of the combination shown, or the envelope over all combinations",
  formats: [["plate.vtu", "VTU"]],
};
const ARCHIVE: Offer = {
  label: "Archive",
  note: "case, results and report in one file for groundslab view",
  formats: [["archive.zip", "ZIP"]],
};

let last = "report.html"; // what was exported before is offered first

/** Ask what to export; resolves with the file, null if the dialog is closed. */
export function chooseExport(store: Store): Promise<string | null> {
  return new Promise((resolve) => {
    const isView = store.doc?.view !== undefined;
    const offers = [REPORT, TABLES, PLAN, BARS, SHEETS, SCHEDULE, SAF, FIELDS, ...(isView ? [] : [ARCHIVE])];
    const rows = offers.map((offer) => new Row(offer, store));
    const close = (file: string | null) => {
      closeDialog(dialog);
      resolve(file);
    };
    const title = "Export";
    const form = h(
      "form",
      { method: "dialog" },
      h("h2", {}, title),
      h(
        "div",
        { class: "export-offers", role: "radiogroup", "aria-label": "what to export" },
        ...rows.map((row) => row.element),
      ),
      h(
        "div",
        { class: "answers" },
        button("Cancel", "", () => close(null)),
        h("button", { type: "submit", class: "main" }, "Export"),
      ),
    );
    const dialog = h("dialog", { class: "export-dialog", "aria-label": title }, form);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const chosen = rows.find((row) => row.radio.checked);
      if (!chosen) return;
      last = chosen.format.value;
      close(last);
    });
    openDialog(dialog, () => close(null));
    const free = rows.filter((row) => !row.radio.disabled);
    const first = free.find((row) => row.has(last)) ?? free[0];
    first?.choose(last);
  });
}

/** One of the offers, with the choice of its format. */
class Row {
  readonly radio: HTMLInputElement;
  readonly format: HTMLSelectElement;
  readonly element: HTMLElement;

  constructor(
    private readonly offer: Offer,
    store: Store,
  ) {
    const problem = problemOf(offer, store);
    this.radio = h("input", { type: "radio", name: "export", id: newId("export"), disabled: problem !== "" });
    const options = offer.formats.map(([value, format]) => h("option", { value }, verbatim(format)));
    const label = say("format of {file}", { file: offer.label });
    this.format = h("select", { "aria-label": label, disabled: problem !== "" }, ...options);
    this.format.addEventListener("change", () => this.choose(this.format.value));
    const note: Child = problem || (offer === PLAN ? verbatim(planText(store.shown)) : offer.note);
    this.element = h(
      "div",
      { class: "export-offer" },
      this.radio,
      h("label", { for: this.radio.id }, h("b", {}, offer.label), h("small", {}, note)),
      this.format,
    );
  }

  has(file: string): boolean {
    return this.offer.formats.some(([known]) => known === file);
  }

  /** Choose the offer, and the format if it is one of it. */
  choose(file: string): void {
    if (this.has(file)) this.format.value = file;
    this.radio.checked = true;
    this.radio.focus();
  }
}

/** Return why something cannot be exported now, empty if it can. */
function problemOf(offer: Offer, store: Store): string {
  if (offer !== SAF && store.solved === null) return "The case has not been solved yet.";
  if (offer === PLAN && store.shown?.isDrawable === false)
    return "An envelope over several limit states is not drawn; choose that of one.";
  if (offer === SAF && store.doc && store.doc.issues.length > 0) return "Fix the errors first";
  return "";
}

/** What the plan would be of, in the language of the page. */
function planText(shown: ShownResult | null): string {
  return shown === null ? "" : `${translate(shown.meaning)}; ${shown.of}`;
}

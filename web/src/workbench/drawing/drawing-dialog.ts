// What is to be made of a drawing: what its layers hold, its unit, its origin; with a small picture of it.

import { button, fill, h, newId, setText } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import { closeDialog, openDialog } from "../controls/dialogs";
import {
  contentText,
  type DrawingChoice,
  findProblem,
  type Layer,
  ROLES,
  type Survey,
  unitsFor,
} from "../model/survey";
import { drawPreview } from "./preview";
import "./drawing.css";

/** What the dialog is used for. */
export interface DrawingUses {
  /** Make a case, what no drawing holds as in a new one if that is wanted; returns why it cannot be made, empty if it was. */
  makeCase(choice: DrawingChoice, shown: boolean, asNew: boolean): Promise<string>;
  /** Show the drawing below the plan. */
  showBelow(choice: DrawingChoice): void;
}

const ORIGINS = [
  ["", "same as in the drawing"],
  ["centered", "center of the slab"],
] as const;

/** Ask what to make of a drawing until it is made, or the dialog is closed. */
export function askAboutDrawing(name: string, survey: Survey, uses: DrawingUses): Promise<void> {
  return new Promise((resolve) => new DrawingDialog(name, survey, uses, resolve).start());
}

class DrawingDialog {
  private readonly roles = new Map<Layer, HTMLSelectElement>();
  private readonly unit = h("select", { id: newId("unit") });
  private readonly origin = h(
    "select",
    { id: newId("origin") },
    ...ORIGINS.map(([value, text]) => h("option", { value }, text)),
  );
  private readonly gap = h("input", { id: newId("gap"), value: "1 mm", size: 7, maxlength: 20 });
  private readonly union = h("input", { type: "checkbox" });
  private readonly shown = h("input", { type: "checkbox", checked: true });
  private readonly asNew = h("input", { type: "checkbox", checked: true });
  private readonly message = h("p", { class: "messages", role: "alert" });
  private readonly make = h("button", { type: "submit", class: "main" }, "Create case");
  private readonly preview: ReturnType<typeof drawPreview>;
  private readonly dialog: HTMLDialogElement;

  constructor(
    name: string,
    private readonly survey: Survey,
    private readonly uses: DrawingUses,
    private readonly resolve: () => void,
  ) {
    this.preview = drawPreview(survey);
    const title = say("Open drawing {name}", { name: verbatim(name) });
    const form = h(
      "form",
      { method: "dialog", class: "drawing-form" },
      h("h2", {}, title),
      h("div", { class: "drawing-parts" }, this.layerTable(), this.preview.element),
      ...survey.remarks.map((remark) => h("p", { class: "quiet" }, `${remark}.`)),
      this.settings(),
      this.message,
      this.answers(),
    );
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.accept();
    });
    form.addEventListener("change", () => this.update());
    this.dialog = h("dialog", { class: "drawing-dialog", "aria-label": title }, form);
  }

  start(): void {
    openDialog(this.dialog, () => this.close());
    this.update();
  }

  private close(): void {
    closeDialog(this.dialog);
    this.resolve();
  }

  private layerTable(): HTMLElement {
    const heads = ["layer", "entities", "content"].map((text) => h("th", { scope: "col" }, text));
    const rows = this.survey.layers.map((layer) => this.layerRow(layer));
    const empty = h("tr", {}, h("td", { colspan: 3, class: "empty" }, "The drawing is empty."));
    const body = h("tbody", {}, ...(rows.length > 0 ? rows : [empty]));
    return h("div", { class: "drawing-layers" }, h("table", {}, h("thead", {}, h("tr", {}, ...heads)), body));
  }

  private layerRow(layer: Layer): HTMLElement {
    const options = ROLES.map(([value, text]) => h("option", { value, selected: value === (layer.role ?? "") }, text));
    const select = h(
      "select",
      { "aria-label": say("content of layer {layer}", { layer: verbatim(layer.name) }) },
      ...options,
    );
    this.roles.set(layer, select);
    const content = contentText(layer);
    const name = h(
      "th",
      { scope: "row", title: verbatim(layer.name) },
      verbatim(layer.name),
      layer.hidden && h("small", {}, " hidden"),
    );
    const row = h("tr", {}, name, h("td", { title: content }, content), h("td", {}, select));
    const mark = () => this.preview.mark(layer);
    const unmark = () => this.preview.mark(null);
    row.addEventListener("pointerenter", mark);
    row.addEventListener("pointerleave", unmark);
    row.addEventListener("focusin", mark);
    row.addEventListener("focusout", unmark);
    return row;
  }

  private settings(): HTMLElement {
    const { unit } = this.survey;
    const choose = h("option", { value: "" }, "choose …");
    const units = unitsFor(this.survey).map((name) => {
      return h(
        "option",
        { value: name, selected: name === unit },
        name === unit ? say("{name}, from the drawing", { name: verbatim(name) }) : name,
      );
    });
    fill(this.unit, unit === null ? choose : null, ...units);
    return h(
      "div",
      { class: "drawing-settings" },
      h("label", { for: this.unit.id }, "drawing unit", this.unit),
      h("label", { for: this.origin.id }, "origin", this.origin),
      h("label", { for: this.gap.id }, "close gaps up to", this.gap),
      h("label", {}, this.union, "join outlines side by side"),
      h("label", {}, this.shown, "show the drawing under the plan"),
      h("label", {}, this.asNew, "concrete, ground and self-weight as in a new case"),
    );
  }

  private answers(): HTMLElement {
    const below = () => {
      this.close();
      this.uses.showBelow(this.choice);
    };
    const underlay = button("Only show under the plan", "Keep the current case and show the drawing under it", below);
    return h(
      "div",
      { class: "answers" },
      button("Cancel", "", () => this.close()),
      underlay,
      this.make,
    );
  }

  private get choice(): DrawingChoice {
    const roles = [...this.roles].filter(([, select]) => select.value !== "");
    return {
      layers: Object.fromEntries(roles.map(([layer, select]) => [layer.name, select.value])),
      unit: this.unit.value,
      centered: this.origin.value === "centered",
      gap: this.gap.value.trim() || "0 mm",
      union: this.union.checked,
    };
  }

  /** Show what is missing, and each layer of the picture by what it holds. */
  private update(): void {
    const problem = findProblem(this.choice);
    setText(this.message, problem);
    this.make.disabled = problem !== "";
    this.dialog.querySelectorAll<HTMLButtonElement>(".answers button")[1]!.disabled = this.choice.unit === "";
    for (const group of this.preview.element.children)
      group.setAttribute("data-role", this.choice.layers[group.getAttribute("data-layer") ?? ""] ?? "");
  }

  private async accept(): Promise<void> {
    if (this.make.disabled) return;
    this.make.disabled = true;
    setText(this.message, "Reading the drawing …");
    const problem = await this.uses.makeCase(this.choice, this.shown.checked, this.asNew.checked);
    if (problem === "") return this.close();
    this.make.disabled = false;
    setText(this.message, problem);
  }
}

// The dialog of an action: its numbers, below the plan that shows what they make.
import { button, fill, h, newId } from "../../../viewer/shared/dom";
import type { Additions } from "../../model/changes/copies";
import { Impossible } from "../../model/changes/transform";
import type { Canvas } from "../canvas";
import type { Generator } from "../generators/generator";
import type { Actions } from "./actions";
import type { ActionField, Values } from "./fields";
import type { ActionForm } from "./forms";

export class ActionDialog {
  readonly element = h("form", { class: "action-dialog", role: "dialog", hidden: true });
  private form: ActionForm | Generator | null = null;
  private readonly typed = new Map<string, string>(); // what was entered last, by form and field

  constructor(
    private readonly canvas: Canvas,
    private readonly actions: Actions,
  ) {
    this.element.addEventListener("submit", (event) => {
      event.preventDefault();
      this.apply();
    });
    this.element.addEventListener("input", () => this.update());
    this.element.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key === "Escape") this.close();
    });
  }

  /** Ask for the numbers of an action or a generator. */
  open(form: ActionForm | Generator): void {
    this.form = form;
    const id = newId("action");
    const rows = form.fields.map((field) => this.makeRow(form, field));
    const message = h("p", { class: "action-message", role: "status" });
    const apply = h("button", { type: "submit", class: "main" }, form.label);
    const cancel = button("Cancel", "", () => this.close());
    fill(this.element, h("h3", { id }, form.label), ...rows, h("div", { class: "answers" }, apply, cancel, message));
    this.element.setAttribute("aria-labelledby", id);
    this.element.hidden = false;
    this.element.querySelector<HTMLElement>("label:not([hidden]) :is(input, select)")?.focus();
    this.element.querySelector<HTMLInputElement>("label:not([hidden]) input")?.select();
    this.update();
  }

  close(): void {
    if (!this.form) return;
    this.form = null;
    this.element.hidden = true;
    this.canvas.ghosts = [];
    this.canvas.redraw();
    this.canvas.element.focus({ preventScroll: true });
  }

  /** Show what the numbers make of the selection. */
  update(): void {
    if (!this.form) return;
    const values = this.read();
    for (const field of this.form.fields) {
      const row = this.element.querySelector<HTMLElement>(`[data-key="${field.key}"]`)!;
      row.hidden = field.shown?.(values) === false;
    }
    const made = this.plan();
    const isMade = typeof made !== "string";
    this.canvas.ghosts = isMade ? this.actions.preview(made.change) : [];
    this.canvas.redraw();
    const message = this.element.querySelector(".action-message")!;
    message.classList.toggle("bad", !isMade);
    fill(message, isMade ? (made.note ?? "") : made);
    this.element.querySelector<HTMLButtonElement>("[type=submit]")!.disabled = !isMade;
  }

  private apply(): void {
    const made = this.plan();
    if (typeof made === "string") return this.update();
    for (const [key, value] of Object.entries(this.read())) this.typed.set(`${this.form!.name} ${key}`, value);
    this.close();
    this.actions.make(made);
  }

  /** Return what the numbers make, or why they make nothing. */
  private plan(): Additions | string {
    try {
      return this.actions.plan(this.form!, this.read());
    } catch (error) {
      if (error instanceof Impossible) return `${error.message}.`;
      throw error;
    }
  }

  private makeRow(form: ActionForm | Generator, { key, label, is, initial, options }: ActionField): HTMLElement {
    const { all, active } = this.actions.cases;
    const value = is === "case" ? active : (this.typed.get(`${form.name} ${key}`) ?? initial);
    const choices = is === "case" ? all : (options ?? []);
    const attributes = { name: key, "data-is": is };
    const input =
      is === "choice" || is === "case"
        ? h("select", attributes, ...choices.map((each) => h("option", { selected: each === value }, each)))
        : is === "flag"
          ? h("input", { ...attributes, type: "checkbox", checked: value === "yes" })
          : h("input", { ...attributes, value, autocomplete: "off", spellcheck: "false" });
    return h("label", { class: `action-row is-${is}`, "data-key": key }, h("span", {}, label), input);
  }

  private read(): Values {
    const inputs = [...this.element.querySelectorAll<HTMLInputElement | HTMLSelectElement>("input, select")];
    const valueIn = (input: HTMLInputElement | HTMLSelectElement) =>
      input instanceof HTMLInputElement && input.type === "checkbox" ? (input.checked ? "yes" : "") : input.value;
    return Object.fromEntries(inputs.map((input) => [input.name, valueIn(input)]));
  }
}

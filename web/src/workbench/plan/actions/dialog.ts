// The dialog of an action: its numbers, below the plan that shows what they make.
import { button, fill, h, newId } from "../../../viewer/shared/dom";
import { keep, together, translate, verbatim } from "../../../viewer/shared/language";
import type { Additions } from "../../model/changes/copies";
import { Impossible } from "../../model/changes/transform";
import type { Point } from "../../model/geometry";
import { formatLength } from "../../model/quantities";
import type { Canvas } from "../canvas";
import type { ActionField, Values } from "../fields";
import type { Generator } from "../generators/generator";
import { pickPlaces } from "../generators/picking";
import type { Actions } from "./actions";
import type { ActionForm } from "./forms";

const PICK = "Click points on the plan to fill in x and y";

export class ActionDialog {
  readonly element = h("form", { class: "action-dialog", role: "dialog", hidden: true });
  private form: ActionForm | Generator | null = null;
  private stopPicking = () => {};
  private readonly typed = new Map<string, string>(); // what was entered last, by form and field

  constructor(
    private readonly canvas: Canvas,
    private readonly actions: Actions,
  ) {
    this.element.addEventListener("submit", (event) => {
      event.preventDefault();
      this.apply();
    });
    this.element.addEventListener("input", (event) => {
      this.fillIn(event.target as HTMLInputElement);
      this.update();
    });
    this.element.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key === "Escape") this.close();
    });
  }

  /** Ask for the numbers of an action or a generator. */
  open(form: ActionForm | Generator): void {
    this.stopPicking();
    this.form = form;
    const id = newId("action");
    const rows = form.fields.map((field) => this.makeRow(form, field));
    const message = h("p", { class: "action-message", role: "status", id: `${id}-message` });
    const apply = h("button", { type: "submit", class: "main" }, form.label);
    const cancel = button("Cancel", "", () => this.close());
    const pick = "places" in form ? [button("Pick on plan", PICK, () => this.pick(form), "pick")] : [];
    const answers = h("div", { class: "answers" }, apply, ...pick, cancel, message);
    fill(this.element, h("h3", { id }, form.label), ...rows, answers);
    this.element.setAttribute("aria-labelledby", id);
    this.element.hidden = false;
    this.element.querySelector<HTMLElement>("label:not([hidden]) :is(input, select)")?.focus();
    this.element.querySelector<HTMLInputElement>("label:not([hidden]) input")?.select();
    this.update();
  }

  close(): void {
    if (!this.form) return;
    this.stopPicking();
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
    fill(message, isMade ? (made.note ?? "") : this.markFault(made));
    if (isMade) this.markFault("");
    this.element.querySelector<HTMLButtonElement>("[type=submit]")!.disabled = !isMade;
  }

  /** Mark the field that a fault begins with; returns the fault with the field's label. */
  private markFault(fault: string): string {
    const [, key = "", rest = ""] = /^(\w+)\s?: (.*)$/s.exec(fault) ?? [];
    for (const input of this.inputs) input.setAttribute("aria-invalid", String(input.name === key));
    const field = this.form!.fields.find((each) => each.key === key);
    return field ? together([field.label, rest], ": ") : fault;
  }

  /** Fill in what a choice stands for; a choice that no longer holds becomes the first one. */
  private fillIn(changed: HTMLInputElement | HTMLSelectElement): void {
    const inputs = new Map(this.inputs.map((input) => [input.name, input]));
    for (const { key, fills, options } of this.form?.fields ?? []) {
      const choice = inputs.get(key)!;
      for (const [name, value] of Object.entries(fills?.(choice.value) ?? {})) {
        const input = inputs.get(name)!;
        if (changed === choice) input.value = value;
        else if (input.value !== value) choice.value = options![0]!;
      }
    }
  }

  /** Take the places of a generator from clicks on the plan. */
  private pick({ places }: Generator): void {
    this.stopPicking();
    const take = (at: Point, n: number) => {
      for (const input of this.inputs) {
        const coordinate = places[n]!.indexOf(input.name);
        if (coordinate >= 0) input.value = formatLength(at[coordinate]!);
      }
      this.update();
    };
    this.stopPicking = pickPlaces(this.canvas, places.length, take, () =>
      this.element.querySelector<HTMLElement>("[type=submit]")?.focus(),
    );
  }

  private get inputs(): (HTMLInputElement | HTMLSelectElement)[] {
    return [...this.element.querySelectorAll<HTMLInputElement | HTMLSelectElement>("input, select")];
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
      if (error instanceof Impossible) return keep(`${translate(error.message)}.`);
      throw error;
    }
  }

  private makeRow(form: ActionForm | Generator, field: ActionField): HTMLElement {
    const { key, label, is, initial, options } = field;
    const { all, active } = this.actions.casesFor(field);
    const other = all.find((name) => name !== active) ?? active; // for loads in a second case
    const value =
      is === "case" ? (key === "case" ? active : other) : (this.typed.get(`${form.name} ${key}`) ?? initial);
    const choices = is === "case" ? all : (options ?? []);
    const attributes = { name: key, "data-is": is };
    const input =
      is === "choice" || is === "case"
        ? h(
            "select",
            attributes,
            ...choices.map((each) =>
              h("option", { value: each, selected: each === value }, is === "case" ? verbatim(each) : each),
            ),
          )
        : is === "flag"
          ? h("input", { ...attributes, type: "checkbox", checked: value === "yes" })
          : h("input", { ...attributes, value, autocomplete: "off", spellcheck: "false" });
    return h("label", { class: `action-row is-${is}`, "data-key": key }, h("span", {}, label), input);
  }

  private read(): Values {
    const valueIn = (input: HTMLInputElement | HTMLSelectElement) =>
      input instanceof HTMLInputElement && input.type === "checkbox" ? (input.checked ? "yes" : "") : input.value;
    return Object.fromEntries(this.inputs.map((input) => [input.name, valueIn(input)]));
  }
}

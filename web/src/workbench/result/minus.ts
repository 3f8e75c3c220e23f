// What is subtracted from the result shown: a combination of it, or the result that was kept as reference.

import { isDifference } from "../../viewer/data/fields";
import { decodeScene, type Scene } from "../../viewer/data/scene";
import { fill, h, setText } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import type { Api, Subtracted } from "../client/api";

/** What the choice needs of the server. */
export type DifferenceApi = Pick<Api, "difference" | "keepReference">;

const REFERENCE = "reference";
const COMBINATION = "combination ";

/** The choice beside that of the combination, and the differences that it leads to. */
export class Minus {
  readonly select = h("select", {
    class: "minus-choice",
    "aria-label": "Minus",
    title: "Subtract a combination, or the result kept as reference, and show the difference",
  });
  /** Says over the picture what minus what is shown. */
  readonly label = h("p", { class: "preview-over difference-over", hidden: true });
  private reference: number | null = null; // the run that was kept
  private chosen = "";
  private names: readonly string[] = [];

  /** `onChoose` is called when something else is chosen. */
  constructor(
    private readonly api: DifferenceApi,
    private readonly onChoose: () => void,
  ) {
    this.select.addEventListener("change", () => {
      this.chosen = this.select.value;
      onChoose();
    });
    this.update();
  }

  /** What is subtracted; null: nothing. */
  get subtracted(): Subtracted | null {
    if (this.chosen === REFERENCE && this.reference !== null) return { minus: "", reference: this.reference };
    return this.chosen.startsWith(COMBINATION)
      ? { minus: this.chosen.slice(COMBINATION.length), reference: null }
      : null;
  }

  /** Offer the combinations of a result; what was chosen stays if it is there. */
  offer(result: Scene | null): void {
    const { combinations } = result?.head ?? { combinations: [] };
    this.names = combinations.length > 1 ? combinations.filter((each) => each.values).map((each) => each.name) : [];
    this.update();
  }

  /** Let the server keep the results of a run as the reference that can be subtracted. */
  async keep(run: number): Promise<void> {
    const isShown = this.chosen === REFERENCE;
    this.reference = null; // whatever comes of it, the one before is no longer meant
    try {
      await this.api.keepReference(run);
      this.reference = run;
    } finally {
      this.update();
      if (isShown) this.onChoose();
    }
  }

  /** Say over the picture that the difference will come, if something is subtracted. */
  announce(): void {
    this.label.hidden = this.subtracted === null;
    setText(this.label, "Computing the difference …");
  }

  /** Subtract nothing. */
  reset(): void {
    this.chosen = "";
    this.label.hidden = true;
    this.update();
  }

  /** Forget the reference, which belongs to another document. */
  forget(): void {
    this.reference = null;
    this.reset();
  }

  /** Return the difference of a run to what is subtracted; null: nothing is. */
  async fetch(run: number): Promise<Scene | null> {
    const { subtracted } = this;
    return subtracted && decodeScene(await this.api.difference(run, subtracted));
  }

  /** Say what is shown, if that is a difference. */
  tell(scene: Scene | null, words: string): void {
    this.label.hidden = scene === null || !isDifference(scene);
    setText(this.label, verbatim(words));
  }

  private update(): void {
    const values = [...(this.reference === null ? [] : [REFERENCE]), ...this.names.map((name) => COMBINATION + name)];
    if (!values.includes(this.chosen)) this.chosen = "";
    const options = values.map((value) =>
      value === REFERENCE
        ? h("option", { value }, "minus the reference")
        : h("option", { value }, say("minus {name}", { name: verbatim(value.slice(COMBINATION.length)) })),
    );
    fill(this.select, h("option", { value: "" }, "minus nothing"), ...options);
    this.select.value = this.chosen;
    this.select.hidden = values.length === 0;
  }
}

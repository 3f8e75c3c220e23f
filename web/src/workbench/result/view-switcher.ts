// The picture of the result: in plan with tools and scale, or in space.

import {
  type Choice,
  choiceName,
  fieldOf,
  fillCombinations,
  fillFields,
  isEnvelope,
  Legend,
  Locator,
  number,
  onTheme,
  PlanView,
  type Point,
  parseChoice,
  type Scene,
  SpaceView,
  symbolText,
  type Tool,
  valueAt,
} from "../../viewer";
import { h, setText } from "../shell/elements";

export interface StageHooks {
  /** A place was picked. */
  picked(at: Point): void;
  /** A line was drawn. */
  cut(start: Point, end: Point): void;
  /** Another field or combination is shown. */
  shown(): void;
}

/** What is looked at, kept while results change. */
export class Stage {
  readonly element: HTMLElement;
  readonly bar: HTMLElement;
  readonly plan: PlanView;
  scene: Scene | null = null;
  locator: Locator | null = null;
  choice: Choice = 0;
  field = "";
  private readonly fields = h("select", { "aria-label": "field", class: "field-choice" });
  private readonly combinations = h("select", { "aria-label": "combination", class: "combination-choice" });
  private readonly planBox = h("div", { class: "stage-box" });
  private readonly spaceBox = h("div", { class: "stage-box", hidden: true });
  private readonly reading = h("div", { class: "reading", "aria-hidden": "true" });
  private readonly legend: Legend;
  private readonly toolButtons: Record<Tool, HTMLButtonElement>;
  private readonly modeButtons: Record<"plan" | "space", HTMLButtonElement>;
  private space: SpaceView | null = null;
  private mode: "plan" | "space" = "plan";
  private wantedName = ""; // of the combination, so that it stays chosen when their order changes

  constructor(private readonly hooks: StageHooks) {
    const button = (words: string, hint: string, run: () => void) =>
      h("button", { type: "button", title: hint, onclick: run }, words);
    this.toolButtons = {
      pan: button("Pan", "Drag to shift the picture, turn the wheel to zoom", () => this.setTool("pan")),
      pick: button("Pick", "Click on the slab to read all values there", () => this.setTool("pick")),
      section: button("Section", "Click two places to draw the values along the line between them", () =>
        this.setTool("section"),
      ),
    };
    this.modeButtons = {
      plan: button("Plan", "The slab from above", () => this.setMode("plan")),
      space: button("3-D", "The bent slab in space", () => this.setMode("space")),
    };
    const side = h("div", { class: "stage-side" });
    this.bar = h(
      "div",
      { class: "stage-bar", role: "toolbar", "aria-label": "result" },
      this.combinations,
      this.fields,
      h("div", { class: "group", role: "group", "aria-label": "tool" }, ...Object.values(this.toolButtons)),
      h("div", { class: "group", role: "group", "aria-label": "view" }, ...Object.values(this.modeButtons)),
      button("Fit", "Show the whole slab", () => this.fit()),
    );
    this.element = h(
      "div",
      { class: "stage" },
      h("div", { class: "stage-views" }, this.planBox, this.spaceBox, this.reading),
      side,
    );
    this.plan = new PlanView(this.planBox);
    this.legend = new Legend(side);
    this.plan.onShow = (shown) => this.legend.show(shown, this.scene);
    this.plan.onPick = (x, y) => hooks.picked([x, y]);
    this.plan.onSection = (start, end) => hooks.cut(start, end);
    this.plan.onHover = (at) => this.read(at);
    this.fields.addEventListener("change", () => this.show(this.choice, this.fields.value));
    this.combinations.addEventListener("change", () => this.show(parseChoice(this.combinations.value), this.field));
    onTheme((theme) => {
      this.plan.setTheme(theme);
      this.space?.setTheme(theme);
    });
    this.setTool("pick");
    this.setMode("plan");
  }

  /** Take another result; zoom, field and combination stay as far as it has them. */
  take(scene: Scene): void {
    this.scene = scene;
    this.locator = new Locator(scene.mesh);
    this.plan.setScene(scene);
    this.space?.setScene(scene);
    this.field = fillFields(this.fields, scene, this.field || "settlement");
    const named = scene.head.combinations.findIndex((each) => each.name === this.wantedName);
    const wanted = isEnvelope(this.choice) ? this.choice : named >= 0 ? named : undefined;
    const possible = fillCombinations(this.combinations, scene, wanted);
    // what has no values can be chosen too: its reason stands in place of the picture
    for (const option of this.combinations.options) option.disabled = false;
    this.show(named >= 0 && wanted === named ? named : (possible ?? 0), this.field);
  }

  /** Show nothing: the document is another one. */
  clear(): void {
    this.scene = null;
    this.locator = null;
    this.plan.setScene(null);
    this.plan.setPlan(null);
    this.plan.markPick(null);
    this.plan.markSection(null);
    this.space?.setScene(null);
    this.wantedName = "";
  }

  /** Show a field of a combination or an envelope. */
  show(choice: Choice, field: string): void {
    const { scene } = this;
    if (!scene) return;
    if (typeof choice === "number") this.wantedName = scene.head.combinations[choice]?.name ?? "";
    this.choice = choice;
    this.field = field;
    this.combinations.value = String(choice);
    this.fields.value = field;
    this.fields.title = fieldOf(scene, field).meaning;
    this.combinations.title = choiceName(scene, choice);
    const values = typeof choice !== "number" || scene.head.combinations[choice]?.values !== null;
    if (values && this.mode === "space" && this.space) {
      this.space.onShow = (shown) => this.legend.show(shown, scene);
      this.space.show(choice, field);
    } else if (values) this.plan.show(choice, field);
    this.hooks.shown();
  }

  fit(): void {
    if (this.mode === "plan") this.plan.fit();
    else this.space?.fit();
  }

  setTool(tool: Tool): void {
    this.plan.setTool(tool);
    for (const [name, button] of Object.entries(this.toolButtons))
      button.setAttribute("aria-pressed", String(name === tool));
  }

  private setMode(mode: "plan" | "space"): void {
    this.mode = mode;
    for (const [name, button] of Object.entries(this.modeButtons))
      button.setAttribute("aria-pressed", String(name === mode));
    for (const button of Object.values(this.toolButtons)) button.disabled = mode === "space";
    this.planBox.hidden = mode !== "plan";
    this.spaceBox.hidden = mode !== "space";
    if (mode === "space" && !this.space) {
      this.space = new SpaceView(this.spaceBox);
      this.space.setScene(this.scene);
    }
    if (this.scene) this.show(this.choice, this.field);
  }

  /** The value under the pointer. */
  private read(at: Point | null): void {
    const { scene, locator } = this;
    if (!at || !scene || !locator) return setText(this.reading, "");
    let words = `x ${at[0].toFixed(2)}  y ${at[1].toFixed(2)} m`;
    const spot = this.plan.shown ? locator.at(at[0], at[1]) : null;
    if (spot) {
      const info = fieldOf(scene, this.field);
      words += `   ${symbolText(info.symbol)} = ${number(valueAt(scene, locator, this.choice, this.field, spot).value)} ${info.unit}`;
    }
    setText(this.reading, words.replaceAll("-", "−"));
  }
}

// A result as a picture: which field of which combination, in plan or in space, with its color scale.

import {
  type Choice,
  choiceName,
  combinationName,
  type Envelope,
  envelopesOf,
  type FieldInfo,
  fieldOf,
  fieldsOf,
  fieldValueAt,
  groupFields,
  isEnvelope,
  parseChoice,
} from "../data/fields";
import { lengthsOf } from "../data/lengths";
import { labelEverywhere } from "../data/load-labels";
import { formatNumber, withMinus } from "../data/numbers";
import { Locator } from "../data/point-location";
import type { Combination, Point, Scene } from "../data/scene";
import type { ScaleRange, ShownField } from "../data/shown-field";
import { PlanView, type Tool } from "../plan/plan-view";
import { annotationsOf } from "../plan/result-symbols";
import { allow, button, fill, h, press, setRead, setText } from "../shared/dom";
import { keepNames, say, translate, verbatim } from "../shared/language";
import { plainSymbols, symbolText } from "../shared/symbols";
import { onThemeChange } from "../shared/theme";
import { SpaceView } from "../space/space-view";
import { Legend } from "./legend";
import "./result-view.css";

type Mode = "plan" | "space";

const OF_PLAN = "Of the plan alone: choose Plan first.";

export interface ResultViewHooks {
  /** A point was picked. */
  onPick(at: Point): void;
  /** A section was cut between two points, or with a width a strip. */
  onSection(start: Point, end: Point, width: number): void;
  /** Another field or combination is shown. */
  onShow(): void;
}

/** What is looked at, kept while results change. */
export class ResultView {
  readonly plan: PlanView;
  space: SpaceView | null = null; // made when it is first used
  scene: Scene | null = null;
  locator: Locator | null = null;
  choice: Choice = 0;
  field = "";
  mode: Mode = "plan";
  /** The scale of what is shown. */
  shown: ShownField | null = null;
  readonly fields = h("select", { "aria-label": "Field", class: "field-choice" });
  readonly combinations = h("select", { "aria-label": "Combination", class: "combination-choice" });
  readonly toolGroup: HTMLElement;
  readonly modeGroup: HTMLElement;
  readonly fitButton = button("Fit", "Zoom to the whole plate (0)", () => this.fit());
  readonly meshButton = button("Mesh", "Show the mesh over the field", () => this.setMesh(!this.mesh));
  readonly numbersButton = button("Numbers", "Show values on contours and where there is space", () =>
    this.setLayer("numbers", !this.layers.numbers),
  );
  readonly reactionsButton = button("Reactions", "Show what supports and walls bear in the combination", () =>
    this.setLayer("reactions", !this.layers.reactions),
  );
  readonly barsButton = button(
    "Bars",
    "Show diameter and spacing of the bars provided, over fields of their layer",
    () => this.setLayer("bars", !this.layers.bars),
  );
  /** Beside the picture: the scale. */
  readonly scaleBox = h("div", { class: "gs-scale" });
  /** The picture. */
  readonly element: HTMLElement;
  private readonly planBox = h("div", { class: "gs-box" });
  private readonly spaceBox = h("div", { class: "gs-box", hidden: true });
  private readonly everywhere = h("div", { class: "gs-everywhere" });
  private readonly reading = h("div", { class: "gs-reading", "aria-hidden": "true" });
  private readonly legend: Legend;
  private readonly tools: Record<Tool, HTMLButtonElement>;
  private readonly modes: Record<Mode, HTMLButtonElement>;
  private range: ScaleRange = "auto";
  private mesh = false;
  private readonly layers = { numbers: true, reactions: true, bars: true };
  /** What was chosen last, so that it stays so when the order of combinations changes, or one passing scene lacks it. */
  wanted: { name: string; choice: Choice; field: string } = { name: "", choice: 0, field: "settlement" };

  /** `offerRefused`: whether combinations without values can be chosen. */
  constructor(
    private readonly hooks: ResultViewHooks,
    private readonly offerRefused = false,
  ) {
    this.tools = {
      pan: button("Pan", "Drag to pan; scroll or pinch to zoom", () => this.setTool("pan")),
      pick: button("Pick", "Click the plate to read all values at that point", () => this.setTool("pick")),
      section: button(
        "Section",
        "Drag from one point to another, or click both, to cut a section; hold Shift to align it with x or y; drag the section sideways to average over a strip",
        () => this.setTool("section"),
      ),
    };
    this.modes = {
      plan: button("Plan", "Top view of the plate", () => this.setMode("plan")),
      space: button("3-D", "3-D view of the deflected plate", () => this.setMode("space")),
    };
    this.toolGroup = h("div", { class: "gs-group", role: "group", "aria-label": "Tool" }, ...Object.values(this.tools));
    this.modeGroup = h("div", { class: "gs-group", role: "group", "aria-label": "View" }, ...Object.values(this.modes));
    this.element = h("div", { class: "gs-stage" }, this.planBox, this.spaceBox, this.everywhere, this.reading);
    this.plan = new PlanView(this.planBox);
    this.legend = new Legend(this.scaleBox);
    this.plan.onShow = (shown) => this.showLegend(shown);
    this.plan.onPick = (at) => hooks.onPick(at);
    this.plan.onSection = (start, end, width) => hooks.onSection(start, end, width);
    this.plan.onHover = (at) => this.read(at);
    this.fields.addEventListener("change", () => this.show(this.choice, this.fields.value));
    this.combinations.addEventListener("change", () => this.show(parseChoice(this.combinations.value), this.field));
    onThemeChange((theme) => {
      this.plan.setTheme(theme);
      this.space?.setTheme(theme);
    });
    this.setTool("pick");
    press(this.modes, "plan");
    this.setMesh(false);
    for (const name of ["numbers", "reactions", "bars"] as const) this.setLayer(name, true);
  }

  /** Show a scene; zoom, field and combination stay as far as it has them, after one that passes in any case. */
  setScene(
    scene: Scene,
    isPassing = false,
    field = this.wanted.field,
    choice: Choice | undefined = this.matchingChoice(scene),
  ): void {
    keepNames("result", scene.head);
    this.scene = scene;
    this.locator = new Locator(scene.mesh);
    this.plan.setScene(scene);
    this.space?.setScene(scene);
    fillFields(this.fields, scene);
    fillCombinations(this.combinations, scene, this.offerRefused);
    const options = [...this.combinations.options];
    const wanted = options.find((each) => each.value === String(choice) && !each.disabled);
    const found = wanted ?? options.find((each) => each.dataset.empty === undefined && /^\d+$/.test(each.value));
    const fields = fieldsOf(scene).map((each) => each.name);
    const shown = found ? parseChoice(found.value) : 0;
    const what = fields.includes(field) ? field : (fields[0] ?? "");
    if (isPassing) this.draw(shown, what);
    else this.show(shown, what);
  }

  /** Show nothing. */
  clear(): void {
    this.scene = null;
    this.locator = null;
    this.wanted = { ...this.wanted, name: "" };
    this.plan.setScene(null);
    this.plan.setPlan(null);
    this.plan.mark("pick", null);
    this.plan.mark("section", null);
    this.space?.setScene(null);
    setText(this.everywhere, "");
  }

  /** Show a field of a combination or an envelope. */
  show(choice: Choice, field: string): void {
    if (!this.scene) return;
    const name = isEnvelope(choice) ? "" : (this.scene.head.combinations[choice]?.name ?? "");
    this.wanted = { name, choice, field };
    this.draw(choice, field);
  }

  private draw(choice: Choice, field: string): void {
    const { scene } = this;
    if (!scene) return;
    this.choice = choice;
    this.field = field;
    this.combinations.value = String(choice);
    this.fields.value = field;
    setRead(this.fields, "title", fieldOf(scene, field).meaning);
    setRead(this.combinations, "title", verbatim(choiceName(scene, choice)));
    if (isEnvelope(choice) || scene.head.combinations[choice]?.values) this.view().show(choice, field);
    const factors = isEnvelope(choice) ? null : new Map(scene.head.combinations[choice]?.factors ?? []);
    const { plan } = scene.head;
    const acting = factors && !plan.plates?.length ? labelEverywhere(plan.loads, factors) : "";
    setText(this.everywhere, acting && say("Entire slab: {acting}", { acting: plainSymbols(acting) }));
    this.offerLayers(scene);
    this.hooks.onShow();
  }

  setRange(range: ScaleRange): void {
    this.range = range;
    this.plan.setRange(range);
    this.space?.setRange(range);
  }

  /** Show the mesh over the field, in plan and in space, or not. */
  setMesh(mesh: boolean): void {
    this.mesh = mesh;
    this.meshButton.setAttribute("aria-pressed", String(mesh));
    this.plan.setMesh(mesh);
    this.space?.setMesh(mesh);
  }

  /** Show numbers on the field, reactions or bars, or not. */
  private setLayer(name: keyof ResultView["layers"], on: boolean): void {
    this.layers[name] = on;
    this.layerButtons[name].setAttribute("aria-pressed", String(on));
    this.plan.setLayers({ [name]: on });
  }

  private get layerButtons(): Record<keyof ResultView["layers"], HTMLButtonElement> {
    return { numbers: this.numbersButton, reactions: this.reactionsButton, bars: this.barsButton };
  }

  /** Offer what the scene has: reactions of one combination, bars over a field of their layer. */
  private offerLayers({ head }: Scene): void {
    const of = this.mode === "space" ? OF_PLAN : "";
    const { reactions, bars } = annotationsOf(head, isEnvelope(this.choice) ? null : this.choice, this.field);
    allow(this.numbersButton, of);
    this.reactionsButton.hidden = !head.combinations.some((each) => each.reactions?.length);
    allow(this.reactionsButton, of || (reactions.length ? "" : "An envelope has no reactions: choose a combination."));
    this.barsButton.hidden = !head.bars?.length;
    allow(this.barsButton, of || (bars.length ? "" : "Choose a field of a layer of bars first."));
  }

  setTool(tool: Tool): void {
    this.plan.setTool(tool);
    press(this.tools, tool);
  }

  fit(): void {
    this.view().fit();
  }

  /** Mark a place on the plan and bring it into view. */
  reveal(at: Point): void {
    if (this.mode !== "plan") this.setMode("plan");
    this.plan.mark("place", at);
    this.plan.center(at);
  }

  private setMode(mode: Mode): void {
    this.mode = mode;
    press(this.modes, mode);
    for (const each of Object.values(this.tools)) allow(each, mode === "space" ? OF_PLAN : "");
    this.planBox.hidden = mode !== "plan";
    this.spaceBox.hidden = mode !== "space";
    if (mode === "space" && !this.space) {
      this.space = new SpaceView(this.spaceBox);
      this.space.onShow = (shown) => this.showLegend(shown);
      this.space.setRange(this.range);
      this.space.setMesh(this.mesh);
      this.space.setScene(this.scene);
    }
    this.draw(this.choice, this.field);
  }

  private view(): PlanView | SpaceView {
    return this.mode === "space" && this.space ? this.space : this.plan;
  }

  /** Return the choice that stands for the present one in another scene. */
  private matchingChoice(scene: Scene): Choice | undefined {
    const { name, choice } = this.wanted;
    if (isEnvelope(choice)) return choice;
    const { combinations } = scene.head;
    const position = combinations.findIndex((each) => each.name === name);
    if (position >= 0) return position;
    return name === "" ? undefined : findGoverning(combinations);
  }

  private showLegend(shown: ShownField | null): void {
    this.shown = shown;
    this.legend.show(shown, this.scene);
  }

  /** Show the value under the pointer. */
  private read(at: Point | null): void {
    const { scene, locator } = this;
    if (!at || !scene || !locator) return setText(this.reading, "");
    const { unit, per_meter: per } = lengthsOf(scene.head.plan);
    const figure = (value: number) => translate((value * per).toFixed(2));
    let text = `x ${figure(at[0])}  y ${figure(at[1])} ${unit}`;
    const spot = this.plan.shown ? locator.locate(...at) : null;
    if (spot) {
      const info = fieldOf(scene, this.field);
      const found = fieldValueAt(scene, locator, this.choice, this.field, spot);
      text += `   ${symbolText(info.symbol)} = ${translate(formatNumber(found.value))} ${info.unit}`;
      if (isEnvelope(this.choice))
        text += ` (${say("combination {number}", { number: scene.head.combinations[found.from]?.number ?? "" })})`;
    }
    setText(this.reading, verbatim(withMinus(text)));
  }
}

/** Return the index of the combination with the largest sum of factors, of those with values. */
function findGoverning(combinations: readonly Combination[]): number | undefined {
  const sumOf = ({ factors }: Combination) => [...factors].reduce((sum, [, factor]) => sum + factor, 0);
  const sums = combinations.map((each) => (each.values === null ? -Infinity : sumOf(each)));
  const largest = Math.max(...sums);
  return Number.isFinite(largest) ? sums.indexOf(largest) : undefined;
}

/** Fill a list with the fields of a scene, in groups. */
function fillFields(select: HTMLSelectElement, scene: Scene): void {
  const makeOption = ({ name, meaning, symbol }: FieldInfo) =>
    h(
      "option",
      { value: name, title: meaning },
      verbatim(`${symbolText(symbol)} – ${translate(meaning).split(/[,(]/)[0]!.trim()}`),
    );
  const groups = groupFields(fieldsOf(scene));
  fill(select, ...groups.map(([label, fields]) => h("optgroup", { label }, ...fields.map(makeOption))));
}

/** Fill a list with the combinations and envelopes of a scene; those without values are marked, and disabled if not offered. */
function fillCombinations(select: HTMLSelectElement, scene: Scene, offerRefused: boolean): void {
  const { combinations, left_out: leftOut } = scene.head;
  const envelopes = envelopesOf(scene).map((each: Envelope) =>
    h("option", { value: each }, verbatim(choiceName(scene, each))),
  );
  const options = combinations.map((each, i) => {
    const empty = each.values === null;
    const attributes = {
      value: i,
      disabled: empty && !offerRefused,
      "data-empty": empty,
      title: verbatim(each.refused ?? ""),
    };
    return h("option", attributes, verbatim(combinationName(scene, each) + remarkOn(each, leftOut)));
  });
  if (!envelopes.length) return fill(select, ...options);
  fill(
    select,
    h("optgroup", { label: "Envelopes" }, ...envelopes),
    h("optgroup", { label: "Combinations" }, ...options),
  );
}

/** Return what is to be said of a combination beside its name. */
function remarkOn({ name, refused, values, certified }: Combination, leftOut: readonly string[]): string {
  // the kind of failure stands before the reason
  if (refused !== null) return ` (${refused.split(":", 1)[0]!.trim().toLowerCase()})`;
  if (values === null) return ` ${translate(leftOut.includes(name) ? "(left out)" : "(no values)")}`;
  return certified ? "" : ` ${translate("(not certified)")}`;
}

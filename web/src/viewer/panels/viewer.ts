// A whole viewer of results: what to show, the plan or the view in space, the scale, values at a point, a section.

import { neat, number } from "../data/color-scale";
import { type Choice, choiceName, fieldOf, isEnvelope, parseChoice, valueAt } from "../data/fields";
import { Locator } from "../data/point-location";
import type { Point, Scene } from "../data/scene";
import type { Layers } from "../plan/overlay";
import { PlanView, type Shown, type Tool } from "../plan/plan-view";
import { make, symbolText } from "../shared/dom";
import { onTheme, setTheme, type Theme, theme } from "../shared/theme";
import { SpaceView } from "../space/space-view";
import { fillCombinations, fillFields } from "./controls";
import { Legend } from "./legend";
import { SectionChart } from "./section-chart";
import { ValuePanel } from "./value-panel";
import "./viewer.css";

export interface ViewerOptions {
  field?: string; // shown first
  combination?: Choice;
  themeSwitch?: boolean; // whether the viewer has one (a page may have its own)
}

type Mode = "plan" | "space";

/** Size of the printed picture [px of style sheets, 96 per inch], and dots per pixel. */
const PAPER = { width: 540, tallest: 640, ratio: 4 } as const;

export class Viewer {
  readonly element = make("div", { class: "gs-viewer" });
  readonly plan: PlanView;
  private space: SpaceView | null = null; // made when it is first asked for
  private readonly legend: Legend;
  private readonly panel: ValuePanel;
  private readonly chart: SectionChart;
  private readonly stage = make("div", { class: "gs-stage" });
  private readonly planBox = make("div", { class: "gs-box" });
  private readonly spaceBox = make("div", { class: "gs-box", hidden: true });
  private readonly scaleBox = make("div", { class: "gs-scale" });
  private readonly side = make("div", { class: "gs-side" });
  private readonly status = make("div", { class: "gs-status", "aria-hidden": "true" });
  private readonly chartBox = make("div", { class: "gs-chart-box", hidden: true });
  private readonly chartTitle = make("div", { class: "gs-chart-title" });
  private readonly chartOf = make("select", { "aria-label": "Combinations in the section" });
  private readonly fields = make("select", { "aria-label": "Field" });
  private readonly combinations = make("select", { "aria-label": "Combination" });
  private readonly lines = make("select", { "aria-label": "Section line" });
  private readonly tools: Record<Tool, HTMLButtonElement>;
  private readonly modes: Record<Mode, HTMLButtonElement>;
  private readonly locator: Locator;
  private readonly larger = make(
    "button",
    { type: "button", title: "Fill the window with the viewer (Escape goes back)", click: () => this.enlarge() },
    "Enlarge",
  );
  private readonly printed = make("div", { class: "gs-print" });
  private choice: Choice = 0;
  private field = "";
  private mode: Mode = "plan";
  private spaceShown: Shown | null = null;
  private pick: Point | null = null;
  private section: { start: Point; end: Point; name: string } | null = null;
  private readonly ended: (() => void)[] = [];

  constructor(
    container: HTMLElement,
    private readonly scene: Scene,
    options: ViewerOptions = {},
  ) {
    this.locator = new Locator(scene.mesh);
    const button = (text: string, title: string, act: () => void) =>
      make("button", { type: "button", title, click: act }, text);
    const tool = (name: Tool, text: string, title: string) => button(text, title, () => this.setTool(name));
    this.tools = {
      pan: tool("pan", "Pan", "Drag to move, wheel or pinch to zoom"),
      pick: tool("pick", "Pick", "Click on the plate to read all values there"),
      section: tool("section", "Section", "Click two points to cut a section; with Shift along x or y"),
    };
    this.modes = {
      plan: button("Plan", "The plate seen from above", () => this.setMode("plan")),
      space: button("3-D", "The bent plate in space", () => this.setMode("space")),
    };
    const choices = make(
      "div",
      { class: "gs-bar gs-choices" },
      make("label", {}, make("span", {}, "Field"), this.fields),
      make("label", {}, make("span", {}, "Combination"), this.combinations),
    );
    const bar = make(
      "div",
      { class: "gs-bar", role: "toolbar", "aria-label": "Viewer" },
      make("div", { class: "gs-group", role: "group", "aria-label": "Tool" }, ...Object.values(this.tools)),
      make("div", { class: "gs-group", role: "group", "aria-label": "View" }, ...Object.values(this.modes)),
      button("Fit", "Show the whole plate (0)", () => this.fit()),
      this.showMenu(),
      this.larger,
    );
    const named = scene.head.plan.lines;
    if (named.length) {
      this.lines.append(
        make("option", { value: "" }, "Section along …"),
        ...named.map((line, i) => make("option", { value: i }, `Section ${line.name || i + 1}`)),
      );
      this.lines.addEventListener("change", () => this.chooseLine());
      this.tools.section.parentElement!.after(this.lines);
    }
    if (options.themeSwitch) {
      const turn = button("", "Light or dark", () => setTheme(theme() === "dark" ? "light" : "dark"));
      const name = (to: Theme) => {
        turn.textContent = to === "dark" ? "Light" : "Dark";
      };
      name(theme());
      this.ended.push(onTheme(name));
      bar.append(turn);
    }
    const chartBar = make(
      "div",
      { class: "gs-chart-bar" },
      this.chartTitle,
      this.chartOf,
      button("Close", "Take the section away", () => this.cut(null)),
    );
    const chartPlace = make("div", { class: "gs-chart-place" });
    this.chartBox.append(chartBar, chartPlace);
    this.stage.append(this.planBox, this.spaceBox, this.status);
    this.element.append(
      choices,
      bar,
      make("div", { class: "gs-main" }, this.stage, this.scaleBox, this.side),
      this.chartBox,
      this.printed,
    );
    container.append(this.element);
    this.plan = new PlanView(this.planBox);
    this.legend = new Legend(this.scaleBox);
    this.panel = new ValuePanel(this.side);
    this.chart = new SectionChart(chartPlace);
    this.connect();
    this.plan.setScene(scene);
    this.field = fillFields(this.fields, scene, options.field);
    const choice = fillCombinations(this.combinations, scene, options.combination);
    if (choice !== null) this.choice = choice;
    this.setTool("pick");
    this.setMode("plan");
    this.update();
  }

  /** Show a field of a combination, and all values at a point if one is given. */
  show(choice: Choice, field: string, point?: Point): void {
    this.choice = choice;
    this.field = field;
    this.fields.value = field;
    this.combinations.value = String(choice);
    if (point) this.setPick(point);
    this.update();
  }

  /** What is shown now. */
  get shown(): { choice: Choice; field: string } {
    return { choice: this.choice, field: this.field };
  }

  setTool(tool: Tool): void {
    this.plan.setTool(tool);
    for (const [name, button] of Object.entries(this.tools)) button.setAttribute("aria-pressed", String(name === tool));
  }

  setMode(mode: Mode): void {
    this.mode = mode;
    for (const [name, button] of Object.entries(this.modes)) button.setAttribute("aria-pressed", String(name === mode));
    for (const button of Object.values(this.tools)) button.disabled = mode === "space";
    this.planBox.hidden = mode !== "plan";
    this.spaceBox.hidden = mode !== "space";
    if (mode === "space" && !this.space) {
      this.space = new SpaceView(this.spaceBox);
      this.space.setScene(this.scene);
    }
    this.update();
  }

  fit(): void {
    if (this.mode === "plan") this.plan.fit();
    else this.space?.fit();
  }

  /** Put the present view on paper: call before printing. */
  toPaper(): void {
    const { scene } = this;
    const [x0, y0, x1, y1] = scene.head.plan.bounds;
    const width = PAPER.width;
    const height = Math.round(
      Math.min(PAPER.tallest, Math.max(220, ((width - 80) * (y1 - y0)) / Math.max(x1 - x0, 1e-6) + 70)),
    );
    const picture =
      this.mode === "plan"
        ? this.plan.snapshot(width, height, PAPER.ratio)
        : this.space?.snapshot(width, 400, PAPER.ratio);
    const info = fieldOf(scene, this.field);
    this.printed.replaceChildren(
      make(
        "div",
        { class: "gs-print-title" },
        `${symbolText(info.symbol)} [${info.unit}]: ${info.meaning}; ${choiceName(scene, this.choice)}`,
      ),
    );
    const row = make("div", { class: "gs-print-row" });
    if (picture) {
      picture.style.width = `${width}px`;
      row.append(picture);
    }
    new Legend(row).show(this.mode === "plan" ? this.plan.shown : this.spaceShown, scene);
    this.printed.append(row);
    const chart = this.section && this.chart.snapshot(660, 220, PAPER.ratio);
    if (chart) {
      const names = this.chart.names();
      const key =
        names.length > 1
          ? [
              make(
                "div",
                { class: "gs-print-key" },
                ...names.map(({ name, colour }) =>
                  make("span", {}, make("i", { style: `background:${colour}` }), name),
                ),
              ),
            ]
          : [];
      this.printed.append(
        make(
          "div",
          { class: "gs-print-part" },
          make("div", { class: "gs-print-title" }, this.chartTitle.textContent ?? ""),
          chart,
          ...key,
        ),
      );
    }
    if (this.pick) {
      const values = new ValuePanel(make("div", { class: "gs-print-part" }));
      values.show(scene, this.locator, this.choice, this.pick);
      this.printed.append(
        make(
          "div",
          { class: "gs-print-part" },
          make("div", { class: "gs-print-title" }, "Values at a point"),
          values.element,
        ),
      );
    }
  }

  dispose(): void {
    for (const end of this.ended) end();
    this.plan.dispose();
    this.space?.dispose();
    this.chart.dispose();
    this.element.remove();
  }

  private connect(): void {
    const { plan, panel } = this;
    this.fields.addEventListener("change", () => {
      this.field = this.fields.value;
      this.update();
    });
    this.combinations.addEventListener("change", () => {
      this.choice = parseChoice(this.combinations.value);
      this.update();
    });
    this.chartOf.addEventListener("change", () => this.drawChart());
    plan.onShow = (shown) => this.legend.show(shown, this.scene);
    plan.onPick = (x, y) => this.setPick([x, y]);
    plan.onSection = (start, end) => this.cut({ start, end, name: "" });
    plan.onHover = (at) => this.tell(at);
    panel.onField = (field) => this.show(this.choice, field);
    this.chart.onPlace = (at) => plan.markPlace(at);
    const before = () => this.toPaper();
    const after = () => this.printed.replaceChildren();
    addEventListener("beforeprint", before);
    addEventListener("afterprint", after);
    this.ended.push(
      onTheme((to) => {
        plan.setTheme(to);
        this.space?.setTheme(to);
        this.chart.setTheme(to);
      }),
      () => removeEventListener("beforeprint", before),
      () => removeEventListener("afterprint", after),
    );
    const escape = (event: KeyboardEvent) => {
      if (event.key === "Escape" && this.element.classList.contains("gs-large")) this.enlarge();
    };
    document.addEventListener("keydown", escape);
    this.ended.push(() => document.removeEventListener("keydown", escape));
  }

  private update(): void {
    const { scene, choice, field } = this;
    if (!scene.head.combinations.some((each) => each.values !== null)) {
      this.panel.element.textContent = "No combination has values to show.";
      return;
    }
    if (this.mode === "space" && this.space) {
      this.space.onShow = (shown) => {
        this.spaceShown = shown;
        this.legend.show(shown, scene);
      };
      this.space.show(choice, field);
    } else this.plan.show(choice, field);
    this.panel.show(scene, this.locator, choice, this.pick, field);
    this.fillChart();
  }

  private setPick(point: Point): void {
    this.pick = point;
    this.plan.markPick(point);
    this.panel.show(this.scene, this.locator, this.choice, point, this.field);
  }

  private chooseLine(): void {
    const line = this.lines.value === "" ? undefined : this.scene.head.plan.lines[Number(this.lines.value)];
    if (!line) return this.cut(null);
    this.cut({ start: line.start, end: line.end, name: line.name });
  }

  private cut(section: { start: Point; end: Point; name: string } | null): void {
    this.section = section;
    this.plan.markSection(section ? [section.start, section.end] : null);
    this.chartBox.hidden = !section;
    if (!section?.name) this.lines.value = "";
    this.fillChart();
  }

  private fillChart(): void {
    if (!this.section) return this.chart.show(null);
    const before = this.chartOf.value;
    const of = this.scene.head.combinations.filter((each) => each.values !== null);
    const state = [...new Set(of.map((each) => each.limit_state))];
    this.chartOf.replaceChildren(
      make("option", { value: "this" }, "the combination shown"),
      ...(of.length > 1 ? [make("option", { value: "all" }, "all combinations")] : []),
      ...(state.length > 1
        ? state.map((each) => make("option", { value: `state:${each}` }, `all ${each} combinations`))
        : []),
    );
    this.chartOf.hidden = of.length < 2;
    if ([...this.chartOf.options].some((option) => option.value === before)) this.chartOf.value = before;
    this.drawChart();
  }

  private drawChart(): void {
    const { section, scene, locator, field } = this;
    if (!section) return;
    const { start, end, name } = section;
    const wanted = this.chartOf.value;
    const several = scene.head.combinations.flatMap((each, i) =>
      each.values !== null && (wanted === "all" || wanted === `state:${each.limit_state}`) ? [i] : [],
    );
    const choices: Choice[] = wanted === "this" || !several.length ? [this.choice] : several;
    const place = ([x, y]: Point) => `(${neat(x, 5)}, ${neat(y, 5)})`;
    const info = fieldOf(scene, field);
    this.chartTitle.textContent = `${symbolText(info.symbol)} [${info.unit}] along ${name ? `${name}: ` : ""}${place(start)} to ${place(end)} m`;
    this.chart.show({ scene, locator, field, choices, start, end, name });
  }

  private tell(at: Point | null): void {
    const { status, scene } = this;
    if (!at) {
      status.textContent = "";
      return;
    }
    const [x, y] = at;
    let text = `x ${x.toFixed(2)}  y ${y.toFixed(2)} m`;
    const spot = this.locator.at(x, y);
    if (spot && this.plan.shown) {
      const info = fieldOf(scene, this.field);
      const found = valueAt(scene, this.locator, this.choice, this.field, spot);
      text += `   ${symbolText(info.symbol)} = ${number(found.value)} ${info.unit}`;
      if (isEnvelope(this.choice)) text += ` (combination ${scene.head.combinations[found.from]?.number ?? ""})`;
    }
    status.textContent = text.replace(/-/g, "\u2212");
  }

  private showMenu(): HTMLElement {
    const layer = (name: keyof Layers, text: string) => {
      const box = make("input", { type: "checkbox", checked: true });
      box.addEventListener("change", () => this.plan.setLayers({ [name]: box.checked }));
      return make("label", {}, box, text);
    };
    const option = (name: "lines" | "mesh" | "contact", text: string, on: boolean) => {
      const box = make("input", { type: "checkbox", checked: on });
      box.addEventListener("change", () => this.plan.setOptions({ [name]: box.checked }));
      return make("label", {}, box, text);
    };
    const same = make("input", { type: "checkbox" });
    same.addEventListener("change", () => {
      this.plan.setRange(same.checked ? "common" : "auto");
      this.space?.setRange(same.checked ? "common" : "auto");
    });
    const menu = make(
      "details",
      { class: "gs-menu" },
      make("summary", {}, "Show"),
      make(
        "div",
        {},
        layer("loads", "loads"),
        layer("columns", "columns"),
        layer("supports", "supports"),
        layer("zones", "zones"),
        layer("ground", "ground"),
        layer("output", "lines and points"),
        layer("labels", "names and sizes"),
        layer("extremes", "largest and smallest"),
        option("lines", "lines between colours", true),
        option("contact", "contact boundary", true),
        option("mesh", "elements", false),
        make("label", {}, same, "one scale for all combinations"),
      ),
    );
    const shut = (event: Event) => {
      const outside =
        event instanceof KeyboardEvent
          ? event.key === "Escape"
          : !(event.target instanceof Node && menu.contains(event.target));
      if (outside) menu.open = false;
    };
    document.addEventListener("pointerdown", shut);
    document.addEventListener("keydown", shut);
    this.ended.push(
      () => document.removeEventListener("pointerdown", shut),
      () => document.removeEventListener("keydown", shut),
    );
    return menu;
  }

  private enlarge(): void {
    this.element.classList.toggle("gs-large");
    const large = this.element.classList.contains("gs-large");
    this.larger.textContent = large ? "Reduce" : "Enlarge";
    document.documentElement.classList.toggle("gs-has-large", large);
  }
}

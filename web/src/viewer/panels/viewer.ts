// The viewer of results in a report: the picture, values at a point, a section, and all of it on paper.
import { type Choice, choiceName, fieldOf } from "../data/fields";
import type { Point, Scene } from "../data/scene";
import type { Layers } from "../plan/plan-symbols";
import { button, h, setText } from "../shared/dom";
import { type Text, translate, verbatim } from "../shared/language";
import { symbolText } from "../shared/symbols";
import { currentTheme, onThemeChange, switchTheme } from "../shared/theme";
import { Legend } from "./legend";
import { ResultView } from "./result-view";
import { SectionPanel } from "./section-panel";
import { ValuePanel } from "./value-panel";
import "./viewer.css";

/** Size of the printed picture [px of style sheets, 96 per inch], and dots per pixel. */
const PAPER = { width: 540, maxHeight: 640, ratio: 4 } as const;

const LAYERS: readonly [keyof Layers, string][] = [
  ["loads", "loads"],
  ["columns", "columns"],
  ["axes", "axes"],
  ["supports", "supports"],
  ["zones", "zones"],
  ["ground", "ground"],
  ["output", "lines and points"],
  ["labels", "labels"],
  ["reactions", "reactions"],
  ["bars", "bars"],
  ["extremes", "minimum and maximum"],
];

export class Viewer {
  readonly element = h("div", { class: "gs-viewer" });
  private readonly view: ResultView;
  private readonly values: ValuePanel;
  private readonly section: SectionPanel;
  private readonly enlargeButton = button("Enlarge", "Fill the window with the viewer (Escape to exit)", () =>
    this.enlarge(),
  );
  private readonly printed = h("div", { class: "gs-print" });
  private pick: Point | null = null;

  constructor(
    container: HTMLElement,
    private readonly scene: Scene,
    field?: string,
    choice?: Choice,
  ) {
    const chartBox = h("div", { class: "gs-chart-box", hidden: true });
    const chartPlace = h("div", { class: "gs-chart-place" });
    const side = h("div", { class: "gs-side" });
    this.view = new ResultView({
      onPick: (at) => this.setPick(at),
      onSection: (start, end, width) => this.section.cut({ start, end, name: "", width }),
      onShow: () => this.update(),
    });
    const { view } = this;
    this.section = new SectionPanel(view, chartPlace, "", (section) => {
      chartBox.hidden = !section;
    });
    this.values = new ValuePanel(side);
    this.values.onField = (name) => view.show(view.choice, name);
    const close = button("Close", "Remove the section", () => this.section.cut(null));
    chartBox.append(
      h("div", { class: "gs-chart-bar" }, this.section.title, this.section.combinations, close),
      chartPlace,
    );
    const choices = [makeLabel("Field", view.fields), makeLabel("Combination", view.combinations)];
    this.element.append(
      h("div", { class: "gs-bar gs-choices" }, ...choices),
      this.makeToolbar(),
      h("div", { class: "gs-main" }, view.element, view.scaleBox, side),
      chartBox,
      this.printed,
    );
    container.append(this.element);
    view.setScene(scene, false, field, choice);
    addEventListener("beforeprint", () => this.toPaper());
    addEventListener("afterprint", () => this.printed.replaceChildren());
    document.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && this.element.classList.contains("gs-large")) this.enlarge();
    });
  }

  /** Show a field of a combination, and all values at a point. */
  show(choice: Choice | undefined, field: string | undefined, point: Point): void {
    this.setPick(point);
    this.view.show(choice ?? this.view.choice, field ?? this.view.field);
  }

  private makeToolbar(): HTMLElement {
    const { view } = this;
    const theme = button("", "Light or dark", switchTheme);
    const nameTheme = () => {
      setText(theme, currentTheme() === "dark" ? "Light" : "Dark");
    };
    nameTheme();
    onThemeChange(nameTheme);
    return h(
      "div",
      { class: "gs-bar", role: "toolbar", "aria-label": "Viewer" },
      view.toolGroup,
      this.section.lines,
      view.modeGroup,
      view.fitButton,
      view.meshButton,
      view.numbersButton,
      this.makeMenu(),
      this.enlargeButton,
      theme,
    );
  }

  /** Make the menu of what is drawn. */
  private makeMenu(): HTMLElement {
    const { plan } = this.view;
    const makeBox = (text: string, checked: boolean, change: (on: boolean) => void) => {
      const box = h("input", { type: "checkbox", checked, onchange: () => change(box.checked) });
      return h("label", {}, box, text);
    };
    const boxes = [
      ...LAYERS.map(([name, text]) => makeBox(text, true, (on) => plan.setLayers({ [name]: on }))),
      makeBox("lines between colors", true, (lines) => plan.setOptions({ lines })),
      makeBox("contact boundary", true, (contact) => plan.setOptions({ contact })),
      makeBox("same scale for all combinations", false, (common) => this.view.setRange(common ? "common" : "auto")),
    ];
    const menu = h("details", { class: "gs-menu" }, h("summary", {}, "Show"), h("div", {}, ...boxes));
    document.addEventListener("pointerdown", (event) => {
      if (!(event.target instanceof Node && menu.contains(event.target))) menu.open = false;
    });
    document.addEventListener("keydown", (event) => {
      if (event.key === "Escape") menu.open = false;
    });
    return menu;
  }

  private update(): void {
    const { view, scene } = this;
    if (scene.head.combinations.some((each) => each.values !== null))
      this.values.show(scene, view.locator, view.choice, this.pick, view.field);
    else setText(this.values.element, "No combination has values to show.");
    this.section.update();
  }

  private setPick(point: Point): void {
    this.pick = point;
    this.view.plan.mark("pick", point);
    this.update();
  }

  private enlarge(): void {
    const isLarge = this.element.classList.toggle("gs-large");
    setText(this.enlargeButton, isLarge ? "Reduce" : "Enlarge");
    document.documentElement.classList.toggle("gs-has-large", isLarge);
  }

  /** Put the present view on paper. */
  private toPaper(): void {
    const { scene, view } = this;
    const [x0, y0, x1, y1] = scene.head.plan.bounds;
    const { width, maxHeight, ratio } = PAPER;
    const height = Math.round(
      Math.min(maxHeight, Math.max(220, ((width - 80) * (y1 - y0)) / Math.max(x1 - x0, 1e-6) + 70)),
    );
    const inSpace = view.mode === "space" && view.space;
    const picture = inSpace ? inSpace.snapshot(width, 400, ratio) : view.plan.snapshot(width, height, ratio);
    const row = h("div", { class: "gs-print-row" }, picture);
    new Legend(row).show(view.shown, scene);
    const info = fieldOf(scene, view.field);
    const about = `${symbolText(info.symbol)} [${info.unit}]: ${translate(info.meaning)}`;
    this.printed.replaceChildren(makeTitle(verbatim(`${about}; ${choiceName(scene, view.choice)}`)), row);
    const chart = this.section.section && this.section.chart.snapshot(660, 220, ratio);
    if (chart) {
      const names = this.section.chart.names();
      const keys = names.map(({ name, color }) =>
        h("span", {}, h("i", { style: `background:${color}` }), verbatim(name)),
      );
      const key = names.length > 1 ? h("div", { class: "gs-print-key" }, ...keys) : "";
      this.printed.append(makePart(makeTitle(verbatim(this.section.title.textContent ?? "")), chart, key));
    }
    if (this.pick) {
      const part = makePart(makeTitle("Values at a point"));
      new ValuePanel(part).show(scene, view.locator, view.choice, this.pick);
      this.printed.append(part);
    }
  }
}

function makeLabel(text: string, select: HTMLSelectElement): HTMLElement {
  return h("label", {}, h("span", {}, text), select);
}

function makeTitle(text: Text): HTMLElement {
  return h("div", { class: "gs-print-title" }, text);
}

function makePart(...children: (Node | string)[]): HTMLElement {
  return h("div", { class: "gs-print-part" }, ...children);
}

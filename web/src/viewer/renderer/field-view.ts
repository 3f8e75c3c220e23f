// What views of a field share: what they show, the renderer that draws it, keys, pictures for paper.
import type { Choice } from "../data/fields";
import type { Scene } from "../data/scene";
import type { ScaleRange, ShownField } from "../data/shown-field";
import { h } from "../shared/dom";
import { ARROWS } from "../shared/keys";
import { currentTheme, type Theme } from "../shared/theme";
import { createRenderer } from "./create-renderer";
import type { FieldRenderer } from "./renderer";

export abstract class FieldView {
  /** Another field, combination or scale is shown; null: none. */
  onShow?: (shown: ShownField | null) => void;
  protected renderer: FieldRenderer;
  protected scene: Scene | null = null;
  protected choice: { choice: Choice; field: string } | null = null;
  protected range: ScaleRange = "auto";
  protected mesh = false; // whether the elements' sides are drawn
  protected fitted = false; // whether the user has left the view as `fit` made it
  private theme: Theme = currentTheme();
  private frame = 0;

  constructor(
    readonly element: HTMLElement,
    antialias: boolean,
  ) {
    this.renderer = createRenderer(antialias, (replacement) => {
      this.renderer = replacement;
      this.load();
    });
    element.addEventListener("keydown", (event) => {
      if (this.handleKey(event)) event.preventDefault();
    });
  }

  /** Show the entire plate. */
  abstract fit(): void;
  /** Find out what is to be shown: values, scale, marks. */
  protected abstract refresh(): void;
  protected abstract draw(): void;
  /** Move or turn what is seen as an arrow points. */
  protected abstract step(arrow: readonly [number, number], far: boolean): void;
  /** Enlarge what is seen, or make it smaller. */
  protected abstract zoom(enlarge: boolean): void;

  setScene(scene: Scene | null): void {
    this.scene = scene;
    this.choice = null;
    this.load();
  }

  /** Show a field of a combination or an envelope. */
  show(choice: Choice, field: string): void {
    this.choice = { choice, field };
    this.refresh();
  }

  setRange(range: ScaleRange): void {
    this.range = range;
    this.refresh();
  }

  /** Draw the elements' sides over the field, or not. */
  setMesh(mesh: boolean): void {
    this.mesh = mesh;
    this.refresh();
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
    this.renderer.setTheme(theme);
    this.redraw();
  }

  /** Give the renderer everything it needs. */
  protected load(): void {
    this.renderer.setTheme(this.theme);
    this.renderer.setMesh(this.scene?.mesh ?? null);
    this.refresh();
  }

  /** Draw with the next frame. */
  protected redraw(): void {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  /** Dots per pixel of style sheets on the screen. */
  protected get screenRatio(): number {
    return Math.min(window.devicePixelRatio || 1, 2);
  }

  /** Return a picture of what `paint` has the renderer draw, on white. */
  protected takePicture(width: number, height: number, ratio: number, paint: () => void): HTMLCanvasElement {
    const picture = h("canvas", { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    this.renderer.setTheme("light");
    paint();
    picture.getContext("2d")!.drawImage(this.renderer.canvas, 0, 0, picture.width, picture.height);
    this.renderer.setTheme(this.theme);
    this.draw();
    return picture;
  }

  /** Handle a key; returns whether it means something here. */
  protected handleKey(event: KeyboardEvent): boolean {
    if (event.target !== this.element || event.ctrlKey || event.metaKey || event.altKey) return false;
    const arrow = ARROWS[event.key];
    if (arrow) this.step(arrow, event.shiftKey);
    else if (["+", "=", "-"].includes(event.key)) this.zoom(event.key !== "-");
    else if (event.key === "0") this.fit();
    else return false;
    return true;
  }
}

// The keyboard in the drawing.
import { ARROWS } from "../../../viewer/shared/keys";
import type { Store } from "../../client/store";
import type { Change } from "../../model/changes/edits";
import { duplicateItem } from "../../model/changes/new-items";
import { removeItem } from "../../model/changes/references";
import { editsBetween } from "../../model/geometry";
import { samePath } from "../../model/paths";
import type { Canvas } from "../canvas";
import type { ToolBar } from "../tool-bar";
import { toolForKey } from "../tools";
import { removeCorner } from "./handles";
import { Nudge } from "./nudge";
import type { Pointer } from "./pointer";

export class Keyboard {
  private readonly nudge: Nudge;

  constructor(
    private readonly canvas: Canvas,
    private readonly pointer: Pointer,
    private readonly store: Store,
    private readonly push: (change: Change) => void,
    private readonly tools: ToolBar,
  ) {
    this.nudge = new Nudge(canvas, push);
    canvas.element.addEventListener("keydown", (event) => {
      if (this.handle(event)) event.preventDefault();
    });
  }

  /** Handle a key; returns whether it means something here. */
  private handle(event: KeyboardEvent): boolean {
    const isCommand = event.ctrlKey || event.metaKey;
    if (isCommand && event.key.toLowerCase() === "d") this.duplicate();
    else if (isCommand || event.altKey) return false;
    else if (ARROWS[event.key]) this.move(ARROWS[event.key]!, event.shiftKey ? 10 : 1);
    else return this.handlePlain(event);
    return true;
  }

  private handlePlain(event: KeyboardEvent): boolean {
    const { canvas, tools } = this;
    const tool = toolForKey(event.key);
    switch (event.key) {
      case "Escape":
        if (!this.pointer.cancel() && tools.current().name === "select") this.store.select(null);
        tools.choose("select");
        break;
      case "Enter":
        this.pointer.finish();
        break;
      case "Delete":
      case "Backspace":
        if (!this.store.broken) this.remove();
        break;
      case "0":
        canvas.fit();
        break;
      case "+":
      case "=":
      case "-":
        canvas.camera.zoom(event.key === "-" ? 0.8 : 1.25);
        canvas.moved();
        break;
      case "n":
      case "N":
        this.selectNext(event.shiftKey ? -1 : 1);
        break;
      case " ":
        break;
      default:
        if (tool) tools.choose(tool);
        return tool !== null;
    }
    return true;
  }

  private move([dx, dy]: readonly [number, number], times: number): void {
    const item = this.canvas.selected;
    if (item?.movable && !this.store.broken) {
      const step = this.canvas.step * times;
      this.nudge.step(item, dx * step, dy * step);
    } else {
      this.canvas.camera.pan(-dx * 40, dy * 40);
      this.canvas.moved();
    }
  }

  private remove(): void {
    const { selected, corner } = this.canvas;
    const after = selected && corner !== null ? removeCorner(selected.geometry, corner) : null;
    const path = this.store.selection;
    if (selected && after) {
      this.canvas.corner = null;
      const edits = editsBetween(selected.geometry, after);
      this.push({ edits, text: `remove a corner of ${selected.title}` });
    } else if (path && !(path[0] === "plate" && path.length < 3)) {
      this.push(removeItem(this.store.data, path));
      this.store.select(null);
    }
  }

  private duplicate(): void {
    const item = this.canvas.selected;
    if (!item || this.store.broken) return;
    const step = item.movable ? this.canvas.step * 2 : 0;
    const addition = duplicateItem(this.store.data, item.path, [step, step]);
    if (!addition) return;
    this.push(addition.change);
    this.store.select(addition.path);
  }

  /** Select the next item in the order of the drawing. */
  private selectNext(by: number): void {
    const { items } = this.canvas;
    const now = items.findIndex((item) => samePath(item.path, this.store.selection));
    this.store.select(items[(now + by + items.length) % Math.max(1, items.length)]?.path ?? null);
  }
}

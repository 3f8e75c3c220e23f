// The keyboard in the drawing.

import { ARROWS } from "../../../viewer/shared/keys";
import { say, verbatim } from "../../../viewer/shared/language";
import type { Store } from "../../client/store";
import { detachingEdits } from "../../model/changes/attachment";
import type { Change } from "../../model/edits";
import { editsBetween } from "../../model/geometry";
import { loadsOn } from "../../model/items";
import { samePath } from "../../model/paths";
import { type Actions, formForKey } from "../actions/actions";
import type { ActionDialog } from "../actions/dialog";
import type { Canvas } from "../canvas";
import { generatorForKey } from "../generators/generators";
import type { ToolBar } from "../tool-bar";
import { toolForKey } from "../tools";
import { removeCorner } from "./handles";
import { Nudge } from "./nudge";
import type { Pointer } from "./pointer";
import { typeKey } from "./typed-input";

export class Keyboard {
  private readonly nudge: Nudge;
  private typed = ""; // a length or a place

  constructor(
    private readonly canvas: Canvas,
    private readonly pointer: Pointer,
    private readonly store: Store,
    private readonly push: (change: Change) => void,
    private readonly tools: ToolBar,
    private readonly actions: Actions,
    private readonly dialog: ActionDialog,
    private readonly showHint: (text: string) => void,
  ) {
    this.nudge = new Nudge(canvas, push);
    canvas.element.addEventListener("pointerdown", () => {
      this.typed = "";
    });
    canvas.element.addEventListener("keydown", (event) => {
      if (this.handle(event)) event.preventDefault();
    });
  }

  /** Handle a key; returns whether it means something here. */
  private handle(event: KeyboardEvent): boolean {
    const isCommand = event.ctrlKey || event.metaKey;
    if (isCommand && event.key.toLowerCase() === "d") this.actions.duplicate();
    else if (isCommand && event.key.toLowerCase() === "a") this.selectDrawn();
    else if (isCommand || event.altKey) return false;
    else if (this.type(event.key)) return true;
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
        this.remove();
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
        else if (!this.openAction(event.key)) return false;
    }
    return true;
  }

  /** Take a key as part of a length or a place while something is drawn; returns whether it is one. */
  private type(key: string): boolean {
    const { pointer, tools } = this;
    if ((tools.current().draws === "nothing" && !pointer.isMoving) || this.store.broken) return false;
    if (this.typed && (key === "Enter" || key === "Escape")) {
      const isPlaced = key === "Escape" || pointer.placeTyped(this.typed);
      this.showTyped("", isPlaced ? "" : pointer.refusal(this.typed));
      return true;
    }
    const typed = typeKey(this.typed, key);
    if (typed !== null) this.showTyped(typed);
    return typed !== null;
  }

  private showTyped(typed: string, hint = ""): void {
    this.typed = typed;
    const { current } = this.tools;
    const what = this.pointer.isMoving ? "move here" : "draw to here";
    this.showHint(hint || (typed ? say("{typed} — Enter: {what}", { typed: verbatim(typed), what }) : current().hint));
  }

  /** Open the dialog of a key; returns whether there is one, an action only if something is selected. */
  private openAction(key: string): boolean {
    const action = this.store.selected.length > 0 ? formForKey(key) : null;
    const generator = action ? null : generatorForKey(key);
    const form = action ?? generator;
    if (!form) return false;
    const why = generator ? this.tools.whyNot(generator.name) : this.actions.whyNot(action!.name);
    if (why) this.showHint(why);
    else this.dialog.open(form);
    return true;
  }

  private move([dx, dy]: readonly [number, number], times: number): void {
    const moved = this.canvas.selectedItems.filter((item) => item.movable);
    if (moved.length > 0 && !this.store.broken) {
      const step = this.canvas.step * times;
      this.nudge.step([...moved, ...loadsOn(this.canvas.items, moved)], dx * step, dy * step);
    } else {
      this.canvas.camera.pan(-dx * 40, dy * 40);
      this.canvas.moved();
    }
  }

  private remove(): void {
    const { selected, corner } = this.canvas;
    const after = selected && corner !== null ? removeCorner(selected.geometry, corner) : null;
    if (selected && after && !this.store.broken) {
      this.canvas.corner = null;
      const edits = [...detachingEdits(selected), ...editsBetween(selected.geometry, after)];
      this.push({ edits, text: say("remove a corner of {item}", { item: selected.title }) });
    } else this.actions.remove();
  }

  /** Select all that is drawn on the slab. */
  private selectDrawn(): void {
    this.store.selectAll(this.canvas.items.filter(({ kind }) => kind !== "slab").map(({ path }) => path));
  }

  /** Select the next item in the order of the drawing. */
  private selectNext(by: number): void {
    const { items } = this.canvas;
    const now = items.findIndex((item) => samePath(item.path, this.store.selection));
    this.store.select(items[(now + by + items.length) % Math.max(1, items.length)]?.path ?? null);
  }
}

import type { FormContext } from "../../src/workbench/form/context";
import { partWidget } from "../../src/workbench/form/section";
import { applyOptimistic } from "../../src/workbench/model/changes/optimistic-edits";
import type { Change } from "../../src/workbench/model/edits";
import type { Issue } from "../../src/workbench/model/issues";
import { type Path, pathKey, type Table } from "../../src/workbench/model/paths";
import { schema } from "./schema";

/** A page with a form over data that every change is applied to. */
export class Page {
  readonly changes: Change[] = [];
  issues: Issue[] = [];
  readonly ctx: FormContext;
  update: () => void = () => undefined;

  constructor(public data: Table) {
    this.ctx = {
      schema,
      memory: new Map(),
      data: () => this.data,
      issues: () => this.issues,
      change: (change) => {
        this.changes.push(change);
        for (const edit of change.edits) this.data = applyOptimistic(this.data, edit);
        this.update();
      },
    };
  }

  show(path: Path) {
    const widget = partWidget(this.ctx, path, schema.nodeAt(path, this.data)!.node);
    document.body.replaceChildren(widget.element);
    this.update = () => widget.update();
    widget.update();
    return widget;
  }

  field(path: Path): HTMLElement {
    return document.querySelector<HTMLElement>(`[data-path='${pathKey(path)}']`)!;
  }

  input(path: Path): HTMLInputElement {
    return this.field(path).querySelector("input")!;
  }

  type(path: Path, text: string): void {
    const input = this.input(path);
    input.focus();
    input.value = text;
    input.dispatchEvent(new Event("input", { bubbles: true }));
  }
}

export const makeIssue = (
  path: Path,
  found = '"30"',
  expected = 'a pressure such as "30 MPa"',
  hint = "the unit is missing",
): Issue => ({ location: "", path, found, expected, hint });
export const PLATE: Table = { plate: { length_x: "6 m", length_y: "4 m", thickness: "250 mm", E: "30 GPa", nu: 0.2 } };

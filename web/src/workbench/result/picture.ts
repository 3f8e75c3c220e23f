// The picture of the result, in its place that of a preview or of a reference; items of the model are selected in it.

import { choiceName, combinationsOf, fieldOf, fieldsOf, isDifference, isEnvelope } from "../../viewer/data/fields";
import type { Point, Scene } from "../../viewer/data/scene";
import { ResultView, type ResultViewHooks } from "../../viewer/panels/result-view";
import { fill, h } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import type { Api, CombinationSummary } from "../client/api";
import type { ShownResult, Store } from "../client/store";
import { formatPath, parsePath } from "../model/paths";
import { type DifferenceApi, Minus } from "./minus";
import { itemAt, itemOf, itemsIn, middleOf } from "./plan-items";
import { Preview, type PreviewHooks } from "./preview";
import type { Target } from "./table-rows";

/** A click so near to a point or a line of the model selects it [px]. */
const REACH = 8;

export class Picture {
  readonly view: ResultView;
  readonly preview: Preview;
  readonly minus: Minus;
  readonly element: HTMLElement;
  /** The place whose values are wanted. */
  pick: Point | null = null;
  result: Scene | null = null;
  private run = 0; // that the result is of
  private turn = 0; // counts what is to be shown
  private readonly referenceLabel = h("p", { class: "preview-over", hidden: true }, "Reference");
  private readonly refused = h("div", { class: "refused-over", role: "alert", hidden: true });

  constructor(
    private readonly store: Store,
    api: Pick<Api, "preview"> & DifferenceApi,
    hooks: ResultViewHooks,
    previews: PreviewHooks,
    private readonly onError: (error: unknown) => void,
  ) {
    const onPick = (at: Point) => {
      this.choose(at);
      hooks.onPick(at);
    };
    const onShow = () => {
      const { scene, choice } = this.view;
      this.minus.tell(scene, scene ? choiceName(scene, choice) : "");
      hooks.onShow();
    };
    this.minus = new Minus(api, () => this.showResult());
    this.view = new ResultView({ ...hooks, onPick, onShow }, true);
    this.preview = new Preview(store, api, this.view, {
      ...previews,
      onShow: () => {
        this.turn += 1; // a difference that is on its way comes too late
        this.referenceLabel.hidden = true;
        previews.onShow();
      },
    });
    const { view, preview, referenceLabel, refused } = this;
    const outdated = h("p", { class: "outdated-over" }, "Result of an earlier model");
    const over = [preview.label, referenceLabel, this.minus.label, refused, outdated];
    this.element = h("div", { class: "stage-place" }, view.element, view.scaleBox, ...over);
    store.on(["selection"], () => this.markSelected());
  }

  /** Make the choices and tools that stand above the picture. */
  makeToolbar(): HTMLElement {
    const { combinations, fields, toolGroup, modeGroup, fitButton, meshButton } = this.view;
    const { numbersButton, reactionsButton, barsButton } = this.view;
    const about = { class: "stage-bar", role: "toolbar", "aria-label": "result" };
    const switches = [fitButton, meshButton, numbersButton, reactionsButton, barsButton];
    return h("div", about, combinations, this.minus.select, fields, toolGroup, modeGroup, ...switches);
  }

  /** What is shown, as files of it are asked for; null: nothing. */
  get shown(): ShownResult | null {
    const { scene, choice, field } = this.view;
    if (!scene) return null;
    const shown = combinationsOf(scene, choice).map((i) => scene.head.combinations[i]!);
    const states = new Set(shown.map((one) => one.limit_state));
    return {
      field,
      meaning: fieldOf(scene, field).meaning,
      of: choiceName(scene, choice),
      combination: isEnvelope(choice) ? "" : (shown[0]?.name ?? ""),
      envelope: isEnvelope(choice) && states.size === 1 ? (shown[0]?.limit_state ?? "") : "",
      isDrawable: !isEnvelope(choice) || states.size === 1,
      subtracted: isDifference(scene) ? this.minus.subtracted : null,
    };
  }

  /** Show the result of a run, or its difference to what is subtracted; null: none. */
  setResult(result: Scene | null, run = 0): void {
    this.result = result;
    this.run = run;
    this.minus.offer(result);
    if (result) return this.showResult();
    this.turn += 1;
    this.pick = null;
    this.minus.forget();
    this.view.clear();
  }

  /** Show the result, and in its place the difference to what is subtracted as soon as that is there. */
  private showResult(): void {
    const { result } = this;
    if (!result) return;
    this.turn += 1;
    const { turn } = this;
    this.referenceLabel.hidden = true;
    this.view.setScene(result);
    this.minus.announce();
    this.markSelected();
    const show = (difference: Scene | null) => {
      if (difference && turn === this.turn) this.view.setScene(difference, true);
    };
    this.minus.fetch(this.run).then(show, (error: unknown) => {
      // the results of a later run come next, with a difference of their own
      if (turn !== this.turn || this.store.solved?.run !== this.run) return;
      this.minus.reset();
      this.onError(error);
    });
  }

  /** Show the picture of a reference, null: that of the result again. */
  showReference(scene: Scene | null): void {
    if (!scene) return this.showResult();
    this.turn += 1;
    this.referenceLabel.hidden = false;
    this.view.setScene(scene, true);
  }

  /** Say over the picture why the combination shown has none. */
  tellRefused(one: CombinationSummary | null): void {
    this.refused.hidden = one === null || one.refused === null;
    fill(
      this.refused,
      h("h3", {}, say("{name} has no solution", { name: verbatim(one?.name ?? "") })),
      h("p", {}, verbatim(one?.refused ?? "")),
    );
  }

  /** Show what a cell of a table leads to: its field, its combination, its place; the item it names is selected. */
  follow({ place, combination, field, item }: Target): void {
    const { view } = this;
    if (!view.scene) return;
    const { combinations, plan } = view.scene.head;
    const position = combinations.findIndex(({ name }) => name === combination);
    const hasField = fieldsOf(view.scene).some(({ name }) => name === field);
    view.show(position < 0 ? view.choice : position, hasField && field !== null ? field : view.field);
    const named = item && itemsIn(plan, item.list).find(({ name }) => name === item.name);
    if (named) this.store.select(parsePath(named.path));
    const at = place ?? (named && middleOf(named));
    if (at) view.reveal(at);
  }

  /** Take a place that was clicked, and select the item there. */
  private choose(at: Point): void {
    this.pick = at;
    const { scene, plan } = this.view;
    const item = scene && itemAt(scene.head.plan, at, plan.lengthOf(REACH));
    if (item) this.store.select(parsePath(item.path));
  }

  /** Mark the item of the model that is selected. */
  private markSelected(): void {
    const { selection } = this.store;
    const { scene, plan } = this.view;
    const item = selection && scene && itemOf(scene.head.plan, formatPath(selection));
    plan.mark("selected", item ? { points: item.points, closed: item.shape === "area" } : null);
  }
}

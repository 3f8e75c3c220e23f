// The tabs of tables below the picture: which tables each has; a table is asked for when it is first seen.
import { fillOptions, h, setText } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import { type Api, Refused, type ResultTable } from "../client/api";
import type { Tab } from "../controls/tabs";
import type { Target } from "./table-rows";
import { TableView } from "./table-view";

/** The tabs in their order: name, label, and the tables in them with what each is called there. */
const GROUPS: readonly { name: string; label: string; tables: Record<string, string> }[] = [
  { name: "checks", label: "Checks", tables: { checks: "checks", calculations: "calculations" } },
  {
    name: "combinations",
    label: "Combinations",
    tables: { combinations: "all combinations", extremes: "extremes", tilt: "tilt" },
  },
  { name: "envelope", label: "Envelope", tables: { envelope: "envelope" } },
  {
    name: "columns",
    label: "Columns",
    tables: { column_envelope: "extremes", columns: "all combinations", zone_punching: "punching around zones" },
  },
  {
    name: "walls",
    label: "Walls",
    tables: {
      walls: "all combinations",
      core_loads: "loads of cores",
      cores: "cores",
      wall_punching: "punching at ends",
      wall_reinforcement: "reinforcement",
    },
  },
  { name: "beams", label: "Beams", tables: { beams: "all combinations", beam_reinforcement: "reinforcement" } },
  { name: "building", label: "Building", tables: { building: "all combinations", storeys: "storeys" } },
  {
    name: "supports",
    label: "Supports",
    tables: { supports: "supports", pile_punching: "punching over piles", joints: "joints" },
  },
  { name: "strips", label: "Strips", tables: { strips: "design strips", lines: "section lines", points: "points" } },
  {
    name: "reinforcement",
    label: "Reinforcement",
    tables: { reinforcement: "required", shear_reinforcement: "links against punching", bars: "bar quantities" },
  },
  { name: "alternatives", label: "Alternatives", tables: { alternatives: "alternatives" } },
  {
    name: "ground",
    label: "Ground",
    tables: { comparison: "ground model comparison", constants: "constants", soil: "soil below points" },
  },
  { name: "mesh", label: "Mesh and errors", tables: { errors: "errors", mesh: "mesh", steps: "steps" } },
];

class Group {
  readonly panel = h("div", { class: "lower-panel table-box" });
  readonly choice = h("select", { "aria-label": "Table" });
  readonly view: TableView;
  /** What is being made, or why it could not be. */
  private readonly words = h("p", { class: "table-words", role: "status", hidden: true });
  shown = ""; // run, update and name of the table
  chosen = ""; // the table that was asked for

  constructor(
    readonly name: string,
    readonly label: string,
    readonly tables: Readonly<Record<string, string>>,
    onTarget: (target: Target) => void,
  ) {
    this.view = new TableView(this.choice, onTarget);
    this.panel.append(this.words, this.view.element);
  }

  /** Say something in place of a table; nothing: show the table. */
  say(text: string, bad = false): void {
    setText(this.words, text);
    this.words.hidden = text === "";
    this.words.classList.toggle("bad", bad);
    this.view.hideRows(text !== "");
  }

  /** Offer those of some tables that belong here; returns whether there are any. */
  offer(names: readonly string[]): boolean {
    const there = Object.entries(this.tables).filter(([name]) => names.includes(name));
    fillOptions(this.choice, there);
    // not what was first while that was all: strips come before the lines that were there
    this.choice.value = there.find(([name]) => name === this.chosen)?.[0] ?? there[0]?.[0] ?? "";
    this.choice.hidden = there.length < 2;
    this.view.element.hidden = there.length === 0;
    this.say("");
    return there.length > 0;
  }
}

export class ResultTables {
  private readonly groups: Group[];
  private readonly kept = new Map<string, ResultTable>();
  private run: number | null = null;
  private update = 0;

  constructor(
    private readonly api: Pick<Api, "table">,
    onTarget: (target: Target) => void,
    private readonly onError: (error: unknown) => void,
  ) {
    this.groups = GROUPS.map(({ name, label, tables }) => new Group(name, label, tables, onTarget));
    for (const group of this.groups)
      group.choice.addEventListener("change", () => this.choose(group.name, group.choice.value));
  }

  get tabs(): Tab[] {
    return this.groups.map(({ name, label, panel }) => ({ name, label, panel }));
  }

  /** Put something before the rows of a tab. */
  addTo(tab: string, element: HTMLElement): void {
    this.groups.find(({ name }) => name === tab)?.panel.prepend(element);
  }

  /** Choose a table of a tab. */
  choose(tab: string, table: string): void {
    const group = this.groups.find(({ name }) => name === tab);
    if (group) group.choice.value = group.chosen = table;
    void this.see(tab);
  }

  /** Show no tables until those of newer results are there, which follow; the tabs stay. */
  wait(): void {
    this.run = null;
    for (const group of this.groups) {
      group.view.element.hidden = true;
      group.say("The tables are being made …");
    }
  }

  /** Take the names of the tables of a run's results; `offer` is called with each tab and whether it has any. */
  set(
    run: number | null,
    update: number,
    names: readonly string[],
    offer: (tab: string, offered: boolean) => void,
  ): void {
    if (run !== this.run || update !== this.update) this.kept.clear();
    [this.run, this.update] = [run, update];
    for (const group of this.groups) offer(group.name, group.offer(names));
  }

  /** Show the chosen table of a tab that has come into view. */
  async see(tab: string): Promise<void> {
    const group = this.groups.find((one) => one.name === tab);
    const { run, update } = this;
    const name = group?.choice.value;
    const wanted = `${run} ${update} ${name}`;
    const isCurrent = () => run === this.run && update === this.update;
    if (!group || !name || run === null) return;
    if (group.shown === wanted) return group.say("");
    group.panel.setAttribute("aria-busy", "true");
    if (!this.kept.has(name))
      group.say(say("The table is being made: {table} …", { table: group.tables[name] ?? name }));
    try {
      const table = this.kept.get(name) ?? (await this.api.table(run, name));
      if (!isCurrent()) return;
      this.kept.set(name, table);
      if (name !== group.choice.value) return;
      group.shown = wanted;
      group.say("");
      group.view.show(table);
    } catch (error) {
      if (!isCurrent()) return;
      if (error instanceof Refused) group.say(say("The table could not be made: {why}", { why: error.message }), true);
      else this.onError(error);
    } finally {
      if (isCurrent()) group.panel.setAttribute("aria-busy", "false");
    }
  }
}

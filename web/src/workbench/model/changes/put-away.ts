// What a kind of ground refuses, by the checks of the model: put away, and brought back with a ground that has it.

import type { Edit } from "../edits";
import { isTable, type Json, listAt, sameValue, type Table, tableAt } from "../paths";
import { parseLength } from "../quantities";
import { applyOptimistic } from "./optimistic-edits";
import type { Memory } from "./variants";

/** Kinds of ground without an end sideways, and those whose layers boreholes describe. */
const ENDLESS: readonly Json[] = ["continuum", "constrained modulus"];
const WITH_BOREHOLES: readonly Json[] = ["vlasov", "layered", "constrained modulus"];
/** What soil zones share with the rest of the ground. */
const SHARED_RULES = ["kind", "gamma", "formulas", "mode", "coupling"];

/** A list with items that a ground may refuse; `names` is what one and several of them are called. */
interface Rule {
  list: string;
  names(item: Table): readonly [string, string];
  /** Whether the data, in which the ground is of its new kind, can have an item. */
  fits(item: Table, data: Table, memory: Memory): boolean;
}

/** In this order, as zones depend on boreholes, and loads on supports. */
const RULES: readonly Rule[] = [
  { list: "boreholes", names: () => ["borehole", "boreholes"], fits: boreholeFits },
  { list: "soil_zones", names: () => ["soil zone", "soil zones"], fits: zoneFits },
  { list: "supports", names: () => ["pile", "piles"], fits: pileFits },
  {
    list: "loads",
    names: (load) =>
      load.on === "ground" ? ["load on the ground", "loads on the ground"] : ["settlement", "settlements"],
    fits: loadFits,
  },
  { list: "joints", names: () => ["elastic joint", "elastic joints"], fits: jointFits },
];

/** The edits that put away or bring back what depends on the ground, and how many items of what name. */
export interface Mended {
  edits: Edit[];
  away: Map<string, number>;
  back: Map<string, number>;
}

/** An item that was put away, and the position that it had. */
type Kept = { position: number; item: Table };

/** Mend the lists that depend on the ground, given the data before and with the ground of its new kind. */
export function mendLists(before: Table, after: Table, memory: Memory): Mended {
  const mended: Mended = { edits: [], away: new Map(), back: new Map() };
  for (const rule of RULES) {
    const edits = [
      ...putAway(rule, before, after, memory, mended.away),
      ...bringBack(rule, after, memory, mended.back),
    ];
    after = edits.reduce(applyOptimistic, after);
    mended.edits.push(...edits);
  }
  return mended;
}

/** Forget what the present ground can have: if it is not there, the user has removed it, or it was brought back. */
export function forgetWhatFits(data: Table, memory: Memory): void {
  for (const rule of RULES) {
    const rest = keptOf(rule, memory).filter(({ item }) => !rule.fits(item, data, memory));
    remember(rule, memory, rest);
  }
}

/** Change the items of a list that are put away. */
export function changeKept(list: string, memory: Memory, change: (item: Table) => Table): void {
  const items = (memory.get(list)?.items ?? []) as Kept[];
  if (items.length > 0) memory.set(list, { items: items.map((kept) => ({ ...kept, item: change(kept.item) })) });
}

/** Remove the items that do not fit, from the last on; the only loads of a slab stay, as it needs one. */
function putAway(rule: Rule, before: Table, after: Table, memory: Memory, away: Map<string, number>): Edit[] {
  const items = listAt(after, [rule.list]);
  const refused = items.flatMap((item, position) =>
    isTable(item) && !rule.fits(item, after, memory) ? [position] : [],
  );
  if (refused.length === 0 || (rule.list === "loads" && refused.length === items.length)) return [];
  const old = listAt(before, [rule.list]);
  const kept = refused.map((position): Kept => ({ position, item: old[position] as Table }));
  remember(rule, memory, [...keptOf(rule, memory), ...kept]);
  for (const { item } of kept) count(rule, item, away);
  if (refused.length === items.length) return [{ op: "remove", path: [rule.list] }];
  return refused.toReversed().map((position) => ({ op: "remove", path: [rule.list, position] }));
}

/** Add the items that were put away and fit again, each where it was; they stay known, as this may be undone. */
function bringBack(rule: Rule, data: Table, memory: Memory, back: Map<string, number>): Edit[] {
  const edits: Edit[] = [];
  for (const each of keptOf(rule, memory).toSorted((a, b) => a.position - b.position)) {
    if (!rule.fits(each.item, data, memory)) continue;
    const items = listAt(data, [rule.list]);
    const edit: Edit =
      items.length === 0
        ? { op: "set", path: [rule.list], value: [each.item] }
        : { op: "add", path: [rule.list], value: each.item, at: Math.min(each.position, items.length) };
    edits.push(edit);
    data = applyOptimistic(data, edit);
    count(rule, each.item, back);
  }
  return edits;
}

function keptOf(rule: Rule, memory: Memory): Kept[] {
  return (memory.get(rule.list)?.items as Kept[] | undefined) ?? [];
}

function remember(rule: Rule, memory: Memory, kept: readonly Kept[]): void {
  if (kept.length > 0) memory.set(rule.list, { items: [...kept] });
  else memory.delete(rule.list);
}

function count(rule: Rule, item: Table, counts: Map<string, number>): void {
  const [one, several] = rule.names(item);
  const number = (counts.get(one) ?? counts.get(several) ?? 0) + 1;
  counts.delete(one);
  counts.set(number === 1 ? one : several, number);
}

/** Whether ground goes on at all sides. */
export function isEndless(ground: Table): boolean {
  return ENDLESS.includes(ground.kind ?? "");
}

/** Whether a layer is given by its two stiffnesses. */
export function isInterfaceLayer(layer: Json): boolean {
  return isTable(layer) && ("k0" in layer || "k1" in layer);
}

/** As many soil layers as the ground has, which vary alike, and no zones of other soil. */
function boreholeFits(hole: Table, data: Table): boolean {
  const ground = tableAt(data, ["ground"]);
  const [own, layers] = [listAt(hole, ["layers"]), listAt(ground, ["layers"])];
  return (
    WITH_BOREHOLES.includes(ground.kind ?? "") &&
    listAt(data, ["soil_zones"]).length === 0 &&
    own.length === layers.length &&
    !layers.some(isInterfaceLayer) &&
    own.every((layer, n) => variationOf(layer) === variationOf(layers[n]!))
  );
}

function variationOf(layer: Json): Json {
  return (isTable(layer) && layer.variation) || "linear";
}

/** Zones are of the kind of the rest, with the same rules and layers. */
function zoneFits(zone: Table, data: Table): boolean {
  const [own, ground] = [tableAt(zone, ["ground"]), tableAt(data, ["ground"])];
  const [layers, others] = [listAt(own, ["layers"]), listAt(ground, ["layers"])];
  return (
    !isEndless(ground) &&
    listAt(data, ["boreholes"]).length === 0 &&
    SHARED_RULES.every((key) => sameValue(own[key], ground[key])) &&
    layers.length === others.length &&
    layers.every((layer, n) => sameDivision(layer, others[n]!))
  );
}

function sameDivision(a: Json, b: Json): boolean {
  const sublayers = (layer: Json) => (isTable(layer) && layer.sublayers) || 1;
  return isInterfaceLayer(a) === isInterfaceLayer(b) && sublayers(a) === sublayers(b);
}

/** Piles need ground that gives their stiffness, and end in its layers or in a half-space below them. */
function pileFits(support: Table, data: Table): boolean {
  if (support.kind !== "pile") return true;
  const ground = tableAt(data, ["ground"]);
  if (!isEndless(ground)) return false;
  if (ground.kind === "continuum" && "half_space" in ground) return true;
  const depths = listAt(ground, ["layers"]).map((layer) => (isTable(layer) ? parseLength(layer.thickness) : null));
  const length = parseLength(support.length);
  if (length === null || depths.includes(null)) return true; // an issue of its own
  return length < depths.reduce<number>((sum, depth) => sum + (depth ?? 0), 0);
}

/** Loads beside the slab need ground that carries shear, settlements the support that they move. */
function loadFits(load: Table, data: Table, memory: Memory): boolean {
  if (load.on === "ground") return carriesShear(data);
  if (load.kind !== "settlement") return true;
  const isCalled = (support: Json) => isTable(support) && support.name === load.support;
  const isAway = ((memory.get("supports")?.items ?? []) as Kept[]).some(({ item }) => isCalled(item));
  return !isAway || listAt(data, ["supports"]).some(isCalled);
}

/** A plate glued to ground that carries shear settles alike on both sides of an elastic joint. */
function jointFits(joint: Table, data: Table): boolean {
  return joint.kind !== "elastic" || tableAt(data, ["contact"]).tensionless !== false || !carriesShear(data);
}

/** Whether the ground carries shear anywhere. */
function carriesShear(data: Table): boolean {
  const zones = listAt(data, ["soil_zones"]).map((zone) => tableAt(zone, ["ground"]));
  return [tableAt(data, ["ground"]), ...zones].some((ground) => {
    if (ground.kind === "winkler") return false;
    if (ground.kind === "pasternak") return !isZero(ground.k1);
    const layers = listAt(ground, ["layers"]);
    return layers.length === 0 || layers.some((layer) => !isInterfaceLayer(layer) || !isZero((layer as Table).k1));
  });
}

function isZero(value: Json | undefined): boolean {
  return Number.parseFloat(String(value)) === 0;
}

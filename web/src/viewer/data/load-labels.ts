// Labels of loads on a plan: what acts at each place in the combination that is shown.
import { say, together, verbatim } from "../shared/language";
import { formatShort } from "./numbers";
import type { Load } from "./scene";

/** What the symbol of a value at the end of a line ends with. */
const END = "_end";
const round = (value: number) => formatShort(value, 5);

/** A load that is drawn, and its label; empty where the label of another load at the same place includes it. */
export interface LabeledLoad {
  load: Load;
  text: string;
}

/**
 * Return the loads that take part, with labels.
 *
 * With the factors of a combination by load case a label is the sum of all that acts at a place, factors included.
 * Without them (envelopes) each load's label names its case and the factor 1, unless there are no cases.
 */
export function labelLoads(loads: readonly Load[], factors: ReadonlyMap<string, number> | null): LabeledLoad[] {
  const factorOf = (load: Load) => (factors && load.case ? (factors.get(load.case) ?? 0) : 1);
  const acting = loads.filter((load) => factorOf(load) !== 0);
  const groups = new Map<string, Load[]>();
  for (const load of acting) groups.set(placeKey(load), [...(groups.get(placeKey(load)) ?? []), load]);
  return acting.map((load) => {
    if (!factors && load.case)
      return { load, text: say("{load} (1.0 {name})", { load: labelOf([load], () => 1), name: verbatim(load.case) }) };
    const group = groups.get(placeKey(load))!;
    return { load, text: group[0] === load ? labelOf(group, factorOf) : "" };
  });
}

/** Return what acts on the entire slab under the factors of a combination, empty if nothing does. */
export function labelEverywhere(loads: readonly Load[], factors: ReadonlyMap<string, number>): string {
  const everywhere = loads.filter((load) => load.everywhere);
  return together(
    labelLoads(everywhere, factors).map(({ text }) => text),
    ", ",
  );
}

/** Return a key that loads of one kind at one place share. */
function placeKey({ kind, points, ring }: Load): string {
  return JSON.stringify([kind, points ?? ring ?? null]);
}

/** Return the sum of loads at one place. */
function labelOf(loads: readonly Load[], factorOf: (load: Load) => number): string {
  const sums = new Map<string, { value: number; unit: string }>();
  for (const load of loads) {
    for (const [symbol, value, unit] of load.parts) {
      sums.set(symbol, { value: (sums.get(symbol)?.value ?? 0) + factorOf(load) * value, unit });
    }
  }
  const all = [...sums].filter(([symbol]) => !symbol.endsWith(END));
  const some = all.filter(([, { value }]) => round(value) !== "0");
  const words = (some.length > 0 ? some : all.slice(0, 1)).map(([symbol, { value, unit }]) => {
    const end = sums.get(symbol + END);
    const from = round(value);
    const values = end && round(end.value) !== from ? say("{from} to {to}", { from, to: round(end.value) }) : from;
    return say("{symbol} = {values} {unit}", { symbol: verbatim(symbol), values, unit });
  });
  const load = together(words, ", ");
  return loads.some(({ varies }) => varies) ? say("{load} and varying", { load }) : load;
}

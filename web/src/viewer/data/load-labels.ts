// What loads are called on a plan: what acts at each place in the combination that is shown.
import { neat as rounded } from "./color-scale";
import type { Load } from "./scene";

const neat = (value: number) => rounded(value, 5);

/** A load that is drawn, and its words; empty where another load at the same place speaks for it. */
export interface ShownLoad {
  load: Load;
  words: string;
}

/**
 * Return the loads that take part, with words.
 *
 * With the factors of a combination by load case the words are the sum of all that acts at a place, factors included.
 * Without them (envelopes) each load says its case and that its factor is 1, unless there are no cases.
 */
export function shownLoads(loads: readonly Load[], factors: ReadonlyMap<string, number> | null): ShownLoad[] {
  const factorOf = (load: Load) => (factors && load.case ? (factors.get(load.case) ?? 0) : 1);
  const acting = loads.filter((load) => factorOf(load) !== 0);
  const groups = new Map<string, Load[]>();
  for (const load of acting) groups.set(placeKey(load), [...(groups.get(placeKey(load)) ?? []), load]);
  return acting.map((load) => {
    if (!factors && load.case) return { load, words: `${wordsOf([load], () => 1)} (1.0 ${load.case})` };
    const group = groups.get(placeKey(load))!;
    return { load, words: group[0] === load ? wordsOf(group, factorOf) : "" };
  });
}

/** The same for loads of one kind at one place. */
function placeKey({ kind, points, ring }: Load): string {
  return JSON.stringify([kind, points ?? ring ?? null]);
}

/** How large loads at one place are together. */
function wordsOf(loads: readonly Load[], factorOf: (load: Load) => number): string {
  const sums = new Map<string, { value: number; unit: string }>();
  for (const load of loads) {
    for (const [symbol, value, unit] of load.parts) {
      sums.set(symbol, { value: (sums.get(symbol)?.value ?? 0) + factorOf(load) * value, unit });
    }
  }
  const end = sums.get("q_end");
  sums.delete("q_end");
  const all = [...sums];
  const some = all.filter(([, { value }]) => neat(value) !== "0");
  const words = (some.length > 0 ? some : all.slice(0, 1)).map(([symbol, { value, unit }]) => {
    const to = end && neat(end.value) !== neat(value) ? ` to ${neat(end.value)}` : "";
    return `${symbol} = ${neat(value)}${to} ${unit}`;
  });
  return words.join(", ") + (loads.some((load) => load.varies) ? " and varying" : "");
}

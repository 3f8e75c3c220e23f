// What a result writes on its plan: what supports and walls do to the plate, and the bars that are laid.
import type { BarSet, Head, Reaction, Ring } from "../data/scene";
import { plainSymbols } from "../shared/symbols";
import type { Layers } from "./plan-symbols";
import type { PlanSymbol } from "./symbols";

/** What is written of a result besides its field. */
export interface Annotations {
  reactions: readonly Reaction[];
  bars: readonly BarSet[];
}

/** Return the layer of bars that a field is of, such as bottom_x; "" of others. */
export function layerOf(field: string): string {
  return /(?:^|_)((?:bottom|top)_[xy])$/.exec(field)?.[1] ?? "";
}

/** Return what is written with a field of a combination; null: of no single one, which has no reactions. */
export function annotationsOf(head: Head, combination: number | null, field: string): Annotations {
  const reactions = combination === null ? [] : (head.combinations[combination]?.reactions ?? []);
  const layer = layerOf(field);
  return { reactions, bars: (head.bars ?? []).filter((set) => set.layer === layer) };
}

/** Return the symbols of what is written: borders of zones of bars, and words. */
export function annotationSymbols({ reactions, bars }: Annotations, layers: Layers): PlanSymbol[] {
  return [...(layers.bars ? bars.flatMap(barSymbols) : []), ...(layers.reactions ? reactions.map(reactionSymbol) : [])];
}

function barSymbols({ rings, at, text }: BarSet): PlanSymbol[] {
  const zone = (points: Ring, n: number): PlanSymbol => {
    return { kind: "bars", shape: "area", points, texts: n ? [] : [text] };
  };
  return rings.length ? rings.map(zone) : [{ kind: "bars", shape: "point", points: [at], texts: [text] }];
}

function reactionSymbol({ at, text }: Reaction): PlanSymbol {
  return { kind: "reaction", shape: "point", points: [at], texts: [plainSymbols(text)] };
}

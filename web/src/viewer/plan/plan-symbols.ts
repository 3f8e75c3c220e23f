// The symbols of a solved plan.
import { labelLoads } from "../data/load-labels";
import type { Load, Plan, Ring } from "../data/scene";
import { plainSymbols } from "../shared/symbols";
import { type PlanSymbol, thicknessText } from "./symbols";

/** What of the plan is drawn. */
export interface Layers {
  loads: boolean;
  columns: boolean;
  supports: boolean;
  zones: boolean;
  ground: boolean; // boreholes, soil zones, voids
  output: boolean; // section lines, strips, points
  labels: boolean;
  extremes: boolean; // where the shown field has its minimum and maximum
  axes: boolean;
}

export const ALL_LAYERS: Layers = {
  loads: true,
  columns: true,
  supports: true,
  zones: true,
  ground: true,
  output: true,
  labels: true,
  extremes: true,
  axes: true,
};

/** Return the symbols from below upwards; `factors` of the load cases, null where no one combination is shown. */
export function symbolsOf(plan: Plan, layers: Layers, factors: ReadonlyMap<string, number> | null): PlanSymbol[] {
  const area = (kind: PlanSymbol["kind"], ring: Ring, text = ""): PlanSymbol => ({
    kind,
    shape: "area",
    points: ring,
    texts: [text],
  });
  const point = (kind: PlanSymbol["kind"], { x, y, name }: { x: number; y: number; name: string }): PlanSymbol => ({
    kind,
    shape: "point",
    points: [[x, y]],
    texts: [name],
  });
  const ground = [
    ...plan.soil_zones.map(({ ring }) => area("soil zone", ring)),
    ...plan.voids.map(({ ring }) => area("void", ring)),
    ...plan.boreholes.map((each) => point("borehole", each)),
  ];
  const output = [
    ...plan.strips.map(
      ({ start, end, name, width }): PlanSymbol => ({
        kind: "strip",
        shape: "line",
        points: [start, end],
        texts: [name],
        width,
      }),
    ),
    ...plan.lines.map(
      ({ start, end, name }): PlanSymbol => ({
        kind: "section line",
        shape: "line",
        points: [start, end],
        texts: [name],
      }),
    ),
    ...plan.points.map((each) => point("output point", each)),
  ];
  const supports = plan.supports.map(
    ({ kind, points, name, elastic }): PlanSymbol => ({ kind: "support", shape: kind, points, texts: [name], elastic }),
  );
  const symbols = [
    ...(layers.ground ? ground : []),
    ...(layers.zones ? plan.zones.map(({ ring, thickness }) => area("zone", ring, thicknessText(thickness))) : []),
    area("slab", plan.outline),
    ...plan.openings.map(({ ring }) => area("opening", ring)),
    ...(layers.output ? output : []),
    ...(layers.loads ? labelLoads(plan.loads, factors).flatMap(({ load, text }) => loadSymbol(load, text)) : []),
    ...(layers.supports ? supports : []),
    ...(layers.columns ? plan.columns.map((each) => ({ ...point("column", each), foot: each.ring })) : []),
  ];
  return layers.labels ? symbols : symbols.map((symbol) => ({ ...symbol, texts: [] }));
}

/** Return the symbol of a load, none if it acts on the entire slab. */
function loadSymbol({ kind, points, ring, holes, footprint }: Load, text: string): PlanSymbol[] {
  const texts = text ? [plainSymbols(text)] : [];
  const load = { kind: "load", texts } as const;
  if (kind === "uniform") return [];
  if (ring) return [{ ...load, shape: "area", points: ring, holes: holes ?? [] }];
  if (!points?.length) return [];
  if (points.length > 1) return [{ ...load, shape: "line", points }];
  return [{ ...load, shape: "point", points, foot: footprint, hidden: !text, upward: /= \u2212/.test(text) }];
}

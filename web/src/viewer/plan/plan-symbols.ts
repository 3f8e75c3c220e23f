// The symbols of a solved plan.
import { lengthsOf } from "../data/lengths";
import { labelLoads } from "../data/load-labels";
import type { Area, Beam, BuildingAxis, FrameLine, Line, Load, Place, Plan, Wall } from "../data/scene";
import { plainSymbols } from "../shared/symbols";
import { type PlanSymbol, zoneText } from "./symbols";

/** What of the plan is drawn. */
export const ALL_LAYERS = {
  loads: true,
  columns: true,
  supports: true,
  zones: true,
  ground: true, // boreholes, soil zones, voids
  output: true, // section lines, strips, points
  labels: true,
  numbers: true, // on contours and on a raster
  reactions: true, // of supports and walls
  bars: true, // that are laid, over fields of their layer
  extremes: true, // where the shown field has its minimum and maximum
  axes: true, // of the building
  rulers: true, // along the edges of the picture, and the scale bar
};
export type Layers = typeof ALL_LAYERS;

/** Return the symbols from below upwards; `factors` of the load cases, null where no one combination is shown. */
export function symbolsOf(plan: Plan, layers: Layers, factors: ReadonlyMap<string, number> | null): PlanSymbol[] {
  type Kind = PlanSymbol["kind"];
  const area = (kind: Kind, { ring }: Pick<Area, "ring">, text = "") =>
    ({ kind, shape: "area", points: ring, texts: [text] }) as const;
  const line = (kind: Kind, { start, end, name }: Line) =>
    ({ kind, shape: "line", points: [start, end], texts: [name] }) as const;
  const point = (kind: Kind, { x, y, name }: Place): PlanSymbol => ({
    kind,
    shape: "point",
    points: [[x, y]],
    texts: [name],
  });
  const ground = [
    ...plan.soil_zones.map((each) => area("soil zone", each)),
    ...plan.voids.map((each) => area("void", each)),
    ...plan.boreholes.map((each) => point("borehole", each)),
  ];
  const output = [
    ...plan.strips.map((each) => ({ ...line("strip", each), width: each.width })),
    ...plan.lines.map((each) => line("section line", each)),
    ...plan.points.map((each) => point("output point", each)),
  ];
  const supports = plan.supports.map(
    ({ kind, points, name, elastic }): PlanSymbol => ({ kind: "support", shape: kind, points, texts: [name], elastic }),
  );
  const further = plan.plates ?? [];
  const zones = [...plan.zones, ...further.flatMap((each) => each.zones)];
  const openings = [...plan.openings, ...further.flatMap((each) => each.openings)];
  const symbols = [
    ...(layers.ground ? ground : []),
    ...(layers.zones ? zones.map((each) => area("zone", each, zoneText(each, lengthsOf(plan)))) : []),
    area("slab", { ring: plan.outline }),
    ...further.map(({ ring }) => area("slab", { ring })),
    ...openings.map((each) => area("opening", each)),
    ...(layers.axes ? (plan.axes ?? []).map(axisSymbol) : []),
    ...(layers.output ? output : []),
    ...(layers.loads ? labelLoads(plan.loads, factors).flatMap(({ load, text }) => loadSymbol(load, text)) : []),
    ...(layers.supports ? supports : []),
    ...(layers.columns ? (plan.building ?? []).map(frameSymbol) : []),
    ...(layers.columns ? (plan.beams ?? []).map(beamSymbol) : []),
    ...(layers.columns ? (plan.walls ?? []).map(wallSymbol) : []),
    ...(layers.columns ? plan.columns.map((each) => ({ ...point("column", each), foot: each.ring })) : []),
  ];
  return layers.labels ? symbols : symbols.map((symbol) => ({ ...symbol, texts: [] }));
}

function wallSymbol({ name, points, pieces, thickness }: Wall): PlanSymbol {
  return { kind: "wall", shape: "line", points, pieces, texts: [name], width: thickness };
}

/** Return the symbol of an axis, its name at the last of its points. */
function axisSymbol({ name, points, bubble }: BuildingAxis): PlanSymbol {
  return { kind: "axis", shape: "line", points: [...points, bubble], texts: [name] };
}

function beamSymbol({ name, points, width }: Beam): PlanSymbol {
  return { kind: "beam", shape: "line", points, texts: [name], width };
}

function frameSymbol({ points }: FrameLine): PlanSymbol {
  return { kind: "beam of the building", shape: "line", points, texts: [] };
}

/** Return the symbol of a load, none if it acts on the entire slab. */
function loadSymbol({ everywhere, points, pieces, ring, holes, footprint }: Load, text: string): PlanSymbol[] {
  const texts = text ? [plainSymbols(text)] : [];
  const load = { kind: "load", texts } as const;
  if (everywhere) return [];
  if (ring) return [{ ...load, shape: "area", points: ring, holes: holes ?? [] }];
  if (!points?.length) return [];
  if (points.length > 1) return [{ ...load, shape: "line", points, pieces }];
  return [{ ...load, shape: "point", points, foot: footprint, hidden: !text, upward: /^(P|w_s) = \u2212/.test(text) }];
}

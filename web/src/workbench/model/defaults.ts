// Values of new items, so that they can be solved at once and changed later.

import { namesIn } from "./names";
import { isTable, listAt, type Table, valueAt } from "./paths";
import { formatLength, parseLength } from "./quantities";

const LAYER: Table = { E: "20 MPa", nu: 0.3, thickness: "4 m" };

const DEFAULTS: Record<string, Table> = {
  Plate: { length_x: "6 m", length_y: "4 m", thickness: "300 mm", E: "30 GPa", nu: 0.2 },
  Winkler: { kind: "winkler", k: "20 MPa/m" },
  Pasternak: { kind: "pasternak", k0: "20 MPa/m", k1: "10 MN/m" },
  Vlasov: { kind: "vlasov", layers: [LAYER] },
  Layered: { kind: "layered", coupling: "consistent", layers: [LAYER] },
  Continuum: { kind: "continuum", layers: [LAYER], half_space: { E: "60 MPa", nu: 0.3 } },
  ConstrainedModulus: { kind: "constrained modulus", layers: [LAYER] },
  HalfSpace: { E: "60 MPa", nu: 0.3 },
  Selvadurai: { E: "20 MPa", depth: "5 m" },
  SoilLayer: LAYER,
  InterfaceLayer: { k0: "20 MPa/m", k1: "10 MN/m" },
  StraightAxes: { kind: "straight", first: "A", distances: "3 x 6 m" },
  RayAxes: { kind: "ray", first: "1", angles: [0, 45, 90, 135, 180, 225, 270, 315] },
  RingAxes: { kind: "ring", first: "A", distances: "2 x 4 m" },
  UniformLoad: { kind: "uniform", q: "5 kPa" },
  PatchLoad: { kind: "patch", q: "20 kPa" },
  AreaLoad: { kind: "area", q: "20 kPa" },
  LineLoad: { kind: "line", q: "20 kN/m" },
  LineMoment: { kind: "line moment", m: "20 kNm/m" },
  PointLoad: { kind: "point", P: "100 kN" },
  CoreLoad: { kind: "core", P: "1 MN" },
  SelfWeight: { kind: "self weight", unit_weight: "25 kN/m^3" },
  TemperatureLoad: { kind: "temperature", difference: "10 K" },
  ShrinkageLoad: { kind: "shrinkage", top: 0.0003 },
  SettlementLoad: { kind: "settlement", w: "5 mm" },
  PointSupport: { kind: "point" },
  LineSupport: { kind: "line" },
  LoadCase: { action: "permanent" },
  Combination: { limit_state: "ultimate" },
  Combine: { sets: ["ultimate", "characteristic"] },
  BarZone: { layers: ["bottom_x", "bottom_y"], diameter: "12 mm", spacing: "150 mm" },
  Reinforcement: { concrete: "C30/37", steel: "B500B", bottom: ["40 mm", "50 mm"], top: ["40 mm", "50 mm"] },
  Vehicle: { kind: "vehicle", wheels: [{ P: "45 kN", width_x: "200 mm", width_y: "200 mm" }] },
  Wheel: { P: "45 kN", width_x: "200 mm", width_y: "200 mm" },
  Rack: { kind: "rack", P: "60 kN", rows: ["0 m", "1.1 m"], width_x: "150 mm", width_y: "150 mm" },
  TR34Floor: { kind: "TR34", concrete: "C30/37" },
  ACI360Floor: { kind: "ACI 360", f_r: "4 MPa" },
  Void: { depth: "10 mm" },
  Building: { storeys: ["4 m", "3 m"] },
};

const FRAME_BEAM: Table = { kind: "rectangle", width: "300 mm", height: "600 mm" };

/** Whether a new part of a definition starts with usual values. */
export const hasDefaults = (definition: string) => definition in DEFAULTS;

/** What a new part of a definition starts with; an empty table where nothing can be guessed. */
export function defaultsFor(definition: string, data: Table): Table {
  if (definition === "Zone") return { thickness: thickenedPlate(data) };
  if (definition === "Building") {
    const E = valueAt(data, ["plate", "E"]) ?? "30 GPa";
    return { ...structuredClone(DEFAULTS.Building), E, beams: [defaultsFor("BuildingBeams", data)] };
  }
  if (definition === "BuildingBeams") return { through: columnsOf(data), section: { ...FRAME_BEAM } };
  if (definition === "BuildingColumns") return { names: columnsOf(data).slice(0, 1), section: { ...FRAME_BEAM } };
  if (definition === "Core") return { walls: namesIn(listAt(data, ["walls"])) };
  if (definition === "Borehole") return { layers: layersOf(data) };
  return structuredClone(DEFAULTS[definition] ?? {});
}

/** The names of all columns. */
function columnsOf(data: Table): string[] {
  return namesIn(listAt(data, ["columns"]));
}

/** A thickness half as much again as the plate's, in round figures. */
function thickenedPlate(data: Table): string {
  const own = parseLength(valueAt(data, ["plate", "thickness"]));
  return own === null ? "600 mm" : formatLength(Math.round(own * 1.5 * 20) / 20, "mm");
}

function layersOf(data: Table): Table[] {
  const layers = listAt(data, ["ground", "layers"]).filter(isTable);
  return structuredClone(layers.length > 0 ? layers : [LAYER]);
}

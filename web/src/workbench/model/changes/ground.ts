// Switching the kind of the ground: what depends on it follows, and comes back with a kind that can have it.

import { keep, say, together, translate } from "../../../viewer/shared/language";
import { defaultsFor } from "../defaults";
import type { Edit } from "../edits";
import { isTable, type Json, listAt, type Path, pathKey, sameValue, type Table, tableAt } from "../paths";
import type { Part } from "../schema";
import { applyOptimistic } from "./optimistic-edits";
import { changeKept, forgetWhatFits, isEndless, isInterfaceLayer, type Mended, mendLists } from "./put-away";
import { convertTable, type Memory, replaceTable } from "./variants";

/** The edits of a switch, and the line that says what was put away or brought back; empty if nothing was. */
export interface GroundSwitch {
  edits: Edit[];
  notice: string;
}

/** Make the ground another kind, its zones too; what the new kind cannot have is put away. */
export function switchGround(data: Table, from: Part | null, to: Part, memory: Memory): GroundSwitch {
  forgetWhatFits(data, memory);
  const ground = replaceTable(
    data,
    ["ground"],
    convertGround(data, tableAt(data, ["ground"]), ["ground"], from, to, memory),
  );
  const edits = [...ground, ...switchZones(data, from, to, memory)];
  const after = edits.reduce(applyOptimistic, data);
  edits.push(...divideBoreholes(after), ...mendBeyond(after, memory));
  const mended = mendLists(data, edits.reduce(applyOptimistic, data), memory);
  return { edits: [...edits, ...mended.edits], notice: noticeOf(mended) };
}

/** Return what a switch put away and brought back, in a line. */
function noticeOf({ away, back }: Mended): string {
  const list = (counts: Map<string, number>) =>
    together(
      [...counts].map(([name, number]) => keep(`${number} ${translate(name)}`)),
      ", ",
    );
  return together([
    away.size > 0
      ? say("Set aside: {items}; restored when the ground supports them again.", { items: list(away) })
      : "",
    back.size > 0 ? say("Restored: {items}.", { items: list(back) }) : "",
  ]);
}

/** The edits that make the zones of the new kind, also those put away; without an end sideways there are none. */
function switchZones(data: Table, from: Part | null, to: Part, memory: Memory): Edit[] {
  const zones = listAt(data, ["soil_zones"]).filter(isTable);
  if (isEndless({ kind: to.kind })) {
    for (const zone of zones) if (from) memory.set(pathKey([...placeOf(zone), from.name]), tableAt(zone, ["ground"]));
    return [];
  }
  changeKept("soil_zones", memory, (zone) => {
    const ground = tableAt(zone, ["ground"]);
    if (ground.kind === to.kind) return zone;
    return { ...zone, ground: convertGround(data, ground, ["soil_zones"], null, to, memory, placeOf(zone)) };
  });
  return zones.flatMap((zone, index) => {
    const path: Path = ["soil_zones", index, "ground"];
    const ground = convertGround(data, tableAt(data, path), path, from, to, memory, placeOf(zone));
    return replaceTable(data, path, ground);
  });
}

/** Return what the memory calls a zone by, whatever its position. */
function placeOf(zone: Table): Path {
  return ["soil_zones", JSON.stringify(tableAt(zone, ["shape"]))];
}

/** Return a ground of its new kind. */
function convertGround(
  data: Table,
  own: Table,
  path: Path,
  from: Part | null,
  to: Part,
  memory: Memory,
  place = path,
): Table {
  const filledKey = pathKey([...place, "filled"]);
  const carried = carriedOver(own, memory.get(filledKey) ?? {}, to);
  const before = memory.get(pathKey([...place, to.name]));
  const found = convertTable(data, path, carried, from, to, memory, place);
  if (from) memory.set(pathKey([...place, from.name]), own);
  // layers of the user on a rigid base stay on it
  if (to.kind === "continuum" && "layers" in carried && !before) delete found.half_space;
  const wanted = mendGround(found, data, before ?? {});
  memory.set(filledKey, Object.fromEntries(Object.entries(wanted).filter(([key]) => !(key in carried))));
  return wanted;
}

/** Return what of a ground another kind takes over: not what the last switch filled in, nor layers given by k0, k1. */
function carriedOver(own: Table, filled: Table, to: Part): Table {
  const isOwn = ([key, value]: [string, Json]) => !(key in filled) || !sameValue(value, filled[key]);
  const carried = Object.fromEntries(Object.entries(own).filter(isOwn));
  if (to.kind !== "layered" && listAt(own, ["layers"]).some(isInterfaceLayer)) delete carried.layers;
  return carried;
}

/** Return a ground without keys that its kind, its layers, or other parts of the file refuse. */
function mendGround(found: Table, data: Table, before: Table): Table {
  const ground = divideLayers(found, before);
  const layers = listAt(ground, ["layers"]);
  const consistent = ground.coupling === "consistent";
  const hasModes = !consistent && !layers.some(isInterfaceLayer);
  if (!hasModes) delete ground.gamma;
  const several = ground.kind === "vlasov" && (layers.length > 1 || listAt(data, ["boreholes"]).length > 0);
  if (!hasModes || several) delete ground.formulas;
  if (layers.length > 1 && ground.mode === "sinh") delete ground.mode;
  if ("selvadurai" in ground && listAt(data, ["plates"]).length > 0) {
    delete ground.selvadurai;
    ground.k = defaultsFor("Winkler", data).k ?? null;
  }
  return ground;
}

/** Return a ground whose layers have sublayers where they may, those of before if they have none. */
function divideLayers(ground: Table, before: Table): Table {
  const old = listAt(before, ["layers"]);
  const divides = ground.coupling === "consistent";
  if (!("layers" in ground)) return ground;
  const layers = listAt(ground, ["layers"]).map((layer, n): Json => {
    if (!isTable(layer)) return layer;
    if (!divides) return withoutSublayers(layer);
    const { sublayers } = tableAt(old, [n]);
    return sublayers === undefined || "sublayers" in layer || old.length !== listAt(ground, ["layers"]).length
      ? layer
      : { ...layer, sublayers };
  });
  return { ...ground, layers };
}

function withoutSublayers({ sublayers: _, ...layer }: Table): Table {
  return layer;
}

/** The edits that take the sublayers of boreholes away where the ground has none: those of the ground count. */
function divideBoreholes(data: Table): Edit[] {
  if (tableAt(data, ["ground"]).coupling === "consistent") return [];
  return listAt(data, ["boreholes"]).flatMap((hole, index) =>
    listAt(hole, ["layers"]).flatMap((layer, n): Edit[] =>
      isTable(layer) && "sublayers" in layer
        ? [{ op: "remove", path: ["boreholes", index, "layers", n, "sublayers"] }]
        : [],
    ),
  );
}

/** Ground without an end goes on at all sides: what says where a margin ends is put away, and comes back. */
function mendBeyond(data: Table, memory: Memory): Edit[] {
  const beyond = tableAt(data, ["beyond"]);
  const ends = ["edge", "sides"].filter((key) => key in beyond);
  if (isEndless(tableAt(data, ["ground"]))) {
    if (ends.length > 0) memory.set("beyond", Object.fromEntries(ends.map((key) => [key, beyond[key] ?? null])));
    return ends.map((key): Edit => ({ op: "remove", path: ["beyond", key] }));
  }
  const kept = Object.entries(memory.get("beyond") ?? {});
  if (beyond.kind !== "margin" || ends.length > 0) return [];
  return kept.map(([key, value]): Edit => ({ op: "set", path: ["beyond", key], value }));
}

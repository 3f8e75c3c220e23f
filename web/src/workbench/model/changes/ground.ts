// Switching the kind of the ground: what depends on it follows, and comes back with a kind that can have it.

import { isTable, type Json, listAt, type Table, tableAt } from "../paths";
import type { Part } from "../schema";
import type { Edit } from "./edits";
import { type Memory, switchKind } from "./variants";

/** Kinds of ground without an end sideways, and those whose layers boreholes describe. */
const CONTINUOUS = ["Continuum", "ConstrainedModulus"];
const WITH_BOREHOLES = ["Vlasov", "Layered", "ConstrainedModulus"];

/** The edits that make the ground another kind, its zones too; what the new kind cannot have is put away. */
export function switchGround(data: Table, from: Part | null, to: Part, memory: Memory): Edit[] {
  const zones = listAt(data, ["soil_zones"]);
  const endless = CONTINUOUS.includes(to.name);
  const followed = endless
    ? []
    : zones.flatMap((_, index) => switchKind(data, ["soil_zones", index, "ground"], from, to, memory));
  return [
    ...switchKind(data, ["ground"], from, to, memory),
    ...followed,
    ...removeSublayers(data, to),
    ...keepOrPutAway(data, "soil_zones", !endless, memory, (zone) => tableAt(zone, ["ground"]).kind === to.kind),
    ...keepOrPutAway(data, "boreholes", WITH_BOREHOLES.includes(to.name), memory),
    ...(endless ? openEdges(data) : []),
  ];
}

/** Sublayers belong to stacks of layers. */
function removeSublayers(data: Table, to: Part): Edit[] {
  if (to.name === "Layered") return [];
  return listAt(data, ["ground", "layers"]).flatMap((layer, index): Edit[] =>
    isTable(layer) && "sublayers" in layer ? [{ op: "remove", path: ["ground", "layers", index, "sublayers"] }] : [],
  );
}

/** Put a list away that the ground cannot have, or bring it back where all of it fits. */
function keepOrPutAway(
  data: Table,
  key: string,
  allowed: boolean,
  memory: Memory,
  fits: (item: Table) => boolean = () => true,
): Edit[] {
  const list = data[key];
  if (!allowed) {
    if (list === undefined) return [];
    memory.set(key, { list });
    return [{ op: "remove", path: [key] }];
  }
  const known: Json | undefined = memory.get(key)?.list;
  if (list !== undefined || !Array.isArray(known) || !known.filter(isTable).every(fits)) return [];
  memory.delete(key);
  return [{ op: "set", path: [key], value: known }];
}

/** A continuum goes on at all sides: what says where a margin ends is taken away. */
function openEdges(data: Table): Edit[] {
  const beyond = tableAt(data, ["beyond"]);
  return ["edge", "sides"].filter((key) => key in beyond).map((key) => ({ op: "remove", path: ["beyond", key] }));
}

// The items of the case that a result's picture shows: by their list and name, and by a place.
import type { Plan, Point, Ring } from "../../viewer/data/scene";
import { isInside } from "../model/geometry";

/** An item with its path, and where it is: a point, a line or an area. */
export interface PlanItem {
  path: string;
  name: string;
  shape: "point" | "line" | "area";
  points: Ring;
}

type Source = {
  path: string;
  name?: string;
  x?: number;
  y?: number;
  start?: Point;
  end?: Point;
  points?: Point[];
  ring?: Ring;
};

function describe({ path, name = "", x, y, start, end, points, ring }: Source): PlanItem[] {
  if (x !== undefined && y !== undefined) return [{ path, name, shape: "point", points: [[x, y]] }];
  if (start && end) return [{ path, name, shape: "line", points: [start, end] }];
  if (ring) return [{ path, name, shape: "area", points: ring }];
  if (points?.length) return [{ path, name, shape: points.length > 1 ? "line" : "point", points }];
  return [];
}

/** Return the items of a list of the case, such as `columns` or `output.strips`. */
export function itemsIn(plan: Plan, list: string): PlanItem[] {
  const lists: Record<string, readonly Source[]> = {
    columns: plan.columns,
    walls: plan.walls ?? [],
    beams: plan.beams ?? [],
    "building.beams": plan.building ?? [],
    supports: plan.supports,
    loads: plan.loads.filter((load) => !load.everywhere),
    boreholes: plan.boreholes,
    "output.points": plan.points,
    "output.lines": plan.lines,
    "output.strips": plan.strips,
    "plate.openings": plan.openings,
    "contact.voids": plan.voids,
    "plate.zones": plan.zones,
    soil_zones: plan.soil_zones,
  };
  return (lists[list] ?? []).flatMap(describe);
}

/** Lists whose items are picked, those before others where several are at one place. */
const PICKED = [
  "columns",
  "walls",
  "beams",
  "building.beams",
  "supports",
  "loads",
  "boreholes",
  "output.points",
  "output.lines",
  "output.strips",
  "contact.voids",
  "plate.zones",
  "soil_zones",
];

/** Return the item at a place: the first point or line within a distance [m], else the first area around it. */
export function itemAt(plan: Plan, at: Point, reach: number): PlanItem | null {
  const all = PICKED.flatMap((list) => itemsIn(plan, list));
  const near = all.find(({ shape, points }) => shape !== "area" && distanceTo(points, at) <= reach);
  return near ?? all.find(({ shape, points }) => shape === "area" && isInside(points, at)) ?? null;
}

/** Return the item at a path as plans write it, null if it has no place. */
export function itemOf(plan: Plan, path: string): PlanItem | null {
  const list = path.replace(/\[\d+\](\.shape)?$/, "");
  return itemsIn(plan, list).find((item) => item.path === path.replace(/\.shape$/, "")) ?? null;
}

/** Return the least distance of a place from a point or a line. */
function distanceTo(points: Ring, [x, y]: Point): number {
  if (points.length === 1) return Math.hypot(points[0]![0] - x, points[0]![1] - y);
  return Math.min(
    ...points.slice(1).map(([bx, by], n) => {
      const [ax, ay] = points[n]!;
      const square = (bx - ax) ** 2 + (by - ay) ** 2;
      const along = square > 0 ? ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / square : 0;
      const share = Math.min(Math.max(along, 0), 1);
      return Math.hypot(ax + share * (bx - ax) - x, ay + share * (by - ay) - y);
    }),
  );
}

/** Return the middle of an item. */
export function middleOf({ points }: PlanItem): Point {
  const sum = points.reduce<Point>(([x, y], [u, v]) => [x + u, y + v], [0, 0]);
  return [sum[0] / points.length, sum[1] / points.length];
}

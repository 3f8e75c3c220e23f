// A small picture of a case: its slabs, openings and columns in plan.
import { svg } from "../../viewer/shared/dom";
import { boundsOf, type Geometry, readGeometry, readSides, ringOf } from "../model/geometry";
import { listAt, type Table } from "../model/paths";

const [WIDTH, HEIGHT, EDGE] = [104, 66, 5];

/** The picture of a case in plan, empty if its lengths cannot be read. */
export function thumbnail(data: Table): SVGElement {
  const shapes = shapesOf(data);
  const bounds = boundsOf(shapes.flatMap(({ geometry }) => [...ringOf(geometry)]));
  const element = svg("svg", { class: "thumbnail", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, "aria-hidden": "true" });
  if (!bounds) return element;
  const [x0, y0, x1, y1] = bounds;
  const scale = Math.min((WIDTH - 2 * EDGE) / (x1 - x0 || 1), (HEIGHT - 2 * EDGE) / (y1 - y0 || 1));
  const toScreen = ([x, y]: readonly [number, number]) => [
    WIDTH / 2 + scale * (x - (x0 + x1) / 2),
    HEIGHT / 2 - scale * (y - (y0 + y1) / 2),
  ];
  for (const { geometry, kind } of shapes) {
    const points = ringOf(geometry).map(toScreen);
    if (geometry.type === "point") {
      const [cx = 0, cy = 0] = points[0] ?? [];
      element.append(svg("rect", { class: kind, x: cx - 1.6, y: cy - 1.6, width: 3.2, height: 3.2 }));
    } else element.append(svg("polygon", { class: kind, points: points.map((each) => each.join(" ")).join(" ") }));
  }
  return element;
}

/** Return what is drawn, from the bottom up. */
function shapesOf(data: Table): { geometry: Geometry; kind: string }[] {
  const below = (key: string) => listAt(data, [key]).map((_, n) => [key, n] as const);
  const slab = readSides(data) ?? readGeometry(data, ["plate", "outline"]);
  const others = below("plates").map((path) => readGeometry(data, [...path, "outline"]));
  const openings = listAt(data, ["plate", "openings"]).map((_, n) => readGeometry(data, ["plate", "openings", n]));
  const columns = below("columns").map((path) => readGeometry(data, path));
  const named = (list: readonly (Geometry | null)[], kind: string) =>
    list.flatMap((geometry) => (geometry ? [{ geometry, kind }] : []));
  return [...named([slab, ...others], "slab"), ...named(openings, "opening"), ...named(columns, "column")];
}

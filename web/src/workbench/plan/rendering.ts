// The drawing of the model: what each thing looks like in plan.

import { isClosed, nearest, type Point, type Ring, readGeometry, ringOf } from "../model/geometry";
import type { Item } from "../model/items";
import { listAt, type Path, pathKey, pathWords, type Table } from "../model/paths";
import { metres, plain } from "../model/quantities";
import { svg } from "../shell/elements";
import type { Camera } from "./camera";

const GLYPH = 26; // px: length of a load's arrow

/** What is drawn with which marks. */
export interface Look {
  selected: Path | null;
  /** The thing under the pointer. */
  hovered: Path | null;
  /** Paths that faults are about. */
  faulty: readonly Path[];
  /** The load case whose loads are drawn strongly; empty for all. */
  loadCase: string;
}

/** All things of a model, from below upwards. */
export function paintItems(camera: Camera, items: readonly Item[], look: Look): SVGElement[] {
  const loadsAt = new Map<string, Item[]>();
  for (const item of items.filter((each) => each.kind === "load")) {
    loadsAt.set(placeKey(item), [...(loadsAt.get(placeKey(item)) ?? []), item]);
  }
  return items.map((item) => {
    const group = svg("g", { class: classesOf(item, look), "data-path": pathKey(item.path), "data-kind": item.kind });
    group.append(...shapesOf(camera, item, loadsAt, look));
    return group;
  });
}

/** The same for loads that act at the same place. */
function placeKey({ geometry }: Item): string {
  return geometry.type === "point" ? `${geometry.x} ${geometry.y}` : JSON.stringify({ ...geometry, at: 0 });
}

function classesOf(item: Item, look: Look): string {
  const words = pathWords(item.path);
  const marks = [
    look.selected && pathWords(look.selected) === words ? "selected" : "",
    look.hovered && pathWords(look.hovered) === words ? "hovered" : "",
    look.faulty.some(
      (path) => pathWords(path).startsWith(words) && path.length >= item.path.length && item.kind !== "slab",
    )
      ? "faulty"
      : "",
    item.kind === "load" && look.loadCase && item.table.case !== look.loadCase ? "faint" : "",
  ];
  return ["thing", item.kind.replaceAll(" ", "-"), ...marks.filter(Boolean)].join(" ");
}

function shapesOf(camera: Camera, item: Item, loadsAt: ReadonlyMap<string, Item[]>, look: Look): SVGElement[] {
  const ring = ringOf(item.geometry).map((point) => camera.toPixel(point));
  switch (item.kind) {
    case "slab":
      return [area(ring)];
    case "opening":
      return [area(ring), ...cross(ring)];
    case "zone":
      return [
        area(ring),
        ...(item.table.thickness === undefined
          ? []
          : [label(topMiddle(ring), `t = ${String(item.table.thickness)}`, [0, 13], "label middle")]),
      ];
    case "soil zone":
    case "void":
      return [area(ring), label(leftTop(ring), item.title, [5, 13])];
    case "column":
      return column(camera, item, ring);
    case "support":
      return item.geometry.type === "point"
        ? pointSupport(ring[0] ?? [0, 0], item.table)
        : [path(ring, false), ...comb(ring), label(middle(ring), nameOf(item), [6, 14])];
    case "load":
      return load(camera, item, ring, loadsAt, look);
    case "borehole":
      return borehole(ring[0] ?? [0, 0], nameOf(item));
    case "strip":
      return strip(camera, item, ring);
    case "section line":
      return [path(ring, false), ...ends(ring), label(ring[0] ?? [0, 0], nameOf(item), [6, -6])];
    case "output point":
    case "gap":
      return [...plus(ring[0] ?? [0, 0]), label(ring[0] ?? [0, 0], nameOf(item) || item.title, [7, -5])];
  }
}

type Pixel = readonly [number, number];

function nameOf(item: Item): string {
  return typeof item.table.name === "string" ? item.table.name : "";
}

/** A surface; lines have no such class, as a closed one would be filled, too. */
function area(ring: readonly Pixel[]): SVGElement {
  return path(ring, true, "area");
}

/** A line through pixels. */
export function path(ring: readonly Pixel[], closed: boolean, className = ""): SVGElement {
  const words = ring.map(([x, y], n) => `${n === 0 ? "M" : "L"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");
  return svg("path", { d: words + (closed ? "Z" : ""), class: className || null });
}

/** A text with a halo, so that it can be read above lines. */
export function label([x, y]: Pixel, words: string, [dx, dy]: Pixel = [0, 0], className = "label"): SVGElement {
  return svg("text", { x: (x + dx).toFixed(1), y: (y + dy).toFixed(1), class: className }, words);
}

function leftTop(ring: readonly Pixel[]): Pixel {
  return [Math.min(...ring.map((each) => each[0])), Math.min(...ring.map((each) => each[1]))];
}

function topMiddle(ring: readonly Pixel[]): Pixel {
  const across = ring.map((each) => each[0]);
  return [(Math.min(...across) + Math.max(...across)) / 2, leftTop(ring)[1]];
}

function middle(ring: readonly Pixel[]): Pixel {
  const [a, b] = [ring[Math.floor((ring.length - 1) / 2)] ?? [0, 0], ring[Math.ceil((ring.length - 1) / 2)] ?? [0, 0]];
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}

/** The two diagonals that mark an opening, of the rectangle around it where it is no rectangle. */
function cross(ring: readonly Pixel[]): SVGElement[] {
  if (ring.length !== 4) return [];
  const [a, b, c, d] = ring as [Pixel, Pixel, Pixel, Pixel];
  return [path([a, c], false, "fine"), path([b, d], false, "fine")];
}

function column(camera: Camera, item: Item, ring: readonly Pixel[]): SVGElement[] {
  const at = ring[0] ?? [0, 0];
  const foot = item.foot?.map((point) => camera.toPixel(point)) ?? [];
  const size =
    foot.length > 0 ? Math.max(...foot.map(([x, y]) => Math.max(Math.abs(x - at[0]), Math.abs(y - at[1])))) : 0;
  const body = size < 3.5 ? svg("rect", { x: at[0] - 3.5, y: at[1] - 3.5, width: 7, height: 7 }) : area(foot);
  return [body, label(at, nameOf(item), [Math.max(size, 4) + 4, Math.max(size, 4) + 9])];
}

function pointSupport([x, y]: Pixel, table: Table): SVGElement[] {
  const triangle = area([
    [x, y],
    [x - 7, y + 12],
    [x + 7, y + 12],
  ]);
  const elastic = table.stiffness !== undefined;
  const ground = elastic
    ? path(
        [
          [x - 7, y + 15],
          [x - 3.5, y + 19],
          [x, y + 15],
          [x + 3.5, y + 19],
          [x + 7, y + 15],
        ],
        false,
        "fine",
      )
    : path(
        [
          [x - 9, y + 15],
          [x + 9, y + 15],
        ],
        false,
        "fine",
      );
  return [triangle, ground, label([x, y], typeof table.name === "string" ? table.name : "", [11, 16])];
}

/** Short strokes along a line support. */
function comb(ring: readonly Pixel[]): SVGElement[] {
  const strokes: SVGElement[] = [];
  along(ring, 9, ([x, y], [dx, dy]) =>
    strokes.push(
      path(
        [
          [x, y],
          [x - dy * 5 - dx * 5, y + dx * 5 - dy * 5],
        ],
        false,
        "fine",
      ),
    ),
  );
  return strokes;
}

/** Call with places along a line, so many pixels apart, and the direction there. */
function along(ring: readonly Pixel[], spacing: number, visit: (at: Pixel, direction: Pixel) => void): void {
  ring.slice(1).forEach((b, n) => {
    const a = ring[n] as Pixel;
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length === 0) return;
    const direction: Pixel = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    const count = Math.min(400, Math.max(1, Math.round(length / spacing)));
    for (let k = 0; k <= count; k += 1) {
      visit([a[0] + ((b[0] - a[0]) * k) / count, a[1] + ((b[1] - a[1]) * k) / count], direction);
    }
  });
}

function load(
  camera: Camera,
  item: Item,
  ring: readonly Pixel[],
  loadsAt: ReadonlyMap<string, Item[]>,
  look: Look,
): SVGElement[] {
  const here = loadsAt.get(placeKey(item)) ?? [item];
  const strong = here.filter((each) => !look.loadCase || each.table.case === look.loadCase);
  const marked = here.find((each) => isOne(look.selected, each) || isOne(look.hovered, each));
  const speaks = item === (marked ?? strong[0] ?? here[0]); // for all at the same place
  const named = marked && strong.length === 0 ? [marked] : strong;
  const words = !speaks ? [] : marked || strong.length < 2 ? named.map(loadWords) : [`${strong.length} loads`];
  if (item.geometry.type === "point") {
    const foot = item.foot ? [area(item.foot.map((point) => camera.toPixel(point)))] : [];
    return speaks ? [...foot, ...pointLoad(item, ring[0] ?? [0, 0], words)] : foot;
  }
  const labels = (at: Pixel, dx: number, dy: number, up: boolean) =>
    words.map((each, n) => label(at, each, [dx, dy + 12 * (up ? n - words.length + 1 : n)]));
  const wall = item.table.kind === "line";
  if (isClosed(item.geometry) && !wall)
    return [area(ring), ...holes(camera, item), ...labels(leftTop(ring), 5, 13, false)];
  if (isClosed(item.geometry)) ring = [...ring, ...ring.slice(0, 1)];
  const arrows: SVGElement[] = [];
  along(ring, 16, ([x, y]) =>
    arrows.push(
      path(
        [
          [x, y],
          [x, y - 11],
        ],
        false,
        "fine",
      ),
      path(
        [
          [x - 2.5, y - 4.5],
          [x, y],
          [x + 2.5, y - 4.5],
        ],
        false,
        "fine",
      ),
    ),
  );
  return [
    path(ring, false, "wall"),
    path(
      ring.map(([x, y]): Pixel => [x, y - 11]),
      false,
      "fine",
    ),
    ...arrows,
    ...labels(ring[0] ?? [0, 0], 4, -15, true),
  ];
}

/** The edges of the parts of an area that are not loaded. */
function holes(camera: Camera, item: Item): SVGElement[] {
  return listAt(item.table, ["holes"]).flatMap((_, n) => {
    const hole = readGeometry(item.table, ["holes", n]);
    return hole
      ? [
          path(
            ringOf(hole).map((point) => camera.toPixel(point)),
            true,
            "hole",
          ),
        ]
      : [];
  });
}

/** One arrow for all loads at a place; their values stand beside it. */
function pointLoad(item: Item, [x, y]: Pixel, words: readonly string[]): SVGElement[] {
  const near: Pixel = [x - 3, y - 3];
  const far: Pixel = [x - 3 - GLYPH * 0.62, y - 3 - GLYPH];
  const upwards = String(item.table.P ?? "")
    .trim()
    .startsWith("-");
  const [head, tail] = upwards ? [far, near] : [near, far];
  return [
    path([tail, head], false),
    arrowHead(tail, head),
    ...words.map((each, n) => label(far, each, [0, -4 - 12 * (words.length - 1 - n)], "label middle")),
  ];
}

function isOne(chosen: Path | null, item: Item): boolean {
  return chosen !== null && pathWords(chosen) === pathWords(item.path);
}

/** A load's name and size. */
function loadWords(item: Item): string {
  if (item.table.kind !== "point")
    return [nameOf(item), String(item.table.q ?? "")].filter(Boolean).join("  ").replace("-", "−");
  const moments = ["M_x", "M_y"]
    .filter((key) => item.table[key] !== undefined)
    .map((key) => `, ${key.replace("_", "")} ${String(item.table[key])}`);
  return `${String(item.table.P ?? "")}${moments.join("")}`.replace("-", "−");
}

function arrowHead(from: Pixel, to: Pixel): SVGElement {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
  const [dx, dy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  const back = (side: number): Pixel => [to[0] - dx * 8 - dy * 3.5 * side, to[1] - dy * 8 + dx * 3.5 * side];
  return path([to, back(1), back(-1)], true, "head");
}

function borehole([x, y]: Pixel, name: string): SVGElement[] {
  return [
    svg("circle", { cx: x, cy: y, r: 7 }),
    svg("path", {
      d: `M${x} ${y}L${x} ${y - 7}A7 7 0 0 1 ${x + 7} ${y}ZM${x} ${y}L${x} ${y + 7}A7 7 0 0 1 ${x - 7} ${y}Z`,
      class: "filled",
    }),
    label([x, y], name, [10, -4]),
  ];
}

function strip(camera: Camera, item: Item, ring: readonly Pixel[]): SVGElement[] {
  const a: Pixel = ring[0] ?? [0, 0];
  const b: Pixel = ring[1] ?? a;
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const half = ((metres(item.table.width) ?? 0) / 2) * camera.scale;
  if (length === 0) return [];
  const [nx, ny] = [(-(b[1] - a[1]) / length) * half, ((b[0] - a[0]) / length) * half];
  const outline: Pixel[] = [
    [a[0] + nx, a[1] + ny],
    [b[0] + nx, b[1] + ny],
    [b[0] - nx, b[1] - ny],
    [a[0] - nx, a[1] - ny],
  ];
  return [area(outline), path(ring, false), label(a, nameOf(item), [6, -6])];
}

/** Bars across the ends of a section line. */
function ends(ring: readonly Pixel[]): SVGElement[] {
  const [a, b] = [ring[0], ring[1]];
  if (!a || !b) return [];
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
  const [nx, ny] = [(-(b[1] - a[1]) / length) * 6, ((b[0] - a[0]) / length) * 6];
  return [a, b].map(([x, y]) =>
    path(
      [
        [x - nx, y - ny],
        [x + nx, y + ny],
      ],
      false,
    ),
  );
}

function plus([x, y]: Pixel): SVGElement[] {
  return [
    path(
      [
        [x - 5, y],
        [x + 5, y],
      ],
      false,
    ),
    path(
      [
        [x, y - 5],
        [x, y + 5],
      ],
      false,
    ),
  ];
}

/** Lengths of a shape's edges, or of a line, written beside them. */
export function paintDimensions(camera: Camera, ring: Ring, closed: boolean): SVGElement[] {
  const marks: SVGElement[] = [];
  // opposite sides of a rectangle are alike
  const count = !closed ? ring.length - 1 : isBox(ring) ? 2 : ring.length;
  if (count > 24) return marks;
  const centre = ring.reduce((sum, [x]) => sum + camera.toPixel([x, 0])[0], 0) / Math.max(1, ring.length);
  for (let n = 0; n < count; n += 1) {
    const [a, b] = [ring[n], ring[(n + 1) % ring.length]];
    if (!a || !b) continue;
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const [p, q] = [camera.toPixel(a), camera.toPixel(b)];
    if (Math.hypot(q[0] - p[0], q[1] - p[1]) < 34) continue;
    const steep = Math.abs(q[1] - p[1]) > Math.abs(q[0] - p[0]);
    const middle: Pixel = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
    const right = middle[0] > centre;
    marks.push(
      label(
        middle,
        `${plain(length, 3)} m`,
        steep ? [right ? -8 : 8, -8] : [0, -8],
        `label dimension ${!steep ? "middle" : right ? "end" : ""}`,
      ),
    );
  }
  return marks;
}

/** Whether a ring is a rectangle along x and y. */
function isBox(ring: Ring): boolean {
  const [a, b, c, d] = ring;
  return (
    ring.length === 4 && !!a && !!b && !!c && !!d && a[1] === b[1] && b[0] === c[0] && c[1] === d[1] && d[0] === a[0]
  );
}

/** The place of a ring nearest to a place, for pulling a thing by its corner. */
export function nearestCorner(ring: Ring, at: Point): Point {
  return ring.reduce<Point>(
    (best, each) => (nearest(each, each, at).distance < nearest(best, best, at).distance ? each : best),
    ring[0] ?? at,
  );
}

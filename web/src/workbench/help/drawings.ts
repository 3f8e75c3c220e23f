// Small drawings that show what the keys of a part mean.
import { svg } from "../../viewer/shared/dom";
import {
  arrow,
  axes,
  base,
  box,
  dimension,
  HEIGHT,
  letter,
  type Mark,
  mark,
  path,
  pressure,
  spring,
  still,
  WIDTH,
} from "./figure";

const SLAB = () => box("concrete", 20, 36, 144, 14);

/** The drawing of each part, by the part's name in the schema. */
const DRAWINGS: Record<string, () => Mark[]> = {
  ...share(drawPlate, "Plate", "FurtherPlate", "Zone"),
  ...share(drawLayers, "SoilLayer", "HalfSpace", "Vlasov", "Continuum", "ConstrainedModulus", "Layered"),
  ...share(drawSprings, "Winkler", "Pasternak", "InterfaceLayer"),
  ...share(drawFootprint, "Column", "PointLoad", "Wheel"),
  ...share(drawRectangle, "Rectangle", "PatchLoad"),
  ...share(drawPressure, "UniformLoad", "AreaLoad"),
  ...share(drawSupport, "PointSupport", "LineSupport"),
  ...share(drawAxes, "Reinforcement", "Bars", "BarZone"),
  ...share(drawContact, "Contact", "Void", "GapPoint"),
  LineLoad: drawLineLoad,
  Pile: drawPile,
  Borehole: drawBorehole,
  Beyond: drawBeyond,
  Circle: drawCircle,
};

function share(draw: () => Mark[], ...names: string[]): Record<string, () => Mark[]> {
  return Object.fromEntries(names.map((name) => [name, draw]));
}

/** The names of the parts that have a drawing. */
export const DRAWN = Object.keys(DRAWINGS);

/** Return the keys that the drawing of a part explains. */
export function drawnKeys(part: string): string[] {
  return DRAWINGS[part]?.().flatMap((each) => each.keys) ?? [];
}

/** Return the drawing of a part with what explains a key highlighted, null where nothing in it does. */
export function drawPart(part: string, key: string): SVGElement | null {
  const marks = DRAWINGS[part]?.() ?? [];
  if (!marks.some((each) => each.keys.includes(key))) return null;
  const groups = marks.map(({ keys, elements }) =>
    svg("g", { class: keys.includes(key) ? "lit" : keys.length > 0 ? "letter" : null }, ...elements),
  );
  return svg("svg", { class: "figure", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, "aria-hidden": "true" }, ...groups);
}

/** The plate in plan and in section. */
function drawPlate(): Mark[] {
  return [
    still(box("concrete", 26, 10, 84, 62), box("concrete", 132, 38, 40, 14)),
    mark("openings", box("opening", 84, 18, 16, 14)),
    mark("zones shape", box("zone", 34, 46, 26, 18)),
    mark("outline edges", box("outline", 26, 10, 84, 62)),
    mark("length_x", ...dimension(26, 88, 110, 88, "L_x")),
    mark("length_y", ...dimension(18, 72, 18, 10, "L_y")),
    mark("thickness", ...dimension(125, 52, 125, 38, "t")),
    mark("E nu shear_factor thermal_expansion", letter(152, 68, "E, ν")),
  ];
}

/** Layers of soil below a slab. */
function drawLayers(): Mark[] {
  return [
    still(box("concrete", 40, 8, 84, 10), path("M14 18H40M124 18H150")),
    mark("layers sublayers", box("soil", 14, 18, 136, 40)),
    mark("half_space", box("soil deep", 14, 58, 136, 34)),
    mark("thickness", ...dimension(24, 58, 24, 18, "h")),
    mark("E", letter(86, 31, "E")),
    mark("nu", letter(108, 43, "nu")),
    mark("E_bottom variation", path("M64 20L74 56", "line"), letter(86, 54, "E_b")),
    mark("groundwater", path("M112 34H150M128 34l-4 -6h8z"), letter(162, 38, "z_w")),
    still(path("M14 58H150")),
  ];
}

/** Springs below a slab, and the layer that carries shear on top of them. */
function drawSprings(): Mark[] {
  const places = [32, 62, 92, 122, 152];
  return [
    still(box("concrete", 20, 14, 144, 14), base(20, 164, 84)),
    mark("k k0 selvadurai", ...places.map((x) => spring(x, 40, 84)), letter(77, 66, "k")),
    mark("k1", box("shear", 20, 30, 144, 9), letter(174, 39, "k_1")),
  ];
}

/** The footprint of a column or of a force in plan. */
function drawFootprint(): Mark[] {
  return [
    axes(20, 92),
    still(box("concrete", 84, 26, 44, 36)),
    mark("width_x", ...dimension(84, 18, 128, 18, "c_x")),
    mark("width_y", ...dimension(78, 62, 78, 26, "c_y")),
    mark("diameter", svg("circle", { class: "outline", cx: 106, cy: 44, r: 18 }), letter(97, 41, "d")),
    mark("angle", path("M84 62L108 52M108 62A24 24 0 0 0 106 53", "line thin"), letter(120, 60, "alpha", "start")),
    mark("x", path("M106 44V92", "line thin"), arrow(52, 92, 106, 92), letter(100, 87, "x", "end")),
    mark("y", path("M106 44H150", "line thin"), arrow(150, 92, 150, 44), letter(158, 72, "y", "start")),
    mark("P", svg("circle", { class: "load", cx: 106, cy: 44, r: 3.5 }), letter(114, 56, "P", "start")),
  ];
}

/** A rectangle in plan: from the smaller to the larger coordinate. */
function drawRectangle(): Mark[] {
  return [
    axes(24, 90),
    mark("q", box("area", 72, 24, 84, 42), letter(114, 50, "q")),
    still(box("outline", 72, 24, 84, 42)),
    mark("x", path("M72 66V92M156 66V92", "line thin"), letter(72, 101, "x_1"), letter(156, 101, "x_2")),
    mark("y", path("M156 24H164M156 66H164", "line thin"), letter(172, 28, "y_2"), letter(172, 70, "y_1")),
  ];
}

/** A pressure on the slab, and how it changes in plan. */
function drawPressure(): Mark[] {
  return [
    still(SLAB()),
    mark("q", ...pressure(20, 164, 16, 36), letter(92, 11, "q")),
    mark("shape", path("M50 58H134"), letter(92, 70, "shape")),
    mark("slope", path("M20 16L164 2", "line"), letter(172, 12, "q_x", "end")),
  ];
}

/** A force along a line, from its start to its end. */
function drawLineLoad(): Mark[] {
  return [
    still(SLAB()),
    mark("q", ...pressure(34, 150, 20, 36, 10), letter(24, 24, "q")),
    mark("q_end", path("M150 10V35"), letter(160, 14, "q_e", "start")),
    mark("points bulges", path("M34 60H150"), letter(34, 74, "1"), letter(150, 74, "2")),
  ];
}

/** A support below a slab: way that is free, stiffness, largest force. */
function drawSupport(): Mark[] {
  return [
    still(box("concrete", 20, 12, 144, 14), base(72, 112, 88)),
    mark("gap", path("M78 36H106"), ...dimension(66, 36, 66, 26, "g_s")),
    mark("stiffness", spring(92, 36, 88), letter(106, 64, "K", "start")),
    mark("limit", arrow(136, 60, 136, 28), letter(142, 52, "R_max", "start")),
    mark("rotation rotational_stiffness", path("M60 20a34 22 0 0 0 64 0"), letter(48, 46, "K_r", "end")),
    mark("x y points", path("M92 4V12M88 8L92 12L96 8"), letter(104, 9, "x, y", "start")),
  ];
}

/** A pile below a slab. */
function drawPile(): Mark[] {
  return [
    still(box("concrete", 20, 8, 144, 12), box("soil", 20, 20, 144, 78), box("concrete", 84, 20, 16, 62)),
    mark("length", ...dimension(72, 82, 72, 20, "l")),
    mark("diameter", ...dimension(84, 93, 100, 93, "d")),
    mark("E", letter(112, 54, "E_p", "start")),
    mark("limit", arrow(130, 84, 130, 60), letter(136, 76, "R_c", "start")),
    mark("limit_tension", arrow(130, 30, 130, 50), letter(136, 44, "R_t", "start")),
  ];
}

/** Boreholes in plan, and the layers that one of them found. */
function drawBorehole(): Mark[] {
  const cross = (x: number, y: number) => path(`M${x - 5} ${y}h10M${x} ${y - 5}v10`);
  return [
    still(box("concrete", 22, 20, 84, 56), cross(38, 34), cross(38, 64)),
    mark("x y", cross(88, 46), letter(88, 36, "x, y")),
    mark("layers", box("soil", 138, 16, 22, 30), box("soil deep", 138, 46, 22, 42), path("M138 46h22")),
    still(path("M94 46L134 18", "line thin")),
  ];
}

/** Bars in a section of the slab: cover, and distances of their axes from the faces. */
function drawAxes(): Mark[] {
  const bars = (y: number) => [44, 74, 104, 134].map((x) => svg("circle", { class: "bar", cx: x, cy: y, r: 4 }));
  return [
    still(box("concrete", 30, 14, 124, 76)),
    mark("bottom bottom_x bottom_y bottom_mesh", ...bars(74), ...dimension(22, 90, 22, 74, "d_1")),
    mark("top top_x top_y top_mesh", ...bars(30), ...dimension(22, 30, 22, 14, "d_1")),
    mark("cover", ...dimension(164, 90, 164, 78, ""), letter(168, 88, "c", "start")),
    mark("spacing", ...dimension(74, 64, 104, 64, "s")),
    mark("diameter", letter(134, 66, "phi")),
  ];
}

/** The ground beyond the plate. */
function drawBeyond(): Mark[] {
  return [
    still(box("concrete", 20, 22, 90, 12)),
    mark("kind sides", box("soil", 20, 34, 150, 52)),
    mark("width", path("M110 22V16M170 34V16", "line thin"), ...dimension(110, 20, 170, 20, "b")),
    mark("edge", path("M170 34V86")),
  ];
}

/** A gap between plate and ground, and the pressure under it. */
function drawContact(): Mark[] {
  return [
    still(box("concrete", 20, 18, 144, 12), path("M20 42H84C92 42 92 56 100 56H132C140 56 140 42 148 42H164")),
    mark("gap", ...dimension(34, 42, 34, 30, "g_0")),
    mark("depth voids", path("M100 42H132", "line thin"), ...dimension(116, 56, 116, 42, "d")),
    mark("limit_pressure", arrow(60, 66, 60, 44), arrow(74, 66, 74, 44), letter(67, 80, "p_max")),
  ];
}

/** A circle in plan. */
function drawCircle(): Mark[] {
  return [
    axes(24, 92),
    still(svg("circle", { class: "outline", cx: 112, cy: 48, r: 34 })),
    mark("centre", svg("circle", { class: "load", cx: 112, cy: 48, r: 2.5 }), letter(112, 64, "x, y")),
    mark("radius", arrow(112, 48, 136, 24), letter(116, 32, "r")),
  ];
}

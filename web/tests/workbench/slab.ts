import type { Table } from "../../src/workbench/model/paths";

const L_SHAPE: Table = {
  kind: "polygon",
  points: [
    ["0 m", "0 m"],
    ["6 m", "0 m"],
    ["6 m", "2 m"],
    ["2 m", "2 m"],
    ["2 m", "4 m"],
    ["0 m", "4 m"],
  ],
};
/** A slab with an opening, a column and loads. */
export const DATA: Table = {
  plate: {
    outline: L_SHAPE,
    thickness: "300 mm",
    openings: [{ kind: "circle", centre: ["1 m", "1 m"], radius: "250 mm" }],
  },
  columns: [{ name: "A1", x: "4 m", y: "1 m", width_x: "400 mm", width_y: "400 mm" }],
  loads: [
    { kind: "point", P: "10 kN", column: "A1" },
    { kind: "uniform", q: "5 kPa" },
  ],
};
/** A place that was not snapped. */
export const free = (at: [number, number]) => ({ at, fromX: null, fromY: null, onPoint: false });

// @vitest-environment happy-dom
// How items are drawn.
import { describe, expect, it } from "vitest";
import { Camera } from "../../../src/viewer/plan/camera";
import { keepChildren } from "../../../src/viewer/shared/dom";
import { readGeometry, ringOf } from "../../../src/workbench/model/geometry";
import { itemsOf } from "../../../src/workbench/model/items";
import type { Path, Table } from "../../../src/workbench/model/paths";
import { type Drawn, drawItems } from "../../../src/workbench/plan/rendering";

describe("the drawing", () => {
  const camera = new Camera();
  const drawn = (data: Table, kind: string) =>
    drawItems(
      camera,
      itemsOf(data, null).filter((item) => item.kind === kind),
      { selected: [], hovered: null, faulty: [], loadCase: "" },
    );
  const square = [
    ["0 m", "0 m"],
    ["1 m", "0 m"],
    ["1 m", "1 m"],
    ["0 m", "0 m"],
  ];

  it("fills areas, but no line that is closed", () => {
    const loads = drawn(
      {
        loads: [
          { kind: "line", q: "1 kN/m", points: square },
          { kind: "area", q: "1 kPa", shape: { kind: "polygon", points: square.slice(1) } },
        ],
      },
      "load",
    );
    expect(loads.map((group) => group.querySelectorAll(".area").length)).toEqual([0, 1]);
    const supports = drawn(
      {
        supports: [
          { kind: "line", name: "W", points: square },
          { kind: "point", name: "P", x: "0 m", y: "0 m" },
        ],
      },
      "support",
    );
    expect(supports.map((group) => group.querySelectorAll(".area").length)).toEqual([0, 1]);
  });

  it("draws walls as thick as they are, and loads on them along their axes", () => {
    const data: Table = {
      walls: [
        {
          name: "W1",
          thickness: "1 m",
          points: [
            ["0 m", "0 m"],
            ["4 m", "0 m"],
            ["4 m", "4 m"],
          ],
        },
      ],
      loads: [{ kind: "line", q: "20 kN/m", wall: "W1" }],
    };
    const [wall] = drawn(data, "wall");
    const path = wall!.querySelector(".area")!.getAttribute("d")!;
    const corners = [...path.matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) =>
      camera.toPlan([Number(x), Number(y)]),
    );
    const expected = [
      [0, 0.5],
      [3.5, 0.5],
      [3.5, 4],
      [4.5, 4],
      [4.5, -0.5],
      [0, -0.5],
    ];
    expect(corners.length).toBe(expected.length);
    for (const corner of expected)
      expect(Math.min(...corners.map(([x, y]) => Math.hypot(x - corner[0]!, y - corner[1]!)))).toBeLessThan(0.1);
    const [load] = itemsOf(data, null).filter((item) => item.kind === "load");
    expect(load!.movable).toBe(false);
    expect(ringOf(load!.geometry).length).toBe(3);
  });

  it("draws beams as wide as their sections", () => {
    const data: Table = {
      beams: [
        {
          name: "B1",
          points: [
            ["0 m", "0 m"],
            ["4 m", "0 m"],
          ],
          section: { kind: "rib", width: "50 cm", height: "60 cm", effective_width: "2 m" },
        },
      ],
    };
    const [beam] = drawn(data, "beam");
    const path = beam!.querySelector(".area")!.getAttribute("d")!;
    const ys = [...path.matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) => camera.toPlan([Number(x), Number(y)])[1]);
    expect(Math.max(...ys)).toBeCloseTo(0.25, 1);
    expect(Math.min(...ys)).toBeCloseTo(-0.25, 1);
  });

  it("takes a wall along the slab's edge, and loads on it, from the server's plan, and holds them there", () => {
    const data: Table = {
      walls: [{ name: "W1", thickness: "0.2 m", edge: "bottom" }],
      loads: [{ kind: "line", q: "20 kN/m", wall: "W1" }],
    };
    const points = [
      [-2, -0.9],
      [2, -0.9],
    ];
    const items = itemsOf(data, { walls: [{ path: "walls[1]", name: "W1", points }] });
    expect(items.map(({ kind, movable }) => [kind, movable])).toEqual([
      ["wall", false],
      ["load", false],
    ]);
    for (const { geometry } of items) expect(ringOf(geometry)).toEqual(points);
    expect(itemsOf(data, null)).toEqual([]);
  });

  it("has circles and arcs whose chords turn by two degrees at most", () => {
    const circle = ringOf(readGeometry({ o: { kind: "circle", radius: "1 mm" } }, ["o"])!);
    expect(circle.length).toBe(180);
    const half = ringOf(
      readGeometry(
        {
          o: {
            kind: "polygon",
            points: [
              ["0 m", "0 m"],
              ["2 m", "0 m"],
            ],
            bulges: [1],
          },
        },
        ["o"],
      )!,
    );
    expect(half.length).toBe(91);
    // on a half circle about (1, 0)
    for (const [x, y] of half) expect(Math.hypot(x - 1, y)).toBeCloseTo(1, 12);
  });

  it("keeps what looks the same, and its place among what is drawn", () => {
    const items = (x: string) =>
      itemsOf(
        {
          columns: [
            { name: "A", x, y: "0 m" },
            { name: "B", x: "2 m", y: "0 m" },
            { name: "C", x: "4 m", y: "0 m" },
          ],
        },
        null,
      );
    const kept: Drawn = new Map();
    const draw = (x: string, selected: Path[] = []) =>
      drawItems(camera, items(x), { selected, hovered: null, faulty: [], loadCase: "" }, kept);
    const group = document.createElement("div");
    const before = draw("0 m");
    keepChildren(group, before);
    const after = draw("1 m", [["columns", 2]]);
    keepChildren(group, after);
    expect(before.map((element, n) => element === after[n])).toEqual([false, true, false]);
    expect([...group.children]).toEqual(after);
    keepChildren(group, [after[2]!, after[0]!]);
    expect([...group.children]).toEqual([after[2], after[0]]);
  });
});

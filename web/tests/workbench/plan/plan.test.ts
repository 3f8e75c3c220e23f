// @vitest-environment happy-dom
// The drawing: snapping, handles, and the edits that dragging and drawing make.
import { describe, expect, it } from "vitest";
import { editsBetween, readGeometry, readSides, ringOf, signedArea } from "../../../src/workbench/model/geometry";
import { itemsOf } from "../../../src/workbench/model/items";
import type { Table } from "../../../src/workbench/model/paths";
import { Camera } from "../../../src/workbench/plan/camera";
import { Drawing, Moving, Reshaping } from "../../../src/workbench/plan/interaction/gestures";
import { dragged, handlesOf, withoutCorner } from "../../../src/workbench/plan/interaction/handles";
import { itemsAt } from "../../../src/workbench/plan/interaction/hit-testing";
import { roundedTo, roundStep, snap } from "../../../src/workbench/plan/interaction/snapping";
import { paintItems } from "../../../src/workbench/plan/rendering";
import { freeName, madeAtPoint, madeOfShape, outlineEdits, toolOf } from "../../../src/workbench/plan/tools";

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
const DATA: Table = {
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
const free = (at: [number, number]) => ({ at, fromX: null, fromY: null, onPoint: false });

describe("snapping", () => {
  const points = [
    [2, 2],
    [5, 0.503],
  ] as const;

  it("takes an existing corner that is near before all else", () => {
    expect(snap({ at: [2.03, 1.96], points, step: 0.1, reach: 0.1 }).at).toEqual([2, 2]);
  });

  it("takes round lengths where nothing is near", () => {
    expect(snap({ at: [3.333, 1.449], points: [], step: 0.1, reach: 0.01 }).at).toEqual([3.3, 1.4]);
  });

  it("goes in line with an existing place, each axis for itself", () => {
    const snapped = snap({ at: [3.14, 0.5034], points, step: 0.02, reach: 0.05 });
    expect(snapped.at[1]).toBe(0.503);
    expect(snapped.fromY).toEqual([5, 0.503]);
    expect(snapped.fromX).toBeNull();
  });

  it("makes steps of 1, 2 and 5, and numbers without noise", () => {
    expect([0.003, 0.01, 0.011, 0.3, 7].map(roundStep)).toEqual([0.005, 0.01, 0.02, 0.5, 10]);
    expect([roundedTo(0.1 + 0.2, 0.1), roundedTo(-0.001, 0.05), roundedTo(1234.5678, 0.002)]).toEqual([
      0.3, 0, 1234.568,
    ]);
  });
});

describe("the drawing", () => {
  const camera = new Camera();
  const drawn = (data: Table, kind: string) =>
    paintItems(
      camera,
      itemsOf(data, null).filter((item) => item.kind === kind),
      { selected: null, hovered: null, faulty: [], loadCase: "" },
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
});

describe("handles", () => {
  it("keeps a rectangle by its sides about the origin: the opposite edge moves the other way", () => {
    const sides = readSides({ plate: { length_x: "6 m", length_y: "4 m" } });
    const right = handlesOf(sides!).find((handle) => handle.kind === "edge" && handle.at[0] === 3)!;
    const after = dragged(sides!, right, [3.5, 9])!;
    expect(editsBetween(sides!, after)).toEqual([{ op: "length", path: ["plate", "length_x"], value: 7 }]);
  });

  it("never turns a rectangle inside out", () => {
    const box = readGeometry({ o: { kind: "rectangle", x: ["0 m", "2 m"], y: ["0 m", "1 m"] } }, ["o"])!;
    const corner = handlesOf(box)[0]!;
    expect(dragged(box, corner, [3, 0.5])).toMatchObject({ x: [2, 3], y: [0.5, 1] });
    expect(dragged(box, corner, [2, 0.5])).toBeNull();
  });

  it("adds and removes corners of a polygon together with their bulges", () => {
    const arched = readGeometry(
      {
        p: {
          kind: "polygon",
          points: [
            ["0 m", "0 m"],
            ["2 m", "0 m"],
            ["2 m", "2 m"],
            ["0 m", "2 m"],
          ],
          bulges: [0, 0.5],
        },
      },
      ["p"],
    )!;
    const add = handlesOf(arched).find((handle) => handle.kind === "add" && handle.index === 0)!;
    expect(
      handlesOf(arched)
        .filter((handle) => handle.kind === "add")
        .map((handle) => handle.index),
    ).toEqual([0, 2, 3]);
    const more = dragged(arched, add, [1, -1])!;
    expect(more).toMatchObject({
      points: [
        [0, 0],
        [1, -1],
        [2, 0],
        [2, 2],
        [0, 2],
      ],
      bulges: [0, 0, 0.5],
    });
    expect(withoutCorner(more, 1)).toEqual(arched);
    const triangle = {
      ...arched,
      points: [
        [0, 0],
        [1, 0],
        [0, 1],
      ],
    } as typeof arched;
    expect(withoutCorner(triangle, 0)).toBeNull();
  });

  it("draws arcs to the left of a counter-clockwise bulge: two half circles make a circle", () => {
    const disc = readGeometry(
      {
        p: {
          kind: "polygon",
          points: [
            ["-1 m", "0 m"],
            ["1 m", "0 m"],
          ],
          bulges: [1, 1],
        },
      },
      ["p"],
    )!;
    expect(signedArea(ringOf(disc))).toBeGreaterThan(3.12);
    expect(signedArea(ringOf(disc))).toBeLessThan(Math.PI);
  });
});

describe("dragging", () => {
  const items = itemsOf(DATA, null);
  const column = items.find((item) => item.kind === "column")!;

  it("is one edit that moves the thing and says so", () => {
    const moving = new Moving(column, [4.1, 1.05]);
    moving.to(free([4.5, 1.2]));
    const ghost = moving.to(free([5, 1.25]));
    expect(ghost.geometry).toMatchObject({ x: 5, y: 1.25 });
    expect(moving.change()).toEqual({
      edits: [{ op: "move", path: ["columns", 0], by: [1, 0.25] }],
      text: "move column A1",
    });
  });

  it("is no edit where nothing has moved", () => {
    const moving = new Moving(column, [4, 1]);
    moving.to(free([4, 1]));
    expect(moving.change()).toBeNull();
  });

  it("writes a circle's radius as a length", () => {
    const opening = items.find((item) => item.kind === "opening")!;
    const reshaping = new Reshaping(opening, handlesOf(opening.geometry)[0]!);
    reshaping.to(free([1.5, 1]));
    expect(reshaping.change()).toEqual({
      edits: [{ op: "length", path: ["plate", "openings", 0, "radius"], value: 0.5 }],
      text: "reshape opening 1",
    });
  });

  it("lets loads on a column stay with it", () => {
    const load = items.find((item) => item.kind === "load")!;
    expect(load).toMatchObject({ movable: false, geometry: { x: 4, y: 1 } });
    expect(items.filter((item) => item.kind === "load")).toHaveLength(1);
  });
});

describe("drawing", () => {
  const draw = (tool: Parameters<typeof toolOf>[0], ...clicks: [number, number][]) => {
    const drawing = new Drawing(toolOf(tool));
    for (const at of clicks) {
      if (drawing.down(at, 0.05)) break;
      drawing.up(at, 0.05);
    }
    return drawing.made(DATA, "");
  };

  it("makes a rectangle of a drag", () => {
    const drawing = new Drawing(toolOf("opening"));
    drawing.down([4, 1.5], 0.05);
    expect(drawing.up([3, 0.5], 0.05)).toBe(true);
    expect(drawing.made(DATA, "")?.change.edits).toEqual([
      {
        op: "add",
        path: ["plate", "openings"],
        value: { kind: "rectangle", x: ["3 m", "4 m"], y: ["0.5 m", "1.5 m"] },
      },
    ]);
  });

  it("makes a polygon of clicks that end at the first corner", () => {
    const made = draw("zone", [0, 0], [2, 0], [2, 2], [0.01, 0.01]);
    expect(made?.path).toEqual(["plate", "zones", 0]);
    expect(made?.change.edits[0]).toMatchObject({
      value: {
        thickness: "450 mm",
        shape: {
          kind: "polygon",
          points: [
            ["0 m", "0 m"],
            ["2 m", "0 m"],
            ["2 m", "2 m"],
          ],
        },
      },
    });
  });

  it("makes nothing of a rectangle without an area", () => {
    const drawing = new Drawing(toolOf("opening"));
    drawing.down([4, 1.5], 0.05);
    drawing.up([5, 1.5], 0.05);
    expect(drawing.made(DATA, "")).toBeNull();
  });

  it("puts a point load on the column that is clicked, and names columns anew", () => {
    expect(madeAtPoint("point load", DATA, [4.1, 1.1], "live").change.edits[0]).toMatchObject({
      value: { kind: "point", column: "A1", case: "live" },
    });
    expect(madeAtPoint("point load", DATA, [1, 1], "").change.edits[0]).toMatchObject({
      value: { x: "1 m", y: "1 m" },
    });
    expect(madeAtPoint("column", DATA, [1, 3], "").change.edits[0]).toMatchObject({
      value: { name: "C1", width_x: "400 mm" },
    });
    expect(freeName(["C1", "C2"], "C1")).toBe("C3");
    expect(freeName(["wall"], "wall")).toBe("wall 2");
  });

  it("replaces the sides by the outline that is drawn, and keeps the rest of the slab", () => {
    const data: Table = { plate: { length_x: "6 m", length_y: "4 m", thickness: "1 ft", E: "30 GPa", nu: 0.2 } };
    const made = madeOfShape("slab", data, { kind: "rectangle", from: [0, 0], to: [3, 2] }, "");
    expect(made.change.edits.map((edit) => ("path" in edit ? [edit.op, edit.path.join(".")] : []))).toEqual([
      ["remove", "plate.length_x"],
      ["remove", "plate.length_y"],
      ["set", "plate.outline"],
    ]);
    expect(outlineEdits({}, { kind: "circle" }).length).toBe(4);
  });
});

describe("what lies under the pointer", () => {
  it("is the column first, then the load on it, then the opening, then the slab", () => {
    const items = itemsOf(DATA, null);
    expect(itemsAt(items, [4, 1], 0.05).map((item) => item.kind)).toEqual(["column", "load", "slab"]);
    expect(itemsAt(items, [1, 1], 0.05).map((item) => item.kind)).toEqual(["opening", "slab"]);
    expect(itemsAt(items, [5, 3], 0.05)).toEqual([]);
  });

  it("takes what cannot be read here from the server's plan", () => {
    const odd: Table = {
      plate: { length_x: "1 furlong", length_y: "2 m" },
      columns: [{ name: "A", x: "1 rod", y: "0 m" }],
    };
    const plan: Table = {
      outline: [
        [-1, -1],
        [1, -1],
        [1, 1],
      ],
      columns: [{ path: "columns[1]", x: 5.03, y: 0 }],
    };
    expect(itemsOf(odd, plan).map((item) => item.geometry.type)).toEqual(["fixed", "point"]);
    expect(itemsOf(odd, null)).toEqual([]);
  });
});

describe("the camera", () => {
  it("keeps the place under the pointer while it zooms", () => {
    const camera = new Camera();
    Object.assign(camera, { width: 400, height: 300 });
    camera.fit([0, 0, 6, 4]);
    const before = camera.toPlan([100, 80]);
    camera.zoom(1.7, [100, 80]);
    const after = camera.toPlan([100, 80]);
    expect(after[0]).toBeCloseTo(before[0], 12);
    expect(after[1]).toBeCloseTo(before[1], 12);
    expect(camera.toPixel(after)[0]).toBeCloseTo(100, 9);
  });
});

describe("line loads along arcs", () => {
  const arch: Table = {
    loads: [
      {
        kind: "line",
        q: "1 kN/m",
        points: [
          ["-1 m", "0 m"],
          ["1 m", "0 m"],
          ["3 m", "0 m"],
        ],
        bulges: [-1],
      },
    ],
  };
  const line = readGeometry(arch, ["loads", 0])!;

  it("are drawn along the arc, over (0, 1) and straight on", () => {
    const ring = ringOf(line);
    expect(Math.max(...ring.map(([, y]) => y))).toBeCloseTo(1, 2);
    expect(ring.at(-1)).toEqual([3, 0]);
  });

  it("keep their arcs when a corner is added or taken away", () => {
    const add = handlesOf(line).find((each) => each.kind === "add")!;
    expect(add).toMatchObject({ index: 1, at: [2, 0] });
    const more = dragged(line, add, [2, 1])!;
    expect(more).toMatchObject({
      points: [
        [-1, 0],
        [1, 0],
        [2, 1],
        [3, 0],
      ],
      bulges: [-1],
    });
    expect(withoutCorner(more, 2)).toEqual(line);
    expect(editsBetween(line, withoutCorner(line, 0)!)).toContainEqual({
      op: "set",
      path: ["loads", 0, "bulges"],
      value: [],
    });
  });

  it("on a circle lie where its shape is", () => {
    const ring: Table = { loads: [{ kind: "line", q: "1 kN/m", shape: { kind: "circle", radius: "2 m" } }] };
    expect(itemsOf(ring, null)[0]?.geometry).toMatchObject({ type: "circle", radius: 2 });
  });
});

// @vitest-environment happy-dom
// Handles, and the edits that dragging them makes.
import { describe, expect, it } from "vitest";
import { editsBetween, readGeometry, readSides, ringOf, signedArea } from "../../../../src/workbench/model/geometry";
import { itemsOf } from "../../../../src/workbench/model/items";
import type { Table } from "../../../../src/workbench/model/paths";
import { canBend, dragHandle, handlesOf, removeCorner } from "../../../../src/workbench/plan/interaction/handles";

describe("handles", () => {
  it("keeps a rectangle by its sides about the origin: the opposite edge moves the other way", () => {
    const sides = readSides({ plate: { length_x: "6 m", length_y: "4 m" } });
    const right = handlesOf(sides!).find((handle) => handle.kind === "edge" && handle.at[0] === 3)!;
    const after = dragHandle(sides!, right, [3.5, 9])!;
    expect(editsBetween(sides!, after)).toEqual([{ op: "length", path: ["plate", "length_x"], value: 7 }]);
  });

  it("never turns a rectangle inside out", () => {
    const box = readGeometry({ o: { kind: "rectangle", x: ["0 m", "2 m"], y: ["0 m", "1 m"] } }, ["o"])!;
    const corner = handlesOf(box)[0]!;
    expect(dragHandle(box, corner, [3, 0.5])).toMatchObject({ x: [2, 3], y: [0.5, 1] });
    expect(dragHandle(box, corner, [2, 0.5])).toBeNull();
  });

  it("bends an edge through a place, and straightens it again", () => {
    const points = ["0 m", "4 m"].map((x) => [x, "1 m"]);
    const line = readGeometry({ loads: [{ kind: "line", points }] }, ["loads", 0])!;
    expect(canBend(line)).toBe(true);
    // below the chord, which runs along x: a half circle counter-clockwise; its top is 2 m from the chord
    const bend = { kind: "bend", index: 0, at: [2, 1] } as const;
    const half = dragHandle(line, { ...bend, at: [2, 1] }, [2, -1])!;
    expect(half).toMatchObject({ bulges: [1] });
    // a quarter of a circle rises by (1 - cos 45 degrees) r, r being 4 m / 2 / sin 45 degrees; to the left is clockwise
    const quarter = dragHandle(line, { ...bend, at: [2, 1] }, [2, 1 + 2 * (Math.SQRT2 - 1)])!;
    expect("bulges" in quarter && quarter.bulges[0]).toBeCloseTo(-Math.tan(Math.PI / 8), 6);
    // another place of the half circle gives the same arc, whose middle is the handle
    const [x, y] = [2 + 2 * Math.cos(-0.4), 1 + 2 * Math.sin(-0.4)];
    expect(dragHandle(line, { ...bend, at: [2, 1] }, [x, y])).toMatchObject({ bulges: [1] });
    expect(handlesOf(half).find(({ kind }) => kind === "bend")!.at).toEqual([2, -1]);
    expect(ringOf(half).some(([px, py]) => Math.hypot(px - 2, py + 1) < 1e-9)).toBe(true);
    expect(dragHandle(half, { ...bend, at: [2, -1] }, [2, 1.005])).toMatchObject({ bulges: [0] });
    expect(dragHandle(half, { ...bend, at: [2, -1] }, [-30, 1])).toMatchObject({ bulges: [0] });
  });
  it("bends what has arcs only", () => {
    const path = {
      pattern: "p",
      points: [
        ["0 m", "0 m"],
        ["4 m", "0 m"],
      ],
    };
    expect(canBend(readGeometry({ moves: [path] }, ["moves", 0])!)).toBe(false);
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
    const more = dragHandle(arched, add, [1, -1])!;
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
    expect(removeCorner(more, 1)).toEqual(arched);
    const triangle = {
      ...arched,
      points: [
        [0, 0],
        [1, 0],
        [0, 1],
      ],
    } as typeof arched;
    expect(removeCorner(triangle, 0)).toBeNull();
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
    const more = dragHandle(line, add, [2, 1])!;
    expect(more).toMatchObject({
      points: [
        [-1, 0],
        [1, 0],
        [2, 1],
        [3, 0],
      ],
      bulges: [-1],
    });
    expect(removeCorner(more, 2)).toEqual(line);
    expect(editsBetween(line, removeCorner(line, 0)!)).toContainEqual({
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

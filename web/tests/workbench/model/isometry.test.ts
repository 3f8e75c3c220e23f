import { describe, expect, it } from "vitest";

import { transformTable } from "../../../src/workbench/model/changes/transform";
import { applyTo, keepsAxes, reflection, rotation, translation } from "../../../src/workbench/model/isometry";

const close = (point: readonly number[], to: readonly number[]) =>
  point.forEach((value, n) => {
    expect(value).toBeCloseTo(to[n]!, 12);
  });

describe("an isometry", () => {
  it("turns counter-clockwise about its point, exactly by right angles", () => {
    expect(applyTo(rotation(90, [1, 0]), [3, 0])).toEqual([1, 2]);
    expect(applyTo(rotation(-90, [0, 0]), [3, 1])).toEqual([1, -3]);
    close(applyTo(rotation(30, [0, 0]), [2, 0]), [Math.sqrt(3), 1]);
    expect([rotation(180, [2, 1]), rotation(30, [0, 0])].map(keepsAxes)).toEqual([true, false]);
  });
  it("mirrors about a line through two points", () => {
    expect(applyTo(reflection([2, 0], [2, 1]), [5, 7])).toEqual([-1, 7]);
    expect(applyTo(reflection([0, 0], [1, 1]), [5, 7])).toEqual([7, 5]);
    close(applyTo(reflection([0, 1], [1, 3]), [0, 1]), [0, 1]);
    close(applyTo(reflection([0, 1], [1, 3]), [2, 0]), [-2, 2]);
  });
});

describe("a transformed item", () => {
  it("keeps the units and the text of what does not change", () => {
    const column = { name: "A", x: "70 cm", y: "0.10 m", width_x: "20 cm", width_y: "30 cm" };
    expect(transformTable(column, translation([0.1, 0]))).toEqual({ ...column, x: "80 cm" });
    expect(transformTable({ x: "0.1 m", y: "300 mm" }, translation([0.2, 0.0005]))).toEqual({
      x: "0.3 m",
      y: "300.5 mm",
    });
  });
  it("has its footprint and its moments turned", () => {
    // sum F dx = 10 and sum F dy = 4: a quarter turn maps the distances (dx, dy) to (-dy, dx)
    const load = { kind: "point", P: "1 kN", M_x: "10 kNm", M_y: "4 kNm", x: "1 m", y: "0 m" };
    const sides = { width_x: "2 m", width_y: "1 m" };
    expect(transformTable({ ...load, ...sides }, rotation(90, [0, 0]))).toEqual({
      ...load,
      x: "0 m",
      y: "1 m",
      M_x: "-4 kNm",
      M_y: "10 kNm",
      width_x: "1 m",
      width_y: "2 m",
    });
    expect(transformTable({ M_x: "10 kNm" }, rotation(90, [0, 0]))).toEqual({ M_x: "0 kNm", M_y: "10 kNm" });
    expect(() => transformTable({ ...load, M_y: "4 Nm" }, rotation(30, [0, 0]))).toThrow("different units");
  });
  it("has its footprint at an angle, which comes back", () => {
    const column = { name: "A", x: "0 m", y: "0 m", width_x: "2 m", width_y: "1 m" };
    const turned = { ...column, angle: 30 };
    expect(transformTable(column, rotation(30, [0, 0]))).toEqual(turned);
    expect(transformTable(turned, rotation(-30, [0, 0]))).toEqual(column);
    expect(transformTable(turned, rotation(60, [0, 0]))).toEqual({ ...column, width_x: "1 m", width_y: "2 m" });
    expect(transformTable(turned, rotation(180, [0, 0]))).toEqual(turned);
    expect(transformTable(turned, translation([0, 0]))).toEqual(turned);
    expect(transformTable(turned, reflection([0, 0], [0, 1]))).toEqual({ ...column, angle: -30 });
    expect(transformTable({ ...column, angle: 120 }, rotation(30, [0, 0]))).toEqual({ ...column, angle: -30 });
    const round = { name: "B", x: "0 m", y: "0 m", diameter: "1 m" };
    expect(transformTable(round, rotation(30, [0, 0]))).toEqual(round);
  });
  it("has the same pressure at the images of the places", () => {
    const slope = ["3 kPa/m", "-1 kPa/m"];
    const bend = ["2 kPa/m^2", "0.5 kPa/m^2", "-4 kPa/m^2"];
    const load = { kind: "patch", q: "7 kPa", x: ["0 m", "2 m"], y: ["0 m", "1 m"], slope, bend };
    const pressure = (table: Record<string, unknown>, [x, y]: readonly number[]) => {
      const numbers = (key: string) => ((table[key] ?? ["0", "0"]) as string[]).map(Number.parseFloat) as number[];
      const [u, v] = [x! - numbers("about")[0]!, y! - numbers("about")[1]!];
      const [sx, sy] = numbers("slope") as [number, number];
      const [xx, xy, yy] = numbers("bend") as [number, number, number];
      return 7 + sx * u + sy * v + (xx * u * u + 2 * xy * u * v + yy * v * v) / 2;
    };
    for (const isometry of [rotation(37, [1, 2]), reflection([0, 1], [2, 2]), translation([3, -1])]) {
      const image = transformTable(load, isometry);
      for (const place of [
        [0.3, 0.8],
        [2, 1],
        [-1, 4],
      ] as const)
        expect(pressure(image, applyTo(isometry, place))).toBeCloseTo(pressure(load, place), 6);
    }
  });
  it("is a polygon if it was a rectangle, and its arcs bend the other way in a mirror", () => {
    const shape = { kind: "rectangle", x: ["0 m", "2 m"], y: ["0 m", "1 m"] };
    expect(transformTable(shape, rotation(90, [0, 0]))).toEqual({
      kind: "rectangle",
      x: ["-1 m", "0 m"],
      y: ["0 m", "2 m"],
    });
    const load = { kind: "patch", q: "1 kPa", x: shape.x, y: shape.y };
    expect(transformTable(load, rotation(45, [0, 0]))).toEqual({
      kind: "area",
      q: "1 kPa",
      shape: {
        kind: "polygon",
        points: [
          ["0 m", "0 m"],
          ["1.414213562 m", "1.414213562 m"],
          ["0.707106781 m", "2.121320344 m"],
          ["-0.707106781 m", "0.707106781 m"],
        ],
      },
    });
    const polygon = { kind: "polygon", points: [["1 m", "0 m"]], bulges: [0.5, 0] };
    expect(transformTable(polygon, reflection([0, 0], [0, 1]))).toEqual({
      ...polygon,
      points: [["-1 m", "0 m"]],
      bulges: [-0.5, 0],
    });
  });
  it("of a circle without a center moves away from the origin", () => {
    expect(transformTable({ kind: "circle", radius: "1 m" }, translation([1, 2]))).toEqual({
      kind: "circle",
      radius: "1 m",
      centre: ["1 m", "2 m"],
    });
  });
  it("of a pattern that stands has another direction, and no mirror image", () => {
    const move = { pattern: "rack", points: [["1 m", "0 m"]], turn: 30 };
    expect(transformTable(move, rotation(90, [0, 0]))).toEqual({ ...move, points: [["0 m", "1 m"]], turn: 120 });
    expect(() => transformTable(move, reflection([0, 0], [1, 0]))).toThrow("mirrored");
  });
  it("turns axes of the building, and mirrors none", () => {
    const rays = { kind: "ray", first: "1", centre: ["1 m", "0 m"], angles: [0, 300] };
    const turned = { ...rays, centre: ["0 m", "1 m"], angles: [90, 30] };
    expect(transformTable(rays, rotation(90, [0, 0]))).toEqual(turned);
    const straight = { kind: "straight", first: "A", distances: "6 m", origin: ["1 m", "0 m"] };
    expect(transformTable(straight, rotation(90, [0, 0]))).toEqual({ ...straight, origin: ["0 m", "1 m"], angle: 90 });
    expect(() => transformTable(rays, reflection([0, 0], [1, 0]))).toThrow("mirrored");
  });
});

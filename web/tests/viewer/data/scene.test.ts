import { describe, expect, it } from "vitest";
import { decodeGzipBase64, decodeScene, readValues, SceneError } from "../../../src/viewer/data/scene";
import { grid, Packer, packedScene } from "../synthetic";

const mesh = grid(2, 1);
const buffer = packedScene(mesh, [{ name: "A", fields: { settlement: (x) => 10 * x } }]);

describe("a packed scene", () => {
  it("gives back mesh and values as they were packed", () => {
    const scene = decodeScene(buffer);
    expect(scene.mesh.nodes).toEqual(mesh.nodes);
    expect(scene.mesh.elements).toEqual(mesh.elements);
    expect(scene.mesh.nodeCount).toBe(15);
    expect(scene.mesh.elementCount).toBe(2);
    const settlement = readValues(scene, scene.head.combinations[0]!.values!.settlement!);
    expect(settlement[2]).toBe(5);
  });

  it("measures nodes from an origin, so that they keep their digits far away", () => {
    const packer = new Packer();
    const blocks = {
      nodes: packer.add(mesh.nodes, "f32", [15, 2]),
      elements: packer.add(mesh.elements, "u32", [2, 9]),
    };
    const { head } = decodeScene(buffer);
    const scene = decodeScene(packer.packed({ ...head, mesh: { origin: [32_450_000, 5_400_000], ...blocks } }));
    expect(scene.mesh.nodes[2]).toBe(32_450_000.25);
    expect(scene.mesh.nodes[3]).toBe(5_400_000);
  });

  it("reads every type of number with its scale and shift", () => {
    const packer = new Packer();
    const mesh = grid(1, 1);
    const blocks = { nodes: packer.add(mesh.nodes, "f32", [9, 2]), elements: packer.add(mesh.elements, "u16", [1, 9]) };
    const wanted = [
      packer.add([1, 3, 100], "u8", [3], 0.5, 1),
      packer.add([-7, 2.5, 1000], "u16", [3], 0.25, -7),
      packer.add([0, 70000], "u32", [2]),
      packer.add([-5, 6], "i32", [2]),
      packer.add([1.5, -2.25], "f32", [2], 2, 1),
    ];
    const scene = decodeScene(
      packer.packed({
        format: 3,
        title: "",
        version: "",
        mesh: blocks,
        fields: [],
        combinations: [],
        left_out: [],
        plan: {
          bounds: [0, 0, 1, 1],
          outline: [],
          openings: [],
          zones: [],
          columns: [],
          supports: [],
          loads: [],
          boreholes: [],
          soil_zones: [],
          voids: [],
          lines: [],
          strips: [],
          points: [],
        },
      }),
    );
    expect(scene.mesh.elements).toEqual(mesh.elements);
    expect(wanted.map((each) => [...readValues(scene, each)])).toEqual([
      [1, 3, 100],
      [-7, 2.5, 1000],
      [0, 70000],
      [-5, 6],
      [4, -3.5],
    ]);
    // 2 (1, 3, 100) - 10 (4, -3.5), node by node; the other nodes have none
    const sum = readValues(scene, {
      sum: [
        [2, wanted[0]!],
        [-10, wanted[4]!],
      ],
    });
    expect([...sum]).toEqual([-38, 41, 200, 0, 0, 0, 0, 0, 0]);
  });

  it("says in words what is wrong with it", () => {
    expect(() => decodeScene(new ArrayBuffer(0))).toThrow(SceneError);
    expect(() => decodeScene(buffer.slice(0, 40))).toThrow("incomplete");
    expect(
      () =>
        decodeScene(buffer.slice(0, buffer.byteLength - 200)).mesh &&
        readValues(
          decodeScene(buffer.slice(0, buffer.byteLength - 200)),
          decodeScene(buffer).head.combinations[0]!.values!.contact!,
        ),
    ).toThrow("incomplete");
    expect(() => decodeScene(packedScene(mesh, [], { format: 1 }))).toThrow("format 1");
    expect(() => decodeScene(packedScene({ ...mesh, elements: mesh.elements.map((node) => node + 1) }, []))).toThrow(
      "damaged",
    );
  });

  it("comes out of a report's text", async () => {
    const zipped = await new Response(
      new Blob([buffer]).stream().pipeThrough(new CompressionStream("gzip")),
    ).arrayBuffer();
    const text = btoa(String.fromCharCode(...new Uint8Array(zipped))).replace(/(.{76})/g, "$1\n");
    expect((await decodeGzipBase64(`\n${text}\n`)).mesh.nodes).toEqual(mesh.nodes);
    await expect(decodeGzipBase64(btoa("not gzip"))).rejects.toThrow("damaged");
  });
});

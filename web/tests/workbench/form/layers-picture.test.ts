// @vitest-environment happy-dom
// The picture of the ground's layers.
import { beforeEach, describe, expect, it, vi } from "vitest";
import { layersToDraw } from "../../../src/workbench/form/layers-picture";
import { Page } from "../form-page";

beforeEach(() => void vi.useFakeTimers());

const LAYERS = [
  { E: "10 MPa", nu: 0.3, thickness: "1 m" },
  { E: "20 MPa", E_bottom: "40 MPa", nu: 0.3, thickness: "300 cm" },
];

describe("the layers of the ground", () => {
  it("are as high as they are thick, with a half-space below", () => {
    const drawn = layersToDraw({ kind: "continuum", layers: LAYERS, half_space: { E: "60 MPa", nu: 0.3 } });
    expect(drawn.map((each) => each.label)).toEqual([
      "E = 10 MPa, 1 m",
      "E = 20 MPa to 40 MPa, 300 cm",
      "E = 60 MPa, half-space",
    ]);
    expect((drawn[1]?.height ?? 0) / (drawn[0]?.height ?? 1)).toBeCloseTo(3);
    expect(drawn.map((each) => each.endless)).toEqual([false, false, true]);
  });

  it("are not drawn while a thickness is no length, or there are none", () => {
    expect(layersToDraw({ kind: "vlasov", layers: [{ E: "10 MPa", nu: 0.3, thickness: "deep" }] })).toEqual([]);
    expect(layersToDraw({ kind: "continuum" })).toEqual([]);
  });

  it("stand in the form of ground that has them", () => {
    const page = new Page({ ground: { kind: "vlasov", layers: LAYERS } });
    page.show(["ground"]);
    expect(document.querySelectorAll(".layers rect")).toHaveLength(2);
    expect(document.querySelectorAll(".layers .base")).toHaveLength(1);
  });
});

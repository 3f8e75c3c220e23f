import { describe, expect, it } from "vitest";
import { bandOf, makeScale } from "../../../src/viewer/data/color-scale";
import { Camera } from "../../../src/viewer/plan/camera";
import { type Picture, sideColor, type View } from "../../../src/viewer/renderer/renderer";
import { colorize, rasterize } from "../../../src/viewer/renderer/software-renderer";
import { paletteOf } from "../../../src/viewer/shared/palette";
import { grid, nodal, trianglesOf } from "../synthetic";

const NOTHING = 255;
/** A view from above. */
function viewOf(seen: { x: number; y: number; scale: number }, width: number, height: number): View {
  const camera = Object.assign(new Camera(), seen, { width, height });
  return { camera: camera.lookDown(), width, height, ratio: 1, scale: seen.scale, exaggeration: 0, box: camera.box };
}

const of0 = (x: number, y: number) => 3 * x - 2 * y;

describe("drawing without a graphics card", () => {
  const mesh = grid(
    5,
    4,
    (x, y) => [10 * x + 2 * y, 8 * y],
    (i, j) => !(i === 2 && j === 2),
  );
  const of = of0;
  const values = nodal(mesh, of);
  const scale = makeScale(-16, 36, true);
  const contact = nodal(mesh, (x) => x - 6);
  const picture: Picture = { values, contact, settlement: null, scale, lines: false, mesh: false };
  const camera = { x: 6, y: 4, scale: 20 };
  const [width, height] = [300, 200];
  const faces = trianglesOf(mesh);
  const raster = rasterize(mesh, faces, [[0, faces.length]], picture, viewOf(camera, width, height));
  const placeOf = (i: number) =>
    [
      camera.x + ((i % width) + 0.5 - width / 2) / camera.scale,
      camera.y - (Math.floor(i / width) + 0.5 - height / 2) / camera.scale,
    ] as const;

  it("fills the plate and nothing else, every pixel with its band", () => {
    let wrong = 0;
    for (let i = 0; i < width * height; i++) {
      const [x, y] = placeOf(i);
      const [u, v] = [(x - y / 4) / 10, y / 8];
      const hole = u > 0.4 && u < 0.6 && v > 0.5 && v < 0.75;
      const plate = u > 0 && u < 1 && v > 0 && v < 1 && !hole;
      const wanted = plate ? bandOf(scale, of(x, y)) : NOTHING;
      if (raster.bands[i] !== wanted) wrong += 1;
    }
    // pixels whose center lies on a limit may go either way
    expect(wrong).toBeLessThan(0.001 * width * height);
  });

  it("draws a plate in a national grid as it draws one near the origin", () => {
    const [dx, dy] = [32_450_000, 5_400_000];
    const far = {
      ...mesh,
      origin: [dx, dy] as [number, number],
      nodes: mesh.nodes.map((v, i) => v + (i % 2 ? dy : dx)),
    };
    const view = viewOf({ x: camera.x + dx, y: camera.y + dy, scale: camera.scale }, width, height);
    const { bands } = rasterize(far, faces, [[0, faces.length]], picture, view);
    const wrong = bands.filter((band, i) => band !== raster.bands[i]).length;
    expect(wrong).toBeLessThan(0.001 * width * height);
  });

  it("leaves no pixel between neighboring triangles", () => {
    // sides through the very middle of pixels, where rounding decides
    const plain = grid(30, 20, (x, y) => [30 * x, 20 * y]);
    const all = trianglesOf(plain);
    const of = { ...picture, values: nodal(plain, of0), contact: null };
    for (const zoom of [18.33, 18.7, 19.07, 19.44, 31.7])
      for (const x of [15, 15 + 23 / zoom]) {
        const { bands } = rasterize(plain, all, [[0, all.length]], of, viewOf({ x, y: 10, scale: zoom }, 200, 200));
        expect(bands.indexOf(NOTHING)).toBe(-1);
      }
  });

  it("knows where the plate has lifted", () => {
    for (let i = 0; i < width * height; i++) {
      const [x] = placeOf(i);
      if (raster.bands[i] !== NOTHING && Math.abs(x - 6) > 1e-3) expect(raster.lifted![i]).toBe(x > 6 ? 1 : 0);
    }
  });

  it("draws sides of elements that stand out from the middle of the scale", () => {
    for (const [of, low] of [
      [makeScale(-1, 1, true), 255],
      [makeScale(0, 1, false), 0],
    ] as const) {
      const middle = of.colors[of.diverging ? Math.floor(of.colors.length / 2) : 0]!;
      expect(Math.abs(middle[0] - low)).toBeLessThan(100);
      expect(Math.abs(sideColor(of)[0] - middle[0])).toBeGreaterThan(150);
    }
  });

  it("colors the bands, and leaves the rest clear", () => {
    const pixels = colorize({ ...raster, lifted: null }, picture, viewOf(camera, width, height), paletteOf("light"));
    for (let i = 0; i < width * height; i += 7) {
      const [x] = placeOf(i);
      const band = raster.bands[i]!;
      expect(pixels[4 * i + 3]).toBe(band === NOTHING ? 0 : 255);
      if (band !== NOTHING && x < 5.8) expect([...pixels.subarray(4 * i, 4 * i + 3)]).toEqual(scale.colors[band]);
    }
  });
});

// The renderer that suits the computer.
import type { FieldRenderer } from "./renderer";
import { SoftwareRenderer } from "./software-renderer";
import { WebglRenderer } from "./webgl-renderer";

/** Return a renderer, whose edges a graphics card smooths if `antialias`; if the graphics card is lost later, `onLost` is called with one that takes its place. */
export function createRenderer(antialias: boolean, onLost: (replacement: FieldRenderer) => void): FieldRenderer {
  try {
    const webgl = new WebglRenderer(antialias);
    webgl.canvas.addEventListener("webglcontextlost", () => {
      const software = new SoftwareRenderer();
      webgl.canvas.replaceWith(software.canvas);
      onLost(software);
    });
    return webgl;
  } catch {
    return new SoftwareRenderer();
  }
}

// Colors of what canvases draw, which style sheets do not reach; those that theme.css has too are the same there.
import type { Theme } from "./theme";

export type Rgb = [number, number, number]; // 0 .. 255

export interface Palette {
  paper: string;
  ink: string;
  ink2: string;
  line: string;
  halo: string; // behind text over a picture
  hatch: string; // where there is no contact
}

const PALETTES: Record<Theme, Palette> = {
  light: {
    paper: "#ffffff",
    ink: "#1b1f23",
    ink2: "#545c66",
    line: "#d3d8dd",
    halo: "rgb(255 255 255 / 0.85)",
    hatch: "#404040",
  },
  dark: {
    paper: "#16191d",
    ink: "#e6e9ec",
    ink2: "#a7b0ba",
    line: "#343a42",
    halo: "rgb(16 19 23 / 0.85)",
    hatch: "#c8d0d8",
  },
};

export function paletteOf(theme: Theme): Palette {
  return PALETTES[theme];
}

/** Return the parts, 0 .. 255, of a color written as #rrggbb. */
export function rgbOf(color: string): Rgb {
  return [1, 3, 5].map((at) => Number.parseInt(color.slice(at, at + 2), 16)) as Rgb;
}

export const FONT =
  'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "Liberation Sans", "DejaVu Sans", sans-serif';

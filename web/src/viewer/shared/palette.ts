// The colours that canvases are drawn with: the style sheet's do not reach into them.
import type { Rgb } from "../data/color-scale";
import type { Theme } from "./theme";

export interface Look {
  paper: string;
  ink: string;
  ink2: string;
  line: string;
  halo: string; // behind text over a picture
  hatch: string; // where there is no contact
  load: string;
  support: string;
  soil: string;
  section: string;
  accent: string;
}

const LIGHT: Look = {
  paper: "#ffffff",
  ink: "#1b1f23",
  ink2: "#545c66",
  line: "#d3d8dd",
  halo: "rgb(255 255 255 / 0.85)",
  hatch: "#404040",
  load: "#b3135f",
  support: "#16703a",
  soil: "#7a5a1e",
  section: "#0b5fa5",
  accent: "#0b5fa5",
};
const DARK: Look = {
  paper: "#16191d",
  ink: "#e6e9ec",
  ink2: "#a7b0ba",
  line: "#343a42",
  halo: "rgb(16 19 23 / 0.85)",
  hatch: "#c8d0d8",
  load: "#ff7eb6",
  support: "#6fce8d",
  soil: "#d2ac69",
  section: "#6fb3ef",
  accent: "#6fb3ef",
};

/** Return the parts, 0 .. 255, of a colour written as #rrggbb. */
export function rgbOf(colour: string): Rgb {
  return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)) as Rgb;
}

export function look(theme: Theme): Look {
  return theme === "dark" ? DARK : LIGHT;
}

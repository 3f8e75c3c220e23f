// Icons of the tools.
import { lineIcon } from "../controls/icons";
import type { GeneratorName } from "./generators/generator";
import type { ToolName } from "./tools";

const PATHS: Record<ToolName | GeneratorName, string> = {
  select: "M4 2l8 7-4 .6L10.3 14l-1.8.8-2.2-4.3L4 13z",
  slab: "M2 4h12v8H2z",
  opening: "M2 3h12v10H2zM5.5 6h5v4h-5zM5.5 6l5 4M10.5 6l-5 4",
  zone: "M2 4h12v8H2zM7 4v8M9 12l5-5M7 11l7-7M7 7.5L10.5 4",
  column: "M5 5h6v6H5zM5 5l6 6M11 5l-6 6",
  "point load": "M8 2v10M5 9l3 4 3-4M3 14.5h10",
  "line load": "M2 3h12M3 3v8M8 3v8M13 3v8M2 13h12M1.8 9L3 11.5 4.2 9M6.8 9L8 11.5 9.2 9M11.8 9l1.2 2.5L14.2 9",
  "area load": "M2 5l3-2h9l-3 2zM2 5v7l9 .0V5M11 12l3-2V3M4.5 7v3M8 7v3",
  support: "M8 3l5 8H3zM2 13.5h12",
  wall: "M1 6h14v4H1zM4 10l4-4M8 10l4-4",
  beam: "M1 6h3M6 6h4M12 6h3M1 10h3M6 10h4M12 10h3",
  "line support": "M2 5h12M3 9l3-4M7 9l3-4M11 9l3-4",
  borehole: "M8 2a6 6 0 1 0 .01 0M8 2v12M2 8h12",
  "soil zone": "M2 4h12v8H2zM4 7h2M8 6h2M11 9h2M5 10h2",
  void: "M2 5h3c0 7 6 7 6 0h3M2 13h12",
  plate: "M1 5h6v6H1zM9 5h6v6H9z",
  joint: "M2 4h5v8H2zM9 4h5v8H9zM8 1v3M8 6.5v3M8 12v3",
  refinement: "M2 3h12v10H2zM8 3v10M2 8h12M8 5.5h6M11 3v5",
  racks: "M2 4h2v2H2zM7 4h2v2H7zM12 4h2v2h-2zM2 10h2v2H2zM7 10h2v2H7zM12 10h2v2h-2z",
  vehicle: "M2 5h7v6H2zM9 7h3l2 2v2H9zM5 11a1.5 1.5 0 1 0 .01 0M11.5 11a1.5 1.5 0 1 0 .01 0",
  columns: "M4 1v14M12 1v14M1 5h14M1 11h14M3 4h2v2H3zM11 4h2v2h-2zM3 10h2v2H3zM11 10h2v2h-2z",
  axes: "M5 5v10M11 5v10M2 10h12M5 1a2 2 0 1 0 .01 0M11 1a2 2 0 1 0 .01 0",
  "edge wall": "M2 14V3h12M5 14V6h9",
  strip: "M2 11L13 3M4 14L15 6",
  "section line": "M2 12L14 4M1 10.5l2.2 3M12.8 2.5l2.2 3",
};

export function toolIcon(name: ToolName | GeneratorName): SVGSVGElement {
  return lineIcon(PATHS[name]);
}

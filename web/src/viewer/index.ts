// All that pages use of the view library.

export { number } from "./data/color-scale";
export * from "./data/fields";
export { Locator, type Spot } from "./data/point-location";
export * from "./data/scene";
export { fillCombinations, fillFields } from "./panels/controls";
export { Legend } from "./panels/legend";
export { type Section, SectionChart } from "./panels/section-chart";
export { sectionText, ValuePanel } from "./panels/value-panel";
export { Viewer, type ViewerOptions } from "./panels/viewer";
export type { Layers } from "./plan/overlay";
export { PlanView, type Range, type Shown, type Tool } from "./plan/plan-view";
export { make, symbol, symbolText } from "./shared/dom";
export { onTheme, setTheme, startTheme, type Theme, theme } from "./shared/theme";
export { SpaceView } from "./space/space-view";

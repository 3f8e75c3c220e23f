// All that pages use of the view library.
export * from "./data/scene";
export * from "./data/fields";
export { Locator, type Spot } from "./data/point-location";
export { PlanView, type Range, type Shown, type Tool } from "./plan/plan-view";
export type { Layers } from "./plan/overlay";
export { SpaceView } from "./space/space-view";
export { SectionChart, type Section } from "./panels/section-chart";
export { Legend } from "./panels/legend";
export { ValuePanel, sectionText } from "./panels/value-panel";
export { fillCombinations, fillFields } from "./panels/controls";
export { number } from "./data/color-scale";
export { make, symbol, symbolText } from "./shared/dom";
export { onTheme, setTheme, startTheme, theme, type Theme } from "./shared/theme";
export { Viewer, type ViewerOptions } from "./panels/viewer";

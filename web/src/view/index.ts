// All that pages use of the view library.
export * from "./scene";
export * from "./fields";
export { Locator, type Spot } from "./locate";
export { PlanView, type Range, type Shown, type Tool } from "./plan-view";
export type { Layers } from "./overlay";
export { SpaceView } from "./space-view";
export { SectionChart, type Section } from "./section-chart";
export { Legend } from "./legend";
export { ValuePanel, sectionText } from "./value-panel";
export { fillCombinations, fillFields } from "./controls";
export { number } from "./scale";
export { make, symbol, symbolText } from "./dom";
export { onTheme, setTheme, startTheme, theme, type Theme } from "./theme";
export { Viewer, type ViewerOptions } from "./viewer";

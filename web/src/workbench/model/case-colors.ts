// The color of each load case: by its position among the cases, the same in the plan and in tables; no key of the file.

/** The first color is that of loads without a case. */
const COLORS = 8;

/** Return the color of the case at a position; the colors of the theme come again after the last. */
export function caseColor(position: number): string {
  const n = Math.max(0, position) % COLORS;
  return n === 0 ? "var(--gs-load)" : `var(--gs-case-${n})`;
}

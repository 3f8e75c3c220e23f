// Where a box of text stands beside what it is about.

/** Left, top, width, height. */
export type Box = readonly [number, number, number, number];

const GAP = 14;

/**
 * Return left and top of a box beside a control, within the window: to its right, else below, above or to its left;
 * where none of these has room, or without a control, in the middle.
 */
export function placeBeside(
  control: { left: number; top: number; right: number; bottom: number } | null,
  [width, height]: readonly [number, number],
  [screenWidth, screenHeight]: readonly [number, number],
): [left: number, top: number] {
  const middle: [number, number] = [(screenWidth - width) / 2, (screenHeight - height) / 2];
  if (!control) return middle;
  const keepIn = (value: number, size: number, screen: number) => Math.max(GAP, Math.min(value, screen - size - GAP));
  const across = keepIn(control.top, height, screenHeight);
  const along = keepIn(control.left, width, screenWidth);
  if (control.right + GAP + width <= screenWidth - GAP) return [control.right + GAP, across];
  if (control.bottom + GAP + height <= screenHeight - GAP) return [along, control.bottom + GAP];
  if (control.top - GAP - height >= GAP) return [along, control.top - GAP - height];
  if (control.left - GAP - width >= GAP) return [control.left - GAP - width, across];
  return middle;
}

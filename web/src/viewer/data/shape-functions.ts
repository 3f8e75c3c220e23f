// Shape functions of the nine-node quadrilateral. Node order: the corners (-1,-1), (1,-1), (1,1), (-1,1), the midsides
// (0,-1), (1,0), (0,1), (-1,0), the center (0,0).

/** Place of each node on the 3 x 3 grid of one-dimensional nodes (-1, 0, 1). */
const COLUMN = [0, 2, 2, 0, 1, 2, 1, 0, 1] as const;
const ROW = [0, 0, 2, 2, 0, 1, 2, 1, 1] as const;

/** The eight triangles of a nine-node quadrilateral: all meet in its center, two along each side. */
export const TRIANGLES = [0, 4, 8, 4, 1, 8, 1, 5, 8, 5, 2, 8, 2, 6, 8, 6, 3, 8, 3, 7, 8, 7, 0, 8] as const;

/** Two triangles of its corners alone. */
export const CORNERS = [0, 1, 2, 0, 2, 3] as const;

/** The nodes of an element's four sides: end, end, middle. */
export const SIDES = [
  [0, 1, 4],
  [1, 2, 5],
  [2, 3, 6],
  [3, 0, 7],
] as const;

function lagrange(xi: number): [number, number, number] {
  return [(xi * (xi - 1)) / 2, 1 - xi * xi, (xi * (xi + 1)) / 2];
}

function lagrangeDerivatives(xi: number): [number, number, number] {
  return [xi - 0.5, -2 * xi, xi + 0.5];
}

/** Return the nine shape functions at (xi, eta). */
export function shapeFunctions(xi: number, eta: number): number[] {
  const x = lagrange(xi);
  const y = lagrange(eta);
  return COLUMN.map((column, a) => x[column] * y[ROW[a]!]!);
}

/** Return the derivatives of the nine shape functions with respect to xi and to eta. */
export function shapeDerivatives(xi: number, eta: number): [number[], number[]] {
  const [x, y, dx, dy] = [lagrange(xi), lagrange(eta), lagrangeDerivatives(xi), lagrangeDerivatives(eta)];
  return [COLUMN.map((column, a) => dx[column] * y[ROW[a]!]!), COLUMN.map((column, a) => x[column] * dy[ROW[a]!]!)];
}

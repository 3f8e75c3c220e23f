// Lengths in the unit that pictures show them in: meters, or what the case asks for.
import type { Lengths, Plan } from "./scene";

export const METERS: Lengths = { unit: "m", per_meter: 1, small: "mm", small_per_meter: 1000 };

export function lengthsOf(plan: Plan | null | undefined): Lengths {
  return plan?.lengths ?? METERS;
}

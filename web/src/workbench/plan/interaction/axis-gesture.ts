// Dragging an axis of the building: a straight one sideways, a ray about its center, a ring outwards.

import { distanceBetween } from "../../../viewer/data/points";
import { say, verbatim } from "../../../viewer/shared/language";
import { type Axis, axesIn, parseDistances } from "../../model/axes";
import { angleEdits, axisEdits } from "../../model/changes/attachment";
import type { Change, Edit } from "../../model/edits";
import type { Point } from "../../model/geometry";
import { samePath, type Table, tableAt, valueAt } from "../../model/paths";
import { formatDecimals, parseTyped, replaceDecimalComma } from "../../model/quantities";
import { roundTo } from "./snapping";

const WHOLE = 1; // degrees that rays are turned to
const FREE = { length: 1e-3, angle: 0.1 }; // m and degrees, without snapping

/** What is dragged and typed: the angle of a ray, the radius of a ring, the distance of a straight axis from its neighbor. */
export class AxisGesture {
  /** The edits that move it there, none as long as it has not moved. */
  edits: readonly Edit[] = [];
  /** Where it would be, in words. */
  text = "";
  private readonly before: number;

  constructor(
    private readonly data: Table,
    readonly axis: Axis,
    private readonly start: Point,
  ) {
    this.before = this.valueBefore();
  }

  /** Move to a place of the pointer, to round lengths of a step [m] or whole degrees; returns whether that is possible. */
  moveTo(to: Point, step: number, free: boolean): boolean {
    const value = this.before + this.wayTo(to);
    return this.take(roundTo(value, this.axis.ray ? (free ? FREE.angle : WHOLE) : free ? FREE.length : step));
  }

  /** Move to a value that was typed; returns whether it is one. */
  type(text: string): boolean {
    const value = this.axis.ray ? parseAngle(text) : parseTyped(text);
    return value !== null && this.take(value);
  }

  /** Return the change that was made, null for none. */
  change(): Change | null {
    const { name, ray } = this.axis;
    const text = ray
      ? say("turn axis {name}", { name: verbatim(name) })
      : say("move axis {name}", { name: verbatim(name) });
    return this.edits.length > 0 ? { edits: [...this.edits], text } : null;
  }

  /** Return why what was typed is no value, in words. */
  refusal(typed: string): string {
    return this.axis.ray
      ? say('Found "{typed}", expected an angle such as 30.', { typed: verbatim(typed) })
      : say('Found "{typed}", expected a length such as 3.5 that ends before the next axis.', {
          typed: verbatim(typed),
        });
  }

  private take(value: number): boolean {
    const { axis, data } = this;
    const edits = axis.ray ? angleEdits(data, axis, value) : axisEdits(data, axis, this.shiftTo(value));
    if (!edits) return false;
    this.edits = value === this.before ? [] : edits;
    this.text = this.describe(value);
    return true;
  }

  /** Return by how much a value moves the axis to where the family counts on, or outwards [m]. */
  private shiftTo(value: number): number {
    return this.isFirst ? this.before - value : value - this.before;
  }

  /** Whether it is the first of straight axes, whose distance is that to the next one. */
  private get isFirst(): boolean {
    return this.axis.direction !== null && this.axis.position === 0;
  }

  private valueBefore(): number {
    const { axis, data } = this;
    if (axis.ray) return Number(valueAt(data, [...axis.path, "angles", axis.position]) ?? 0);
    if (!axis.direction) return axis.radius;
    const distances = parseDistances(tableAt(data, axis.path).distances) ?? [];
    return distances[Math.max(0, axis.position - 1)] ?? 0;
  }

  /** Return by how much the pointer has changed the value. */
  private wayTo(to: Point): number {
    const { axis, start } = this;
    const { place, direction } = axis;
    if (axis.ray) {
      const turn = ((angleAt(place, to) - angleAt(place, start) + 540) % 360) - 180;
      return turn;
    }
    if (!direction) return distanceBetween([...place], to) - distanceBetween([...place], start);
    const across = (to[0] - start[0]) * direction[1] - (to[1] - start[1]) * direction[0];
    return this.isFirst ? -across : across;
  }

  /** Return a value with what it is of, in symbols. */
  private describe(value: number): string {
    const { axis, data } = this;
    if (axis.ray) return `${axis.name}: ${formatDecimals(value, 3)}°`;
    const length = `${formatDecimals(value, 3)} m`;
    if (!axis.direction) return `${axis.name}: R = ${length}`;
    const family = axesIn(data).filter(({ path }) => samePath(path, axis.path));
    const first = this.isFirst ? 0 : axis.position - 1;
    return `${family[first]!.name} – ${family[first + 1]!.name}: ${length}`;
  }
}

function angleAt([x, y]: readonly [number, number], to: Point): number {
  return (Math.atan2(to[1] - y, to[0] - x) * 180) / Math.PI;
}

function parseAngle(text: string): number | null {
  const value = Number(replaceDecimalComma(text.trim().replace(/\s*(°|deg)$/, "")) || Number.NaN);
  return Number.isFinite(value) && Math.abs(value) <= 360 ? value : null;
}

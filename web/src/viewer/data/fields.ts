// Fields of a scene: basic ones as they were packed, derived ones, and envelopes over combinations.
import { ALL_LOADS, say, translate, verbatim } from "../shared/language";
import type { LocalPoint, Locator } from "./point-location";
import { type Combination, type Extreme, type Field, readValues, type Scene } from "./scene";

/** A combination by its index in the head, or an envelope over all certified combinations (of one limit state). */
export type Choice = number | Envelope;
export type Envelope = "largest" | "smallest" | `largest:${string}` | `smallest:${string}`;

/** A field that can be shown, of the scene or derived of its moments. */
export interface FieldInfo extends Field {
  derived: boolean;
}

/** The field whose sign distinguishes contact (negative) from gap; never offered as a field. */
export const CONTACT = "contact";
const MOMENTS = ["moment_x", "moment_y", "moment_xy"] as const;
type Moments = [mx: number, my: number, mxy: number];

/** A moment derived from m_x, m_y and m_xy. */
interface DerivedField extends Pick<Field, "name" | "symbol" | "meaning"> {
  of: (...moments: Moments) => number;
}

const designField = (face: string, axis: string, of: DerivedField["of"]): DerivedField => ({
  name: `${face}_${axis}`,
  symbol: `m_${axis} ${face}`,
  get meaning() {
    return say("design moment {face} {axis}, for reinforcement along {axis} (Wood and Armer)", { face, axis });
  },
  of,
});

/** The derived moments; names as in the tables. */
const DERIVED: readonly DerivedField[] = [
  { name: "m_1", symbol: "m_1", meaning: "larger principal moment", of: (...m) => principalMoments(...m)[0] },
  { name: "m_2", symbol: "m_2", meaning: "smaller principal moment", of: (...m) => principalMoments(...m)[1] },
  designField("bottom", "x", (...m) => designMoments(...m)[0]),
  designField("bottom", "y", (...m) => designMoments(...m)[1]),
  designField("top", "x", (mx, my, mxy) => 0 - designMoments(-mx, -my, mxy)[0]),
  designField("top", "y", (mx, my, mxy) => 0 - designMoments(-mx, -my, mxy)[1]),
];

/** Whether a scene is the difference of two results, all of whose fields are given. */
export function isDifference(scene: Scene): boolean {
  return scene.head.difference !== undefined;
}

/** Return the fields that can be shown: those of the scene, then what is derived of the moments. */
export function fieldsOf(scene: Scene): FieldInfo[] {
  const basic = scene.head.fields
    .filter((field) => field.name !== CONTACT)
    .map((field) => ({ ...field, derived: false }));
  if (isDifference(scene)) return basic;
  const moment = basic.find((field) => field.name === MOMENTS[0]);
  if (!moment || !MOMENTS.every((name) => basic.some((field) => field.name === name))) return basic;
  const averaged = "derived from m_x, m_y and m_xy at the nodes";
  const common = { unit: moment.unit, averaged, signed: true, derived: true };
  return [...basic, ...DERIVED.map(({ name, symbol, meaning }) => ({ name, symbol, meaning, ...common }))];
}

/** The groups of fields in their order, and how the names of their fields begin. */
const GROUPS: readonly (readonly [label: string, starts: RegExp])[] = [
  ["Deformation", /^(settlement|rotation)/],
  ["Contact", /^(pressure|line_force|gap|penetration)/],
  ["Moments and shear", /^(moment|shear)/],
  ["Derived moments", new RegExp(`^(${DERIVED.map(({ name }) => name).join("|")})$`)],
  ["Reinforcement", /^(required|provided|utilization|missing)/],
  ["Analysis", /^/],
];

/** Return fields in groups, those that are empty left out; a field belongs to the first group that fits. */
export function groupFields(fields: readonly FieldInfo[]): [label: string, fields: FieldInfo[]][] {
  const groupOf = ({ name }: FieldInfo) => GROUPS.find(([, starts]) => starts.test(name))?.[0];
  return GROUPS.map(([label]): [string, FieldInfo[]] => [
    label,
    fields.filter((each) => groupOf(each) === label),
  ]).filter(([, own]) => own.length > 0);
}

/** Where a field is smallest and largest: value, x, y. */
export interface FieldExtremes {
  min: Extreme;
  max: Extreme;
}

/** Return where a field of a combination or an envelope is smallest and largest at nodes. */
export function extremesOf(scene: Scene, choice: Choice, name: string): FieldExtremes {
  const of = nodalValues(scene, choice, name);
  const given = isEnvelope(choice) ? undefined : scene.head.combinations[choice]?.extremes[name];
  const { min, max, minNode, maxNode } = findExtremes(of);
  const at = (node: number): [number, number] => [scene.mesh.nodes[2 * node]!, scene.mesh.nodes[2 * node + 1]!];
  return { min: given?.min ?? [min, ...at(minNode)], max: given?.max ?? [max, ...at(maxNode)] };
}

/** Return the largest line force along the plate's edges in a combination or an envelope [kN/m], if there is any. */
export function lineForceOf(scene: Scene, choice: Choice): Extreme | null {
  const found = combinationsOf(scene, choice)
    .map((each) => scene.head.combinations[each]?.extremes.line_force?.max)
    .filter((each) => each !== undefined);
  return found.length ? found.reduce((most, each) => (each[0] > most[0] ? each : most)) : null;
}

/** Return what is known of a field by its name. */
export function fieldOf(scene: Scene, name: string): FieldInfo {
  const found = fieldsOf(scene).find((field) => field.name === name);
  if (!found) throw new RangeError(`no field ${name}`);
  return found;
}

/** Return the principal moments m_1 >= m_2 by Mohr's circle. */
export function principalMoments(mx: number, my: number, mxy: number): [number, number] {
  const [middle, radius] = [(mx + my) / 2, Math.hypot((mx - my) / 2, mxy)];
  return [middle + radius, middle - radius];
}

/** Return the direction of m_1, from x [degrees]. */
export function principalDirection(mx: number, my: number, mxy: number): number {
  return (Math.atan2(2 * mxy, mx - my) * 90) / Math.PI;
}

/** Return the design moments along x and y at the bottom, >= 0 (Wood 1968, Armer 1968), sagging positive. */
export function designMoments(mx: number, my: number, mxy: number): [number, number] {
  const twist = Math.abs(mxy);
  const [x, y] = [mx + twist, my + twist];
  // where one of them would be negative it is none, and the other grows by the twist that is left to it alone
  if (x < 0 && y < 0) return [0, 0];
  if (x < 0) return [0, Math.max(my + (mxy * mxy) / Math.abs(mx), 0)];
  if (y < 0) return [Math.max(mx + (mxy * mxy) / Math.abs(my), 0), 0];
  return [x, y];
}

/** Return one derived moment of m_x, m_y and m_xy. */
export function deriveMoment(name: string, ...moments: Moments): number {
  const field = DERIVED.find((each) => each.name === name);
  if (!field) throw new RangeError(`no derived field ${name}`);
  return field.of(...moments);
}

/** Whether a choice is an envelope. */
export function isEnvelope(choice: Choice): choice is Envelope {
  return typeof choice !== "number";
}

/** Return the indices of the combinations that an envelope goes over: certified, with values, of its limit state. */
export function combinationsOf(scene: Scene, choice: Choice): number[] {
  if (!isEnvelope(choice)) return [choice];
  const state = limitStateOf(choice);
  return scene.head.combinations.flatMap((each, i) =>
    each.values !== null && each.certified && (state === null || each.limit_state === state) ? [i] : [],
  );
}

/** Return the envelopes that a scene offers: none of one combination, one pair for each limit state that has several. */
export function envelopesOf(scene: Scene): Envelope[] {
  if (isDifference(scene)) return [];
  const all = combinationsOf(scene, "largest").map((i) => scene.head.combinations[i]!.limit_state);
  if (all.length < 2) return [];
  const states = [...new Set(all)];
  if (states.length === 1) return ["largest", "smallest"];
  const several = states.filter((state) => all.filter((each) => each === state).length > 1);
  return [...several.flatMap((state): Envelope[] => [`largest:${state}`, `smallest:${state}`]), "largest", "smallest"];
}

/** Return the name of a choice, in the language of the page; that of a combination stays as the user gave it. */
export function choiceName(scene: Scene, choice: Choice): string {
  const { combinations } = scene.head;
  if (isEnvelope(choice)) {
    const state = limitStateOf(choice);
    if (state === null) return translate(isLargest(choice) ? "max of all combinations" : "min of all combinations");
    return say(isLargest(choice) ? "max of all {state} combinations" : "min of all {state} combinations", { state });
  }
  const one = combinations[choice];
  if (!one) return "";
  const name = combinationName(scene, one);
  if (!one.minus) return name;
  const other = combinations.find((each) => each.name === one.minus);
  if (scene.head.difference === "combination")
    return say("{name} minus {other}", { name: verbatim(name), other: verbatim(combinationName(scene, other!)) });
  return one.minus === one.name
    ? say("{name} minus the reference", { name: verbatim(name) })
    : say("{name} minus {minus} of the reference", { name: verbatim(name), minus: verbatim(one.minus) });
}

/** Return what a combination is called, with its number if there are several. */
export function combinationName({ head: { combinations } }: Scene, { number, name }: Combination): string {
  if (combinations.length > 1) return `${number} ${name}`;
  return name === ALL_LOADS ? translate(name) : name;
}

/** Return a choice from its text, as a select element keeps it. */
export function parseChoice(text: string): Choice {
  return /^\d+$/.test(text) ? Number(text) : (text as Envelope);
}

/** Return nodal values of a field, of a combination or an envelope; kept for the next time. */
export function nodalValues(scene: Scene, choice: Choice, name: string): Float32Array {
  const key = `${choice} ${name}`;
  const kept = CACHES.get(scene) ?? new Map<string, Float32Array>();
  CACHES.set(scene, kept);
  const values =
    kept.get(key) ??
    (isEnvelope(choice) ? envelopeValues(scene, choice, name) : combinationValues(scene, choice, name));
  // the most lately used are kept longest
  kept.delete(key);
  kept.set(key, values);
  for (const [oldest, array] of kept) {
    if (sizeOf(kept) <= MOST_BYTES || array === values) break;
    kept.delete(oldest);
  }
  return values;
}

/** A value at a place, and the combination (index) that it comes from. */
export interface FieldValue {
  value: number;
  from: number;
}

/** Return the value of a field at a place: of a combination, or the extreme over an envelope's combinations there. */
export function fieldValueAt(
  scene: Scene,
  locator: Locator,
  choice: Choice,
  name: string,
  spot: LocalPoint,
): FieldValue {
  let found: FieldValue = { value: NaN, from: -1 };
  for (const from of combinationsOf(scene, choice)) {
    const value = interpolateField(scene, locator, from, name, spot);
    if (found.from < 0 || (isLargest(choice) ? value > found.value : value < found.value)) found = { value, from };
  }
  return found;
}

/** Return whether a place is in contact; in an envelope, whether it is in all of its combinations. */
export function isInContact(scene: Scene, locator: Locator, choice: Choice, spot: LocalPoint): boolean | null {
  if (!scene.head.fields.some((field) => field.name === CONTACT)) return null;
  return combinationsOf(scene, choice).every(
    (from) => locator.interpolate(nodalValues(scene, from, CONTACT), spot) < 0,
  );
}

/** Return the smallest and largest of nodal values and their nodes. */
export function findExtremes(of: Float32Array): { min: number; max: number; minNode: number; maxNode: number } {
  let [minNode, maxNode] = [0, 0];
  for (let i = 1; i < of.length; i++) {
    if (of[i]! < of[minNode]!) minNode = i;
    if (of[i]! > of[maxNode]!) maxNode = i;
  }
  return { min: of[minNode] ?? NaN, max: of[maxNode] ?? NaN, minNode, maxNode };
}

const MOST_BYTES = 256e6;
const CACHES = new WeakMap<Scene, Map<string, Float32Array>>();

function sizeOf(kept: Map<string, Float32Array>): number {
  return [...kept.values()].reduce((sum, array) => sum + array.byteLength, 0);
}

/** Whether a choice takes the largest of its combinations' values. */
export function isLargest(choice: Choice): boolean {
  return !isEnvelope(choice) || choice.startsWith("largest");
}

/** Return the limit state of an envelope, null for that of all combinations. */
function limitStateOf(choice: Envelope): string | null {
  const at = choice.indexOf(":");
  return at < 0 ? null : choice.slice(at + 1);
}

function isDerived(scene: Scene, name: string): boolean {
  return !isDifference(scene) && DERIVED.some((each) => each.name === name);
}

function combinationValues(scene: Scene, index: number, name: string): Float32Array {
  if (isDerived(scene, name)) {
    const [mx, my, mxy] = MOMENTS.map((moment) => nodalValues(scene, index, moment));
    const { of } = DERIVED.find((each) => each.name === name)!;
    return mx!.map((value, i) => of(value, my![i]!, mxy![i]!));
  }
  const of = scene.head.combinations[index]?.values?.[name];
  if (!of) throw new RangeError(`no values of ${name} in combination ${index}`);
  return readValues(scene, of);
}

function envelopeValues(scene: Scene, choice: Envelope, name: string): Float32Array {
  const of = combinationsOf(scene, choice);
  if (!of.length) throw new RangeError("no combination for this envelope");
  // a place counts as lifted if it is in any of the combinations
  const largest = name === CONTACT || isLargest(choice);
  const result = combinationValues(scene, of[0]!, name).slice();
  for (const index of of.slice(1)) {
    const other = combinationValues(scene, index, name);
    for (let i = 0; i < result.length; i++)
      if (largest ? other[i]! > result[i]! : other[i]! < result[i]!) result[i] = other[i]!;
  }
  return result;
}

function interpolateField(scene: Scene, locator: Locator, index: number, name: string, spot: LocalPoint): number {
  if (!isDerived(scene, name)) return locator.interpolate(nodalValues(scene, index, name), spot);
  const moments = MOMENTS.map((moment) => locator.interpolate(nodalValues(scene, index, moment), spot));
  return deriveMoment(name, ...(moments as Moments));
}

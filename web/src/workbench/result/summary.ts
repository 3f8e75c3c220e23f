// The figures of a combination that a reader wants first, and the certificates of all.

import { formatNumber } from "../../viewer/data/numbers";
import { button, fill, h } from "../../viewer/shared/dom";
import { keep, say, together, verbatim } from "../../viewer/shared/language";
import { symbolElement } from "../../viewer/shared/symbols";
import type { CombinationSummary, DesignCheck, Summary, SummaryRow } from "../client/api";
import type { Json } from "../model/paths";

/** The checks of the design, each with its utilization: what fails or needs attention comes first. */
function designOf(summary: Summary | null): HTMLElement[] {
  const design = summary?.design;
  if (!design) return [];
  const open = design.checks.some((check) => check.status === "fails" || check.status === "attention");
  const hanging = design.checks.some(hangs);
  const rows = design.checks.map((check) =>
    h(
      "tr",
      { class: check.status === "fails" ? "bad" : "" },
      h("th", { scope: "row" }, verbatim(check.name)),
      h("td", {}, check.utilization === null ? "" : check.utilization.toFixed(2)),
      h("td", { class: "unit" }, betweenText(check)),
      h(
        "td",
        { class: "note" },
        verbatim(check.words),
        hangs(check) ? h("strong", {}, verbatim(` ${check.verdict}`)) : "",
      ),
    ),
  );
  return [
    h("p", { class: open ? "verdict bad" : hanging ? "verdict doubtful" : "quiet" }, verbatim(design.headline)),
    ...(rows.length ? [h("table", { class: "figures" }, h("tbody", {}, ...rows))] : []),
  ];
}

function hangs(check: DesignCheck): boolean {
  return check.verdict !== check.status;
}

/** Return between which values the utilization is within the discretization error, empty where it has none. */
export function betweenText({ utilization, between }: DesignCheck): string {
  if (between === null || utilization === null || between[0] === between[1]) return "";
  const [used, low, high] = [utilization, ...between].map((value) => (value === null ? "∞" : value.toFixed(2)));
  return low === used && high === used ? "±<0.01" : say("{from} to {to}", { from: low!, to: high! });
}

/** Show what fails in the design, and the figures of one combination; null: none is chosen. */
export function showSummary(
  element: HTMLElement,
  one: CombinationSummary | null,
  summary: Summary | null = null,
): void {
  const design = designOf(summary);
  if (!one) return fill(element, ...design, h("p", { class: "empty" }, "Choose a combination to see its figures."));
  if (one.refused !== null)
    return fill(element, ...design, h("p", { class: "verdict bad" }, verbatim(`${one.name}: ${one.refused}`)));
  const sections = one.sections.map(({ title, rows, notes }) =>
    h(
      "section",
      {},
      h("h3", {}, verbatim(title)),
      h("table", { class: "figures" }, h("tbody", {}, ...rows.map(makeSummaryRow))),
      ...notes.map((note) => h("p", { class: "quiet" }, verbatim(note))),
    ),
  );
  fill(element, ...design, h("div", { class: "summary-sections" }, ...sections));
}

function makeSummaryRow({ label, symbol, value, unit, note }: SummaryRow): HTMLElement {
  const name = symbol ? [verbatim(label), " ", symbolElement(symbol)] : [verbatim(label)];
  const figure = typeof value === "number" ? formatNumber(value) : (value ?? "");
  return h(
    "tr",
    {},
    h("th", { scope: "row" }, ...name),
    h("td", {}, figure),
    h("td", { class: "unit" }, unit),
    h("td", { class: "note" }, verbatim(note)),
  );
}

/** What a certificate holds beside the ratios that measure how well the equations are satisfied. */
const NO_RATIOS: ReadonlySet<string> = new Set(["holds", "too_large", "load", "reaction", "ground_load"]);

/** Whether a ratio is above its limit. */
function isTooLarge(one: CombinationSummary, key: string): boolean {
  const tooLarge = one.certificate?.too_large;
  return Array.isArray(tooLarge) && tooLarge.includes(key);
}

/** The verdict on a combination. */
export type Verdict = "certified" | "not certified" | "refused";

export function verdictOf(one: CombinationSummary): Verdict {
  if (one.refused !== null || one.certificate === null) return "refused";
  return one.certificate.holds === true ? "certified" : "not certified";
}

const TEXTS: Record<Verdict, string> = { certified: "holds", "not certified": "does not hold", refused: "no result" };

/** Show the certificates of all combinations; `choose` is called with the position of one that was clicked. */
export function showCertificates(element: HTMLElement, summary: Summary | null, choose: (n: number) => void): void {
  const hint = "Each solved combination is checked against the equations; the verdicts appear here.";
  if (!summary) return fill(element, h("p", { class: "empty" }, hint));
  const { combinations } = summary;
  const all = new Set(combinations.flatMap((one) => Object.keys(one.certificate ?? {})));
  const keys = [...all].filter((key) => !NO_RATIOS.has(key));
  const heads = ["combination", "certificate", ...keys.map((key) => key.replaceAll("_", " "))];
  const head = h("tr", {}, ...heads.map((text) => h("th", { scope: "col" }, text)));
  const rows = combinations.map((one, n) => {
    const verdict = verdictOf(one);
    const name = button(one.name || say("combination {number}", { number: n + 1 }), "", () => choose(n), "link");
    const figures =
      verdict === "refused"
        ? [h("td", { class: "why", colspan: Math.max(1, keys.length) }, verbatim(one.refused ?? ""))]
        : keys.map((key) => {
            const className = isTooLarge(one, key) ? "figure too-large" : "figure";
            return h("td", { class: className }, formatFigure(one.certificate?.[key]));
          });
    const mark = h("span", { class: `verdict-mark ${verdict === "certified" ? "good" : "bad"}` }, TEXTS[verdict]);
    return h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, mark), ...figures);
  });
  const table = h("table", { class: "certificates" }, h("thead", {}, head), h("tbody", {}, ...rows));
  fill(element, makeVerdict(summary), h("div", { class: "wide" }, table));
}

/** Make the verdict on all combinations together. */
function makeVerdict({ combinations: all, coarse = "", unknown = false }: Summary): HTMLElement {
  const bad = all.filter((one) => verdictOf(one) !== "certified").length;
  const whose =
    all.length === 1 ? "The result is" : say("The results of all {all} combinations are", { all: all.length });
  const good = say(
    "{whose} certified: equilibrium and contact conditions are satisfied on this mesh. This is not a design approval.",
    { whose },
  );
  if (bad === 0 && unknown) return h("p", { class: "verdict bad" }, verbatim(coarse));
  if (bad === 0 && coarse) return h("p", { class: "verdict doubtful" }, together([good, keep(coarse)]));
  if (bad === 0) return h("p", { class: "verdict good" }, good);
  const some = say("{bad} of {all} combinations have no usable result.", { bad, all: all.length });
  return h("p", { class: "verdict bad" }, all.length === 1 ? "Do not use this result." : some);
}

/** A number with a power of ten: 2.7·10⁻¹³. */
function formatPower(value: number): string {
  const [digits = "", power = ""] = value.toExponential(1).split("e");
  return `${digits.replace("-", "−")}·10${[...power.replace("+", "")].map((sign) => (sign === "-" ? "⁻" : ("⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(sign)] ?? ""))).join("")}`;
}

function formatFigure(value: Json | undefined): string {
  if (typeof value === "number")
    return value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e4) ? formatNumber(value) : formatPower(value);
  if (typeof value === "boolean") return value ? "yes" : "no";
  return typeof value === "string" ? value : "";
}

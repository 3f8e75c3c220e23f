// Buttons that add a section which was cut in the picture to the case: as a section line, or as a design strip.

import type { SectionLine } from "../../viewer/panels/section-panel";
import { button, h } from "../../viewer/shared/dom";
import { say, verbatim } from "../../viewer/shared/language";
import type { Store } from "../client/store";
import { addLine } from "../model/changes/new-items";
import type { Change } from "../model/edits";
import { freeName, namesIn } from "../model/names";
import { listAt, type Table } from "../model/paths";
import { formatLength } from "../model/quantities";

/** Return the change that adds a design strip along a section. */
export function addStrip(data: Table, { start, end }: Pick<SectionLine, "start" | "end">, width: string): Change {
  const name = freeName(namesIn(listAt(data, ["output", "strips"])), "strip 1");
  const place = (point: SectionLine["start"]) => point.map((coordinate) => formatLength(coordinate));
  const value = { name, start: place(start), end: place(end), width };
  return {
    edits: [{ op: "add", path: ["output", "strips"], value }],
    text: say("add strip {name}", { name: verbatim(name) }),
  };
}

/** Make the buttons; `set` says which section they keep, null if there is none or it is in the case already. */
export function keepSection(store: Store, push: (change: Change) => void) {
  let section: SectionLine | null = null;
  const width = h("input", { type: "text", value: "1 m", size: 5, "aria-label": "Width of the strip" });
  const keepLine = button("Add section line", "Add this section line to the case", () => {
    if (section) push(addLine("section line", store.data, [section.start, section.end], "").change);
  });
  const keepStrip = button(
    "Add strip",
    "Add a design strip of this width along the section, for moments over its width",
    () => {
      if (section) push(addStrip(store.data, section, width.value.trim() || "1 m"));
    },
  );
  for (const control of [keepLine, keepStrip]) control.classList.add("small");
  const element = h("div", { class: "keep-section", hidden: true }, keepLine, keepStrip, width);
  const set = (shown: SectionLine | null) => {
    section = shown?.name ? null : shown;
    if (section?.width) width.value = formatLength(section.width);
    element.hidden = section === null;
  };
  return { element, set };
}

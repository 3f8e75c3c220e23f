// @vitest-environment happy-dom
// Messages in the language of the page: the examples that the program's own catalogues are tested by.
import { afterEach, describe, expect, it } from "vitest";
import examples from "../../../tests/unit/languages/translations.json";
import { Catalogue, Verbatim } from "../../src/viewer/shared/catalogue";
import { button, fillOptions, h, setText } from "../../src/viewer/shared/dom";
import {
  chosenLanguage,
  counted,
  keepNames,
  say,
  setMessages,
  storeLanguage,
  translate,
  verbatim,
} from "../../src/viewer/shared/language";

const { language, messages, names, cases } = examples;
const marks = { "; ": "; ", ": ": ": ", ", ": ", ", " / ": " / ", " (": " (", " and ": " und ", " or ": " oder " };
const trimmed = Object.entries(messages).map(([key, value]) => [key.trim(), value.trim()]);
const german = { language, messages: Object.fromEntries(trimmed) as Record<string, string>, marks };

afterEach(() => {
  setMessages(null);
  localStorage.clear();
});

describe("a catalogue", () => {
  const catalogue = new Catalogue(german, new Set(names));

  it.each(cases)("makes of %j %j: %s", (text, expected) => {
    expect(catalogue.translate(text!)).toBe(expected);
    expect(catalogue.translate(text!)).toBe(expected); // remembered
  });

  it("knows what a symbol means without the symbol, too", () => {
    expect(catalogue.translate("shear per length")).toBe("Schub je Länge");
  });

  it("says a message by its template: values are translated, names are not, and what is said stays", () => {
    const count = "{count} slabs of {name}";
    const own = new Catalogue({ ...german, messages: { ...german.messages, [count]: "{name}: {count} Platten" } });
    expect(own.say(count, { count: 1.5, name: "slab" })).toBe("Platte: 1,5 Platten");
    expect(own.say(count, { count: "2 slabs", name: new Verbatim("slab 1.5") })).toBe("slab 1.5: 2 slabs Platten");
    expect(own.say("{what}", { what: own.say("add {name}", { name: new Verbatim("slab") }) })).toBe("add slab");
    expect(say(count, { count: 1.5, name: verbatim("slab") })).toBe("1.5 slabs of slab");
    expect([1, 2].map((n) => counted(n, "{count} slab", count, { name: "A" }))).toEqual(["1 slab", "2 slabs of A"]);
  });

  it("forgets what it remembers when names change", () => {
    const own = new Catalogue(german);
    expect(own.translate("add slab")).toBe("Platte hinzufügen");
    own.setNames(new Set(["slab"]));
    expect(own.translate("add slab")).toBe("slab hinzufügen");
  });
});

describe("an element", () => {
  it("has its texts, titles and labels in the language of the page, and all else as it is", () => {
    setMessages(german);
    const attributes = { title: "Save", "aria-label": "slab", placeholder: "pile", "data-kind": "slab", value: "0.5" };
    const input = h("input", { type: "text", class: "slab", ...attributes });
    expect(input.title).toBe("Speichern");
    expect(input.getAttribute("aria-label")).toBe("Platte");
    expect(input.placeholder).toBe("Pfahl");
    expect([input.className, input.dataset.kind, input.value]).toEqual(["slab", "slab", "0.5"]);
    expect(button("Save", "add slab", () => {}).outerHTML).toContain('title="Platte hinzufügen">Speichern<');
    expect(document.documentElement.lang).toBe("de");
  });

  it("shows a name as it is, and code", () => {
    setMessages(german);
    expect(h("td", { title: verbatim("slab") }, verbatim("Save 0.5")).outerHTML).toBe('<td title="slab">Save 0.5</td>');
    expect(h("code", {}, "Save").textContent).toBe("Save");
    const select = h("select", {});
    fillOptions(select, [
      ["", "slab"],
      ["slab", verbatim("slab")],
    ]);
    expect([...select.options].map(({ value, text }) => [value, text])).toEqual([
      ["", "Platte"],
      ["slab", "slab"],
    ]);
  });

  it("keeps names of the case within messages", () => {
    setMessages(german);
    keepNames("case", { columns: [{ name: "Save", x: "1 m" }] });
    const element = h("p");
    setText(element, "add Save");
    expect(element.textContent).toBe("Save hinzufügen");
    keepNames("result", { combinations: [{ name: "slab" }] });
    expect([translate("add Save"), translate("add slab")]).toEqual(["Save hinzufügen", "slab hinzufügen"]);
  });

  it("is in English without a catalogue", () => {
    expect(h("p", { title: "Save" }, "slab 0.5").outerHTML).toBe('<p title="Save">slab 0.5</p>');
  });
});

describe("the language of the page", () => {
  it("is the one that was chosen, else that of the case, else English", () => {
    expect([undefined, "xx", 3, "toString"].map(chosenLanguage)).toEqual(["en", "en", "en", "en"]);
    expect(chosenLanguage("pl")).toBe("pl");
    storeLanguage("fr");
    expect(chosenLanguage("pl")).toBe("fr");
  });
});

// @vitest-environment happy-dom
// Words of the page in its language: messages are looked up whole, with named holes, and nothing is guessed.
import { afterEach, describe, expect, it } from "vitest";
import { Catalogue, Verbatim } from "../../src/viewer/shared/catalogue";
import { button, fillOptions, h, setText } from "../../src/viewer/shared/dom";
import {
  chosenLanguage,
  counted,
  either,
  keepNames,
  pageLanguage,
  say,
  setMessages,
  storeLanguage,
  together,
  translate,
  verbatim,
} from "../../src/viewer/shared/language";

const messages = {
  Save: "Speichern",
  slab: "Platte",
  pile: "Pfahl",
  "add {name}": "{name} hinzufügen",
  "k_j: shear per length": "k_j: Schub je Länge",
  "{one} or {other}": "{one} oder {other}",
};
const german = { language: "de", messages };

afterEach(() => {
  setMessages(null);
  localStorage.clear();
});

describe("a catalogue", () => {
  it.each([
    ["Save", "Speichern"],
    [" Save ", " Speichern "],
    ["save", "save"],
    ["add slab", "add slab"],
    ["Save: slab", "Save: slab"],
    ["2.5 kNm/m", "2,5 kNm/m"],
    ["(1.5, 2.5) m", "(1,5; 2,5) m"],
    ["Netz 2.5", "Netz 2.5"],
    ["Slab 2.5", "Slab 2.5"],
  ])("makes of %j %j", (text, expected) => {
    expect(new Catalogue(german, new Set(["Slab 2.5"])).translate(text)).toBe(expected);
  });

  it("knows what a symbol means without the symbol, too", () => {
    expect(new Catalogue(german).translate("shear per length")).toBe("Schub je Länge");
  });

  it("says a message by its template: values are translated, names are not, and what is said stays", () => {
    const count = "{count} slabs of {name}";
    const own = new Catalogue({ ...german, messages: { ...messages, [count]: "{name}: {count} Platten" } });
    expect(own.say(count, { count: 1.5, name: "slab" })).toBe("Platte: 1,5 Platten");
    expect(own.say(count, { count: "2 slabs", name: new Verbatim("slab 1.5") })).toBe("slab 1.5: 2 slabs Platten");
    expect(own.say("{what}", { what: own.say("add {name}", { name: new Verbatim("slab") }) })).toBe("slab hinzufügen");
    expect(own.translate(own.keep("B 2.5"))).toBe("B 2.5");
    expect(say(count, { count: 1.5, name: verbatim("slab") })).toBe("1.5 slabs of slab");
    expect([1, 2].map((n) => counted(n, "{count} slab", count, { name: "A" }))).toEqual(["1 slab", "2 slabs of A"]);
  });

  it("says lists", () => {
    setMessages(german);
    expect(together(["Save", "", "slab"], ": ")).toBe("Speichern: Platte");
    expect(either(["slab", "pile", "x"])).toBe("Platte oder Pfahl oder x");
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
    expect(button("Save", "slab", () => {}).outerHTML).toContain('title="Platte">Speichern<');
    expect([document.documentElement.lang, pageLanguage()]).toEqual(["de", "de"]);
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

  it("keeps names of the case", () => {
    setMessages(german);
    keepNames("case", { columns: [{ name: "Save", x: "1 m" }] });
    const element = h("p");
    setText(element, "Save");
    expect(element.textContent).toBe("Save");
    keepNames("result", { combinations: [{ name: "slab" }] });
    expect([translate("Save"), translate("slab"), say("add {name}", { name: "slab" })]).toEqual([
      "Save",
      "slab",
      "slab hinzufügen",
    ]);
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

// What is said of a table of reactions.
import { describe, expect, it } from "vitest";
import {
  choiceOf,
  isTableFile,
  lastReading,
  parsePairs,
  type TypedReactions,
} from "../../../src/workbench/model/reactions";

const NOTHING: TypedReactions = {
  newCases: "",
  cases: "",
  supports: "",
  withoutCases: "",
  withoutSupports: "",
  positive: "presses",
  moments: "about axes",
  mirrored: false,
  tolerance: "",
  widthX: "",
  widthY: "",
  force: "",
  moment: "",
  length: "",
  moveColumns: false,
  sheet: "",
  headings: "",
  decimals: "",
  onlyCase: "",
  originX: "",
  originY: "",
  horizontal: "left out",
};

describe("what is said of a table of reactions", () => {
  it("is a pair on each line, names may have the sign in them", () => {
    expect(parsePairs(" LIVE = B\n\nG=1=G\nWind")).toEqual({ LIVE: "B", "G=1": "G", Wind: "" });
  });

  it("leaves what is not typed as it is in the case", () => {
    const reading = { positive: "presses", moments: "about axes", mirrored: false, horizontal: "left out" };
    expect(choiceOf(NOTHING)).toEqual({ new_cases: {}, cases: {}, supports: {}, move_columns: false, reading });
  });

  it("has keys of the case file", () => {
    const typed = { ...NOTHING, tolerance: " 50 mm ", widthX: "0.4 m", withoutCases: "A\nB\n", force: "kip" };
    const { reading } = choiceOf(typed);
    expect(reading).toMatchObject({ tolerance: "50 mm", footprint: ["0.4 m", "0.4 m"], force: "kip" });
    expect(reading.without_cases).toEqual(["A", "B"]);
    expect(reading).not.toHaveProperty("without_supports");
  });

  it("says where the table is and how its columns and decimals are meant", () => {
    const table = { sheet: "Base", headings: "support = Pos\nF_z = V max", decimals: "comma", onlyCase: "G" };
    const { reading } = choiceOf({ ...NOTHING, ...table, originY: "2 m" });
    expect(reading).toMatchObject({ sheet: "Base", decimals: "comma", case: "G", origin: ["0 m", "2 m"] });
    expect(reading.headings).toEqual({ support: "Pos", F_z: "V max" });
  });

  it("begins with the last table's signs", () => {
    const data = { reactions: { positive: "lifts", mirrored: true } };
    const [moments, horizontal] = ["about axes", "left out"];
    expect(lastReading(data)).toEqual({ positive: "lifts", moments, mirrored: true, horizontal });
    expect(lastReading(null)).toEqual({ positive: "presses", moments, mirrored: false, horizontal });
  });

  it("is asked for files of tables", () => {
    expect(["a.csv", "b.XLSX", "c.toml", "csv"].map(isTableFile)).toEqual([true, true, false, false]);
  });
});

// The folders of src import downwards only, in the order that docs/architecture.md states; biome forbids circles of files.
import { describe, expect, it } from "vitest";
import page from "../../docs/architecture.md?raw";

const SOURCES = import.meta.glob<string>("../src/**/*.ts", { query: "?raw", import: "default", eager: true });

/** The table's rows from the bottom up; the folders of one row do not see each other. */
const rows = page
  .split("| folder of `web/src` |")[1]!
  .split("\n\n")[0]!
  .split("\n")
  .slice(2)
  .map((line) => Array.from(line.split("|")[1]!.matchAll(/`([^`]+)\/`/g), ([, folder]) => folder!));
const ranks = new Map(rows.flatMap((folders, rank) => folders.map((folder) => [folder, rank] as const)));

/** Return the folder of the table that a file is in, without `../src/`. */
function folderOf(file: string): string {
  const parts = file.split("/").slice(2, -1);
  while (parts.length > 0 && !ranks.has(parts.join("/"))) parts.pop();
  return parts.join("/");
}

/** Return the files of src that a file imports. */
function importsOf(file: string, text: string): string[] {
  const paths = Array.from(text.matchAll(/(?:from|import)\s*\(?\s*"(\.[^"]+)"/g), ([, path]) => path!);
  return paths.map((path) => `..${new URL(path, `file://${file.slice(2)}`).pathname}`);
}

/** Return the imports, as `from -> to`, that do not go down. */
function climbs(sources: Readonly<Record<string, string>>): string[] {
  return Object.entries(sources).flatMap(([file, text]) =>
    importsOf(file, text).flatMap((target) => {
      const [from, to] = [folderOf(file), folderOf(target)];
      return from === to || ranks.get(from)! > ranks.get(to)! ? [] : [`${file} -> ${target}`];
    }),
  );
}

describe("the folders", () => {
  it("are all in the table", () => {
    const homeless = Object.keys(SOURCES).filter((file) => folderOf(file) === "");
    expect(homeless).toEqual([]);
    const used = new Set(Object.keys(SOURCES).map(folderOf));
    expect([...ranks.keys()].filter((folder) => !used.has(folder))).toEqual([]);
  });

  it("import only from those above them in the table", () => {
    expect(climbs(SOURCES)).toEqual([]);
  });

  it("are found to climb where one imports from a folder below it in the table, or in its own row", () => {
    const file = "../src/workbench/form/inputs/inputs.ts";
    const climbing = { [file]: 'import { a } from "../../help/facts";\nimport "../../plan/canvas";' };
    expect(climbs(climbing)).toEqual([
      `${file} -> ../src/workbench/help/facts`,
      `${file} -> ../src/workbench/plan/canvas`,
    ]);
    expect(climbs({ "../src/workbench/plan/canvas.ts": 'await import("../text/text-panel")' })).toHaveLength(1);
    expect(climbs({ [file]: 'import { Schema } from "../../model/schema";' })).toEqual([]);
  });
});

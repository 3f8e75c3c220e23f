// @vitest-environment happy-dom
// The dialog for files: where a file goes that is saved before a folder's list has come.

import { expect, test } from "vitest";
import type { Folder } from "../../../src/workbench/client/api";
import { chooseFile } from "../../../src/workbench/shell/file-dialog";

test("saves into the folder that is written, though its files are not listed yet", async () => {
  const listed: (string | null)[] = [];
  const files = async (folder: string | null): Promise<Folder> => {
    listed.push(folder);
    return { folder: folder ?? "/start", parent: null, folders: [], files: [] };
  };
  const chosen = chooseFile({ files }, "save", null);
  await new Promise((resolve) => setTimeout(resolve));
  const field = (name: string) => document.querySelector<HTMLInputElement>(name) as HTMLInputElement;
  field("input.path").value = "/third";
  field(".file-name input").value = "slab";
  document.querySelector("form")?.dispatchEvent(new Event("submit", { cancelable: true }));
  expect(await chosen).toEqual({ file: "/third/slab.toml", over: false });
  expect(listed).toEqual([null, "/third"]);
});

test("lists drawings among the files to open, not among those to save to", async () => {
  const files = async (): Promise<Folder> => ({
    folder: "/start",
    parent: null,
    folders: [],
    files: ["slab.toml"],
    drawings: ["plan.dxf"],
  });
  for (const [purpose, names] of [
    ["open", ["slab.toml", "plan.dxf"]],
    ["save", ["slab.toml"]],
  ] as const) {
    document.body.replaceChildren();
    void chooseFile({ files }, purpose, null);
    await new Promise((resolve) => setTimeout(resolve));
    expect([...document.querySelectorAll(".files .entry")].map((entry) => entry.textContent)).toEqual(names);
  }
});

// @vitest-environment happy-dom
// Slabs of files in the Structural Analysis Format: the one that is chosen becomes a case, with the report on it.
import { expect, test } from "vitest";
import { type DocState, Refused } from "../../../src/workbench/client/api";
import { openSlab, slabText } from "../../../src/workbench/drawing/open-saf";

const SLABS = [
  { name: "S6", height: 0, sides: [5, 12] as [number, number], on_ground: true },
  { name: "S5", height: 3.6, sides: [5, 12.34567] as [number, number], on_ground: false },
];
const settled = () => new Promise((resolve) => setTimeout(resolve));

test("says where a slab is, how large, and whether it lies on ground", () => {
  expect(SLABS.map(slabText)).toEqual(["S6: 5 m by 12 m at 0 m, on ground", "S5: 5 m by 12.35 m at 3.6 m"]);
});

test("makes a case of the chosen slab and shows what was read; a refusal keeps the dialog open", async () => {
  document.body.replaceChildren();
  const asked: string[] = [];
  let refuses = true;
  const done = openSlab("/files/house.xlsx", SLABS, {
    api: {
      openSlab: async (file, slab) => {
        asked.push(`${file} ${slab}`);
        return { state: {} as DocState, report: "taken: plate" };
      },
    },
    leave: async () => true,
    replace: async (make, refused) => {
      await make();
      return refuses ? !refused(new Refused("a wrong row", 422)) : true;
    },
  });
  const submit = () => document.querySelector("form")?.dispatchEvent(new Event("submit", { cancelable: true }));
  document.querySelector("select")!.value = "S5";
  submit();
  await settled();
  expect(document.querySelector(".saf-dialog .messages")?.textContent).toBe("a wrong row");
  refuses = false;
  submit();
  await done;
  expect(asked).toEqual(["/files/house.xlsx S5", "/files/house.xlsx S5"]);
  expect(document.querySelector(".saf-dialog")).toBeNull();
  expect(document.querySelector(".drawing-report pre")?.textContent).toBe("taken: plate");
});

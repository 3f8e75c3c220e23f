// @vitest-environment happy-dom
// Slabs of SAF files and buildings: the one that is chosen becomes a case, with the report on it.
import { expect, test } from "vitest";
import { type DocState, Refused, type SlabChoice, type SlabInFile } from "../../../src/workbench/client/api";
import { openSlab, slabText } from "../../../src/workbench/drawing/open-slab";

const SLABS: SlabInFile[] = [
  { id: "S6", name: "S6", height: 0, sides: [5, 12], on_ground: true },
  { id: "S5", name: "S5", height: 3.6, sides: [5, 12.34567], on_ground: false },
];
const HOUSE: SlabInFile[] = [
  { id: "0a", name: "Ramp", storey: "", height: null, sides: null, columns: 0, walls: 0, problem: "it is tilted" },
  { id: "0b", name: "Raft", storey: "Cellar", height: -3, sides: [6, 4], columns: 2, walls: 1, problem: "" },
];
const settled = () => new Promise((resolve) => setTimeout(resolve));

test("says where a slab is, how large, and whether it lies on ground", () => {
  expect(SLABS.map(slabText)).toEqual(["S6: 5 m by 12 m at 0 m, on ground", "S5: 5 m by 12.35 m at 3.6 m"]);
});

test("says the storey of a slab of a building, what stands on it, or why it cannot be read", () => {
  expect(HOUSE.map(slabText)).toEqual([
    "Ramp cannot be read: it is tilted",
    "Raft: 6 m by 4 m, top at -3 m, storey: Cellar, columns: 2, walls: 1",
  ]);
});

test("asks where the plan of a building is measured from; what cannot be read is not chosen", async () => {
  document.body.replaceChildren();
  const asked: SlabChoice[] = [];
  const done = openSlab("/files/house.ifc", HOUSE, {
    api: {
      openSlab: async (_, choice) => {
        asked.push(choice);
        return { state: {} as DocState, report: "left: beams" };
      },
    },
    leave: async () => true,
    replace: async (make) => {
      await make();
      return true;
    },
  });
  const [slab, origin] = document.querySelectorAll("select");
  expect(slab!.value).toBe("0b");
  expect([...slab!.options].map(({ disabled }) => disabled)).toEqual([true, false]);
  origin!.value = "centered";
  document.querySelector<HTMLInputElement>("input[type=checkbox]")!.checked = true;
  document.querySelector("form")?.dispatchEvent(new Event("submit", { cancelable: true }));
  await done;
  expect(asked).toEqual([{ slab: "0b", centered: true, aligned: true }]);
  expect(document.querySelector(".drawing-report")?.textContent).toContain("geometry alone");
});

test("makes a case of the chosen slab and shows what was read; a refusal keeps the dialog open", async () => {
  document.body.replaceChildren();
  const asked: string[] = [];
  let refuses = true;
  const done = openSlab("/files/house.xlsx", SLABS, {
    api: {
      openSlab: async (file, { slab }) => {
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
  expect(document.querySelector(".slab-dialog .messages")?.textContent).toBe("a wrong row");
  refuses = false;
  submit();
  await done;
  expect(asked).toEqual(["/files/house.xlsx S5", "/files/house.xlsx S5"]);
  expect(document.querySelector(".slab-dialog")).toBeNull();
  expect(document.querySelector(".drawing-report pre")?.textContent).toBe("taken: plate");
});

// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from "vitest";
import { h } from "../../../src/viewer/shared/dom";
import { areaKeys, keepFocus } from "../../../src/workbench/controls/focus";

function control(name: string): HTMLButtonElement {
  return h("button", { id: name }, name);
}

const focused = () => document.activeElement?.id;
const settled = () => new Promise((done) => setTimeout(done));
const get = (name: string) => document.getElementById(name)!;

describe("the focus", () => {
  beforeAll(keepFocus);
  beforeEach(() => {
    document.body.replaceChildren(
      control("before"),
      h("div", { id: "list" }, h("p", {}, control("a1"), control("a2")), h("p", { id: "b" }, control("b1"))),
      control("after"),
    );
  });

  it("goes on to what comes next where the control is, else to what comes before", async () => {
    get("a1").focus();
    get("a1").parentElement!.remove();
    await settled();
    expect(focused()).toBe("b1");
    get("b").hidden = true;
    await settled();
    expect(focused()).toBe("after");
    (get("after") as HTMLButtonElement).disabled = true;
    await settled();
    expect(focused()).toBe("before");
  });

  it("stays where it can be, and where it was left on purpose", async () => {
    get("a1").focus();
    get("b").remove();
    await settled();
    expect(focused()).toBe("a1");
    get("a1").blur();
    get("after").remove();
    await settled();
    expect(document.activeElement).toBe(document.body);
  });

  it("goes to what is made anew in place of all that was there", async () => {
    get("a1").focus();
    get("list").replaceChildren(control("c1"), control("c2"));
    await settled();
    expect(focused()).toBe("c1");
  });

  it("comes back from a dialog to where it was, or near that", async () => {
    get("a2").focus();
    const dialog = h("dialog", { open: true }, control("yes"));
    document.body.append(dialog);
    get("yes").focus();
    get("a2").remove();
    await settled();
    expect(focused()).toBe("yes");
    dialog.remove();
    await settled();
    expect(focused()).toBe("a1");
  });

  it("moves between areas, and back to where it was in each", () => {
    const [first, second] = [h("p", {}, control("x1"), control("x2")), h("p", {}, control("y1"), control("y2"))];
    document.body.replaceChildren(first, second);
    const move = areaKeys([first, second]);
    move(-1);
    expect(focused()).toBe("x1");
    get("x2").focus();
    move(1);
    expect(focused()).toBe("y1");
    get("y1").remove();
    move(1);
    expect(focused()).toBe("x2");
    move(-1);
    expect(focused()).toBe("y2");
  });
});

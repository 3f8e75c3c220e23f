// What a new case starts with: nothing, or one of the examples.
import { button, h, newId } from "../../viewer/shared/dom";
import type { Api, Example } from "../client/api";
import { closeDialog, openDialog } from "../controls/dialogs";
import { thumbnail } from "./thumbnail";
import "./help.css";

/** What was chosen: an example by its name, null for a case that starts with nothing. */
export interface Start {
  example: string | null;
}

/** Ask what a new case starts with; null if the user cancels. */
export async function chooseStart(api: Pick<Api, "examples">): Promise<Start | null> {
  // without the server an empty case is what remains
  const examples = await api.examples().catch(() => []);
  return new Promise((resolve) => {
    const id = newId("dialog");
    const close = (start: Start | null) => {
      closeDialog(dialog);
      resolve(start);
    };
    const empty = button(
      "Empty case",
      "A small slab with comments to start from",
      () => close({ example: null }),
      "main",
    );
    empty.toggleAttribute("autofocus", true);
    const cards = examples.map((each) => card(each, () => close({ example: each.name })));
    const dialog = h(
      "dialog",
      { class: "examples", "aria-labelledby": id },
      h(
        "div",
        { class: "examples-head" },
        h("h2", { id }, "New case"),
        empty,
        button("Cancel", "", () => close(null)),
      ),
      h("h3", {}, "Examples"),
      h("ul", { class: "cards", "aria-label": "examples" }, ...cards),
    );
    openDialog(dialog, () => close(null));
  });
}

function card({ title, about, data }: Example, choose: () => void): HTMLElement {
  const words = h("span", {}, h("strong", {}, title), h("span", { class: "about" }, about));
  return h(
    "li",
    {},
    h("button", { type: "button", class: "card", title: about, onclick: choose }, thumbnail(data), words),
  );
}

// Questions about unsaved work and texts that differ.
import { say, verbatim } from "../../viewer/shared/language";
import type { Api, DocState } from "../client/api";
import type { Store } from "../client/store";
import { ask } from "../controls/dialogs";

/** Ask what to do with unsaved work that the server has found; returns the state after the answer. */
export async function askOffer(api: Pick<Api, "restore">, state: DocState): Promise<DocState> {
  const { offer } = state;
  if (!offer) return state;
  const date = new Date(offer.when);
  const isDate = !Number.isNaN(date.getTime());
  const when = isDate ? date.toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" }) : offer.when;
  const file = offer.file ?? "a case that has never been saved";
  const changed = "Another program has changed the file since then; you will be asked before saving overwrites it.";
  const take = await ask(
    "Restore unsaved work?",
    [
      say("An earlier session ended with unsaved changes: {file}, last changed {when}.", {
        file: verbatim(file),
        when,
      }),
      "You can undo restoring them; the file on disk does not change until you save.",
      ...(offer.changed === true ? [changed] : []),
    ],
    [
      { label: "Dismiss", value: false },
      { label: "Restore", value: true, main: true },
    ],
    null,
  );
  // there may be more, of still earlier runs
  return askOffer(api, await api.restore(take));
}

/** Ask whether the page's text or the server's is to be kept. */
export function askWhichText(server: DocState): Promise<"page" | "server"> {
  const file = server.file ?? "not saved yet";
  return ask(
    "Which version do you want to keep?",
    [
      say("The server has a different version ({file}) from this page, which has unsaved changes.", {
        file: verbatim(file),
      }),
    ],
    [
      { label: "Use the server's version", value: "server" as const },
      { label: "Keep this page's version", value: "page" as const, main: true },
    ],
    null,
  );
}

/** Warn of unsaved work that cannot be kept. */
export function showWarnings(store: Store): void {
  let shown = "";
  store.on(["doc"], () => {
    const { unkept = "" } = store.doc ?? {};
    if (unkept === shown) return;
    shown = unkept;
    if (unkept) store.set("notice", { kind: "bad", text: say("{problem}. Save soon.", { problem: unkept }) });
  });
}

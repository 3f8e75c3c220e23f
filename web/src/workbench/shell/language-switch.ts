// The language of the page: its messages, and the switch between languages.
import { h } from "../../viewer/shared/dom";
import {
  chosenLanguage,
  keepNames,
  LANGUAGES,
  pageLanguage,
  setMessages,
  storeLanguage,
  verbatim,
} from "../../viewer/shared/language";
import { type Api, Lost, Refused } from "../client/api";
import type { Store } from "../client/store";
import { valueAt } from "../model/paths";

const languageFor = (store: Store) => chosenLanguage(valueAt(store.data, ["project", "language"]));

/**
 * Let the page be in the language that was chosen, else in that of the case; in English if its messages do not come.
 * `again` has the server say anew what it has said in another one.
 */
export async function speak(api: Pick<Api, "messages">, store: Store, again: () => Promise<void>): Promise<void> {
  const [language, before] = [languageFor(store), pageLanguage()];
  try {
    setMessages(language === "en" ? null : await api.messages(language));
  } catch (error) {
    if (!(error instanceof Lost || error instanceof Refused)) throw error;
    setMessages(null);
  }
  if (pageLanguage() !== before) await again();
  if (pageLanguage() === "en") return;
  const keep = () => keepNames("case", store.data);
  keep();
  // before what shows the names
  store.on(["doc", "data"], keep);
}

/** The switch, which loads the page again after what waits has been sent; the server keeps all else. */
export function languageSwitch(store: Store, settle: () => Promise<void> = async () => {}): HTMLElement {
  const shown = document.documentElement.lang;
  const options = Object.entries(LANGUAGES).map(([value, name]) =>
    h("option", { value, lang: value, selected: value === shown }, verbatim(name)),
  );
  const onchange = async () => {
    storeLanguage(select.value);
    await settle();
    // edits that the server does not have would be lost
    if (store.waitingCount === 0) location.reload();
  };
  const select: HTMLSelectElement = h(
    "select",
    { "aria-label": "language", onchange: () => void onchange() },
    ...options,
  );
  store.on(["opened"], () => {
    if (languageFor(store) !== shown) location.reload();
  });
  return select;
}

// Opening a drawing: its layers are read, then a case is made of it, or it is shown below the plan.

import { say, verbatim } from "../../viewer/shared/language";
import type { Api, DocState, Refused } from "../client/api";
import type { Store } from "../client/store";
import { fillAsNew } from "../model/changes/new-items";
import type { Change } from "../model/edits";
import { centeringOffset, type DrawingChoice, type Survey } from "../model/survey";
import { askAboutDrawing } from "./drawing-dialog";
import { showReport } from "./report";

const MISSING =
  "Drawings do not include properties such as the thickness and the ground. The list of errors shows what is still missing.";

const FILLED =
  "Concrete, ground and self-weight are those of a new case: check them. The list of errors shows what is still missing.";

/** Whether a file is a drawing by its name. */
export function isDrawing(file: string): boolean {
  return /\.dxf$/i.test(file);
}

/** What the opening of a drawing needs. */
export interface DrawingOpener {
  api: Pick<Api, "surveyDrawing" | "openDrawing">;
  store: Store;
  /** Change the document. */
  push(change: Change): void;
  /** Do something with the server after all edits have been sent; returns whether it went well. */
  run(run: () => Promise<void>): Promise<boolean>;
  /** Ask what to do with unsaved work; returns whether the document may be left. */
  leave(): Promise<boolean>;
  /** Replace the document; `refused` takes the reason if the server refuses. */
  replace(make: () => Promise<DocState>, refused: (error: Refused) => boolean): Promise<boolean>;
}

/** Open a drawing; resolves when its dialog is closed. */
export async function openDrawing(file: string, opener: DrawingOpener): Promise<void> {
  const { api, store } = opener;
  const name = file.replace(/^.*[\\/]/, "");
  let answer: Survey | null = null;
  store.set("notice", { kind: "info", text: say("Reading {file} …", { file: verbatim(name) }) });
  const isRead = await opener.run(async () => {
    answer = await api.surveyDrawing(file);
    store.set("notice", null);
  });
  const survey = answer as Survey | null;
  if (!isRead || !survey) return;
  await askAboutDrawing(name, survey, {
    makeCase: async (choice, shown, asNew) => {
      const problem = await makeCase(file, name, survey, choice, shown, asNew, opener);
      if (problem === "" && asNew) opener.push(fillAsNew(store.data));
      return problem;
    },
    showBelow: (choice) => {
      const offset = choice.centered ? centeringOffset(survey, choice.unit) : ([0, 0] as [number, number]);
      store.set("underlay", { name, survey, unit: choice.unit, offset, shown: true });
    },
  });
}

/** Make a case of a drawing; returns why it cannot be made, empty if it was. */
async function makeCase(
  file: string,
  name: string,
  survey: Survey,
  choice: DrawingChoice,
  shown: boolean,
  asNew: boolean,
  { api, store, leave, replace }: DrawingOpener,
): Promise<string> {
  if (!(await leave())) return "The current case stays open.";
  let problem = "The drawing could not be read.";
  let [report, origin] = ["", [0, 0] as [number, number]];
  const isMade = await replace(
    async () => {
      const made = await api.openDrawing(file, choice);
      ({ report, origin } = made);
      return made.state;
    },
    (error) => {
      problem = error.message;
      return true;
    },
  );
  if (!isMade) return problem;
  const offset: [number, number] = [0 - origin[0], 0 - origin[1]];
  store.set("underlay", { name, survey, unit: choice.unit, offset, shown });
  showReport(name, asNew ? FILLED : MISSING, report);
  return "";
}

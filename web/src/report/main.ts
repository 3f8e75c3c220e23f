// The report's script: the viewer, where the page has a place for it. The page works without it.

import type { Choice } from "../viewer/data/fields";
import { decodeGzipBase64, type Scene, SceneError } from "../viewer/data/scene";
import { Viewer } from "../viewer/panels/viewer";
import type { Messages } from "../viewer/shared/catalogue";
import { setText } from "../viewer/shared/dom";
import { say, setMessages } from "../viewer/shared/language";
import { startTheme } from "../viewer/shared/theme";
import "../viewer/shared/theme.css";
import { openOnPaper } from "./paper";
import "./report.css";

async function start(): Promise<void> {
  startTheme();
  const messages = document.getElementById("messages")?.textContent;
  if (messages) setMessages(JSON.parse(messages) as Messages);
  openOnPaper(document);
  const place = document.getElementById("viewer");
  const packed = document.getElementById("scene");
  if (!place || !packed?.textContent?.trim()) return;
  setText(place, "Unpacking the results …");
  try {
    const scene = await decodeGzipBase64(packed.textContent);
    packed.textContent = ""; // the text is no longer needed
    setText(place, "");
    const { field, combination } = place.dataset;
    const viewer = new Viewer(place, scene, field || undefined, choiceOf(scene, combination));
    followLinks(viewer, scene);
  } catch (error) {
    place.textContent =
      error instanceof SceneError
        ? error.message
        : say("The viewer could not start: {error}. The tables in this report work without it.", {
            error: String(error),
          });
    place.classList.add("viewer-failed");
  }
}

/** Let elements with data-x and data-y lead to that point in the viewer, with data-field and data-combination if given. */
function followLinks(viewer: Viewer, scene: Scene): void {
  document.addEventListener("click", (event) => {
    const link = event.target instanceof Element ? event.target.closest<HTMLElement>("[data-x][data-y]") : null;
    if (!link) return;
    event.preventDefault();
    const { x, y, field, combination } = link.dataset;
    viewer.show(choiceOf(scene, combination), field, [Number(x), Number(y)]);
    viewer.element.scrollIntoView({ behavior: "smooth", block: "center" });
  });
}

/** Return a combination by its name, or an envelope by its text. */
function choiceOf(scene: Scene, name: string | undefined): Choice | undefined {
  if (!name) return undefined;
  const found = scene.head.combinations.findIndex((each) => each.name === name);
  if (found >= 0) return found;
  return /^(largest|smallest)(:|$)/.test(name) ? (name as Choice) : undefined;
}

void start();

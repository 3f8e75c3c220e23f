// A bar that scrolls sideways where its content is too wide, with an arrow at each end beyond which there is more.
import { h } from "../../viewer/shared/dom";
import { lineIcon } from "./icons";

const STEP = 0.7; // of the bar's width

/** Put arrows over the ends of a bar, for the mouse; keys move within the bar. `keep` finds what stays in view. */
export function scrollingBar(content: HTMLElement, keep?: () => Element | undefined): HTMLElement {
  const makeArrow = (direction: -1 | 1) => {
    const onclick = () => {
      content.scrollLeft += direction * STEP * content.clientWidth;
    };
    // it never takes the focus: when it goes at the end, that would move to a tab and scroll the bar back to it
    const onmousedown = (event: Event) => event.preventDefault();
    const attributes = { type: "button", tabindex: -1, "aria-hidden": "true", hidden: true, onclick, onmousedown };
    const arrow = direction < 0 ? "M10 3L5 8l5 5" : "M6 3l5 5-5 5";
    return h("button", { ...attributes, class: `bar-arrow ${direction < 0 ? "start" : "end"}` }, lineIcon(arrow));
  };
  const start = makeArrow(-1);
  const end = makeArrow(1);
  const update = () => {
    const { scrollLeft, scrollWidth, clientWidth } = content;
    start.hidden = scrollLeft < 1;
    end.hidden = scrollLeft + clientWidth > scrollWidth - 1;
  };
  content.addEventListener("scroll", update);
  const sizes = new ResizeObserver(() => {
    keep?.()?.scrollIntoView?.({ block: "nearest", inline: "nearest" });
    update();
  });
  const observe = () => {
    for (const element of [content, ...content.children]) sizes.observe(element);
  };
  observe();
  new MutationObserver(observe).observe(content, { childList: true });
  return h("div", { class: "scrolling-bar" }, content, start, end);
}

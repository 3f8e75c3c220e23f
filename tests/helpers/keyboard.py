"""A user without a mouse: keys are pressed one by one, and the focus must be seen after each of them."""

from __future__ import annotations

from dataclasses import dataclass, field

from helpers.browsing import Bench

#: What is wrong with the focus, empty if nothing is: it is somewhere, in view, not covered, and looks unlike without.
LOOK = """() => {
  const name = (e) => `${e.tagName.toLowerCase()}.${e.getAttribute("class") ?? ""}`
    + ` ${e.getAttribute("aria-label") ?? e.title ?? ""} ${(e.textContent ?? "").trim().slice(0, 30)}`;
  // of a switch its knob shows the focus, of a sheet its frame
  const isUnseen = (e) => getComputedStyle(e).opacity === "0";
  const look = (e) => (isUnseen(e) ? [e.nextElementSibling] : [e, e.parentElement]).map((each) => {
    const { outlineStyle, outlineWidth, outlineColor, boxShadow } = getComputedStyle(each);
    return `${outlineStyle === "none" ? "" : `${outlineStyle} ${outlineWidth} ${outlineColor}`}; ${boxShadow}`;
  }).join("\\n");
  const faults = [];
  const { lastFocus, lastLook } = window;
  const now = document.activeElement;
  const isAway = lastFocus && lastFocus !== now && lastFocus.isConnected;
  if (isAway && look(lastFocus) === lastLook) faults.push(`the focus of ${name(lastFocus)} is not seen`);
  const before = lastFocus ? name(lastFocus) : "nothing";
  window.lastFocus = now === document.body ? null : now;
  if (!window.lastFocus) return [...faults, `nothing has the focus, before that ${before}`];
  window.lastLook = look(now);
  const shown = isUnseen(now) ? now.parentElement : now;
  const box = shown.getBoundingClientRect();
  const [left, right] = [Math.max(box.left, 0), Math.min(box.right, innerWidth)];
  const [top, bottom] = [Math.max(box.top, 0), Math.min(box.bottom, innerHeight)];
  const shares = [0.1, 0.3, 0.5, 0.7, 0.9];
  const isSeen = shares.some((u) => shares.some((v) => {
    const hit = document.elementFromPoint(left + u * (right - left), top + v * (bottom - top));
    return hit !== null && (shown.contains(hit) || now.contains(hit));
  }));
  if (!isSeen) faults.push(`${name(now)} has the focus out of view`);
  return faults;
}"""


@dataclass
class Keys:
    """The keyboard of a page; ``presses`` counts the keys, of which a character that is typed is one."""

    bench: Bench
    presses: int = 0
    faults: list[str] = field(default_factory=list)

    def press(self, *keys: str) -> None:
        """Press keys, one after the other."""
        for key in keys:
            self.presses += 1
            self.bench.page.keyboard.press(key)
            self.faults += [f"key {self.presses}, {key}: {fault}" for fault in self.bench.page.evaluate(LOOK)]

    def type(self, text: str) -> None:
        """Type a text."""
        self.presses += len(text)
        self.bench.page.keyboard.type(text)

    def enter(self, text: str) -> None:
        """Type a text in place of that of the field with the focus, and accept it."""
        self.press("Control+a")
        self.type(text)
        self.press("Enter")

    def to(self, selector: str, key: str = "Tab") -> None:
        """Press a key until an element has the focus."""
        for _ in range(150):
            if self.has(selector):
                return
            self.press(key)
        raise AssertionError(f"{key} never reaches {selector}")

    def has(self, selector: str) -> bool:
        """Whether an element has the focus."""
        return bool(self.bench.page.evaluate("(it) => document.activeElement?.matches(it) ?? false", selector))

    def choose(self, selector: str, value: str, key: str = "Tab") -> None:
        """Go to a choice, and press an arrow until it has a value."""
        self.to(selector, key)
        read = "([it, value]) => [...document.activeElement.options].findIndex((each) => each.value === value)"
        read += " - document.activeElement.selectedIndex"
        steps = self.bench.page.evaluate(read, [selector, value])
        self.press(*(["ArrowDown"] * steps or ["ArrowUp"] * -steps))
        assert self.bench.page.evaluate("() => document.activeElement.value") == value

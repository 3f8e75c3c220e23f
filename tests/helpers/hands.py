"""What a user does in the workbench by mouse and keyboard, counted."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from groundslab.case import casefile
from groundslab.model.combinations import place_patterns
from groundslab.model.model import Model
from helpers.browsing import Bench, Server


@dataclass
class Hands:
    """What a user does in the workbench, counted."""

    bench: Bench
    actions: int = 0

    @property
    def page(self) -> Any:
        """The page."""
        return self.bench.page

    def click(self, locator: Any) -> None:
        """Click on something."""
        self.actions += 1
        locator.click()

    def keys(self, *keys: str) -> None:
        """Press keys, each a chord."""
        for key in keys:
            self.actions += 1
            self.page.keyboard.press(key)

    def type(self, text: str) -> None:
        """Type a text where the focus is, and Enter."""
        self.actions += 1
        self.page.keyboard.type(text)
        self.keys("Enter")

    def enter(self, value: str, locator: Any) -> None:
        """Type a value into a field, or choose it."""
        self.actions += 1
        if locator.evaluate("(element) => element.tagName") == "SELECT":
            locator.select_option(label=value)
        else:
            locator.fill(value)

    def fill(self, values: dict[str, str], *path: str | int) -> None:
        """Enter values of keys below a path."""
        for key, value in values.items():
            self.enter(value, self.bench.field(*path, key).locator("input, select").first)

    def tab(self, name: str) -> None:
        """Choose a view of the model."""
        self.actions += 1
        self.bench.tab(name)

    def generate(self, tool: str, values: dict[str, str]) -> None:
        """Open a generator by its button, enter values, and end with Enter."""
        self.click(self.page.locator(f'.tool[data-tool="{tool}"]'))
        for key, value in values.items():
            self.enter(value, self.page.locator(f'.action-dialog [data-key="{key}"] :is(input, select)'))
        self.keys("Enter")

    def draw(self, tool: str, places: Iterable[str]) -> None:
        """Draw with a tool by typed places."""
        self.page.locator(".drawing").focus()
        self.keys(tool)
        for place in places:
            self.type(place)

    def add_case(self, kind: str) -> None:
        """Add a load case of an action under its usual name in the plan, to which new loads belong."""
        before = self.bench.text().count("[[cases]]")
        self.click(self.page.get_by_role("button", name="+ case"))
        self.enter(kind, self.page.get_by_label("action of the new load case"))
        self.bench.until(lambda: self.bench.text().count("[[cases]]") > before)

    def line(self, tool: str, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Drag a straight line, or a shape, with a tool."""
        self.page.locator(".drawing").focus()
        self.keys(tool)
        self.actions += 1
        self.bench.drag(start, end)

    def click_at(self, x: float, y: float) -> None:
        """Click on a place of the plan [m]."""
        self.actions += 1
        self.bench.click(x, y)

    def open_section(self, name: str) -> None:
        """Open a section of the form."""
        self.click(self.page.locator(f'[data-section="{name}"] > summary'))

    def add_section(self, name: str) -> None:
        """Open a section of the form, and add it with what it starts from."""
        self.open_section(name)
        self.click(self.page.locator(f'[data-section="{name}"] .sub-head').get_by_role("button", name="Add").first)


def begin(server: Server, bench: Bench) -> Hands:
    """Open a new case, which is solved when it is finished alone."""
    bench.open(server.start(None))
    hands = Hands(bench)
    hands.click(bench.page.locator("label:has(#autosolve)").first)
    return hands


def model_of(bench: Bench) -> Model:
    """Return the model, which has no issue."""
    issues = bench.page.locator(".issue-list")
    bench.until(lambda: "No errors" in bench.seen(".issue-count"), lambda: str(issues.text_content()))
    return casefile.loads(bench.text())


def forces_of(model: Model, case: str) -> float:
    """Return the sum of the point loads of a case [N]."""
    loads = place_patterns(model).loads
    return sum(load.P for load in loads if load.kind == "point" and load.case == case)


def all_loads(bench: Bench) -> list[dict[str, Any]]:
    """Return the loads of the case file."""
    found: list[dict[str, Any]] = tomllib.loads(bench.text()).get("loads", [])
    return found

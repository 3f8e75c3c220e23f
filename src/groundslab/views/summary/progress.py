"""The progress of the analysis: on one line of a terminal, or a line every ten seconds in a file."""

from __future__ import annotations

import time
from contextlib import contextmanager
from typing import TYPE_CHECKING

from groundslab.messages import Label, Message, Name, joined

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from rich.console import Console

    from groundslab.model.loads.load_cases import Combination
    from groundslab.results.records import Step


#: Shortest time between two lines in a file [s].
INTERVAL = 10.0


class CombinationCount:
    """Counts the combinations as they begin, from the first again on each mesh, and estimates the time that is left.

    A mesh is another one when a combination begins again. The estimate is the mean time of those that are done, as if
    all are solved on this mesh: further ones may have only those that govern. The first on a mesh, which takes the
    meshing and the first factorization too, is left out of it. `mesh` is the number of the first mesh, None where it is
    the only one.
    """

    def __init__(self, count: int, clock: Callable[[], float] = time.monotonic, mesh: int | None = None) -> None:
        self._count, self._clock, self.mesh = count, clock, mesh
        self._names: set[str] = set()  # of those that have begun on this mesh
        self._name = ""
        self._begun = self._second_begun = 0.0

    @property
    def share(self) -> float | None:
        """The share of combinations that are done, None where there is only one."""
        return (len(self._names) - 1) / self._count if self._count > 1 else None

    def begin_mesh(self) -> None:
        """Note that the combinations begin anew on the next mesh."""
        self._names = set()
        self.mesh = None if self.mesh is None else self.mesh + 1

    def begin(self, name: str) -> None:
        """Note that the next combination begins."""
        if name in self._names:
            self.begin_mesh()
        self._names.add(name)
        self._name, self._begun = name, self._clock()
        if len(self._names) == 2:
            self._second_begun = self._begun

    def seconds_left(self) -> float | None:
        """Return the time that the combinations of this mesh still take, None before it can be estimated [s]."""
        number = len(self._names)
        if number < 3:
            return None
        mean = (self._begun - self._second_begun) / (number - 2)
        return max(0.0, mean * (self._count - number + 1) - (self._clock() - self._begun))

    def words(self) -> str:
        """Return the mesh, number and name of the combination and the time left, empty where there is only one each."""
        parts = self._mesh_words()
        if self._count > 1:
            number = Message("{number} of {count}", number=len(self._names), count=self._count)
            parts += [number, Name(self._name), *self._left_words()]
        return joined(parts) + ": " if parts else ""

    def describe(self, step: Step | None = None) -> str:
        """Return how the analysis goes on in words for engineers, empty where there is nothing to tell them yet.

        Which combination is solved on which mesh, whether the slab lifts off, and the time that is left; `words` and
        `line` have the iterations.
        """
        parts: list[str] = []
        if self._count > 1 and self._names:
            parts.append(Message("combination {number} of {count}", number=len(self._names), count=self._count))
        parts += self._mesh_words()
        if step is not None and step.increment > 1:
            parts.append(Message("load step {number}", number=step.increment))
        if step is not None and (step.changed or step.iteration > 1):
            parts.append(Message("where the slab lifts off (step {number})", number=step.iteration))
        return joined([*parts, *self._left_words()])

    def _mesh_words(self) -> list[str]:
        """Return which mesh it is, empty where it is the only one."""
        return [] if self.mesh is None else [Message("mesh {number}", number=self.mesh)]

    def _left_words(self) -> list[str]:
        """Return how much time is left, empty where that is not known or none."""
        left = self.seconds_left()
        return [] if left is None or left < 1.0 else [Message("about {left:.0f} s left on this mesh", left=left)]


class Progress:
    """Shows each step, and the mesh and the combination that it belongs to, where there are several."""

    def __init__(self, show: Callable[[str], None], combinations: CombinationCount) -> None:
        self._show, self._combinations = show, combinations

    def begin_mesh(self) -> None:
        """Note that the next mesh begins."""
        self._combinations.begin_mesh()

    def begin(self, combination: Combination) -> None:
        """Show that the next combination begins; where there is only one, it is not named."""
        self._combinations.begin(combination.name)
        self._show(self._combinations.words() + Label("begins"))

    def __call__(self, step: Step) -> None:
        """Show a step."""
        self._show(self._combinations.words() + line(step))


@contextmanager
def on_terminal(combinations: CombinationCount, console: Console | None = None) -> Iterator[Progress]:
    """Show the progress on one line of standard error, or of the given console."""
    from rich.console import Console
    from rich.text import Text

    console = console or Console(stderr=True)
    with console.status("analysis begins") as status:
        # as text, since a name may hold what rich takes for markup
        yield Progress(lambda words: status.update(Text(words)), combinations)


@contextmanager
def in_file(
    combinations: CombinationCount, write: Callable[[str], None], clock: Callable[[], float] = time.monotonic
) -> Iterator[Progress]:
    """Write the progress as lines, the first after INTERVAL, and no further one before it has passed again."""
    begun = last = clock()

    def show(words: str) -> None:
        nonlocal last
        now = clock()
        if now - last >= INTERVAL:
            last = now
            write(f"{now - begun:.0f} s: {words}")

    yield Progress(show, combinations)


def line(step: Step) -> str:
    """Return one step of the iteration in words."""
    return Message(
        "{unknowns} unknowns, load {load}{gamma}, contact {contact}: {closed} closed, {changed} changed",
        unknowns=step.unknowns,
        load=step.increment,
        gamma="" if step.gamma is None else Message(", gamma {gamma:.5g}", gamma=step.gamma),
        contact=step.iteration,
        closed=step.in_contact,
        changed=step.changed,
    )

"""Every way in which a check ends without a verdict, and what the engineer is to do.

A check that can be made of what is known is made. One that cannot needs attention, says why and what to do, and is
counted by itself in the headline. What no check ever looks at, such as anchorage, is "not checked" instead. The
documentation has the table, with what is true in each case.
"""

from __future__ import annotations

from dataclasses import dataclass

#: So many of those that a check is about are named.
MOST_NAMED = 5


@dataclass(frozen=True, slots=True)
class Unjudged:
    """A way in which checks end without a verdict.

    Attributes
    ----------
    name : str
        What it is called.
    do : str
        What the engineer is to do.
    """

    name: str
    do: str


#: Punching: another support stands inside the perimeter, and what it takes off is needed for the check to hold.
SUPPORT_INSIDE = Unjudged(
    "support-inside", "move it out of the perimeter, or design what is between by struts and ties"
)
#: Punching: openings and edges leave nothing of the perimeter.
NO_PERIMETER = Unjudged("no-perimeter", "move the openings or the load, or design the slab there by hand")
#: Punching: a column pulls at the slab in an ultimate combination, or a pile does, or it only turns the slab.
PULLS = Unjudged("pulls-or-turns", "tie it to the far face of the slab, and check punching the other way by hand")
#: Equilibrium: glued ground pulls so that its force has no place under the plate, but supports might do without.
GLUED = Unjudged("glued-to-the-ground", "set contact.tensionless = true")
#: A combination has no certified result.
UNSOLVED = Unjudged("no-certified-result", "see why it was not solved, and solve it again")
#: No combination of the limit state that is asked for has a certified result.
NO_COMBINATION = Unjudged("no-combination", "add such a combination")
#: Limits between columns: there are no two columns whose settlements could differ.
ONE_COLUMN = Unjudged("fewer-than-two-columns", "remove the limit, or describe the columns")
#: The program has no rule of the code for it.
NO_RULE = Unjudged("no-rule", "check it by hand, or choose another code")
#: Beams: a beam is described by its stiffness alone, so that its strength is not known.
GIVEN_SECTION = Unjudged("section-by-its-properties", "check its strength by hand, or describe it by width and height")
#: Crack width by EN 1992-1-1:2023, resistance of piles: neither the case nor the program knows what resists.
NO_LIMIT = Unjudged("no-limit", "give it in the case")
#: Restraint: no bars are laid.
NO_BARS = Unjudged("no-bars", "lay the bars")
#: Restraint: the bars yield, so that no crack width is valid.
BARS_YIELD = Unjudged("bars-yield", "lay more bars")
#: Cover: the annex leaves it to another standard.
OTHER_STANDARD = Unjudged("another-standard", "take it from there")
#: Dowels: neither [floor] by TR34 nor [reinforcement] gives the concrete.
NO_CONCRETE = Unjudged("no-concrete", "give one of them")
#: All of them, in the order in which the documentation lists them.
UNJUDGED = (
    SUPPORT_INSIDE, NO_PERIMETER, PULLS, GLUED, UNSOLVED, NO_COMBINATION, ONE_COLUMN, NO_RULE,
    GIVEN_SECTION, NO_LIMIT, NO_BARS, BARS_YIELD, OTHER_STANDARD, NO_CONCRETE,
)  # fmt: skip

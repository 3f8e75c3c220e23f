"""What the report says of the assumptions of a case: those that its own keys make, and no others."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from groundslab.design.codes.en1992_2004.annex import file_of
from groundslab.messages import Message, Name, joined, series, words_in
from groundslab.model.ground import ContinuousGround, Continuum, Winkler
from groundslab.model.plates.pits import pits_of
from groundslab.views.tables.reinforcement import averages

if TYPE_CHECKING:
    from groundslab.model.design.reinforcement import Reinforcement
    from groundslab.model.model import Model
    from groundslab.results.results import Results

_PLATE = (
    "The plate is isotropic in each zone, with small displacements and shear deformation (Mindlin). Its midsurface "
    "stays one plane."
)
_PITS = (
    "Pits are analyzed as if their floors were at the level of the slab around, without forces in its plane: their "
    "walls hand over the moments of the floor unchanged, and only these bend the walls here. Where layers of soil are "
    "given, those under a pit begin at its underside."
)
_ELASTIC = "It is linearly elastic: it does not crack, creep or yield."
_CRACKED = (
    "In {states} combinations it has the secant stiffness of cracked sections with the bars provided (EN 1992-1-1 "
    "7.4.3){creep}; the bars stay elastic. In all others it is linearly elastic and uncracked."
)
_LOADS = (
    "Loads act at the midsurface and vertically, moments about horizontal axes. Self-weight counts only if the case "
    "includes it as a load."
)
_GROUND = {
    "winkler": "The ground is made of springs that do not act on each other and stay linearly elastic",
    "pasternak": "The ground is made of springs under a shear layer, all linearly elastic; its points move vertically "
    "only",
    "layers": "The ground is linearly elastic on a rigid base under the lowest layer, and carries shear. Its points "
    "move vertically only, which is stiffer than a true elastic layer",
    "continuum": "The ground is a linearly elastic continuum that spreads loads in all directions, {below}",
    "constrained modulus": "The ground is linearly elastic, its layers are compressed by the stresses in a homogeneous "
    "half-space",
}
_BEAMS = (
    "Beams and ribs bend, shear and twist with the plate, linearly elastic and uncracked, their axes in its middle "
    "plane; a rib has a flange of its effective width. Eccentric ones stretch the plate in its plane instead, in which "
    "nothing else holds it. They weigh what loads say."
)
_SPANS = (
    "Over openings of the plate beams and walls span from edge to edge by themselves; what acts on them there goes to "
    "both edges."
)
_BUILDING = (
    "Loads on columns and walls are those of the building on a base that does not move. Its stiffness, which is linear "
    "and there from the first load on, changes them as the slab settles; it moves with the means of its footprints."
)
_SMOOTHED = (
    "Moments and shear forces at nodes are smoothed over the elements that meet there, never across a change of "
    "thickness or material. Under a point load or a rigid point support they grow without limit as the mesh is refined."
)
_LINE_FORCE = (
    "At the plate's edge the ground's shear acts as a line force, in addition to the pressure. The pressure limit "
    "counts it as pressure over a strip, and it relieves neither punching nor one-way shear{unless}."
)
_PARAMETERS = (
    "National parameters are those of {title}; the page National parameters of the documentation lists each with its "
    "sources."
)
_CELLS = (
    "Pressure at a node is the mean of the cells around it. It has no limit along the plate's edge: its largest value "
    "grows as the mesh is refined."
)


def list_assumptions(combined: Results) -> list[str]:
    """Return the assumptions of a solved case, a sentence or two each."""
    model = combined.model
    plate = joined((_PLATE, _of_plate(model)), " ")
    sentences = [plate, _LOADS, _of_contact(model), _of_ground(model), *_of_supports(model)]
    if len(combined.combinations) > 1:
        nonlinear = ", as contact makes the response nonlinear" if model.contact.tensionless else ""
        sentences.append(
            Message(
                "Each combination is solved by itself with all its loads growing together{nonlinear}. Results of "
                "different combinations must not be added up.",
                nonlinear=nonlinear,
            )
        )
    sentences += [_SMOOTHED, *_of_pressure(combined)]
    if model.reinforcement is not None:
        sentences.append(
            Message("Bars are for Wood's design moments, {supports}.", supports=averages(model.reinforcement))
        )
        sentences += _of_parameters(model.reinforcement)
    if len(combined.combinations) > 1:
        sentences.append(
            "Envelopes hold the extreme of each quantity by itself; values in different rows need not act together."
        )
    return [words_in(sentence, model.units) for sentence in sentences]


def _of_parameters(steel: Reinforcement) -> Iterator[str]:
    """Yield whose national parameters a design has, and where their sources are listed."""
    if steel.code == "EN 1992-1-1" and steel.annex != "recommended":
        yield Message(_PARAMETERS, title=Name(file_of(steel.annex).title))


def _of_plate(model: Model) -> str:
    """Return whether the plate cracks."""
    if model.cracking is None:
        return _ELASTIC
    creep: str = ", without creep"
    if model.cracking.creep:
        creep = Message(", creep coefficient {creep:g}", creep=model.cracking.creep)
    return Message(_CRACKED, states=series(model.cracking.limit_states), creep=creep)


def _of_contact(model: Model) -> str:
    """Return the assumptions on contact between plate and ground."""
    lifts = "The ground carries no tension: the plate lifts off." if model.contact.tensionless else (
        "The case bonds them: the ground can carry tension."
    )  # fmt: skip
    return joined(("Plate and ground exchange vertical pressure without friction.", lifts), " ")


def _of_ground(model: Model) -> str:
    """Return how the ground resists, where it ends and where it yields."""
    ground = model.ground
    kind = ground.kind if ground.kind in _GROUND else "layers"
    below = ""
    if isinstance(ground, Continuum):
        below = "on a rigid base" if ground.half_space is None else "on a half-space"
    said: str = Message(_GROUND[kind], below=below) if below else _GROUND[kind]
    limit = model.contact.limit_pressure
    up_to: str = ""
    if limit is not None:
        up_to = Message(", up to its limit pressure of {limit:.6g kPa}, at which it yields", limit=limit / 1e3)
    parts: list[str] = [Message("{ground}{up_to}.", ground=said, up_to=up_to)]
    if not isinstance(ground, Winkler | ContinuousGround):
        ends = {
            "none": "The ground ends with the plate.",
            "margin": "The ground ends at the outer edge of a strip around the plate.",
            "infinite": "The ground extends infinitely beyond the plate.",
        }
        parts.append(ends[model.beyond.kind])
    if model.long_term is not None:
        states = series(model.long_term.limit_states)
        template = "In {states} combinations it has {share:g} of its stiffness."
        parts.append(Message(template, states=states, share=model.long_term.stiffness))
    return joined(parts, " ")


def _of_supports(model: Model) -> Iterator[str]:
    """Yield what supports, piles, pits, beams, the building above and joints do beside being elastic."""
    limited = [support.name or Message("support {number}", number=number)
               for number, support in enumerate(model.supports, 1)
               if support.limit is not None or getattr(support, "limit_tension", None)]  # fmt: skip
    if limited:
        names: str = joined(limited[:5])
        if len(limited) > 5:
            names = Message("{names} and {count} more", names=names, count=len(limited) - 5)
        yield Message("Supports and piles with a limit yield there and keep that force: {names}.", names=names)
    if any(map(pits_of, model.every_plate)):
        yield _PITS
    if model.members:
        yield _BEAMS
    if model.spans:
        yield _SPANS
    if model.building is not None:
        yield _BUILDING
    if model.joints:
        sentences = ["Joints transfer shear by the difference in settlement across them, and no moments."]
        yield joined([*sentences, *(["Beams and walls that cross them go on."] if model.members else [])], " ")


def _of_pressure(combined: Results) -> Iterator[str]:
    """Yield how pressures along the plate's edge are to be read."""
    if isinstance(combined.model.ground, ContinuousGround):
        yield _CELLS
    elif any(any(result.constants.k1) for result in combined.results.values()):
        steel = combined.model.reinforcement
        yield Message(_LINE_FORCE, unless=", but the case lets it" if steel and steel.line_force_relieves else "")

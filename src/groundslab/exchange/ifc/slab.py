"""The slab that is read from a building: which one it is, its outline, openings and thickness."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from groundslab.errors import InputError, Issue
from groundslab.exchange.ifc.body import LEVEL, SAME_AREA, Body, is_prismatic
from groundslab.exchange.ifc.file import IfcFile
from groundslab.exchange.report import ReportLine
from groundslab.schema.wording import describe, suggestion

if TYPE_CHECKING:
    from shapely import Polygon

#: What a slab on ground may be.
CLASSES = ("IfcSlab", "IfcFooting")
#: Slabs that are listed at most.
MOST_LISTED = 40
#: An opening through the slab may end so far before its faces [m].
THROUGH = 1e-3


@dataclass(frozen=True, slots=True)
class Slab:
    """A slab: its name, its plan without openings, its top and bottom [m], its thickness [m] if that is one number."""

    name: str
    plan: Polygon
    top: float
    bottom: float
    thickness: float | None


@dataclass(frozen=True, slots=True)
class SlabInFile:
    """A slab of a file: its GlobalId, name and storey, height of its top [m], extent along x and y [m].

    ``columns`` and ``walls`` are how many of them stand on it. A slab that cannot be read has a ``problem``.
    """

    id: str
    name: str
    storey: str
    height: float | None = None
    sides: tuple[float, float] | None = None
    columns: int = 0
    walls: int = 0
    problem: str = ""


def name_of(element: Any) -> str:
    """Return the name of an element, or else its GlobalId."""
    return str(element.Name or "").strip() or str(element.GlobalId)


def find_slabs(file: IfcFile) -> list[Any]:
    """Return the elements that may be a slab on ground; raises InputError if there are none."""
    slabs = [element for name in CLASSES for element in file.by_type(name) if element.Representation is not None]
    if not slabs:
        raise InputError([Issue(file.path, "no slab", f"one of {' or '.join(CLASSES)} with geometry")])
    return slabs


def choose_slab(file: IfcFile, wanted: str) -> Any:
    """Return the element of the slab of a name or GlobalId, or the only one; raises InputError that lists them."""
    slabs = find_slabs(file)
    chosen = [element for element in slabs if not wanted or wanted in (element.GlobalId, name_of(element))]
    chosen = chosen or [element for element in slabs if _spelled(wanted) == _spelled(name_of(element))]
    if len(chosen) == 1:
        return chosen[0]
    if chosen:
        issues = [Issue(file.path, f"{len(chosen)} slabs", "the name or the GlobalId of one of them")]
    else:
        hint = suggestion(wanted, [name_of(element) for element in slabs])
        issues = [Issue(file.path, f"no slab {describe(wanted)}", "one of those that follow", hint)]
    listed = (chosen or slabs)[:MOST_LISTED]
    issues += [Issue(f"slab {describe(name_of(element))}", _about(file, element), "one of these") for element in listed]
    if more := len(chosen or slabs) - len(listed):
        issues.append(Issue(file.path, f"{more:,} more slabs", "one of these"))
    raise InputError(issues)


def _spelled(name: str) -> str:
    """Return a name without capitals and spaces."""
    return "".join(name.split()).casefold()


def _about(file: IfcFile, element: Any) -> str:
    """Return GlobalId, storey, area and height of a slab in words."""
    body = file.body(element)
    size = body
    if isinstance(body, Body):
        size = f"{body.plan().area:.6g} m2, top at {body.top:.6g} m"
    return f"{element.GlobalId}, {element.is_a()}, {storey_of(file, element)}, {size}"


def storey_of(file: IfcFile, element: Any) -> str:
    """Return the storey that an element belongs to, in words."""
    storey = storey_name(file, element)
    return f"storey {describe(storey)}" if storey else "no storey"


def storey_name(file: IfcFile, element: Any) -> str:
    """Return the name of the storey that an element belongs to, empty if there is none."""
    try:
        container = file.relations.get_container(element)
        return "" if container is None else name_of(container)
    except (AttributeError, RuntimeError):
        return ""


def read_slab(file: IfcFile, element: Any, report: list[ReportLine]) -> Slab:
    """Return a slab with its openings; raises InputError if it is not level, or none."""
    where = f"{file.path}, {element.is_a()} {describe(name_of(element))}"
    body = file.body(element)
    if isinstance(body, str):
        raise InputError([Issue(where, body, "a slab with a body")])
    whole, top = body.plan(), body.face(body.top)
    if top.area < (1 - SAME_AREA) * whole.area or not whole.area:
        tilt = body.tilt()
        uneven_top = f"faces that are tilted by {tilt:g} degrees" if tilt > 0 else "a top at several heights"
        part = f"{top.area:.6g} m2 of {whole.area:.6g} m2 are at its top, {body.top:.6g} m"
        raise InputError([Issue(where, uneven_top, "a slab with a level top", part)])
    thickness = body.top - body.bottom if is_prismatic(body) else None
    what = f"the slab, {top.area:.6g} m2, top at {body.top:.6g} m"
    report.append(ReportLine(element.is_a(), name_of(element), True, what))
    if thickness is None:
        why = "its body is no plate of one thickness, which is to be filled in"
        report.append(ReportLine(element.is_a(), name_of(element), None, why))
    report += contradictions(file, element, thickness)
    plan = _without_openings(file, element, body, top, report)
    if plan.geom_type != "Polygon":
        pieces = len(getattr(plan, "geoms", ()))
        raise InputError([Issue(where, f"a plan of {pieces} pieces", "one piece", "a case describes one plate")])
    return Slab(name_of(element), plan, body.top, body.bottom, thickness and round(thickness, 9))


def contradictions(file: IfcFile, element: Any, thickness: float | None) -> list[ReportLine]:
    """Return a note on each thickness [m] that the file says of an element and that its body does not have."""
    said = {} if thickness is None else file.said_thickness(element)
    return [
        ReportLine(
            element.is_a(), name_of(element), None,
            f"its body is {thickness:.6g} m thick, {what} {'is' if what.startswith('its q') else 'are'} {value:.6g} m: "
            "the body counts",
        )
        for what, value in said.items()
        if thickness is not None and abs(value - thickness) > THROUGH
    ]  # fmt: skip


def _without_openings(file: IfcFile, element: Any, body: Body, plan: Any, report: list[ReportLine]) -> Any:
    """Return the plan of a slab without the openings that go through it."""
    for void in (relation.RelatedOpeningElement for relation in element.HasOpenings):
        name, kind = name_of(void), void.is_a()
        opening = file.body(void)
        if isinstance(opening, str):
            report.append(ReportLine(kind, name, False, opening))
        elif opening.top < body.top - THROUGH or opening.bottom > body.bottom + THROUGH:
            report.append(ReportLine(kind, name, False, "it does not go through the slab: a recess, not an opening"))
        elif (hole := opening.plan()).intersection(plan).area <= LEVEL**2:
            report.append(ReportLine(kind, name, False, "it lies beside the slab, or in another opening"))
        else:
            inside = plan.exterior.distance(hole) > 0 if plan.geom_type == "Polygon" else False
            what = f"an opening of {hole.area:.6g} m2{'' if inside else ', cut out of the edge'}"
            report.append(ReportLine(kind, name, True, what))
            plan = plan.difference(hole)
    return plan

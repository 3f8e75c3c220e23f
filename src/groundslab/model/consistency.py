"""Checks between the sections of a model."""

from __future__ import annotations

from collections.abc import Iterator
from math import sqrt

from groundslab.errors import Edit, Repair
from groundslab.geometry.plan import MOST_ELEMENTS
from groundslab.geometry.validity import TOO_CLOSE, find_issues
from groundslab.model import varying_ground
from groundslab.model.axes.families import check_axes
from groundslab.model.cracking import Cracking, check_cracking
from groundslab.model.design.floors import check_floor
from groundslab.model.design.limits import SoilStrength
from groundslab.model.design.reinforcement import (
    check_bar_distances,
    check_bar_zones,
    check_beam_links,
    check_beta,
    check_links,
    check_shear_links,
    check_strips,
)
from groundslab.model.ground import AnyGround, ContinuousGround, Continuum, Layered, SoilLayer, Winkler, carry_shear
from groundslab.model.loads.beside import check_ground_loads
from groundslab.model.loads.clipping import check_distributed_loads
from groundslab.model.loads.core_loads import check_core_moments
from groundslab.model.loads.en1990 import check_combine
from groundslab.model.loads.load_cases import (
    Combination,
    LoadCase,
    check_case_names,
    check_design_combinations,
    check_factors,
)
from groundslab.model.loads.load_types import AnyLoad, SettlementLoad, is_zero
from groundslab.model.loads.patterns import Move, check_patterns, check_positions
from groundslab.model.loads.placement import (
    check_load_columns,
    check_load_cores,
    check_load_walls,
    check_point_loads,
    on_plate,
)
from groundslab.model.outputs import Output, check_output, check_wall_limits
from groundslab.model.plate import Plate
from groundslab.model.plates.joints import AnyJoint, check_joints
from groundslab.model.plates.other_plates import FurtherPlate, bounds_of, check_plates, list_plates, shared_line
from groundslab.model.plates.pits import check_pits, chord_of, pits_of
from groundslab.model.plates.region import PlateRegion
from groundslab.model.reactions import check_reactions
from groundslab.model.settings import SIDES, Beyond, Contact, Mesh
from groundslab.model.structure.beams import Beam
from groundslab.model.structure.building import check_building
from groundslab.model.structure.columns import Column
from groundslab.model.structure.cores import Core, check_cores
from groundslab.model.structure.doors import check_doors
from groundslab.model.structure.members import as_beam, check_members
from groundslab.model.structure.spans import spans_of
from groundslab.model.structure.walls import Wall, WallFaces
from groundslab.model.supports import (
    AnySupport,
    check_line_supports,
    check_names,
    check_piles,
    check_support_distances,
    plan_of_plate,
)
from groundslab.model.varying_ground import Borehole, SoilZone
from groundslab.schema.base import Check
from groundslab.schema.issues import FieldError, RelativeIssue
from groundslab.schema.repairs import remove, set_value, use_nearest
from groundslab.schema.wording import describe, one_of, quote, suggestion

MOST_SURFACES = 200  # each couples with all others at every node
#: The first mesh, where none is described, has so many elements on a plate's shorter side, on that of a long strip
#: fewer: no more than so many in all, if that leaves the least number.
SHORT_SIDE_ELEMENTS, LEAST_ON_SHORT_SIDE, USUAL_ELEMENTS = 12, 6, 500


def usual_size(sides: tuple[float, float]) -> float:
    """Return the size of elements [m] of the first mesh of a plate with sides (x, y) [m], where none is described."""
    x, y = sides
    return min(max(min(sides) / SHORT_SIDE_ELEMENTS, sqrt(x * y / USUAL_ELEMENTS)), min(sides) / LEAST_ON_SHORT_SIDE)


def estimate_elements(plate: Plate, plates: tuple[FurtherPlate, ...], mesh: Mesh) -> float:
    """Return about how many elements the plates have."""
    if mesh.counts is not None:
        return mesh.counts[0] * mesh.counts[1]
    total = 0.0
    for x, y in (slab.sides for slab in list_plates(plate, plates)):
        size = mesh.size if mesh.size is not None else usual_size((x, y))
        total += max(1.0, x / size) * max(1.0, y / size)
    return total


def check_element_count(plate: Plate, plates: tuple[FurtherPlate, ...], mesh: Mesh) -> Iterator[RelativeIssue]:
    """Find meshes with too many elements on the plate."""
    total = estimate_elements(plate, plates, mesh)
    if total > MOST_ELEMENTS:
        key = ("counts",) if mesh.counts is not None else ("size",) if mesh.size is not None else ()
        yield RelativeIssue(("mesh", *key), f"about {total:.3g} elements", f"at most {MOST_ELEMENTS:,} elements")


def check_surface_count(
    plate: Plate, plates: tuple[FurtherPlate, ...], mesh: Mesh, ground: AnyGround
) -> Iterator[RelativeIssue]:
    """Find layers that have too many elements in all their surfaces."""
    if isinstance(ground, Layered):
        surfaces = sum(layer.sublayers if isinstance(layer, SoilLayer) else 1 for layer in ground.layers)
        on_plate = estimate_elements(plate, plates, mesh)
        if surfaces > MOST_SURFACES:
            yield RelativeIssue(("ground", "layers"), f"{surfaces} layers and sublayers", f"at most {MOST_SURFACES}")
        elif on_plate <= MOST_ELEMENTS < on_plate * surfaces:
            product = f"{surfaces} layers and sublayers on about {on_plate:.3g} elements"
            yield RelativeIssue(("ground", "layers"), product, f"at most {MOST_ELEMENTS:,} for the product of both")


def check_shear_of_layers(
    ground: AnyGround, soil_zones: tuple[SoilZone, ...], beyond: Beyond
) -> Iterator[RelativeIssue]:
    """Find layers without shear beside others with it, where the ground beyond is infinite.

    Ground without any shear is the limit in which it ends with the plate; of such layers beneath or beside others no
    tail is known.
    """
    grounds = {("ground",): ground} | {("soil_zones", n, "ground"): zone.ground for n, zone in enumerate(soil_zones)}
    shears = {place: carry_shear(soil) for place, soil in grounds.items()}
    if beyond.kind != "infinite" or not any(map(any, shears.values())):
        return
    for place, layers in shears.items():
        for number in (number for number, shear in enumerate(layers) if not shear):
            key = ("layers", number, "k1") if isinstance(grounds[place], Layered) else ("k1",)
            hint = 'beyond.kind = "margin" needs no shear'
            if isinstance(grounds[place], Winkler):
                continue  # of another kind than the rest, an issue of its own
            expected = "k1 above 0, as other ground has it and is infinite"
            repairs = _end_ground(beyond)
            yield RelativeIssue((*place, *key), "0 N/m", expected, hint, repairs)


def _end_ground(beyond: Beyond) -> tuple[Repair, ...]:
    """Return the repair that ends infinite ground with the plate."""
    width = () if beyond.width is None else (Edit("remove", ("beyond", "width")),)
    return (Repair('set beyond.kind to "none"', (Edit("set", ("beyond", "kind"), "none"), *width)),)


def check_continuum(
    ground: AnyGround, beyond: Beyond, soil_zones: tuple[SoilZone, ...], boreholes: tuple[Borehole, ...]
) -> Iterator[RelativeIssue]:
    """Find what ground without an end sideways cannot have."""
    if not isinstance(ground, ContinuousGround):
        return
    varying: list[tuple[str, tuple[object, ...]]] = [("soil_zones", soil_zones)]
    varying += [("boreholes", boreholes)] if isinstance(ground, Continuum) else []
    for name, items in varying:
        if items:
            hint = 'boreholes go with ground.kind = "constrained modulus" or "vlasov"'
            repairs = (remove((name,)),)
            yield RelativeIssue((name,), f"{name} in {quote(ground.kind)} ground", "no such", hint, repairs)
    if beyond.kind == "margin" and (beyond.edge == "fixed" or beyond.sides != SIDES):
        margin = "a margin that ends" if beyond.edge == "fixed" else "ground beyond some sides"
        expected = 'kind = "infinite", as this ground has no end on any side'
        edits = (
            Edit("set", ("beyond", "kind"), "infinite"),
            *(Edit("remove", ("beyond", key)) for key in ("edge", "sides")),
        )
        repairs = (Repair('set beyond.kind to "infinite"', edits),)
        yield RelativeIssue(("beyond",), margin, expected, "width says how much of it is shown", repairs)


def check_contact_voids(plate: Plate, plates: tuple[FurtherPlate, ...], contact: Contact) -> Iterator[RelativeIssue]:
    """Find voids that do not lie on the plate."""
    covered = PlateRegion(plate, plates)
    for position, void in enumerate(contact.voids):
        yield from on_plate(covered, void, ("contact", "voids", position))


def check_mesh_counts(
    plate: Plate, plates: tuple[FurtherPlate, ...], mesh: Mesh, supports: tuple[AnySupport, ...]
) -> Iterator[RelativeIssue]:
    """Find counts of elements on what is not one plain rectangle."""
    if mesh.counts is not None and (plates or supports or not plate.plain):
        hint = "counts are for one rectangle without openings, zones and supports"
        yield RelativeIssue(("mesh", "counts"), "counts", "a size", hint, (remove(("mesh", "counts")),))


def check_load_cases(loads: tuple[AnyLoad, ...], cases: tuple[LoadCase, ...]) -> Iterator[RelativeIssue]:
    """Find load cases without a unique name, and loads of unknown cases."""
    yield from check_names("cases", [case.name for case in cases], needed=True)
    yield from check_case_names("loads", "case", [load.case for load in loads], cases)


def check_combinations(combinations: tuple[Combination, ...], cases: tuple[LoadCase, ...]) -> Iterator[RelativeIssue]:
    """Find combinations without a unique name, and factors of unknown cases."""
    yield from check_names("combinations", [combination.name for combination in combinations], needed=True)
    yield from check_factors(combinations, cases)


def check_columns(
    plate: Plate, plates: tuple[FurtherPlate, ...], columns: tuple[Column, ...]
) -> Iterator[RelativeIssue]:
    """Find columns without a unique name or off the plate."""
    yield from check_names("columns", [column.name for column in columns], needed=True)
    covered = PlateRegion(plate, plates)
    for position, column in enumerate(columns):
        yield from on_plate(covered, column, ("columns", position))


def check_over_pits(
    plate: Plate, plates: tuple[FurtherPlate, ...], beams: tuple[Beam, ...], output: Output
) -> Iterator[RelativeIssue]:
    """Find beams, and strips designed as beams, that run into pits: what joins their parts there is not known."""
    pits = [(pit.area(chord_of(slab)), chord_of(slab)) for slab in list_plates(plate, plates) for pit in pits_of(slab)]
    expected, hint = "one that ends at the pit, or none", "its parts lie at different levels there"
    for area, chord in pits:
        for number, beam in enumerate(beams):
            if beam.to_shapely(chord).intersects(area.buffer(-2 * chord)):
                yield RelativeIssue(("beams", number), "a beam across a pit", expected, hint)
        for number, strip in enumerate(output.strips):
            if strip.design == "beam" and strip.area().intersects(area.buffer(-2 * chord)):
                place = ("output", "strips", number, "design")
                yield RelativeIssue(place, '"beam" across a pit', expected, hint)


def check_walls(plate: Plate, plates: tuple[FurtherPlate, ...], walls: tuple[Wall, ...]) -> Iterator[RelativeIssue]:
    """Find walls without a unique name, along no edge of a plate, or whose axis leaves the plate, and unfit doors.

    One along an edge stands on the plate with all of its thickness.
    """
    yield from check_names("walls", [wall.name for wall in walls], needed=True)
    covered = PlateRegion(plate, plates)
    near = TOO_CLOSE * covered.size
    for position, wall in enumerate(walls):
        try:
            placed = wall.on(covered.every)
        except FieldError as error:
            yield from (issue.below(("walls", position)) for issue in error.relative_issues)
        else:
            if wall.height is not None and spans_of(as_beam(placed), plate, plates):
                continue  # over openings of the plate it is checked as a beam
            yield from on_plate(covered, placed if wall.edge is None else WallFaces(placed), ("walls", position))
            yield from (issue.below(("walls", position)) for issue in check_doors(placed, near) if placed.doors)


def check_walls_of_cores(
    plate: Plate, plates: tuple[FurtherPlate, ...], walls: tuple[Wall, ...], cores: tuple[Core, ...]
) -> Iterator[RelativeIssue]:
    """Find cores whose walls are not there, bend in arcs, lie on each other or are in another one."""
    yield from check_cores(cores, walls, list_plates(plate, plates))


def check_moments_of_cores(
    plate: Plate,
    plates: tuple[FurtherPlate, ...],
    walls: tuple[Wall, ...],
    cores: tuple[Core, ...],
    loads: tuple[AnyLoad, ...],
) -> Iterator[RelativeIssue]:
    """Find moments that the walls of a core cannot carry."""
    yield from check_core_moments(loads, cores, walls, list_plates(plate, plates))


def check_supports(
    plate: Plate, plates: tuple[FurtherPlate, ...], supports: tuple[AnySupport, ...]
) -> Iterator[RelativeIssue]:
    """Find supports that no mesh can be fitted to."""
    yield from check_line_supports(supports)
    yield from check_names("supports", [support.name for support in supports], needed=False)
    far = list(check_support_distances(bounds_of(plate, plates), supports))
    yield from far
    if not supports or far or any(check_line_supports(supports)):
        return
    points = [n for n, support in enumerate(supports) if not support.edges]
    lines = [n for n, support in enumerate(supports) if support.edges]
    called = {f"plate.points[{n}]": number for n, number in enumerate(points, start=1)}
    called |= {f"plate.lines[{n}]": number for n, number in enumerate(lines, start=1)}
    for issue in find_issues(plan_of_plate(plate, supports, plates=plates)):
        met = next((name for name in called if name in issue.found), None)
        text = issue.found if met is None else issue.found.replace(met, f"supports[{called[met] + 1}]")
        if issue.location in called:
            yield RelativeIssue(("supports", called[issue.location]), text, issue.expected, issue.hint)
        elif met is not None:
            # what comes near another is reported for either of the two; a zone meets a support, too
            text = issue.found.replace(met, issue.location)
            yield RelativeIssue(("supports", called[met]), text, issue.expected, issue.hint)


def check_settlement_loads(loads: tuple[AnyLoad, ...], supports: tuple[AnySupport, ...]) -> Iterator[RelativeIssue]:
    """Find imposed settlements of unknown supports."""
    names = [support.name for support in supports if support.name]
    known_names = set(names)
    for position, load in enumerate(loads):
        if isinstance(load, SettlementLoad) and load.support not in known_names:
            expected = one_of(names) if names else "a support, and [[supports]] that says where it is"
            place = ("loads", position, "support")
            hint, repairs = suggestion(load.support, names), use_nearest(place, load.support, names)
            yield RelativeIssue(place, describe(load.support), expected, hint, repairs)


def check_some_load_acts(loads: tuple[AnyLoad, ...], moves: tuple[Move, ...]) -> Iterator[RelativeIssue]:
    """Find loads that are all zero, where no pattern stands anywhere."""
    if not moves and all(map(is_zero, loads)):
        yield RelativeIssue(
            ("loads",), "loads that are all zero", "at least one load that is not", "nothing would settle"
        )


def check_plate_of_loads(
    plate: Plate, plates: tuple[FurtherPlate, ...], loads: tuple[AnyLoad, ...]
) -> Iterator[RelativeIssue]:
    """Find loads on unknown plates."""
    names = [slab.name for slab in list_plates(plate, plates) if slab.name]
    for position, load in enumerate(loads):
        name = getattr(load, "plate", "")
        if name and name not in names:
            expected = one_of(names) if names else "no plate, as none has a name"
            place = ("loads", position, "plate")
            hint = suggestion(name, names)
            repairs = (*use_nearest(place, name, names), remove(place, label="remove plate"))
            yield RelativeIssue(place, describe(name), expected, hint, repairs)


def check_sections_with_plates(
    plates: tuple[FurtherPlate, ...],
    ground: AnyGround,
    soil_strength: SoilStrength | None,
    cracking: Cracking | None,
) -> Iterator[RelativeIssue]:
    """Find sections that are for a single plate beside several."""
    if not plates:
        return
    if isinstance(ground, Winkler) and ground.selvadurai is not None:
        hint = "the formula's k is one for each plate; soil_zones can hold them"
        yield RelativeIssue(("ground", "selvadurai"), "soil that gives the k of one plate", "k", hint)
    for name, section in {"soil_strength": soil_strength, "cracking": cracking}.items():
        if section is not None:
            section_with_plates, repairs = f"{name} with several plates", (remove((name,)),)
            yield RelativeIssue((name,), section_with_plates, f"no {name}", "it is for a single plate", repairs)


def check_supports_on_joints(
    plate: Plate, plates: tuple[FurtherPlate, ...], joints: tuple[AnyJoint, ...], supports: tuple[AnySupport, ...]
) -> Iterator[RelativeIssue]:
    """Find supports on the line of a joint, of which nobody knows which plate they hold."""
    if not joints or not supports:
        return
    from shapely import LineString, Point

    by_name = {slab.name: slab for slab in list_plates(plate, plates)}
    x0, x1, y0, y1 = bounds_of(plate, plates)
    near = TOO_CLOSE * max(x1 - x0, y1 - y0)
    for joint in joints:
        if not all(name in by_name for name in joint.between):
            continue
        line = shared_line(*(by_name[name] for name in joint.between)).buffer(near)
        for position, support in enumerate(supports):
            if support.edges:
                held = line.intersection(LineString(support.points)).length > 4 * near
            else:
                held = line.intersects(Point(support.points[0]))
            if held:
                hint = "two supports, one on either side, hold both plates"
                on_joint = f"a support on the joint {quote(joint.title)}"
                yield RelativeIssue(("supports", position), on_joint, "a support on one of the plates", hint)


def check_glued_joints(
    contact: Contact, ground: AnyGround, soil_zones: tuple[SoilZone, ...], joints: tuple[AnyJoint, ...]
) -> Iterator[RelativeIssue]:
    """Find elastic joints of plates glued to ground that goes on under them, which settle alike in any case."""
    if contact.tensionless or not any(any(carry_shear(soil)) for soil in (ground, *(z.ground for z in soil_zones))):
        return
    for position, joint in enumerate(joints):
        if joint.kind == "elastic":
            hint = "glued to the surface of ground that carries shear both sides settle as it does"
            expected = "a hinge, or contact.tensionless = true"
            repairs = (set_value(("contact", "tensionless"), True),)
            idle_joint = "an elastic joint without effect"
            yield RelativeIssue(("joints", position, "kind"), idle_joint, expected, hint, repairs)


#: Of plates, joints and their mesh.
PLATES: tuple[Check, ...] = (
    check_plates,
    check_pits,
    check_joints,
    check_axes,
    check_sections_with_plates,
    check_glued_joints,
    check_contact_voids,
    check_element_count,
    check_surface_count,
    check_mesh_counts,
)
#: Of loads, cases and combinations.
LOADS: tuple[Check, ...] = (
    check_plate_of_loads,
    check_some_load_acts,
    check_point_loads,
    check_distributed_loads,
    check_ground_loads,
    check_load_cases,
    check_combinations,
    check_combine,
    check_load_columns,
    check_load_walls,
    check_load_cores,
    check_moments_of_cores,
    check_patterns,
    check_positions,
    check_settlement_loads,
    check_reactions,
)
#: Of columns, walls, cores, beams, the building and supports.
MEMBERS: tuple[Check, ...] = (
    check_columns,
    check_walls,
    check_walls_of_cores,
    check_members,
    check_over_pits,
    check_building,
    check_supports,
    check_supports_on_joints,
    check_piles,
)
#: Of the ground.
GROUND: tuple[Check, ...] = (
    check_shear_of_layers,
    check_continuum,
    varying_ground.check_soil_zone_types,
    varying_ground.check_soil_zone_extent,
    varying_ground.check_soil_depth,
    varying_ground.check_pit_depth,
    varying_ground.check_boreholes,
)
#: Of what is asked of the results.
DESIGN: tuple[Check, ...] = (
    check_output,
    check_wall_limits,
    check_bar_distances,
    check_bar_zones,
    check_strips,
    check_links,
    check_beam_links,
    check_shear_links,
    check_beta,
    check_cracking,
    check_design_combinations,
    check_floor,
)
#: Each is given the sections that it names, and runs where these are right, whatever is wrong with others.
CHECKS: tuple[Check, ...] = (*PLATES, *LOADS, *MEMBERS, *GROUND, *DESIGN)

"""Concrete, steel and bars of the slab, the code and annex by which they are checked, fire, and restraint."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal, get_args

from groundslab.model.design.averaging import Averaging, along_axis
from groundslab.model.design.bars import OTHER_MESH, Bars, BarZone, Layer, MeshName, bars_of_mesh
from groundslab.model.design.beam_links import BeamLinks
from groundslab.model.design.detailing import AllowedBars, Detailing
from groundslab.model.design.punching_links import PunchingLinks
from groundslab.model.design.shear_links import ShearLinks
from groundslab.model.ground import POSITIVE
from groundslab.model.loads.annexes import AnnexName
from groundslab.model.outputs import Output
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import FurtherPlate, list_plates
from groundslab.model.plates.region import PlateRegion
from groundslab.model.shapes import CHORD
from groundslab.model.structure.beams import Beam, GivenSection
from groundslab.model.structure.beta import Beta, beta_field
from groundslab.model.structure.columns import Column
from groundslab.model.structure.doors import check_doors
from groundslab.model.structure.lines import NO_LENGTH
from groundslab.model.structure.wall_ends import wall_ends
from groundslab.model.structure.walls import Wall, place_walls
from groundslab.model.supports import AnySupport, check_names
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Boolean, Choice, ListOf, Number, Quantity, list_quantities
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.section_fields import Table
from groundslab.schema.wording import quote, suggestion
from groundslab.units import coordinate

#: Strengths for which EN 1992-1-1 has rules (3.1.2(2), 3.2.2(3)).
CONCRETE, STEEL = Range(at_least=12e6, at_most=90e6), Range(at_least=400e6, at_most=600e6)
#: Grades 40 to 100 (ACI 318-19 Table 20.2.2.4(a)); by EN 1992-1-1 f_yk is that of STEEL (3.2.2(3)).
ANY_STEEL = Range(at_least=276e6, at_most=690e6)
PARTIAL = Range(at_least=0.1, at_most=10)
#: What is longer by such a share is as long.
ROUNDING = 1e-9
AGGREGATE = Range(at_least=1e-3, at_most=0.15)
CRACK = Range(at_least=5e-5, at_most=1e-3)
#: Concrete with finer aggregates is beyond EN 1992-1-1:2023 (1.1(3)).
D_LOWER = Range(at_least=0.008, at_most=0.063)
#: Of one layer.
MOST_BARS = 100_000

#: Strength classes of EN 1992-1-1 Table 3.1 and of BS 8500-1 (C28/35, C32/40), and of steel by its yield strength and
#: class of ductility (Annex C).
ConcreteClass = Literal[
    "C12/15", "C16/20", "C20/25", "C25/30", "C28/35", "C30/37", "C32/40", "C35/45", "C40/50", "C45/55", "C50/60",
    "C55/67", "C60/75", "C70/85", "C80/95", "C90/105",
]  # fmt: skip
SteelClass = Literal["B450C", "B500A", "B500B", "B500C", "B550A", "B550B"]
#: Codes that strength is checked by, exposure classes of Table 4.1 of EN 1992-1-1.
Code = Literal["EN 1992-1-1", "ACI 318", "EN 1992-1-1:2023"]
Exposure = Literal["X0", "XC1", "XC2", "XC3", "XC4", "XD1", "XD2", "XD3", "XS1", "XS2", "XS3"]
ConcreteChoice = Choice(ConcreteClass, "strength class of the concrete", "give the strength of any other class as f_ck")
SteelChoice = Choice(SteelClass, "class of the steel", "give the yield strength of any other steel as f_yk")
#: Keys that not all codes have, by those that have them. EN 1992-1-1 is its first generation, of 2004.
KEYS_OF_CODES: dict[str, tuple[str, ...]] = {
    "EN 1992-1-1": (
        "concrete", "steel", "annex", "gamma_c", "gamma_s", "accidental", "alpha_cc", "w_max", "exposure",
        "fire", "fire_from", "restraint", "detailing", "proposal", "beta", "braced",
    ),
    "ACI 318": ("size_effect", "detailing", "proposal"),
    "EN 1992-1-1:2023": (
        "concrete", "steel", "gamma_c", "gamma_s", "accidental", "w_max", "gamma_v", "k_tc", "d_lower",
        "beta", "braced",
    ),
}  # fmt: skip


def keys_of_other_codes(code: str) -> list[str]:
    """Return the keys that a code has no use for."""
    keys = dict.fromkeys(key for others in KEYS_OF_CODES.values() for key in others)
    return [key for key in keys if key not in KEYS_OF_CODES[code]]


def _check_all_layers(
    bottom_x: Bars | None,
    bottom_y: Bars | None,
    top_x: Bars | None,
    top_y: Bars | None,
    bottom_mesh: str | None,
    top_mesh: str | None,
    zones: tuple[BarZone, ...],
    w_max: float | None,
) -> Iterator[RelativeIssue]:
    layers = {"bottom_x": bottom_x, "bottom_y": bottom_y, "top_x": top_x, "top_y": top_y}
    meshes = {"bottom": bottom_mesh, "top": top_mesh}
    missing = [name for name, bars in layers.items() if bars is None and meshes[name.split("_")[0]] is None]
    if missing and (len(missing) < len(layers) or w_max is not None or zones):
        yield RelativeIssue((missing[0],), "no bars", "bars in all four layers", "or in none, no zones and no w_max")


def _check_meshes(
    bottom_x: Bars | None,
    bottom_y: Bars | None,
    top_x: Bars | None,
    top_y: Bars | None,
    bottom_mesh: str | None,
    top_mesh: str | None,
) -> Iterator[RelativeIssue]:
    faces = {"bottom_mesh": (bottom_mesh, bottom_x, bottom_y), "top_mesh": (top_mesh, top_x, top_y)}
    for name, (mesh, *bars) in faces.items():
        if mesh is not None and any(bars):
            yield RelativeIssue(
                (name,), "a mesh together with bars", "one of them", "additional bars are given in zones"
            )


def _check_zones(zones: tuple[BarZone, ...]) -> Iterator[RelativeIssue]:
    yield from check_names("zones", [zone.name for zone in zones], needed=True)


def _check_shear_links(shear_links: tuple[ShearLinks, ...]) -> Iterator[RelativeIssue]:
    yield from check_names("shear_links", [links.name for links in shear_links], needed=True)


def _check_links(code: str, links: tuple[PunchingLinks, ...]) -> Iterator[RelativeIssue]:
    seen = set[str]()
    for position, entry in enumerate(links):
        if entry.of in seen:
            yield RelativeIssue(("links", position, "of"), f"{quote(entry.of)} again", "all its links at one place")
        seen.add(entry.of)
        if entry.kind == "studs" and code != "ACI 318":
            expected, hint = f"links with {code}", "studs follow their approval, which is not known here"
            yield RelativeIssue(("links", position, "kind"), '"studs"', expected, hint)


def _check_axes(
    bottom: tuple[float, float] | None,
    top: tuple[float, float] | None,
    cover: tuple[float, float] | None,
    bottom_x: Bars | None,
    bottom_mesh: str | None,
) -> Iterator[RelativeIssue]:
    for name, axes in (("bottom", bottom), ("top", top)):
        if axes is None and (cover is None or (bottom_x is None and bottom_mesh is None)):
            yield RelativeIssue((name,), "nothing", "distances of the bars' axes", "or cover and bars in all layers")


def _check_cover(
    bottom: tuple[float, float] | None,
    top: tuple[float, float] | None,
    bottom_x: Bars | None,
    bottom_y: Bars | None,
    top_x: Bars | None,
    top_y: Bars | None,
) -> Iterator[RelativeIssue]:
    layers = {"bottom_x": bottom_x, "bottom_y": bottom_y, "top_x": top_x, "top_y": top_y}
    axes = *(bottom or (None, None)), *(top or (None, None))
    for (name, bars), axis in zip(layers.items(), axes, strict=True):
        if bars is not None and axis is not None and bars.diameter / 2 >= axis:
            expected = f"bars thinner than {2 * axis!r} m, whose axes lie {axis!r} m from the face"
            yield RelativeIssue((name, "diameter"), f"{bars.diameter!r} m", expected)


#: What else there is where a code has no key of that name.
_HINTS = {
    ("ACI 318", "concrete"): "f_ck is the specified strength f'c",
    ("ACI 318", "steel"): "f_yk is f_y",
    ("EN 1992-1-1:2023", "alpha_cc"): "k_tc is the factor of long-term effects",
    ("EN 1992-1-1:2023", "annex"): "no annex to it is known; gamma_c, gamma_s, gamma_v and k_tc can be given",
    ("EN 1992-1-1:2023", "exposure"): "its limits are not known here; w_max is the largest crack width",
    ("ACI 318", "beta"): "it has the stress of moments where that is largest (8.4.4.2.3)",
    ("ACI 318", "braced"): "it has no constants of beta",
    ("ACI 318", "fire"): "ACI 216.1 is not known here",
    ("EN 1992-1-1:2023", "fire"): "EN 1992-1-2:2023 is not known here",
    ("EN 1992-1-1:2023", "detailing"): "its rules for anchorage and laps are not known here",
    ("EN 1992-1-1:2023", "proposal"): "its rules for anchorage and laps are not known here",
    ("EN 1992-1-1", "k_tc"): "alpha_cc is the factor of long-term effects",
}


def _check_code(code: str, given: set[str]) -> Iterator[RelativeIssue]:
    for key in keys_of_other_codes(code):
        if key in given:
            yield RelativeIssue((key,), f"{key} with {code}", f"no {key}", _HINTS.get((code, key), ""))


def check_concrete(concrete: str | None, f_ck: float | None) -> Iterator[RelativeIssue]:
    """Find concrete that is given neither by class nor by strength, or by both."""
    if (concrete is None) == (f_ck is None):
        stated = "neither concrete nor f_ck" if concrete is None else "both concrete and f_ck"
        yield RelativeIssue(("concrete",), stated, "one of them", 'such as concrete = "C30/37"')


def _check_steel(code: str, steel: str | None, f_yk: float | None) -> Iterator[RelativeIssue]:
    if (steel is None) == (f_yk is None):
        stated = "neither steel nor f_yk" if steel is None else "both steel and f_yk"
        yield RelativeIssue(("steel",), stated, "one of them", 'such as steel = "B500B"')
    if f_yk is not None and code != "ACI 318" and not STEEL.holds(f_yk):
        expected = f"400 to 600 MPa by {code}"
        yield RelativeIssue(("f_yk",), f"{f_yk / 1e6:g} MPa", expected, "ACI 318 knows 276 to 690 MPa")


def _check_fire(fire: str | None, given: set[str]) -> Iterator[RelativeIssue]:
    if fire is None and "fire_from" in given:
        yield RelativeIssue(
            ("fire_from",), "fire_from without fire", "a class of resistance to fire, too", 'such as "REI 60"'
        )


BOTH = "both in accidental combinations, by default the annex's"
COVER = list_quantities(
    "length", "c_nom", "nominal cover of the outer bars at the bottom, at the top", ("bottom", "top"), POSITIVE, "40 mm"
)


def _to_axis(face: str) -> ListOf:
    meaning = f"{face} face to the axis of bars along x, along y; or by cover and bars"
    return list_quantities("length", "d_1", meaning, ("x", "y"), POSITIVE, "50 mm")


class Reinforcement(Section):
    """Concrete, steel and where the bars lie, for reinforcement by EN 1992-1-1, both generations, or ACI 318."""

    constraints: ClassVar[tuple[Check, ...]] = (
        _check_code, check_concrete, _check_steel, _check_all_layers, _check_axes, _check_cover, _check_meshes,
        _check_zones, _check_fire, _check_links, _check_shear_links,
    )  # fmt: skip

    code: Annotated[Code, Choice(Code, "code for the strength checks", "")] = "EN 1992-1-1"
    annex: Annotated[
        AnnexName,
        Choice(
            AnnexName,
            "national parameters of EN 1992-1-1, and of combine",
            "other values: gamma_c, gamma_s and alpha_cc",
        ),
    ] = "recommended"
    concrete: Annotated[ConcreteClass | None, ConcreteChoice] = None
    steel: Annotated[SteelClass | None, SteelChoice] = None
    f_ck: Annotated[
        float | None,
        Quantity(
            "pressure", "f_ck", "characteristic strength of the concrete, if no class", CONCRETE, example="30 MPa"
        ),
    ] = None
    f_yk: Annotated[
        float | None,
        Quantity(
            "pressure", "f_yk", "characteristic yield strength of the steel, if no class", ANY_STEEL, example="500 MPa"
        ),
    ] = None
    gamma_c: Annotated[
        float | None, Number("gamma_C", "partial factor of concrete, by default the annex's", PARTIAL)
    ] = None
    gamma_s: Annotated[float | None, Number("gamma_S", "partial factor of steel, by default the annex's", PARTIAL)] = (
        None
    )
    accidental: Annotated[
        tuple[float, float] | None,
        ListOf(Number("gamma", "", PARTIAL), "gamma", BOTH, 2, members=("gamma_C", "gamma_S")),
    ] = None
    alpha_cc: Annotated[
        float | None,
        Number(
            "alpha_cc",
            "long-term effects on concrete's strength, by default the annex's",
            Range(above=0, at_most=1),
        ),
    ] = None
    gamma_v: Annotated[
        float | None,
        Number("gamma_V", "partial factor of shear by EN 1992-1-1:2023, 1.4 by default; 1.15 if accidental", PARTIAL),
    ] = None
    k_tc: Annotated[
        float | None,
        Number(
            "k_tc",
            "long-term effects on concrete's strength by EN 1992-1-1:2023, 0.85 by default; 1 if loaded late",
            Range(above=0, at_most=1),
        ),
    ] = None
    d_lower: Annotated[
        float | None,
        Quantity(
            "length",
            "D_lower",
            "least size of the coarsest aggregates, for shear by EN 1992-1-1:2023; 16 mm by default",
            D_LOWER,
            example="16 mm",
        ),
    ] = None
    size_effect: Annotated[
        bool, Boolean("whether shear strength falls with the depth, lambda_s of ACI 318 (13.2.6.2 lets it be 1)")
    ] = True
    line_force_relieves: Annotated[
        bool,
        Boolean(
            "whether the ground's line force along the plate's edge relieves punching as pressure inside does, and "
            "one-way shear"
        ),
    ] = False
    aggregate: Annotated[
        float | None,
        Quantity(
            "length", "d_g", "largest size of the aggregate, for the clear distance of bars", AGGREGATE, example="16 mm"
        ),
    ] = None
    exposure: Annotated[
        Exposure | None,
        Choice(Exposure, "exposure class, for the cover and, if bars are provided, the crack width", ""),
    ] = None
    fire: Annotated[
        FireClass | None,
        Choice(FireClass, "fire class by EN 1992-1-2 Table 5.8: R to carry, REI to separate rooms, too", ""),
    ] = None
    fire_from: Annotated[FireFrom, Choice(FireFrom, "where the fire is, above or below the slab", "")] = "above"
    cover: Annotated[
        tuple[float, float] | None,
        COVER,
    ] = None
    outer: Annotated[
        Literal["x", "y"], Choice(Literal["x", "y"], "direction of the outer bars, where cover gives the axes")
    ] = "x"
    bottom: Annotated[
        tuple[float, float] | None,
        _to_axis("bottom"),
    ] = None
    top: Annotated[
        tuple[float, float] | None,
        _to_axis("top"),
    ] = None
    bottom_x: Annotated[Bars | None, Table("bars provided at the bottom along x, to be checked")] = None
    bottom_y: Annotated[Bars | None, Table("bars provided at the bottom along y")] = None
    top_x: Annotated[Bars | None, Table("bars provided at the top along x")] = None
    top_y: Annotated[Bars | None, Table("bars provided at the top along y")] = None
    bottom_mesh: Annotated[
        MeshName | None,
        Choice(MeshName, "welded mesh at the bottom, instead of bottom_x and bottom_y", OTHER_MESH),
    ] = None
    top_mesh: Annotated[
        MeshName | None, Choice(MeshName, "welded mesh at the top, instead of top_x and top_y", OTHER_MESH)
    ] = None
    zones: Annotated[tuple[BarZone, ...], Table("parts of the plan with additional bars between these")] = ()
    beta: Annotated[Beta, beta_field("at columns, piles and thicker zones")] = "code"
    braced: Annotated[
        bool,
        Boolean("whether lateral stability does not depend on frame action of slab and columns, for constants of beta"),
    ] = False
    links: Annotated[
        tuple[PunchingLinks, ...], Table("links against punching, to be checked; propose-bars writes them")
    ] = ()
    shear_links: Annotated[
        tuple[ShearLinks, ...], Table("links against one-way shear in parts of the slab, to be checked", 1000)
    ] = ()
    beam_links: Annotated[
        tuple[BeamLinks, ...], Table("links of beams and of strips that are beams, to be checked")
    ] = ()
    averaging: Annotated[
        Averaging, Table("which moments bars are for at supports: means over a width, those at faces, or peaks")
    ] = Averaging()
    detailing: Annotated[
        Detailing | None, Table("how bars are cut and lapped, for quantities; without it bars have no laps")
    ] = None
    proposal: Annotated[AllowedBars, Table("what bars and links may be proposed")] = AllowedBars()
    w_max: Annotated[
        float | None,
        Quantity(
            "length",
            "w_max",
            "largest crack width in quasi-permanent combinations; by exposure if bars are provided",
            CRACK,
            example="0.3 mm",
        ),
    ] = None
    restraint: Annotated[
        Restraint | None, Table("restrained shortening of the slab, which bars at both faces must bear as it cracks")
    ] = None

    def links_along(self, name: str) -> tuple[BeamLinks, ...]:
        """Return the links along a beam or a strip that is one."""
        return tuple(links for links in self.beam_links if links.of == name)

    def links_at(self, name: str) -> PunchingLinks | None:
        """Return the links around what has a name; None if none are given."""
        return next((links for links in self.links if links.of == name), None)

    @property
    def laid(self) -> bool:
        """Return whether bars are laid, which are then in all four layers."""
        return self.base_bars("bottom_x") is not None

    def base_bars(self, layer: str) -> Bars | None:
        """Return the bars of a layer that lie all over the slab, those of a mesh too; None if none are laid."""
        mesh: str | None = getattr(self, f"{layer.split('_')[0]}_mesh")
        bars: Bars | None = getattr(self, layer)
        return bars if mesh is None else bars_of_mesh(mesh)

    @property
    def bottom_axes(self) -> tuple[float, float]:
        """Return the distances of the axes of bars along x and along y from the bottom face [m]."""
        return self.bottom or self._axes(0, self.base_bars("bottom_x"), self.base_bars("bottom_y"))

    @property
    def top_axes(self) -> tuple[float, float]:
        """Return the distances of the axes of bars along x and along y from the top face [m]."""
        return self.top or self._axes(1, self.base_bars("top_x"), self.base_bars("top_y"))

    def _axes(self, face: int, x: Bars | None, y: Bars | None) -> tuple[float, float]:
        """Return both distances of a face by its cover, the outer bars nearest to it."""
        assert self.cover is not None
        assert x is not None
        assert y is not None
        return axes_by_cover(self.cover[face], self.outer, x.diameter, y.diameter)


def axes_by_cover(cover: float, outer: str, a: float, b: float) -> tuple[float, float]:
    """Return the distances of the axes from a face [m] by its cover: of bars a thick along x, b thick along y."""
    x, y = (cover + a / 2, cover + a + b / 2) if outer == "x" else (cover + b + a / 2, cover + b / 2)
    return coordinate(x), coordinate(y)  # written to files without what rounding has left


def check_bar_distances(
    plate: Plate, plates: tuple[FurtherPlate, ...], reinforcement: Reinforcement | None
) -> Iterator[RelativeIssue]:
    """Find bars that do not fit into the thinnest part of the plate."""
    if reinforcement is None:
        return
    every = list_plates(plate, plates)
    zones = [zone.thickness for slab in every for zone in slab.zones if zone.thickness is not None]
    thinnest = min([*(slab.thickness for slab in every), *zones])
    for face in ("bottom", "top"):
        for position, distance in enumerate(getattr(reinforcement, f"{face}_axes")):
            if distance >= thinnest / 2:
                expected = f"less than half of the least thickness, {thinnest / 2!r} m"
                place = face if getattr(reinforcement, face) is not None else "cover"
                yield RelativeIssue(("reinforcement", place, position), f"{distance!r} m", expected)


def check_bar_zones(
    plate: Plate, plates: tuple[FurtherPlate, ...], reinforcement: Reinforcement | None
) -> Iterator[RelativeIssue]:
    """Find zones beside the plate or of bars that stick out, and plates with more bars than can be counted."""
    if reinforcement is None or not reinforcement.laid:
        return
    base = [reinforcement.base_bars(layer) for layer in get_args(Layer)]
    covered = PlateRegion(plate, plates)
    count = covered.size / min(bars.spacing for bars in (*base, *(z.bars for z in reinforcement.zones)) if bars)
    if count > MOST_BARS:
        bar_count = f"about {count:.3g} bars next to each other"
        yield RelativeIssue(("reinforcement",), bar_count, f"at most {MOST_BARS:,}", "a larger spacing")
    axes = dict(zip(get_args(Layer), (*reinforcement.bottom_axes, *reinforcement.top_axes), strict=True))
    for position, zone in enumerate(reinforcement.zones):
        if covered.area.intersection(zone.shape.ring().polygon(CHORD * covered.size)).area == 0:
            place = ("reinforcement", "zones", position, "shape")
            yield RelativeIssue(place, "a zone off the plate", "one that lies at least partly on it")
        least = min(axes[layer] for layer in zone.layers)
        if zone.bars.diameter / 2 >= least:
            expected = f"bars thinner than {2 * least!r} m, whose axes lie {least!r} m from the face"
            yield RelativeIssue(("reinforcement", "zones", position), f"bars of {zone.bars.diameter!r} m", expected)


def check_beta(reinforcement: Reinforcement | None, columns: tuple[Column, ...]) -> Iterator[RelativeIssue]:
    """Find constants of beta in a case that is not stated to be braced, and betas of columns that no code has."""
    if reinforcement is None:
        return
    betas = [column.beta for column in columns]
    if reinforcement.code == "EN 1992-1-1:2023":
        places = [("reinforcement", "beta"), *(("columns", position, "beta") for position in range(len(columns)))]
        for place, beta in zip(places, (reinforcement.beta, *betas), strict=True):
            if beta == "constant":
                expected = '"code", "sectors" or a number'
                yield RelativeIssue(place, "a constant beta", expected, "those of its Table 8.3 are not known here")
        return
    if "constant" in (reinforcement.beta, *betas) and not reinforcement.braced:
        expected = "braced = true, that lateral stability does not depend on frame action"
        hint = 'else beta = "code" or "sectors"'
        yield RelativeIssue(("reinforcement", "braced"), "a constant beta of a case that is not braced", expected, hint)
    for position, beta in enumerate(betas):
        if beta is not None and reinforcement.code == "ACI 318":
            yield RelativeIssue(("columns", position, "beta"), "beta with ACI 318", "no beta")


def check_links(
    reinforcement: Reinforcement | None,
    columns: tuple[Column, ...],
    supports: tuple[AnySupport, ...],
    walls: tuple[Wall, ...],
    plate: Plate,
    plates: tuple[FurtherPlate, ...],
) -> Iterator[RelativeIssue]:
    """Find links around what is not there."""
    if reinforcement is None or not reinforcement.links:
        return
    names = [column.name for column in columns]
    names += [support.name or f"support {number}" for number, support in enumerate(supports, start=1)]
    placed = [wall for wall in place_walls(walls, list_plates(plate, plates)) if not any(check_doors(wall, NO_LENGTH))]
    names += [end.name for end in wall_ends(placed)]
    for position, links in enumerate(reinforcement.links):
        if names.count(links.of) > 1:
            shared_name, expected = f"{quote(links.of)}, the name of several", "other names of some of them"
            yield RelativeIssue(("reinforcement", "links", position, "of"), shared_name, expected)
        # ends over openings of the plate, and zones that are judged together, are known by the results
        if links.of not in names and not re.match(r"zones? \d|edge at ", links.of):
            place = ("reinforcement", "links", position, "of")
            expected = "the name of a column, pile, zone or end of a wall"
            yield RelativeIssue(place, quote(links.of), expected, suggestion(links.of, names))


def check_strips(
    reinforcement: Reinforcement | None, output: Output, beams: tuple[Beam, ...]
) -> Iterator[RelativeIssue]:
    """Find strips that bars cannot be designed by, as they run along neither x nor y or have the name of a beam."""
    if reinforcement is None:
        return
    by_strip = reinforcement.averaging.by == "strip"
    if by_strip and not output.strips:
        place = ("reinforcement", "averaging", "by")
        yield RelativeIssue(place, '"strip" without strips', "strips in output.strips", 'or "element"')
    names = {beam.name for beam in beams}
    for position, strip in enumerate(output.strips):
        if not by_strip and strip.design == "plate":
            continue
        where = ("output", "strips", position)
        if along_axis(strip) is None:
            why = 'design = "beam"' if strip.design == "beam" else "reinforcement.averaging.by"
            expected, hint = "one along x or along y", f"bars are designed by strips ({why})"
            yield RelativeIssue(where, "a strip at an angle to the bars", expected, hint)
        if strip.design == "beam" and strip.name in names:
            yield RelativeIssue((*where, "name"), f"{quote(strip.name)}, the name of a beam", "another name")


def check_shear_links(
    plate: Plate, plates: tuple[FurtherPlate, ...], reinforcement: Reinforcement | None
) -> Iterator[RelativeIssue]:
    """Find links of the slab that are beside it."""
    if reinforcement is None or not reinforcement.shear_links:
        return
    covered = PlateRegion(plate, plates)
    for position, links in enumerate(reinforcement.shear_links):
        if covered.area.intersection(links.shape.ring().polygon(CHORD * covered.size)).area == 0:
            place = ("reinforcement", "shear_links", position, "shape")
            yield RelativeIssue(place, "links off the plate", "a part of it")


def check_beam_links(
    reinforcement: Reinforcement | None, output: Output, beams: tuple[Beam, ...]
) -> Iterator[RelativeIssue]:
    """Find links of beams that are not there, beyond their ends, or twice at one place."""
    if reinforcement is None or not reinforcement.beam_links:
        return
    lengths = {beam.name: beam.length for beam in beams if not isinstance(beam.section, GivenSection)}
    lengths |= {strip.name: math.dist(strip.start, strip.end) for strip in output.strips if strip.design == "beam"}
    parts = dict[str, list[tuple[float, float]]]()
    for position, links in enumerate(reinforcement.beam_links):
        place = ("reinforcement", "beam_links", position)
        length = lengths.get(links.of)
        if length is None:
            expected = 'the name of a beam of concrete, or of a strip with design = "beam"'
            yield RelativeIssue((*place, "of"), quote(links.of), expected, suggestion(links.of, list(lengths)))
            continue
        end = length if links.end is None else links.end
        for key, way in (("start", links.start), ("end", end)):
            if way > length * (1 + ROUNDING):
                yield RelativeIssue((*place, key), f"{way!r} m", f"at most {length!r} m, where {links.of} ends")
        if any(links.start < high and end > low for low, high in parts.get(links.of, ())):
            overlap = f"links of {quote(links.of)} at a place that has some"
            yield RelativeIssue(place, overlap, "parts that do not overlap", "start and end bound them")
        parts.setdefault(links.of, []).append((links.start, end))


#: Carrying (R), and separating besides (E and I), for so many minutes.
FireClass = Literal[
    "R 30", "R 60", "R 90", "R 120", "R 180", "R 240",
    "REI 30", "REI 60", "REI 90", "REI 120", "REI 180", "REI 240",
]  # fmt: skip
FireFrom = Literal["above", "below", "both"]


#: Tensile strengths of concrete [Pa].
TENSILE = Range(at_least=1e5, at_most=1e7)


class Restraint(Section):
    """Shortening by shrinkage and cooling that ground or building restrain: cracks through the whole thickness."""

    f_ct_eff: Annotated[
        float | None,
        Quantity(
            "pressure",
            "f_ct,eff",
            "tensile strength of the concrete when cracks are first expected; f_ctm by default",
            TENSILE,
            example="2.6 MPa",
        ),
    ] = None

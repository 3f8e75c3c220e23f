"""Ground under the plate: springs, Pasternak, Vlasov, layered ground, elastic continuum."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, Literal

from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Choice, Integer, Number, Quantity
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.repairs import remove
from groundslab.schema.section_fields import ByKind, Table
from groundslab.schema.wording import describe, quote

POSITIVE = Range(above=0)
#: Stiffness against shear: none, or one whose reach is more than nothing.
SHEAR = Range(at_least=0, smallest=1e-3)
POISSON = Range(at_least=0, below=0.5)

Variation = Literal["linear", "quadratic"]
Mode = Literal["auto", "sinh", "profile"]
Formulas = Literal["exact", "as printed"]
Coupling = Literal["interface", "consistent"]

Gamma = Annotated[
    float | Literal["iterate"],
    Number(
        "gamma", "decay of the mode over the depth; iterated by default", Range(above=0, at_most=1000), ("iterate",)
    ),
]
FormulasKey = Annotated[
    Formulas, Choice(Formulas, 'formulas for k0 and k1; "as printed" repeats the misprints of the paper')
]


class Selvadurai(Section):
    """Soil from which Selvadurai's formula finds the modulus of subgrade reaction."""

    E: Annotated[float, Quantity("pressure", "E_s", "Young's modulus of the soil", POSITIVE, example="20 MPa")]
    depth: Annotated[float, Quantity("length", "H", "depth of the soil over the rigid base", POSITIVE, example="8 m")]


def _check_stiffness(k: float | None, selvadurai: Selvadurai | None) -> Iterator[RelativeIssue]:
    if (k is None) == (selvadurai is None):
        stated = "neither k nor selvadurai" if k is None else "both k and selvadurai"
        repairs = () if k is None else (remove(("selvadurai",)), remove(("k",)))
        yield RelativeIssue((), stated, "exactly one of k and selvadurai", repairs=repairs)


class Winkler(Section):
    """Independent springs."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_stiffness,)

    kind: Annotated[Literal["winkler"], Table("independent springs")] = "winkler"
    k: Annotated[
        float | None, Quantity("pressure per length", "k", "modulus of subgrade reaction", POSITIVE, example="20 MPa/m")
    ] = None
    selvadurai: Annotated[Selvadurai | None, Table("soil that gives k, instead of k")] = None

    def modulus(self, a: float) -> float:
        """Return k [Pa/m] under a plate whose longer side is a [m], given or by Selvadurai's formula."""
        if self.k is not None:
            return self.k
        assert self.selvadurai is not None
        # (3.1)
        return 2 * self.selvadurai.E / (a * math.log(1 + 2 * self.selvadurai.depth / a))


class Pasternak(Section):
    """Springs under a layer that carries shear only."""

    kind: Annotated[Literal["pasternak"], Table("springs under a shear layer, both given")] = "pasternak"
    k0: Annotated[
        float, Quantity("pressure per length", "k_0", "modulus of subgrade reaction", POSITIVE, example="20 MPa/m")
    ]
    k1: Annotated[
        float, Quantity("pressure times length", "k_1", "stiffness of the shear layer", SHEAR, example="5 MN/m")
    ]


def _check_variation(variation: str, E_bottom: float | None, given: set[str]) -> Iterator[RelativeIssue]:
    if "variation" in given and E_bottom is None:
        hint, repairs = "give E_bottom as well", (remove(("variation",)),)
        yield RelativeIssue(("variation",), quote(variation), "no variation without E_bottom", hint, repairs)


class SoilLayer(Section):
    """A layer of soil given by its elastic constants."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_variation,)

    E: Annotated[
        float, Quantity("pressure", "E", "Young's modulus, at the top of the layer", POSITIVE, example="20 MPa")
    ]
    E_bottom: Annotated[
        float | None,
        Quantity(
            "pressure", "E_b", "Young's modulus at the bottom of the layer; E by default", POSITIVE, example="40 MPa"
        ),
    ] = None
    variation: Annotated[Variation, Choice(Variation, "how the modulus varies from E to E_bottom")] = "linear"
    nu: Annotated[float, Number("nu", "Poisson's ratio", POISSON)]
    thickness: Annotated[
        float,
        Quantity(
            "length",
            "h",
            "thickness",
            Range(at_least=0, at_most=10_000),
            example="3 m",
        ),
    ]
    sublayers: Annotated[int, Integer("number of equal sublayers, for consistent coupling only", at_most=100)] = 1


class InterfaceLayer(Section):
    """A layer given by the two stiffnesses between its top and its bottom."""

    k0: Annotated[
        float, Quantity("pressure per length", "k_0", "stiffness against compression", POSITIVE, example="20 MPa/m")
    ]
    k1: Annotated[float, Quantity("pressure times length", "k_1", "stiffness against shear", SHEAR, example="5 MN/m")]


def _check_sublayers(
    layers: tuple[SoilLayer | InterfaceLayer, ...], coupling: str = "interface"
) -> Iterator[RelativeIssue]:
    for position, layer in enumerate(layers):
        if coupling != "consistent" and isinstance(layer, SoilLayer) and layer.sublayers != 1:
            expected = 'no sublayers, which only a layered ground with coupling = "consistent" has'
            yield RelativeIssue(("layers", position, "sublayers"), str(layer.sublayers), expected)
        if isinstance(layer, SoilLayer) and not layer.thickness:
            hint = "leave out a layer that is nowhere; at a borehole where it is missing it has 0 m"
            yield RelativeIssue(("layers", position, "thickness"), "0 m", "more than 0 m", hint)


def _check_vlasov_sublayers(layers: tuple[SoilLayer, ...]) -> Iterator[RelativeIssue]:
    return _check_sublayers(layers)


def _check_mode(layers: tuple[SoilLayer, ...], mode: str) -> Iterator[RelativeIssue]:
    if mode == "sinh" and len(layers) > 1:
        mode_and_layers, hint = f'"sinh" with {len(layers)} layers', "the sinh mode is exact for one layer"
        yield RelativeIssue(("mode",), mode_and_layers, 'one layer, or mode = "profile"', hint)


def _check_formulas(layers: tuple[SoilLayer, ...], formulas: str) -> Iterator[RelativeIssue]:
    if formulas == "as printed" and len(layers) > 1:
        formulas_and_layers = f'"as printed" with {len(layers)} layers'
        yield RelativeIssue(("formulas",), formulas_and_layers, 'one layer, or formulas = "exact"')


class Vlasov(Section):
    """Soil layers whose settlement follows one mode over the whole depth."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_vlasov_sublayers, _check_mode, _check_formulas)

    kind: Annotated[Literal["vlasov"], Table("soil layers that settle in one mode over the depth")] = "vlasov"
    layers: Annotated[tuple[SoilLayer, ...], Table("the layers, from the top downwards")]
    gamma: Gamma = "iterate"
    mode: Annotated[
        Mode,
        Choice(Mode, "shape of the mode: sinh is for one layer, profile for any; auto takes sinh for one layer"),
    ] = "auto"
    formulas: FormulasKey = "exact"


def _layer_kind(layer: Any) -> str | None:
    """Return the kind of a layer by its keys, as no key states it."""
    if isinstance(layer, SoilLayer | InterfaceLayer):
        return type(layer).__name__
    if not isinstance(layer, Mapping):
        return None
    soil = layer.keys() & (SoilLayer.model_fields.keys() - InterfaceLayer.model_fields.keys())
    return "SoilLayer" if soil or not layer.keys() & {"k0", "k1"} else "InterfaceLayer"


AnyLayer = Annotated[SoilLayer | InterfaceLayer, ByKind(_layer_kind)]


def _check_layer_kinds(layers: tuple[SoilLayer | InterfaceLayer, ...], coupling: str) -> Iterator[RelativeIssue]:
    interfaces = [isinstance(layer, InterfaceLayer) for layer in layers]
    if coupling == "consistent":
        for position in (position for position, by_k in enumerate(interfaces) if by_k):
            yield RelativeIssue(("layers", position), "k0 and k1", 'E, nu and thickness, as coupling is "consistent"')
    elif any(interfaces) and not all(interfaces):
        expected = "all layers given by k0 and k1, or all by E, nu and thickness"
        yield RelativeIssue(("layers",), "layers of both kinds", expected)


def _check_gamma(
    layers: tuple[SoilLayer | InterfaceLayer, ...],
    coupling: str,
    gamma: float | str,
    formulas: str,
    given: set[str],
) -> Iterator[RelativeIssue]:
    if coupling == "interface" and any(isinstance(layer, SoilLayer) for layer in layers):
        return
    for key, value in (("gamma", gamma), ("formulas", formulas)):
        if key in given:
            yield RelativeIssue((key,), describe(value), f"no {key}, which only interface layers given by E use")


class Layered(Section):
    """A stack of layers with an unknown settlement at each surface between them."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_layer_kinds, _check_sublayers, _check_gamma)

    kind: Annotated[Literal["layered"], Table("a stack of layers, each surface with its own settlement")] = "layered"
    coupling: Annotated[
        Coupling,
        Choice(Coupling, "interface: two stiffnesses per layer; consistent: settlement linear over each sublayer"),
    ]
    layers: Annotated[
        tuple[AnyLayer, ...],
        Table("the layers, from the top downwards, all by E, nu and thickness, or (interface) all by k0, k1"),
    ]
    gamma: Gamma = "iterate"
    formulas: FormulasKey = "exact"


CellSide = Annotated[
    float | None,
    Quantity(
        "length",
        "",
        "side of the cells on which the pressure is constant; by default half a side of the mesh's elements, so that a "
        "finer mesh has a finer grid of cells",
        POSITIVE,
        example="1 m",
    ),
]


class HalfSpace(Section):
    """Half-space of soil below the layers."""

    E: Annotated[float, Quantity("pressure", "E", "Young's modulus", POSITIVE, example="40 MPa")]
    nu: Annotated[float, Number("nu", "Poisson's ratio", POISSON)]


#: Neighboring layers may differ by this factor in E, and a layer may be this part of the depth.
MOST_CONTRAST, LEAST_PART = 1e6, 1e-3


def _check_continuum(layers: tuple[SoilLayer, ...], half_space: HalfSpace | None) -> Iterator[RelativeIssue]:
    if not layers and half_space is None:
        yield RelativeIssue((), "neither layers nor half_space", "at least one of them")
    depth = sum(layer.thickness for layer in layers)
    for position, layer in enumerate(layers):
        if layer.thickness < LEAST_PART * depth:
            expected = f"at least {LEAST_PART * depth:.3g} m, a thousandth of the depth of all layers"
            yield RelativeIssue(("layers", position, "thickness"), f"{layer.thickness:g} m", expected)
    moduli = [modulus for layer in layers for modulus in (layer.E, layer.E_bottom) if modulus is not None]
    moduli += [] if half_space is None else [half_space.E]
    if moduli and max(moduli) > MOST_CONTRAST * min(moduli):
        moduli_range = f"moduli from {min(moduli):.3g} to {max(moduli):.3g} Pa"
        hint = "anything so much stiffer is a rigid base"
        yield RelativeIssue((), moduli_range, f"moduli that differ by a factor of at most {MOST_CONTRAST:g}", hint)


class Continuum(Section):
    """Bonded elastic layers, isotropic and laterally unbounded, on a rigid base or a half-space."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_vlasov_sublayers, _check_continuum)

    kind: Annotated[Literal["continuum"], Table("bonded elastic layers that spread loads in all directions")] = (
        "continuum"
    )
    layers: Annotated[
        tuple[SoilLayer, ...],
        Table("the layers, from the top downwards; on a rigid rough base, unless there is a half_space"),
    ] = ()
    half_space: Annotated[HalfSpace | None, Table("soil below all layers, or all of it")] = None
    cell: CellSide = None


def _check_limit_depth(
    limit_ratio: float | None, unit_weight: float | None, given: set[str]
) -> Iterator[RelativeIssue]:
    if limit_ratio is not None and unit_weight is None:
        yield RelativeIssue(("unit_weight",), "nothing", 'a weight such as "19 kN/m3", as limit_ratio is given')
    for key in ("unit_weight", "unit_weight_below_water", "groundwater"):
        if limit_ratio is None and key in given:
            hint = "the soil's weight is needed to find the limit depth"
            yield RelativeIssue((key,), f"{key} without limit_ratio", "a limit_ratio such as 0.2", hint)


def _check_groundwater(
    groundwater: float | None, unit_weight_below_water: float | None, given: set[str]
) -> Iterator[RelativeIssue]:
    if (groundwater is None) != (unit_weight_below_water is None):
        missing = "groundwater" if groundwater is None else "unit_weight_below_water"
        other = "unit_weight_below_water" if groundwater is None else "groundwater"
        if other in given:
            yield RelativeIssue((missing,), "nothing", f"a value, as {other} is given")


def _check_reloading(reloading: float | None, relief: float) -> Iterator[RelativeIssue]:
    if reloading is not None and relief == 0:
        hint = "what the excavation takes off: its depth times the soil's unit weight"
        yield RelativeIssue(("reloading",), f"{reloading:g} without relief", "a relief above 0", hint)
    if reloading is None and relief > 0:
        yield RelativeIssue(("reloading",), "nothing", "a ratio of moduli such as 4, as there is a relief")


class ConstrainedModulus(Section):
    """Layers that are compressed by the stresses of a homogeneous half-space (DIN 4019, EN 1997-1 annex F)."""

    constraints: ClassVar[tuple[Check, ...]] = (
        _check_vlasov_sublayers,
        _check_limit_depth,
        _check_groundwater,
        _check_reloading,
    )

    kind: Annotated[
        Literal["constrained modulus"],
        Table("layers, each compressed by Boussinesq's stresses over its constrained modulus, as DIN 4019 does"),
    ] = "constrained modulus"
    layers: Annotated[
        tuple[SoilLayer, ...],
        Table("the layers, from the top downwards; their constrained modulus is E (1 - nu) / ((1 + nu)(1 - 2 nu)), E "
              "itself for nu = 0; below them nothing settles"),
    ]  # fmt: skip
    relief: Annotated[
        float,
        Quantity(
            "pressure",
            "sigma_e",
            "weight removed by the excavation under the slab",
            Range(at_least=0),
            example="40 kPa",
        ),
    ] = 0.0
    reloading: Annotated[
        float | None,
        Number(
            "",
            "moduli for reloading, up to the relief, over those for first loading",
            Range(at_least=1, at_most=20),
        ),
    ] = None
    limit_ratio: Annotated[
        float | None,
        Number(
            "",
            "share of the overburden to which the stress by all loads falls at the limit depth, below which nothing "
            "settles: 0.2 by DIN 4019 and EN 1997-1; without it all layers count",
            Range(above=0, at_most=1),
        ),
    ] = None
    unit_weight: Annotated[
        float | None,
        Quantity("weight per volume", "gamma", "weight of the soil, for the overburden", POSITIVE, example="19 kN/m^3"),
    ] = None
    groundwater: Annotated[
        float | None,
        Quantity("length", "z_w", "depth of the groundwater below the slab", Range(at_least=0), example="2 m"),
    ] = None
    unit_weight_below_water: Annotated[
        float | None,
        Quantity("weight per volume", "gamma'", "effective weight of the soil below it", POSITIVE, example="10 kN/m^3"),
    ] = None
    cell: CellSide = None


#: Ground without an end sideways that bears the plate by cells of pressure.
ContinuousGround = Continuum | ConstrainedModulus
AnyGround = Winkler | Pasternak | Vlasov | Layered | Continuum | ConstrainedModulus
Ground = Annotated[AnyGround, ByKind()]


def carry_shear(ground: AnyGround) -> list[bool]:
    """Return whether the layers of a ground carry shear, from the top downwards."""
    if isinstance(ground, Winkler):
        return [False]
    if isinstance(ground, Pasternak):
        return [ground.k1 > 0]
    if isinstance(ground, ContinuousGround):
        return [True]
    return [not isinstance(layer, InterfaceLayer) or layer.k1 > 0 for layer in ground.layers]

"""Examples of quantities and names of members: every field of the case file has some that fit it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from groundslab import units
from groundslab.model.model import Model
from groundslab.schema.base import Section
from groundslab.schema.fields import FieldType, ListOf, Quantity
from groundslab.unit_systems import customary_example

#: Where examples lie, in SI units, by dimension: slabs, their ground and their loads are of this size.
PLAUSIBLE = {
    "length": (1e-4, 20.0),
    "pressure": (1e3, 4e10),
    "pressure per length": (1e2, 1e9),
    "pressure times length": (1e6, 1e8),
    "force per length": (1e4, 1e6),
    "weight per volume": (8e3, 3e4),
    "force": (1e4, 5e6),
    "moment": (1e4, 1e6),
    "moment per angle": (1e6, 1e9),
    "stiffness": (1e6, 1e10),
    "stiffness per length": (1e6, 1e9),
    "pressure per area": (1e2, 1e4),
    "moment per length": (1e3, 1e5),
    "share": (0.01, 0.2),
    "area per length": (1e-4, 1e-2),
    "area": (1e-3, 1.0),
    "second moment of area": (1e-5, 0.1),
    "temperature difference": (1.0, 50.0),
    "strain per temperature": (5e-6, 2e-5),
}
#: The same by key, where people know what to expect.
OF_KEYS = {
    "Plate.E": (20e9, 40e9),
    "SoilLayer.E": (1e6, 2e8),
    "HalfSpace.E": (1e6, 2e8),
    "Reinforcement.f_yk": (4e8, 6e8),
    "Reinforcement.f_ck": (12e6, 90e6),
    "Reinforcement.cover": (0.015, 0.1),
    "Plate.thickness": (0.1, 3.0),
    "Plate.length_x": (3.0, 100.0),
    "UniformLoad.q": (1e3, 1e5),
    "Bars.diameter": (0.006, 0.04),
    "Bars.spacing": (0.05, 0.4),
    "Limits.settlement": (0.005, 0.1),
    "Zone.level": (-3.0, -0.5),
    "Zone.wall": (0.15, 1.0),
}


def fields_of(part: type[Section], seen: set[type[Section]]) -> Iterator[tuple[str, FieldType]]:
    """Yield the types of all fields of a part and of those in it, with part and key."""
    seen.add(part)
    for name, field in part.model_fields.items():
        if field.type is not None:
            yield f"{part.__name__}.{name}", field.type
        for inner in field.sections.parts:
            if inner not in seen:
                yield from fields_of(inner, seen)


ALL = dict(fields_of(Model, set()))


def quantity_in(field: FieldType) -> Quantity | None:
    """Return the quantity that a field is or holds."""
    while isinstance(field, ListOf):
        field = field.each
    return field if isinstance(field, Quantity) else None


QUANTITIES = {key: quantity for key, field in ALL.items() if (quantity := quantity_in(field))}


def test_every_part_is_walked() -> None:
    """Fields of plate, ground, loads, design and joints are among those that are walked."""
    assert QUANTITIES.keys() >= OF_KEYS.keys()
    assert len(QUANTITIES) > 100


def test_examples_fit_their_field() -> None:
    """Each quantity has an example of its own that the field takes, of a usual size, and one for the United States."""
    for key in QUANTITIES:
        quantity = QUANTITIES[key]
        assert quantity.example, "has no example of its own"
        customary = customary_example(quantity.example, quantity.dimension)
        low, high = OF_KEYS.get(key, PLAUSIBLE[quantity.dimension])
        for example in (quantity.example, customary):
            value = quantity.read(example, from_file=True)
            assert value == units.parse(example, quantity.dimension)
            assert low <= value <= high
        assert (
            0.7 <= units.parse(customary, quantity.dimension) / units.parse(quantity.example, quantity.dimension) <= 1.4
        )


@pytest.mark.parametrize(
    ("key", "members"),
    [
        ("Reinforcement.cover", ("bottom", "top")),
        ("Reinforcement.accidental", ("gamma_C", "gamma_S")),
        ("Combine.permanent", ("unfavourable", "favourable")),
        ("Rectangle.x", ("from", "to")),
    ],
)
def test_members_of_pairs(key: str, members: tuple[str, ...]) -> None:
    """Pairs say what their members are."""
    field = ALL[key]
    assert isinstance(field, ListOf)
    assert field.members == members


def test_every_list_of_fixed_length_names_its_members() -> None:
    """No value of a list of fixed length is without a name."""
    fixed = {key: field for key, field in ALL.items() if isinstance(field, ListOf) and field.length}
    assert [key for key, field in fixed.items() if len(field.members) != field.length] == []
    assert len(fixed) > 20


@pytest.mark.parametrize(
    ("text", "dimension", "customary"),
    [
        ("30 GPa", "pressure", "4000 ksi"),
        ("10 kN/m^2", "pressure", "200 psf"),
        ("2.5 MPa", "pressure", "400 psi"),
        ("40 mm", "length", "1.5 in"),
        ("12 m", "length", "40 ft"),
        ("-1.2 m", "length", "-4 ft"),
        ("15 K", "temperature difference", "15 K"),
    ],
)
def test_customary_examples(text: str, dimension: str, customary: str) -> None:
    """Examples are round in units customary in the United States: 4351 ksi, 209 psf, 363 psi, 1.57 in, 39.4 ft ..."""
    assert customary_example(text, dimension) == customary

"""Sentences on paper: indices and powers in words of ours, names as given."""

from __future__ import annotations

import pytest

from groundslab.messages import Message, Name, Symbol, joined
from groundslab.views.report.sentences import raised, set_sentence, written_out


def marked(text: str) -> str:
    """Return a sentence with what stands below the line in braces."""
    return "".join(f"{base}{{{below}}}" if below else base for base, below in set_sentence(text, str))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("v_Ed is 1.2 times v_Rd,c, with sigma_s", "v{Ed} is 1.2 times v{Rd,c}, with σ{s}"),
        ("set soil.k_x, mesh.size or margin_effect", "set soil.k_x, mesh.size or margin_effect"),
        ("areas [cm2/m]. Largest 3 in2/ft", "areas [cm²/m]. Largest 3 in²/ft"),
        ("pile 2 m deep at 4e+04 psi, 1e-06", "pile 2 m deep at 4·10⁺⁴ psi, 1·10⁻⁶".replace("⁺", "")),
        (Message("{unit_weight} {unit}", unit_weight="25", unit=Name("kN/m^3")), "25 kN/m³"),
        (Message("{force} in {name}: 3 m2", force=Symbol("v_Ed"), name=Name("v_Ed 5 m2 2e-3")), None),
    ],
)
def test_words(text: str, expected: str | None) -> None:
    """Symbols have indices and units powers, but neither names of a case nor its keys."""
    assert marked(text) == (expected or "v{Ed} in v_Ed 5 m2 2e-3: 3 m²")


def test_names_in_series() -> None:
    """Names stay where words stand in a row, also those that hold the marks used in between."""
    assert marked(joined(["q_x", Name("q_x"), Name("a\ue000b")])) == "q{x}, q_x, ab"


def test_units_and_numbers() -> None:
    """A power is raised, the root of a unit is not; a number has its power of ten."""
    assert [raised(unit) for unit in ("cm2/m2", "kN/m^3", "MPa^0.5", "kNm")] == ["cm²/m²", "kN/m³", "MPa^0.5", "kNm"]
    assert written_out("8.4990e-07") == "8.4990·10⁻⁷"

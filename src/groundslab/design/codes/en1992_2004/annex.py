"""National parameters of EN 1992-1-1: values and clauses of an annex, from its file in the folder annexes.

A file has what differs from the recommended values. Each parameter is explained in annexes/recommended.toml.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from groundslab.design.codes.eurocode2.annex_files import AnnexFile, read_file, values_of

#: Names of the annexes, and their files.
ANNEXES = {
    "recommended": "recommended", "Austria": "austria", "France": "france", "Germany": "germany", "Italy": "italy",
    "Netherlands": "netherlands", "Poland": "poland", "Spain": "spain", "United Kingdom": "united_kingdom",
}  # fmt: skip


@dataclass(frozen=True, eq=False, slots=True)
class Annex:
    """The parameters of an annex: lengths in meters, those of formulas for stresses in MPa, as clauses have them."""

    gamma_c: float
    gamma_s: float
    accidental: tuple[float, float]
    alpha_cc: float
    alpha_cc_shear: float
    c_rd_c: float
    v_min: tuple[float, float]
    v_min_factored: bool
    most_f_ck_shear: float
    lever_by_cover: bool
    nu: tuple[float, float, float]
    torsion_struts: float
    flattest: float
    crack_friction: float
    c_rd_c_punching: float
    face: float
    k_max: float
    least_beta: float
    constant_beta: tuple[float, float, float]
    rho_strength: float
    links_alone: bool
    link_rows: tuple[float, float, float]
    thickest_link: float
    minimum: tuple[float, float]
    minimum_by_cracking: bool
    most_bars: float
    spacing: tuple[float, float, float]
    spacing_bent_most: tuple[float, float, float]
    k_3: float
    k_3_cover: float
    k_4: float
    crack_spacing_by_stress: bool
    least_f_ct: float
    tension_depth: tuple[float, float]
    w_max: Mapping[str, float]
    c_min_dur: Mapping[str, float]
    delta_c_dev: tuple[float, float]
    beam_links: tuple[float, float]
    link_distances: tuple[tuple[float, float, float], ...]
    leg_distances: tuple[tuple[float, float, float], ...]
    link_distances_by_height: bool
    slab_link_distances: tuple[tuple[float, float], ...]
    slab_links: float
    lap: tuple[float, float]
    cover_relieves: bool


@cache
def annex_of(name: str) -> Annex:
    """Return the parameters of an annex, the recommended ones where it has none of its own."""
    return Annex(**values_of({**file_of("recommended").parameters, **file_of(name).parameters}))


@cache
def file_of(name: str) -> AnnexFile:
    """Return the file of an annex, whose parameters each have value, clause and sources."""
    return read_file("groundslab.design.codes.en1992_2004", ANNEXES[name])


#: What is taken where no annex is named.
RECOMMENDED = annex_of("recommended")

"""The tables and the page of a study, made of arrays whose figures are known."""

from __future__ import annotations

import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from scipy import stats

from helpers.paths import ROOT

pytest.importorskip("jinja2")

from groundslab.study.definition.setup import Limit
from groundslab.study.evaluation import tables
from groundslab.study.evaluation.samples import PURE, Input, Output, Samples, choose_unit
from groundslab.study.report import figures, page
from groundslab.units import UNITS
from groundslab.views.plots.style import PAGE_COLORS

SOIL, LOAD = stats.lognorm(0.3, scale=40e6), stats.norm(50e3, 5e3)
EVIL = '<script>alert("1")</script> & $x_1$ \\frac{'


def values(u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return soil and load at points (n, 2) of the unit square."""
    return SOIL.ppf(u[:, 0]), LOAD.ppf(u[:, 1])


def sample(
    kind: str,
    u: np.ndarray,
    designs: int = 1,
    missing: tuple[int, ...] = (),
    name: str = "w",
    reason: str = "NotConverged",
) -> Samples:
    """Return a study of w = q / E + (what is chosen) / 100 with limit w <= 2 mm."""
    E, q = (np.tile(each, designs) for each in values(u))
    t = np.repeat(np.arange(designs) / 10, len(u))
    w = q / E + t / 100
    w[list(missing)] = np.nan
    inputs = [Input("E", UNITS["MPa"], E, SOIL.pdf), Input("q", UNITS["kPa"], q, LOAD.pdf)]
    inputs += [Input("t", UNITS["mm"], t, None, chosen=True)] * (designs > 1)
    n = len(w)
    return Samples(
        kind=kind,
        seed=3,
        number=np.arange(n),
        reason=tuple(f"{reason}: {name}" if i in missing else "" for i in range(n)),
        seconds=np.full(n, 0.25),
        inputs=tuple(inputs),
        outputs=(Output(name, UNITS["mm"], w),),
        limits=(Limit(f"limit of {name}", name, "at most", 2e-3, 0.05),),
        planned=n,
    )


def monte_carlo(n: int = 400, seed: int = 1, **options: object) -> Samples:
    """Return a study of n variants drawn at random."""
    return sample("monte carlo", np.random.default_rng(seed).random((n, 2)), **options)  # type: ignore[arg-type]


def table(made: Samples, name: str) -> dict[str, tuple[object, ...]]:
    """Return a table of a study as columns by name."""
    found = next(each for each in tables.tables_of(made) if each.name == name)
    return {column.name: column.values for column in found.columns}


def test_statistics_are_numpys() -> None:
    """Mean, deviation, quantiles and extremes are those of the solved variants, in the unit of display."""
    made = monte_carlo(missing=(7, 100))
    w = made.outputs[0].values[np.isfinite(made.outputs[0].values)] * 1e3
    row = {name: column[0] for name, column in table(made, "statistics").items()}
    assert row["variants"] == 398
    assert row["mean"] == pytest.approx(w.mean(), rel=1e-12)
    assert row["standard deviation"] == pytest.approx(w.std(ddof=1), rel=1e-12)
    assert row["coefficient of variation"] == pytest.approx(w.std(ddof=1) / w.mean(), rel=1e-12)
    assert (row["least"], row["greatest"]) == (w.min(), w.max())
    assert row["5% quantile"] == pytest.approx(np.quantile(w, 0.05), rel=1e-12)
    assert row["5% quantile, low"] <= row["5% quantile"] <= row["5% quantile, high"]  # type: ignore[operator]


def test_probability_of_failure_and_what_missing_results_could_change() -> None:
    """Failures are counted among the variants with a result; the target is held against all missing ones failing."""
    made = monte_carlo(missing=(7, 100))
    w = made.outputs[0].values
    row = {name: column[0] for name, column in table(made, "limit_states").items()}
    failed = int((w > 2e-3).sum())
    assert 0 < failed < 60
    assert (row["variants"], row["failed"], row["without a result"]) == (398, failed, 2)
    assert row["probability of failure"] == pytest.approx(failed / 398, rel=1e-12)
    assert row["reliability index"] == pytest.approx(-stats.norm.ppf(failed / 398), rel=1e-9)
    wanted = stats.binomtest(failed + 2, 400).proportion_ci(0.95, "wilson").high
    assert row["high if these fail"] == pytest.approx(wanted, rel=1e-9)
    assert row["target kept"] == ("yes" if wanted < 0.05 else "no")


@pytest.mark.usefixtures("undrawn")
@pytest.mark.parametrize("reason", ["NoEquilibrium", "NeutralEquilibrium"])
def test_a_foundation_that_fails_counts_as_a_failure(reason: str) -> None:
    """Variants without equilibrium fail every limit state, at most and at least; statistics leave them out."""
    made = monte_carlo(missing=(7, 100), reason=reason)
    lower = replace(made, limits=(Limit("least", "w", "at least", 0.0),))
    both = replace(made, limits=(*made.limits, *lower.limits))
    failed = int((made.outputs[0].values > 2e-3).sum())
    for of, expected in ((made, (failed + 2,)), (lower, (2,)), (both, (failed + 2, 2))):
        columns = table(of, "limit_states")
        assert columns["failed"] == expected
        assert columns["variants"] == (400,) * len(expected)
        assert set(columns["without a result"]) == {0}
    row = {name: column[0] for name, column in table(made, "limit_states").items()}
    assert row["probability of failure"] == pytest.approx((failed + 2) / 400, rel=1e-12)
    assert row["probability of failure"] == tables.failure_probability(made, made.groups[0], made.limits[0]).value
    assert table(made, "statistics")["variants"] == (398,)
    assert min(table(made, "exceedance")["probability"]) == pytest.approx(2 / 400, rel=1e-12)  # type: ignore[type-var]
    assert table(made, "missing")["foundation fails"] == ("yes",)
    assert "The foundation of 2 of 400 variants fails" in made_page(made)


@pytest.mark.usefixtures("undrawn")
def test_an_infinite_output_fails_its_limit() -> None:
    """Where no finite amount would do, the limit state has failed; statistics are of the finite ones and say so."""
    made = monte_carlo(40)
    w = made.outputs[0].values.copy()
    w[[3, 8]] = np.inf
    given = {name: getattr(made, name) for name in made.__dataclass_fields__}
    hurt = Samples(**{**given, "outputs": (Output("w", UNITS["mm"], w),)})
    row = {name: column[0] for name, column in table(hurt, "limit_states").items()}
    assert row["target"] == 0.05
    assert (row["variants"], row["failed"]) == (40, int((w > 2e-3).sum()))
    assert row["without a result"] == 0
    assert table(hurt, "statistics")["variants"] == (38,)
    assert "2 variants have an infinite w" in made_page(hurt)
    assert min(table(hurt, "exceedance")["probability"]) == pytest.approx(2 / 40, rel=1e-12)  # type: ignore[type-var]


@pytest.mark.usefixtures("undrawn")
def test_designs_by_words_have_a_figure() -> None:
    """A choice of words is named below the probabilities, as several choices are."""
    made = monte_carlo(30, designs=2)
    words = Input("element", PURE, np.repeat([0.0, 1.0], 30), None, True, ("mitc9",) * 30 + (EVIL,) * 30)
    given = {name: getattr(made, name) for name in made.__dataclass_fields__}
    text = made_page(Samples(**{**given, "inputs": (*made.inputs[:2], words)}))
    assert "element = mitc9" in text
    assert "<script" not in text


def test_the_probability_is_the_exact_one() -> None:
    """The interval of a large sample holds the probability found by an integral over the soil's distribution."""
    made = monte_carlo(20000)
    E = SOIL.ppf((np.arange(20000) + 0.5) / 20000)
    exact = float(LOAD.sf(2e-3 * E).mean())
    found = tables.failure_probability(made, made.groups[0], made.limits[0])
    assert found.low < exact < found.high
    assert found.high - found.low < 0.01


def test_curves_of_exceedance_look_to_the_bad_side() -> None:
    """The share is that of variants above a value, or below it where the limit state says at least."""
    made = monte_carlo(50)
    limit = Limit("a", "w", "at least", 1e-3)
    turned = Samples(**{**{name: getattr(made, name) for name in made.__dataclass_fields__}, "limits": (limit,)})
    above, below = table(made, "exceedance"), table(turned, "exceedance")
    assert not {"target", "target kept"} & set(table(turned, "limit_states"))
    assert above["value"] == below["value"] == tuple(np.sort(made.outputs[0].values) * 1e3)
    assert (set(above["side"]), set(below["side"])) == ({"above"}, {"below"})
    assert above["probability"] == pytest.approx(np.arange(49, -1, -1) / 50, abs=1e-12)
    assert below["probability"] == pytest.approx(np.arange(50) / 50, abs=1e-12)


def test_designs_are_told_apart() -> None:
    """Each value that the designer chose has figures of its own, from the same random numbers, in rising order."""
    made = monte_carlo(100, designs=3)
    found = table(made, "limit_states")
    assert found["design"] == ("t = 0 mm", "t = 100 mm", "t = 200 mm")
    assert found["variants"] == (100, 100, 100)
    p = found["probability of failure"]
    assert p[0] < p[1] < p[2]  # type: ignore[operator]
    assert made.varied == made.inputs[:2]


def test_a_list_has_no_probabilities() -> None:
    """Variants that were set by hand give extremes, but no mean, no probability and no correlation."""
    made = sample("list", np.random.default_rng(0).random((9, 2)))
    assert {each.name for each in tables.tables_of(made)} == {"variants", "statistics", "limit_states"}
    assert set(table(made, "statistics")) == {"output", "unit", "variants", "least", "greatest"}
    assert "probability of failure" not in table(made, "limit_states")


def test_sobol_indices_of_a_product() -> None:
    """For ln w = ln q - ln E the indices would be those of the logarithms; w's come out by the exact moments.

    w = q x with x = 1 / E: V_q = Var(q) E(x)^2, V_x = Var(x) E(q)^2, and the rest is Var(q) Var(x).
    """
    from scipy.stats import qmc

    points = qmc.Sobol(4, scramble=True, rng=np.random.default_rng(4)).random(1024)
    A, B = points[:, :2], points[:, 2:]
    mixed = [np.where(np.arange(2) == i, B, A) for i in range(2)]
    made = sample("saltelli", np.concatenate([A, B, *mixed]))
    assert made.base == 1024
    assert made.by_chance.sum() == 2048
    found = table(made, "sobol")
    mean_x, var_x = np.exp(0.3**2 / 2) / 40e6, (np.exp(0.3**2) - 1) * np.exp(0.3**2) / 40e6**2
    parts = np.array([var_x * 50e3**2, 5e3**2 * mean_x**2, 5e3**2 * var_x])
    first, total = parts[:2] / parts.sum(), (parts[:2] + parts[2]) / parts.sum()
    assert found["input"] == ("E", "q")
    assert found["first-order index"] == pytest.approx(first, abs=0.02)
    assert found["total index"] == pytest.approx(total, abs=0.02)
    assert found["blocks used"] == (1024, 1024)


def test_a_running_study_of_saltellis_sample() -> None:
    """Blocks whose variants have not all been computed are left out; with none whole there are no indices."""
    u = np.random.default_rng(0).random((40, 2))
    whole = sample("saltelli", u)
    part = Samples(
        kind=whole.kind,
        seed=whole.seed,
        number=whole.number[:35],
        reason=whole.reason[:35],
        seconds=whole.seconds[:35],
        inputs=tuple(Input(each.name, each.unit, each.values[:35]) for each in whole.inputs),
        outputs=(Output("w", UNITS["mm"], whole.outputs[0].values[:35]),),
        limits=whole.limits,
        planned=40,
    )
    assert table(part, "sobol")["blocks used"] == (5, 5)
    assert table(part, "variants")["variant"][-1] == 35


def test_tornado_of_one_at_a_time() -> None:
    """The swings are the outputs of the two variants of each input, the widest first."""
    u = np.full((5, 2), 0.5)
    u[1:3, 0], u[3:5, 1] = (0.1, 0.9), (0.1, 0.9)
    made = sample("tornado", u)
    E, q = values(u)
    found = table(made, "tornado")
    assert found["input"] == ("E", "q")
    assert found["at medians"] == pytest.approx([q[0] / E[0] * 1e3] * 2, rel=1e-12)
    assert found["input low"] == pytest.approx([q[0] / E[1] * 1e3, q[3] / E[0] * 1e3], rel=1e-12)
    assert found["input high"] == pytest.approx([q[0] / E[2] * 1e3, q[4] / E[0] * 1e3], rel=1e-12)


def test_correlations_are_scipys() -> None:
    """Pearson's and Spearman's coefficients are SciPy's, of the variants with a result."""
    made = monte_carlo(missing=(3,))
    there = np.isfinite(made.outputs[0].values)
    found = table(made, "correlations")
    assert found["with"] == ("E", "q")
    for place, each in enumerate(made.inputs):
        x, y = each.values[there], made.outputs[0].values[there]
        assert found["Pearson"][place] == pytest.approx(stats.pearsonr(x, y).statistic, rel=1e-10)
        assert found["Spearman"][place] == pytest.approx(stats.spearmanr(x, y).statistic, rel=1e-10)


def test_units_fit_the_size() -> None:
    """The unit of display is the largest one in which the usual value is not below one."""
    assert choose_unit("pressure", np.array([30e6, 40e6])).name == "MPa"
    assert choose_unit("length", np.array([0.012, np.nan])).name == "mm"
    assert choose_unit("length", np.array([0.0])).name == "mm"
    assert choose_unit(None, np.array([3.0])).name == ""


class Checked(HTMLParser):
    """A reader of pages that notes tags left open, ids, references and whatever is loaded from elsewhere."""

    VOID = ("meta", "link", "br", "img", "input", "hr")

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: list[str] = []
        self.references: list[str] = []
        self.loaded: list[str] = []
        self.scripts = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note an element."""
        given = dict(attrs)
        if tag not in self.VOID:
            self.open.append(tag)
        self.scripts += tag == "script"
        if "id" in given:
            self.ids.append(given["id"] or "")
        for name in ("href", "xlink:href"):
            if (given.get(name) or "").startswith("#"):
                self.references.append((given[name] or "")[1:])
        self.references += re.findall(r"url\(#([^)]*)\)", " ".join(filter(None, given.values())))
        links = [given.get(name) for name in ("src", "href", "xlink:href", "data", "action", "srcset")]
        self.loaded += [link for link in links if link and not link.startswith(("#", "data:"))]

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note an element without content."""
        self.handle_starttag(tag, attrs)
        if tag not in self.VOID:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        """Close an element, which must be the last one opened."""
        assert self.open.pop() == tag


def made_page(made: Samples, title: str = "A study", *, maps: bool = False) -> str:
    """Return the page of a study, with two maps if asked for."""
    nodes = np.array([[x, y] for y in (0.0, 1.0, 2.0) for x in (0.0, 2.0, 4.0)])
    elements = np.array([[0, 2, 8, 6, 1, 5, 7, 3, 4]])
    fields = [page.Map(f"mean of {title}", nodes, elements, np.arange(9.0) - 3, UNITS["mm"])]
    fields.append(page.Map("constant", nodes, elements, np.zeros(9), UNITS["%"]))
    return page.html(made, page.Origin(title, (("seed", "3"), ("file", title))), fields if maps else [])


@pytest.fixture(scope="module")
def of_two_designs() -> str:
    """Return the page of a study of two designs, with maps."""
    return made_page(monte_carlo(80, designs=2), maps=True)


@pytest.fixture
def undrawn(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let figures be empty, where a test is about the words beside them."""
    monkeypatch.setattr(figures, "_render", lambda *_, **__: "<svg></svg>")


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["monte carlo", "saltelli", "tornado", "list"])
def test_the_page_is_whole_and_loads_nothing(kind: str) -> None:
    """Every element is closed, ids are unique, references resolve, no script runs, nothing comes from elsewhere."""
    u = np.random.default_rng(2).random((40 if kind == "saltelli" else 5, 2))
    text = made_page(sample(kind, u), maps=kind == "list")
    reader = Checked()
    reader.feed(text)
    assert not reader.open
    assert len(reader.ids) == len(set(reader.ids)) > 0
    assert set(reader.references) <= set(reader.ids)
    assert not reader.loaded
    assert not reader.scripts
    assert "@import" not in text
    assert not re.search(r"url\((?!#)", text)
    assert "default-src 'none'" in text


@pytest.mark.slow
def test_texts_of_the_study_are_escaped() -> None:
    """A title, a name or a reason that looks like markup or like a formula stands in the page as it was written."""
    text = made_page(monte_carlo(60, missing=(5,), name=EVIL), EVIL, maps=True)
    reader = Checked()
    reader.feed(text)
    assert not reader.open
    assert not reader.scripts
    assert "<script" not in text
    assert text.count("&lt;script&gt;") > 5
    assert "NotConverged: &lt;script" in text


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["monte carlo", "saltelli", "tornado"])
def test_long_names_leave_room_for_the_figures(kind: str) -> None:
    """Names of 200 letters, or ones that begin with a line below, are cut in figures and stand whole in tables."""
    name = "_" + "M" * 199
    made = sample(kind, np.random.default_rng(2).random((40 if kind == "saltelli" else 5, 2)), name=name)
    inputs = tuple(Input(each.name + name[2:], each.unit, each.values, each.density) for each in made.inputs)
    given = {each: getattr(made, each) for each in made.__dataclass_fields__}
    text = made_page(Samples(**{**given, "inputs": inputs}))
    assert not any(name in each for each in re.findall(r"<svg.*?</svg>", text, re.DOTALL))
    assert text.count(name) > 3


@pytest.mark.slow
def test_figures_are_whole_svg(of_two_designs: str) -> None:
    """Each figure is an SVG element by itself, the same each time, with the page's colours instead of its own."""
    drawn = re.findall(r"<svg.*?</svg>", of_two_designs, re.DOTALL)
    assert len(drawn) == 8
    for each in drawn:
        ElementTree.fromstring(each)
        assert not any(colour in each for colour in PAGE_COLORS)
        assert "var(--" in each
        assert "mathdefault" not in each
    assert re.findall(r"<svg.*?</svg>", made_page(monte_carlo(80, designs=2), maps=True), re.DOTALL) == drawn


@pytest.mark.usefixtures("undrawn")
def test_a_study_without_any_result_has_a_page() -> None:
    """Where no variant has a result, the page says so and why; where all foundations fail, that this is certain."""
    text = made_page(monte_carlo(12, missing=tuple(range(12))))
    assert "12 of 12 variants have no result" in text
    assert "NotConverged" in text
    text = made_page(monte_carlo(12, missing=tuple(range(12)), reason="NoEquilibrium"))
    assert "The foundation of 12 of 12 variants fails" in text
    assert "Limit states" in text


@pytest.mark.slow
def test_the_page_has_the_colours_of_the_other_pages(of_two_designs: str) -> None:
    """Every colour that the page shares with report and workbench is theirs, light and dark, where they are at hand."""
    theme = ROOT / "web" / "src" / "viewer" / "shared" / "theme.css"
    if not theme.exists():
        pytest.skip("the sources of the other pages are not there")
    own = (Path(page.__file__).parent / "page.css").read_text(encoding="utf-8")
    pattern = re.compile(r"(--gs-[\w-]+): (#\w+);")
    shared = set(pattern.findall(own))
    assert len(shared) > 10
    pairs = re.findall(r"(--gs-[\w-]+): light-dark\((#\w+), (#\w+)\);", theme.read_text(encoding="utf-8"))
    assert shared <= {(name, color) for name, *colors in pairs for color in colors}
    used = set(re.findall(r"var\((--[\w-]+)\)", own + of_two_designs))
    assert {"--gs-ink", "--gs-line", "--gs-bad"} <= used
    assert used <= {name for name, _ in pattern.findall(own)} | {"--second"}


@pytest.mark.usefixtures("undrawn")
def test_an_unfinished_study_says_so() -> None:
    """A page made while the study runs says how many variants are missing."""
    made = monte_carlo(20)
    running = Samples(**{**{name: getattr(made, name) for name in made.__dataclass_fields__}, "planned": 50})
    assert "30 variants are still to be computed" in made_page(running)

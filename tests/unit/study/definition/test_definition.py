"""Studies: their files, paths into a case, distributions, samples."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy import stats

from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.schema.issues import FieldError
from groundslab.study.definition import case_paths, distributions, files
from groundslab.study.definition.schema import StudyFile
from groundslab.study.sampling import designs
from helpers.studies import CASE, STUDY, read

MODEL = casefile.loads(CASE)


def issues_of(folder: Path, study: str, case: str = CASE) -> dict[str, str]:
    """Return what is wrong with a study, by place."""
    with pytest.raises(InputError) as caught:
        read(folder, study, case)
    return {issue.location: str(issue) for issue in caught.value.issues}


class TestPaths:
    """Paths lead to keys as issues name them."""

    @pytest.mark.parametrize(
        ("path", "value"),
        [
            ("plate.thickness", 0.2),
            ("ground.k", 20e6),
            ("loads[2].q", 200e3),
            ("loads[2].x[1]", 1.0),
            ("combinations[2].factors.live", 1.5),
            ('combinations[2].factors."live"', 1.5),
            ("mesh.counts", (8, 6)),
            ("title", "A small slab"),
            ("contact.limit_pressure", None),
        ],
    )
    def test_value(self, path: str, value: object) -> None:
        """A path finds what the case holds, None where nothing is given."""
        assert case_paths.place_of(MODEL, path).value == value

    @pytest.mark.parametrize(
        ("path", "expected"),
        [
            ("", "a path such as"),
            ("ground..k", "a path such as"),
            ("[1].k", "a path such as"),
            ("loads2].q", "a path such as"),
            ("loads[0].q", "positions count from 1"),
            ("ground.kk", 'did you mean "k"?'),
            ("grund.k", 'did you mean "ground"?'),
            ("ground", "a key of ground"),
            ("ground.kind", "says which kind it is"),
            ("loads.q", "loads is a list of 2"),
            ("loads[3].q", "loads[1] to loads[2]"),
            ("supports[1].x", "a case with supports"),
            ("reinforcement.f_ck", "the case does not have it"),
            ("ground.k.x", "a path that ends with ground.k"),
            ("loads[2].x[3]", "a path that ends with loads[2].x"),
            ("combinations[1].factors", '"combinations[1].factors.dead"'),
            ("combinations[1].factors.lve", 'did you mean "live"?'),
        ],
    )
    def test_wrong_paths(self, path: str, expected: str) -> None:
        """A path that leads nowhere says where it went wrong."""
        with pytest.raises(FieldError) as caught:
            case_paths.place_of(MODEL, path)
        assert expected in str(caught.value.relative_issues[0])

    def test_changed_case_is_that_of_a_changed_file(self) -> None:
        """A case with other values at some places is the one that a file with these values describes."""
        places = {
            "ground.k": 15e6, "loads[2].q": 1e5, "loads[2].x[2]": 1.8, "combinations[2].factors.live": 1.2,
            "plate.thickness": 0.25,
        }  # fmt: skip
        found = case_paths.with_values(
            MODEL, {case_paths.place_of(MODEL, path): value for path, value in places.items()}
        )
        text = CASE.replace("20 MPa/m", "15 MPa/m").replace("200 kPa", "100 kPa").replace('"2 m"]', '"1.8 m"]')
        text = text.replace("live = 1.5", "live = 1.2").replace("200 mm", "250 mm")
        assert found == casefile.loads(text)
        assert case_paths.with_values(MODEL, {}) == MODEL

    def test_impossible_values_have_their_place(self) -> None:
        """Issues of a changed case have the path of the key in the case."""
        places = {case_paths.place_of(MODEL, "plate.nu"): 0.6, case_paths.place_of(MODEL, "loads[2].x[2]"): 3.0}
        with pytest.raises(InputError) as caught:
            case_paths.with_values(MODEL, places)
        assert {issue.location for issue in caught.value.issues} == {"plate.nu"}
        with pytest.raises(InputError) as caught:
            case_paths.with_values(MODEL, {case_paths.place_of(MODEL, "loads[2].x[2]"): -9.0})
        assert [issue.location for issue in caught.value.issues] == ["loads[2].x"]


def read_si(raw: object) -> float:
    """Return an amount that is a number already."""
    return float(raw)  # type: ignore[arg-type]


class TestDistributions:
    """Distributions by their moments."""

    @pytest.mark.slow
    @pytest.mark.parametrize(
        "part",
        [
            distributions.Normal(mean=40.0, cov=0.3),
            distributions.Normal(mean=-40.0, cov=0.3),
            distributions.Lognormal(mean=40.0, std=12.0),
            distributions.Gamma(mean=40.0, cov=0.3),
            distributions.Weibull(mean=40.0, cov=0.3),
            distributions.Gumbel(mean=40.0, std=12.0),
            distributions.Beta(mean=40.0, std=12.0, low=0.0, high=100.0),
        ],
    )
    def test_moments(self, part: distributions.AnyDistribution) -> None:
        """Mean and standard deviation, integrated over the quantiles, are the given ones."""
        found = distributions.distribution_of(part, read_si)
        # midpoints of equal probabilities; the last ones carry little
        p = (np.arange(200_000) + 0.5) / 200_000
        values = found.ppf(p)
        assert values.mean() == pytest.approx(math.copysign(40.0, part.mean), rel=2e-4)
        assert values.std() == pytest.approx(12.0, rel=3e-3)
        assert found.mean() == pytest.approx(values.mean(), rel=2e-4)
        assert found.std() == pytest.approx(12.0, rel=1e-9)

    @pytest.mark.parametrize(
        ("part", "cdf"),
        [
            (distributions.Uniform(low=2.0, high=6.0), lambda x: (x - 2) / 4),
            # halves of a triangle over [0, 4] with its top at 1: x^2/4 and 1 - (4 - x)^2/12
            (distributions.Triangular(low=0.0, mode=1.0, high=4.0),
             lambda x: np.where(x < 1, x**2 / 4, 1 - (4 - x) ** 2 / 12)),
            (distributions.Gumbel(mean=0.5772156649015329, std=math.pi / math.sqrt(6)), lambda x: np.exp(-np.exp(-x))),
            (distributions.Scipy(name="expon", parameters={"scale": 2.0}), lambda x: 1 - np.exp(-x / 2)),
            (distributions.Weibull(mean=math.gamma(1.5) * 3, cov=math.sqrt(1 / math.gamma(1.5) ** 2 - 1)),
             lambda x: 1 - np.exp(-((x / 3) ** 2))),
            (distributions.TruncatedNormal(mean=0.0, std=1.0, low=-1.0, high=2.0),
             lambda x: (stats.norm.cdf(x) - stats.norm.cdf(-1)) / (stats.norm.cdf(2) - stats.norm.cdf(-1))),
        ],
    )  # fmt: skip
    def test_distribution_functions(
        self, part: distributions.AnyDistribution, cdf: Callable[[np.ndarray], np.ndarray]
    ) -> None:
        """Quantiles are the inverse of the distribution function in its textbook form."""
        p = np.linspace(0.01, 0.99, 25)
        assert cdf(distributions.distribution_of(part, read_si).ppf(p)) == pytest.approx(p, rel=1e-9)

    @pytest.mark.parametrize(
        ("part", "place"),
        [
            (distributions.Uniform(low=2.0, high=2.0), ("high",)),
            (distributions.Triangular(low=0.0, mode=5.0, high=4.0), ("mode",)),
            (distributions.Normal(mean=0.0, cov=0.3), ("cov",)),
            (distributions.Normal(mean=1.0, std=-1.0), ("std",)),
            (distributions.Lognormal(mean=-1.0, cov=0.1), ("mean",)),
            (distributions.Beta(mean=3.0, std=0.1, low=0.0, high=1.0), ("mean",)),
            (distributions.Beta(mean=0.5, std=0.5, low=0.0, high=1.0), ()),
            (distributions.Weibull(mean=1.0, cov=1e6), ()),
            (distributions.Scipy(name="lognom", parameters={"s": 1.0}), ("name",)),
            (distributions.Scipy(name="lognorm", parameters={"sd": 1.0}), ("parameters", "sd")),
            (distributions.Scipy(name="lognorm", parameters={"scale": 1.0}), ("parameters",)),
            (distributions.Scipy(name="lognorm", parameters={"s": -1.0}), ("parameters",)),
        ],
    )
    def test_impossible_ones(self, part: distributions.AnyDistribution, place: tuple[str, ...]) -> None:
        """Impossible values are reported at their key."""
        with pytest.raises(FieldError) as caught:
            distributions.distribution_of(part, read_si)
        assert caught.value.relative_issues[0].place == place


class TestFile:
    """Study files: all issues at once, with units."""

    def test_setup(self, tmp_path: Path) -> None:
        """Paths, units and names become what the study needs, in SI units."""
        setup = read(tmp_path).setup
        k, machine = setup.variables
        assert (k.name, k.path, k.unit, k.place.value) == ("k", "ground.k", "Pa/m", 20e6)
        assert k.distribution is not None
        assert k.distribution.mean() == pytest.approx(20e6)
        assert (machine.times, machine.unit, machine.value_in_case(1.1)) == (True, "", pytest.approx(220e3))
        assert [output.name for output in setup.outputs] == [
            "largest settlement", "in contact under service", "settlement everywhere under service"
        ]  # fmt: skip
        assert setup.limits[0].bound == 0.008
        assert setup.limits[0].margin(0.007) == pytest.approx(0.001)
        assert setup.count == 12

    def test_all_issues_at_once(self, tmp_path: Path) -> None:
        """Issues of the study's own keys and of its case's file come together."""
        study = STUDY.replace("seed = 3", "seed = -1").replace("count = 12", "").replace('"largest"', '"lagest"')
        found = issues_of(tmp_path, study, CASE.replace("nu = 0.2", "nu = 2"))
        assert found.keys() == {"seed", "sampling.count", "keep[1].take", f"{tmp_path / 'slab.toml'}: plate.nu"}

    def test_all_issues_against_the_case_at_once(self, tmp_path: Path) -> None:
        """What does not fit the case is reported at once as well: paths, units, ranges, names, places."""
        study = (
            STUDY.replace("ground.k", "ground.kk").replace("std = 0.2", 'std = "0.2 m"').replace('"8 mm"', '"8 kPa"')
            + '[[vary]]\npath = "plate.nu"\nvalues = [0.1, 0.7]\n'
            + '[[vary]]\npath = "plate.thickness"\ndistribution = {kind = "uniform", low = "0.2 m", high = "3 kPa"}\n'
            + '[[vary]]\npath = "plate.element"\ndistribution = {kind = "uniform", low = 1, high = 2}\n'
            + '[[vary]]\npath = "contact.limit_pressure"\ntimes = true\nvalues = [1]\n'
            + '[[keep]]\nof = "setlement"\ntake = "largest"\n[[keep]]\nof = "moment_x"\n'
            + '[[keep]]\nof = "load"\ntake = "largest"\n[[keep]]\nof = "gap"\ntake = "at"\nx = "9 m"\ny = "0 m"\n'
            + '[[keep]]\nof = "support force"\nsupport = "pile"\n[[keep]]\nof = "reinforcement"\ntake = "largest"\n'
            + '[[keep]]\nof = "reaction"\ncombination = "servce"\n'
            + '[[random_field]]\npath = "plate.E"\ndistribution = {kind = "normal", mean = 1, cov = 0.1}\n'
            + 'correlation_length = "2 m"\n'
        )
        assert issues_of(tmp_path, study).keys() == {
            "vary[1].path", "vary[2].distribution.std", "vary[3].values[2]", "vary[4].distribution.high",
            "vary[5].distribution", "vary[6].times", "keep[4].of", "keep[5].take", "keep[6].take", "keep[7].x",
            "keep[8].support", "keep[9].of", "keep[10].combination", "limit_state[1].at_most", "random_field[1].path",
        }  # fmt: skip

    @pytest.mark.parametrize(
        ("old", "new", "where"),
        [
            ('"monte carlo"', '"grid"', "sampling.count"),
            ('"monte carlo"\ncount = 12', '"grid"', "vary[1].distribution"),
            ('name = "machine"\ntimes', 'name = "K"\ntimes', "vary[2].name"),
            ('name = "machine"\ntimes', 'name = "Status"\ntimes', "vary[2].name"),
            ('of = "settlement"\ntake = "largest"', 'name = "k"\nof = "load"', "keep[1].name"),
            ('keep = "largest settlement"', 'keep = "settlement everywhere under service"', "limit_state[1].keep"),
            ('keep = "largest settlement"', 'keep = "lrgest settlement"', "limit_state[1].keep"),
            ('at_most = "8 mm"', 'at_most = "8 mm"\nat_least = "1 mm"', "limit_state[1]"),
            ("[[keep]]", '[[correlation]]\nbetween = ["k", "m"]\nrho = 0.5\n[[keep]]', "correlation[1].between[2]"),
            ("[[keep]]", '[[correlation]]\nbetween = ["k", "machine"]\nrho = 1\n[[keep]]', "correlation[1].rho"),
            ('"loads[2].q"', '"ground.k"', "vary[2].path"),
            ('case = "slab.toml"', "", "case"),
        ],
    )
    def test_what_does_not_fit_together(self, tmp_path: Path, old: str, new: str, where: str) -> None:
        """A contradiction of two keys is reported at one of them."""
        assert old in STUDY
        assert where in issues_of(tmp_path, STUDY.replace(old, new, 1))

    def test_a_continuum_is_the_same_everywhere(self, tmp_path: Path) -> None:
        """Random fields and constants that it has not are refused; moduli vary, and results in its depth are kept."""
        layer = '{ E = "20 MPa", nu = 0.3, thickness = "4 m" }'
        case = CASE.replace('kind = "winkler"\nk = "20 MPa/m"', f'kind = "continuum"\nlayers = [{layer}]')
        study = """
case = "slab.toml"
sampling = { kind = "monte carlo", count = 4 }
[[vary]]
path = "ground.layers[1].E"
distribution = { kind = "lognormal", mean = "20 MPa", cov = 0.2 }
[[keep]]
of = "soil settlement"
x = "9 m"
y = "0 m"
z = "3 m"
"""
        assert read(tmp_path, study, case).setup.outputs[0].column == "soil settlement at (9, 0, 3) m"
        wrong = (
            study.replace('z = "3 m"', 'z = "5 m"')
            + """
[[keep]]
of = "k0"
[[random_field]]
path = "ground.layers[1].E"
distribution = { kind = "lognormal", mean = 1, cov = 0.3 }
correlation_length = "5 m"
"""
        )
        issues = issues_of(tmp_path, wrong, case)
        assert issues.keys() == {"keep[1].z", "keep[2].of", "random_field[1].path"}
        assert "the same everywhere" in issues["random_field[1].path"]
        assert "continuum" in issues_of(tmp_path, study.replace("ground.layers[1].E", "ground.k"), CASE)["keep[1].of"]

    def test_saltelli_is_for_independent_variables(self, tmp_path: Path) -> None:
        """Correlation is refused where Sobol's indices are computed; so are impossible correlations."""
        pair = '[[correlation]]\nbetween = ["k", "machine"]\nrho = 0.5\n'
        assert "correlation" in issues_of(tmp_path, STUDY.replace("monte carlo", "saltelli") + pair)
        third = '[[vary]]\npath = "plate.nu"\nname = "nu"\ndistribution = {kind = "uniform", low = 0.1, high = 0.3}\n'
        more = '[[correlation]]\nbetween = ["k", "nu"]\nrho = -0.9\n'
        more += '[[correlation]]\nbetween = ["nu", "machine"]\nrho = 0.9\n'
        assert "correlation" in issues_of(tmp_path, STUDY + third + pair + more)

    def test_described_in_python(self, tmp_path: Path) -> None:
        """A study made of parts with numbers in SI units is written with units, and reads back as the same study."""
        described = StudyFile(
            case="slab.toml",
            sampling={"kind": "list"},
            vary=[
                {"path": "ground.k", "values": [10e6, "20 MPa/m"]},
                {"path": "mesh.counts", "values": [(8, 6), (6, 4)]},
                {"path": "contact.tensionless", "values": [True, False]},
                {"path": "loads[2].x", "values": [(1.0, 2.0), ("0.5 m", "2 m")]},
            ],
            keep=[{"of": "settlement", "take": "at", "x": 1.5, "y": 0}],
            limit_state=[{"name": "l", "keep": "settlement at (1.5, 0) m", "at_most": 0.01}],
        )
        made = files.resolve(described, MODEL)
        again = read(tmp_path, made.study_text, made.case_text)
        assert again.setup.variables == made.setup.variables
        assert again.setup.limits == made.setup.limits
        assert again.setup.model == MODEL
        assert 'values = ["10000000.0 Pa/m", "20 MPa/m"]' in made.study_text


def setup_with(folder: Path, sampling_text: str, *more: str) -> designs.Setup:
    """Return the setup of the small study with another sampling."""
    return read(folder, STUDY.replace('kind = "monte carlo"\ncount = 12', sampling_text) + "".join(more)).setup


class TestSampling:
    """Values of the variants, from the seed alone."""

    def test_grid_and_list(self, tmp_path: Path) -> None:
        """A grid has all values with all others, the last variable first; a list one variant for each position."""
        head, keep = 'case = "slab.toml"\n[sampling]\nkind = "{}"\n', '[[keep]]\nof = "load"\n'
        vary = '[[vary]]\npath = "ground.k"\nvalues = ["1 MPa/m", "2 MPa/m"]\n'
        vary += '[[vary]]\npath = "plate.nu"\nvalues = [0.1, 0.2]\n'
        grid = designs.list_variants(read(tmp_path, head.format("grid") + vary + keep).setup)
        assert [grid[number].values for number in range(1, len(grid) + 1)] == [
            (1e6, 0.1), (1e6, 0.2), (2e6, 0.1), (2e6, 0.2)
        ]  # fmt: skip
        listed = designs.list_variants(read(tmp_path, head.format("list") + vary + keep).setup)
        assert [listed[number].values for number in (1, 2)] == [(1e6, 0.1), (2e6, 0.2)]
        assert len(listed) == 2

    @pytest.mark.parametrize("kind", ["monte carlo", "latin hypercube", "sobol", "saltelli"])
    def test_same_seed_same_sample(self, tmp_path: Path, kind: str) -> None:
        """A sample is that of its seed, and another seed draws another one."""
        text = f'kind = "{kind}"\ncount = 7'
        one, two = (designs.list_variants(setup_with(tmp_path, text)) for _ in range(2))
        assert one.values == two.values
        other = read(tmp_path, STUDY.replace("seed = 3", "seed = 4").replace('"monte carlo"', f'"{kind}"')).setup
        assert designs.list_variants(other).values[0][0] != one.values[0][0]

    def test_latin_hypercube(self, tmp_path: Path) -> None:
        """Each of as many equal parts of a variable's probability holds one value."""
        setup = setup_with(tmp_path, 'kind = "latin hypercube"\ncount = 50')
        for variable, values in zip(setup.variables, designs.list_variants(setup).values, strict=True):
            assert variable.distribution is not None
            parts = np.floor(variable.distribution.cdf(values) * 50)
            assert sorted(parts) == list(range(50))

    def test_sobol_points_are_even(self, tmp_path: Path) -> None:
        """2^8 points of the sequence have one in each of 16 x 16 boxes, which random ones have not."""
        setup = setup_with(tmp_path, 'kind = "sobol"\ncount = 256')
        boxes = np.floor(designs.unit_points(setup, 2) * 16)
        assert len(np.unique(boxes, axis=0)) == 256

    def test_correlation_of_scores(self, tmp_path: Path) -> None:
        """Normal scores of drawn values have the given correlation, within the error of 20,000 of them."""
        more = '[[correlation]]\nbetween = ["k", "machine"]\nrho = -0.6\n'
        setup = setup_with(tmp_path, 'kind = "monte carlo"\ncount = 20000', more)
        k, machine = designs.list_variants(setup).values
        scores = np.log(k), np.array(machine)  # monotone, and normal
        # the standard error of rho is (1 - rho^2) / sqrt(n) = 0.0045
        assert np.corrcoef(*scores)[0, 1] == pytest.approx(-0.6, abs=0.02)
        assert np.mean(k) == pytest.approx(20e6, rel=0.01)
        assert np.std(machine) == pytest.approx(0.2, rel=0.03)

    def test_listed_values_are_equally_likely(self, tmp_path: Path) -> None:
        """Where variants are drawn, values in a list come up alike, the ends of the probabilities included."""
        more = '[[vary]]\npath = "plate.nu"\nvalues = [0.1, 0.2, 0.3]\n'
        setup = setup_with(tmp_path, 'kind = "latin hypercube"\ncount = 300', more)
        values, counts = np.unique(designs.list_variants(setup).values[2], return_counts=True)
        assert (values.tolist(), counts.tolist()) == ([0.1, 0.2, 0.3], [100, 100, 100])
        assert designs.quantiles(setup.variables[2], np.array([0.0, 1.0])) == [0.1, 0.3]

    def test_saltelli_blocks(self, tmp_path: Path) -> None:
        """After A and B each block is A with one variable, or the seeds of one random field, from B."""
        field = '[[random_field]]\npath = "ground.k"\ncorrelation_length = "2 m"\n'
        field += 'distribution = {kind = "lognormal", mean = 1, cov = 0.1}\n'
        setup = setup_with(tmp_path, 'kind = "saltelli"\ncount = 8', field)
        sample = designs.list_variants(setup)
        assert len(sample) == setup.count == 8 * 5
        columns = [np.reshape(column, (5, 8)) for column in (*sample.values, sample.seeds[:, 0])]
        a, b = [column[0] for column in columns], [column[1] for column in columns]
        for one in range(3):
            assert not np.isin(a[one], b[one]).any()
            for other in range(3):
                assert np.array_equal(columns[other][2 + one], b[other] if one == other else a[other])

"""Studies: what is kept of a variant, random fields, maps; all in one process."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest
from scipy import stats

import groundslab
from groundslab.case import casefile
from groundslab.design.bars.required_bars import bar_fields
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.results.fields import PLATE_FIELDS
from groundslab.study.definition import outputs
from groundslab.study.definition.setup import Field
from groundslab.study.execution import variant
from groundslab.study.sampling import designs, random_fields
from helpers.studies import CASE, STUDY, read, run

MODEL = casefile.loads(CASE)


def solved(case: str = CASE) -> groundslab.Results:
    """Return the results of a case."""
    return groundslab.solve(casefile.loads(case))


class TestOutputs:
    """What is kept of results."""

    combined = solved(CASE + '[reinforcement]\nf_ck = "30 MPa"\nf_yk = "500 MPa"\nbottom = ["40 mm", "50 mm"]\n'
                      'top = ["40 mm", "50 mm"]\n')  # fmt: skip

    def output(self, of: str, take: str | None = None, **more: object) -> outputs.RequestedOutput:
        """Return an output."""
        return outputs.RequestedOutput(name=of, of=of, take=take, **more)  # type: ignore[arg-type]

    def test_fields_of_the_plate(self) -> None:
        """Largest, smallest and value at a node are those of the result's own arrays, the worst over combinations."""
        names = ("service", "design")
        for field in PLATE_FIELDS:
            arrays = [getattr(self.combined[name].plate, field) for name in names]
            plate = self.combined["service"].plate
            of = field.replace("_", " ")
            assert outputs.scalar_of(self.output(of, "largest"), self.combined, names) == max(a.max() for a in arrays)
            assert outputs.scalar_of(self.output(of, "smallest"), self.combined, names) == min(a.min() for a in arrays)
            x, y = plate.nodes[17]
            found = outputs.scalar_of(self.output(of, "at", x=x, y=y), self.combined, ["service"])
            assert found == pytest.approx(arrays[0][17], rel=1e-9, abs=1e-12 * np.abs(arrays[0]).max())
            whole = outputs.nodal_values_of(self.output(of, "everywhere"), self.combined, names)
            assert whole is not None
            assert np.array_equal(np.abs(whole), np.maximum(*np.abs(arrays)))

    def test_every_field_and_figure(self) -> None:
        """Whatever is in the lists can be kept, and a value at a node is the field's value there."""
        plate = self.combined["design"].plate
        node = int(np.argmax(plate.moment_x))
        x, y = plate.nodes[node]
        for name in outputs.FIELDS:
            field = outputs.field_of(self.combined["design"], name)
            assert field.shape == (len(plate.nodes),)
            found = outputs.scalar_of(self.output(name, "at", x=x, y=y), self.combined, ["design"])
            assert found == pytest.approx(field[node], rel=1e-8, abs=1e-12 * np.abs(field).max())
        there = {
            name for name in outputs.SCALARS
            if outputs.scalar_of(self.output(name), self.combined, ["design"]) is not None
        }  # fmt: skip
        absent = {"support force", "gamma", "margin effect", *outputs.SOIL}
        assert there == outputs.SCALARS.keys() - {*absent, "k1"} | {"k1"} - (
            set() if self.combined["design"].constants.k1 else {"k1"}
        )

    def test_figures(self) -> None:
        """Load, reaction and contact are those of statics: the loads' sum is the reaction, a part lifts off."""
        # 2 kPa on 12 m2 and 200 kPa on 1 m2
        loads = {"service": 24e3 + 200e3, "design": 1.35 * 24e3 + 1.5 * 200e3}
        for name, load in loads.items():
            assert outputs.scalar_of(self.output("load"), self.combined, [name]) == pytest.approx(load)
            assert outputs.scalar_of(self.output("reaction"), self.combined, [name]) == pytest.approx(load)
        share = outputs.scalar_of(self.output("in contact"), self.combined, ["service"])
        assert share is not None
        assert 0.1 < share < 0.9
        tilt = outputs.scalar_of(self.output("tilt x"), self.combined, ["service"])
        assert tilt is not None
        assert tilt > 0

    def test_mean_is_over_the_area(self) -> None:
        """Of pressure the mean times the area is the reaction."""
        mean = outputs.scalar_of(self.output("pressure", "mean"), self.combined, ["service"])
        assert mean == pytest.approx(224e3 / 12)

    def test_combination_without_results(self) -> None:
        """What needs a combination that has no results is None."""
        assert outputs.scalar_of(self.output("load"), self.combined, ["service", "nothing"]) is None
        assert outputs.nodal_values_of(self.output("gap", "everywhere"), self.combined, ["nothing"]) is None


class TestRows:
    """Variants become rows."""

    @pytest.mark.slow
    def test_row_is_the_changed_case(self, tmp_path: Path) -> None:
        """A row holds what solving the case by itself, with the row's values written into its file, gives."""
        study = run(tmp_path)
        table = study.table()
        assert list(table.index) == list(range(1, 13))
        assert set(table["status"]) == {"solved"}
        row = table.loc[5]
        case = CASE.replace('"20 MPa/m"', f'"{float(row["k"])!r} Pa/m"').replace(
            '"200 kPa"', f'"{float(row["machine"]) * 200!r} kPa"'
        )
        alone = solved(case)
        largest = max(alone[name].plate.settlement.max() for name in ("service", "design"))
        # either is within the certificate of the exact solution of the equations
        assert row["largest settlement"] == pytest.approx(largest, rel=2e-6)
        field = dict(study.fields("settlement"))[5]
        assert field == pytest.approx(alone["service"].plate.settlement, rel=1e-5, abs=1e-8)
        assert np.array_equal(study.mesh("settlement").nodes, alone["service"].plate.nodes)

    @pytest.mark.slow
    def test_failed_variants_are_rows(self, tmp_path: Path) -> None:
        """Impossible values and loads without equilibrium are rows with their reason; the others are solved."""
        study = run(
            tmp_path,
            'case = "slab.toml"\n[sampling]\nkind = "list"\n'
            '[[vary]]\npath = "plate.nu"\nvalues = [0.2, 0.2, 0.2, 0.2]\n'
            '[[vary]]\npath = "loads[2].x[2]"\nvalues = ["2 m", "0.4 m", "2 m", "0.5 m"]\n'
            '[[vary]]\npath = "loads[1].q"\nvalues = ["2 kPa", "2 kPa", "-300 kPa", "2 kPa"]\n'
            '[[keep]]\nof = "load"\ncombination = "service"\n[[keep]]\nname = "all"\nof = "load"\n',
        )
        table = study.table()
        assert list(table["status"]) == ["solved", "failed", "foundation fails", "failed"]
        assert list(table["reason"]) == ["", "input", "NoEquilibrium", "input"]
        assert "loads[2].x" in table["message"][2]
        assert table["load under service"].notna().tolist() == [True, False, False, False]
        assert study.counts() == {"input": 2, "NoEquilibrium": 1, "solved": 1}

    def test_only_what_is_needed_is_solved(self, tmp_path: Path) -> None:
        """A combination that nothing is kept of is not solved, and does not make a variant fail."""
        study = run(
            tmp_path,
            'case = "slab.toml"\n[sampling]\nkind = "list"\n[[vary]]\npath = "combinations[2].factors.live"\n'
            'values = [1.5, -5]\n[[keep]]\nof = "load"\ncombination = "service"\n',
        )
        assert study.table()["load under service"].tolist() == pytest.approx([224e3, 224e3])

    @pytest.mark.slow
    @pytest.mark.parametrize("ground", ["winkler", "vlasov"])
    def test_rows_do_not_depend_on_their_order(self, tmp_path: Path, ground: str) -> None:
        """Variants solved in another order, or each by a new worker, give the same numbers to the last bit."""
        study, case = STUDY.replace("count = 12", "count = 5"), CASE
        if ground == "vlasov":  # with gamma to be found, and infinite ground
            case = case.replace('kind = "winkler"\nk = "20 MPa/m"', 'kind = "vlasov"\n[beyond]\nkind = "infinite"')
            case += '[[ground.layers]]\nE = "20 MPa"\nnu = 0.3\nthickness = "4 m"\n'
            study = study.replace("ground.k", "ground.layers[1].E").replace("20 MPa/m", "20 MPa")
        setup = read(tmp_path, study, case).setup
        sample = designs.list_variants(setup)
        worker = variant.Worker(setup)
        one = {number: worker.row(sample[number]) for number in (1, 2, 3, 4, 5)}
        for number in (5, 1, 3):
            for other in (worker.row(sample[number]), variant.Worker(setup).row(sample[number])):
                assert other.results == one[number].results
                assert np.array_equal(other.fields[0], one[number].fields[0])  # type: ignore[arg-type]

    @pytest.mark.slow
    def test_names_that_en_1990_makes(self, tmp_path: Path) -> None:
        """A combination whose name holds a factor that varies is found by its place among the others."""
        case = CASE.split("[[combinations]]")[0] + '[combine]\nsets = ["ultimate"]\n[mesh]\ncounts = [8, 6]\n'
        name = solved(case).combinations[0].name
        study = run(
            tmp_path,
            'case = "slab.toml"\n[sampling]\nkind = "list"\n[[vary]]\npath = "combine.permanent[1]"\n'
            f'values = [1.35, 1.2]\n[[keep]]\nname = "load"\nof = "load"\ncombination = "{name}"\n',
            case.replace('name = "live"', 'name = "live"\naction = "variable"'),
        )
        first, second = study.table()["load"]
        assert first - second == pytest.approx(0.15 * 24e3)

    def test_reinforcement_is_that_of_the_checks(self) -> None:
        """The largest area under a column is that which bars are checked against, of means and not of the peak."""
        column = '[[columns]]\nname = "C"\nx = "0 m"\ny = "0 m"\nwidth_x = "0.4 m"\nwidth_y = "0.4 m"\n'
        force = '[[loads]]\nkind = "point"\ncase = "dead"\ncolumn = "C"\nP = "600 kN"\n'
        steel = '[reinforcement]\nf_ck = "30 MPa"\nf_yk = "500 MPa"\nbottom = ["40 mm", "50 mm"]\n'
        case = CASE + column + force + steel + 'top = ["40 mm", "50 mm"]\n'
        keep = outputs.RequestedOutput(name="steel", of="reinforcement bottom x", take="largest")
        areas = {}
        for averaged, more in ((True, ""), (False, '[reinforcement.averaging]\nat_columns = "peak"\n')):
            combined = solved(case + more)
            areas[averaged] = outputs.scalar_of(keep, combined, ["design"])
            assert areas[averaged] == pytest.approx(bar_fields(combined)["required_bottom_x"].max(), rel=1e-12)
        averaged_area, peak = areas[True], areas[False]
        assert averaged_area is not None
        assert peak is not None
        assert averaged_area < 0.95 * peak

    @pytest.mark.slow
    def test_reinforcement_is_that_of_ultimate_combinations(self, tmp_path: Path) -> None:
        """Of all combinations the characteristic one, with the larger moments, is not designed for; nor may it be."""
        case = CASE.replace('name = "service"', 'name = "service"\nlimit_state = "characteristic"').replace(
            "factors = {dead = 1.0, live = 1.0}", "factors = {dead = 3.0, live = 3.0}"
        )
        case += '[reinforcement]\nf_ck = "30 MPa"\nf_yk = "500 MPa"\nbottom = ["40 mm", "50 mm"]\n'
        case += 'top = ["40 mm", "50 mm"]\n'
        keep = '[[keep]]\nname = "steel"\nof = "reinforcement bottom x"\ntake = "largest"\n'
        head = 'case = "slab.toml"\n[sampling]\nkind = "list"\n[[vary]]\npath = "plate.nu"\nvalues = [0.2]\n'
        (steel,) = run(tmp_path, head + keep, case).table()["steel"]
        field = outputs.field_of(solved(case)["design"], "reinforcement bottom x")
        assert steel == pytest.approx(field.max(), rel=1e-9)
        other = outputs.field_of(solved(case)["service"], "reinforcement bottom x")
        assert other.max() > 1.1 * field.max()
        for folder in ("other", "third"):
            (tmp_path / folder).mkdir()
        with pytest.raises(InputError, match=r'not for the ultimate limit state, expected "design"'):
            run(tmp_path / "other", head + keep + 'combination = "service"\n', case)
        # without an ultimate combination among those that are solved, nothing is designed
        load = '[[keep]]\nname = "load"\nof = "load"\ncombination = "service"\n'
        (found,) = run(tmp_path / "third", head + load, case).table()["load"]
        assert found == pytest.approx(3 * 224e3)


class TestFields:
    """Random fields of the ground."""

    FIELD = """
[[random_field]]
path = "ground.k"
name = "k over the plan"
distribution = {kind = "lognormal", mean = 1.0, cov = 0.3}
correlation_length = "2 m"
"""

    @pytest.mark.slow
    def test_rows_with_a_field(self, tmp_path: Path) -> None:
        """Variants with a field differ by its seed alone, which is in the row and reproduces it."""
        text = (
            'case = "slab.toml"\n[sampling]\nkind = "monte carlo"\ncount = 3\n'
            '[[keep]]\nof = "settlement"\ntake = "mean"\n[[keep]]\nof = "load"\n'
        )
        study = run(tmp_path, text + self.FIELD)
        table = study.table()
        assert len(set(table["k over the plan"])) == 3
        assert len(set(table["mean settlement"])) == 3
        assert table["load"].tolist() == pytest.approx([1.35 * 24e3 + 300e3] * 3)
        setup = study.setup
        again = variant.Worker(setup).row(designs.Variant(2, (), (int(table["k over the plan"][2]),)))
        assert again.results[0] == table["mean settlement"][2]

    @pytest.mark.slow
    def test_even_field_is_a_factor(self, tmp_path: Path) -> None:
        """A field that hardly varies is a factor on the constant: mean 2 halves the settlement of an even load."""
        field = self.FIELD.replace("mean = 1.0, cov = 0.3", "mean = 2.0, cov = 1e-9")
        case = CASE.replace("200 kPa", "0 kPa")
        text = 'case = "slab.toml"\n[sampling]\nkind = "monte carlo"\ncount = 1\n[[keep]]\nof = "settlement"\n'
        study = run(tmp_path, text + 'take = "largest"\ncombination = "service"\n' + field, case)
        assert study.table()["largest settlement under service"][1] == pytest.approx(2e3 / 40e6, rel=1e-6)

    @pytest.mark.slow
    @pytest.mark.parametrize("model", ["gaussian", "exponential", "matern32"])
    def test_correlation(self, model: str) -> None:
        """Over 1000 places and seeds the scores have mean 0, variance 1 and the formula's correlation along x and y.

        Places of one seed are so far apart that what is drawn there is independent.
        """
        field = Field("f", "ground.k", stats.norm(loc=1.0, scale=0.1), (4.0, 1.0), model)
        x, y = np.array([[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [0.0, 0.5], [0.0, 1.0], [8.0, 2.0]]).T
        far = 1e3 * np.arange(8)[:, None]
        drawn = np.vstack(
            [
                random_fields.scores(field, seed)((x + far).ravel(), (y + 0 * far).ravel()).reshape(8, 6)
                for seed in range(125)
            ]
        )
        r = np.hypot((x[:, None] - x) / 4, (y[:, None] - y) / 1)
        formulas = {
            "gaussian": np.exp(-(r**2)), "exponential": np.exp(-r),
            "matern32": (1 + np.sqrt(3) * r) * np.exp(-np.sqrt(3) * r),
        }  # fmt: skip
        # four standard errors of a covariance of normal numbers, at most sqrt(2 / 1000)
        assert drawn.mean(axis=0) == pytest.approx(np.zeros(6), abs=4 / np.sqrt(1000))
        assert np.cov(drawn.T) == pytest.approx(formulas[model], abs=4 * np.sqrt(2 / 1000))
        made = np.array([random_fields.factors(field, seed)(x, y) for seed in range(3)])
        assert made == pytest.approx(1 + 0.1 * drawn[: 3 * 8 : 8])

    @pytest.mark.parametrize("model", ["gaussian", "exponential", "matern32"])
    def test_correlation_of_the_library(self, model: str) -> None:
        """The library's own correlation is the formula's, so that the length means what the page says."""
        field = Field("f", "ground.k", stats.norm(), (3.0, 3.0), model)
        r = np.linspace(0, 3, 31)
        formulas = {
            "gaussian": np.exp(-(r**2)), "exponential": np.exp(-r),
            "matern32": (1 + np.sqrt(3) * r) * np.exp(-np.sqrt(3) * r),
        }  # fmt: skip
        assert random_fields.correlation_model(field).correlation(3 * r) == pytest.approx(formulas[model], abs=1e-12)

    def test_python_that_lacks_gstools(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """Without the library an error says what to install, before anything is solved."""
        monkeypatch.setitem(sys.modules, "gstools", None)
        with pytest.raises(InputError, match="groundslab\\[study\\]"):
            run(tmp_path, STUDY + self.FIELD)


class TestMaps:
    """Fields of all variants over the plan."""

    @pytest.mark.slow
    def test_mean_std_and_uplift(self, tmp_path: Path) -> None:
        """Maps are the moments of the fields that are kept, and the share of variants that lift there."""
        study = run(tmp_path)
        random_fields = np.array([values for _, values in study.fields("settlement")])
        assert random_fields.shape[0] == 12
        assert study.map("settlement", "mean").values == pytest.approx(random_fields.mean(axis=0))
        assert study.map("settlement", "std").values == pytest.approx(random_fields.std(axis=0, ddof=1))
        uplift = study.map("settlement", "probability of uplift").values
        assert uplift == pytest.approx((random_fields < 0).mean(axis=0))
        assert uplift.max() > 0.9
        assert uplift.min() == 0
        assert study.map("settlement", "mean").unit == "m"

    @pytest.mark.slow
    def test_other_meshes(self, tmp_path: Path) -> None:
        """Where what varies changes the mesh there is no map, and an error says why; the rows are there."""
        text = STUDY.replace('path = "loads[2].q"\nname = "machine"\ntimes = true\n', 'path = "mesh.counts"\n')
        text = text.replace('distribution = {kind = "normal", mean = 1.0, std = 0.2}', "values = [[8, 6], [6, 4]]")
        study = run(tmp_path, text)
        assert len(study) == 12
        with pytest.raises(InputError, match="2 meshes"):
            study.map("settlement", "mean")
        with pytest.raises(InputError, match="settlement everywhere under service"):
            study.map("gap", "mean")
        with pytest.raises(InputError, match="probability of uplift"):
            study.map("settlement", "median")


def test_case_may_be_a_model(tmp_path: Path) -> None:
    """A model takes the place of the case that the file names; the folder keeps it as a file that reads back."""
    model: Model = MODEL.replace(title="Another one")
    study = run(tmp_path, STUDY.replace("count = 12", "count = 1"), model=model)
    assert study.setup.model == model

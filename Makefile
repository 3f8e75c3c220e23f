# Every target does its own set-up: Python 3.11 or newer (with venv and pip) and make are all it takes.
PYTHON ?= python3
VENV   := .venv
OLDEST := .venv-oldest
# all but mcp, which asks for newer packages than groundslab itself
EXTRAS := app cholmod dxf exchange ifc mesh netgen study tables viz
TRIAL  := .venv-dist
BILL   := .venv-bill
SCRIPTS := $(if $(filter Windows_NT,$(OS)),Scripts,bin)
BIN    := $(VENV)/$(SCRIPTS)
JOBS   ?= 2
# versions of Python on which the wheel is tried; uv finds those of this machine, and fetches others
PYTHONS ?= 3.11 3.12 3.13 3.14
# cases that dist-pythons verifies, such as CASES="beam paper"; all if there are none
CASES  ?=
# where another solver can make a difference: what factorizes, uses factors again, and random slabs of several plates
SOLVING := tests/unit/solvers tests/unit/analysis/test_nested.py tests/unit/analysis/test_increments.py \
	tests/unit/analysis/tasks tests/properties/test_random_plates.py
# further options for pytest, such as OPTIONS="-k punching"
OPTIONS ?=
# cases of the verification manual that get pictures; all if none are named
PICTURES ?=
# options for the bench, such as BENCH=--resume
BENCH  ?=
# what is compiled, of tests most of all, is kept from one process to the next
unexport PYTHONDONTWRITEBYTECODE

PIP       := -m pip install --quiet --disable-pip-version-check
INSTALL   := $(BIN)/uv pip install --quiet --python $(VENV)
# a process takes neighboring tests, which share what their module has solved, and the others' when it has no more
PYTEST     = OMP_NUM_THREADS=1 $(BIN)/python -m pytest -n $(JOBS) --dist worksteal --durations 25 --record=out/$@.txt $(OPTIONS)
# Node.js of lock/node.txt, where the machine has none that is recent enough
WITH_NODE := PATH="$$PWD/$(BIN):$$PATH"
COMPILE   := $(BIN)/uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header --no-emit-index-url --no-annotate --no-strip-extras

.PHONY: demo verify verify-light docs test tests test-fast test-short test-slow test-random test-solvers test-oldest coverage lint types check lock pages pages-test dist dist-test dist-pythons licenses bench clean help

help:                   ## list the targets
	@sed -n 's/^\([a-z-]*\): .*## /\1\t/p' $(MAKEFILE_LIST)

$(VENV)/run.stamp: lock/uv.txt lock/run.txt lock/build.txt lock/node.txt pyproject.toml
	@$(PYTHON) -c 'import sys; v = sys.version_info; sys.exit(0 if v >= (3, 11) else "groundslab needs Python 3.11 or newer, found %d.%d; choose another with make PYTHON=python3.12, for instance" % v[:2])'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python $(PIP) --require-hashes -r lock/uv.txt
	$(INSTALL) --require-hashes -r lock/run.txt -r lock/build.txt
	@$(BIN)/python -c 'import hatch_build; raise SystemExit(not hatch_build.has_node())' || $(INSTALL) --require-hashes -r lock/node.txt
	$(WITH_NODE) $(INSTALL) --no-deps --no-build-isolation --editable .
	@touch $@

$(VENV)/dev.stamp: $(VENV)/run.stamp lock/dev.txt
	$(INSTALL) --require-hashes -r lock/dev.txt
	@touch $@

web/node_modules/.package-lock.json: web/package-lock.json | $(VENV)/run.stamp
	$(WITH_NODE); cd web && npm ci

demo: $(VENV)/run.stamp ## solve the paper's first example; picture, VTU and summary under out/table1
	$(BIN)/groundslab solve examples/table1.toml --out out/table1 --plot

lint: $(VENV)/dev.stamp web/node_modules/.package-lock.json ## ruff, the order of imports, and the linter of web/
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	$(WITH_NODE); cd web && npm run lint

types: $(VENV)/dev.stamp ## mypy, strict
	$(BIN)/mypy

test: lint types tests  ## lint, types and every test

# slow tests wait for servers, browsers and other processes
tests test-slow: JOBS := 3
tests: $(VENV)/dev.stamp pages ## every test, or those of OPTIONS
	$(PYTEST)

test-fast: $(VENV)/dev.stamp pages ## the tests that take a fraction of a second, most of all: in a minute
	$(PYTEST) --quick

test-short: $(VENV)/dev.stamp pages ## all tests but the slow ones
	$(PYTEST) -m "not slow"

test-slow: $(VENV)/dev.stamp pages ## the slow tests
	$(PYTEST) -m slow

test-random: export GROUNDSLAB_EXAMPLES := 15
test-random: $(VENV)/dev.stamp pages ## what is tried on random examples, on fifteen times as many: before a release
	$(PYTEST) tests/properties

coverage: $(VENV)/dev.stamp pages ## all tests but the slow ones, and how much of the code they run
	$(PYTEST) -m "not slow" --cov --cov-report=term

test-solvers: $(VENV)/dev.stamp pages ## some tests of what solves, with each solver that can take PARDISO's place
	$(PYTEST) -m "not slow" --solver cholmod $(SOLVING)
	$(PYTEST) -m "not slow" --solver superlu $(SOLVING)

test-oldest: $(VENV)/dev.stamp pages ## all tests but the slow ones with the oldest dependencies that pyproject.toml allows
	$(BIN)/uv venv --quiet --clear --python $(BIN)/python $(OLDEST)
	$(BIN)/uv pip install --quiet --python $(OLDEST) --resolution lowest-direct $(EXTRAS:%=--extra %) --group dev -r pyproject.toml
	PYTHONPATH=src OMP_NUM_THREADS=1 $(OLDEST)/$(SCRIPTS)/python -m pytest -n $(JOBS) -m "not slow" -W ignore::DeprecationWarning

pages: $(VENV)/run.stamp ## build the pages of report and workbench, if older than web/
	$(WITH_NODE) $(BIN)/python hatch_build.py

pages-test: pages web/node_modules/.package-lock.json ## test the code of the pages
	$(WITH_NODE); cd web && npm test

dist: pages             ## build sdist and wheel under dist/
	$(WITH_NODE) $(BIN)/python -m hatchling build --clean

dist-test: dist $(VENV)/dev.stamp ## check both, install each without the repository, and run it
	$(BIN)/twine check --strict dist/*
	$(BIN)/check-wheel-contents dist/*.whl
	$(PYTHON) -m venv --clear $(TRIAL)
	$(BIN)/uv pip install --quiet --python $(TRIAL) --require-hashes -r lock/run.txt -r lock/build.txt
	set -e; for file in dist/*; do \
	  $(TRIAL)/$(SCRIPTS)/python $(PIP) --force-reinstall --no-deps --no-build-isolation $$file; \
	  $(TRIAL)/$(SCRIPTS)/groundslab solve examples/table1.toml --quiet --out out/dist; \
	  $(TRIAL)/$(SCRIPTS)/groundslab report out/dist; \
	done

dist-pythons: dist $(VENV)/dev.stamp ## install the wheel alone on each version of Python, print its size, solve, report and verify
	set -e; for version in $(PYTHONS); do \
	  $(BIN)/uv venv --quiet --clear --python $$version $(TRIAL); \
	  $(BIN)/uv pip install --quiet --python $(TRIAL) dist/*.whl; \
	  echo "Python $$version: $$(du -sm $(TRIAL) | cut -f1) MB"; \
	  $(TRIAL)/$(SCRIPTS)/groundslab solve examples/table1.toml --quiet --out out/dist; \
	  $(TRIAL)/$(SCRIPTS)/groundslab report out/dist; \
	  $(TRIAL)/$(SCRIPTS)/groundslab verify $(CASES) > /dev/null; \
	done

licenses: dist $(VENV)/dev.stamp ## install the wheel with all extras, list the licenses, write a bill of materials (CycloneDX)
	$(BIN)/uv venv --quiet --clear --python $(BIN)/python $(BILL)
	$(BIN)/uv pip install --quiet --python $(BILL) --constraint lock/dev.txt "$$(echo dist/*.whl)[all]"
	$(BILL)/$(SCRIPTS)/python tools/licenses.py --write
	mkdir -p out
	$(BIN)/cyclonedx-py environment --output-reproducible --output-file out/groundslab.cdx.json $(BILL)

verify-light: $(VENV)/dev.stamp ## solve every case with a known answer and compare
	$(BIN)/groundslab verify

verify: verify-light    ## the same, and random slabs beside NGSolve
	$(BIN)/python tools/crosscheck/crosscheck.py

docs: $(VENV)/dev.stamp pages ## build the documentation site under out/docs; every warning is an error
	$(BIN)/python tools/verification_manual.py docs/verification $(PICTURES)
	$(WITH_NODE) $(BIN)/sphinx-build --quiet --fail-on-warning --keep-going --builder html docs out/docs

lock: $(VENV)/dev.stamp ## update the lock files from pyproject.toml
	$(COMPILE) pyproject.toml -o lock/run.txt
	$(COMPILE) pyproject.toml --all-extras --group dev --group docs -o lock/dev.txt
	$(COMPILE) pyproject.toml --extra mesh --extra app --extra dxf --extra ifc --extra tables --extra exchange --extra mcp --extra study --constraint lock/dev.txt -o lock/image.txt
	$(COMPILE) --group build --constraint lock/dev.txt -o lock/build.txt
	$(COMPILE) --group node -o lock/node.txt
	$(COMPILE) --group uv -o lock/uv.txt

bench: $(VENV)/dev.stamp pages ## time all sizes and the other programs, measure default answers and told errors, write docs/performance.md; takes hours
	$(PYTHON) bench/run.py $(BENCH)
	$(PYTHON) bench/time_to_accuracy.py
	bench/.env/own/bin/python bench/default_answer.py
	bench/.env/own/bin/python bench/told_errors.py
	bench/.env/own/bin/python bench/random_slabs.py --accuracy 5
	bench/.env/own/bin/python bench/random_slabs.py --accuracy 2
	$(BIN)/python bench/first_figures.py
	bench/.env/own/bin/python bench/report.py
	bench/.env/own/bin/python paper/reproduce/reproduce.py --stored --write

clean:                  ## remove what the targets made
	rm -rf $(VENV) $(OLDEST) $(TRIAL) $(BILL) dist web/node_modules out .coverage .mypy_cache .pytest_cache .ruff_cache .hypothesis .import_linter_cache bench/.env

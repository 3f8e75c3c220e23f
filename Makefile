# Every target does its own set-up: Python 3.11 or newer (with venv and pip) and make are all it takes.
PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
JOBS   ?= 2
# options for the bench, such as BENCH=--resume
BENCH  ?=

.PHONY: demo test lint types check lock pages pages-test bench clean help

help:                   ## list the targets
	@sed -n 's/^\([a-z]*\): .*## /\1\t/p' $(MAKEFILE_LIST)

$(VENV)/run.stamp: lock/run.txt pyproject.toml
	@$(PYTHON) -c 'import sys; v = sys.version_info; sys.exit(0 if v >= (3, 11) else "groundslab needs Python 3.11 or newer, got %d.%d; say make PYTHON=python3.12, for instance" % v[:2])'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r lock/run.txt
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --editable .
	@touch $@

$(VENV)/dev.stamp: $(VENV)/run.stamp lock/dev.txt
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r lock/dev.txt
	@touch $@

demo: $(VENV)/run.stamp ## solve the paper's first example; picture, VTU and summary under out/table1
	$(BIN)/groundslab solve examples/table1.toml --out out/table1 --plot

lint: $(VENV)/dev.stamp ## ruff
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

types: $(VENV)/dev.stamp ## mypy, strict
	$(BIN)/mypy

test: lint types        ## lint, types and every test
	OMP_NUM_THREADS=1 $(BIN)/pytest -n $(JOBS)

web/node_modules/.stamp: web/package-lock.json
	cd web && npm ci
	@touch $@

pages: web/node_modules/.stamp ## build the report's script and the workbench's page from web/
	cd web && npm run build

pages-test: pages       ## test them, and that what is built is what the repository holds
	cd web && npm test
	git diff --exit-code --stat -- src/groundslab/views/report/static src/groundslab/workbench/static

lock: $(VENV)/dev.stamp ## write the lock files anew from pyproject.toml
	$(BIN)/python -m pip install --quiet uv
	$(BIN)/uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header --no-emit-index-url --no-annotate pyproject.toml -o lock/run.txt
	$(BIN)/uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header --no-emit-index-url --no-annotate --group dev --all-extras pyproject.toml -o lock/dev.txt

bench:                  ## time all sizes and the other programs, one by one, and write docs/performance.md; hours
	$(PYTHON) bench/run.py $(BENCH)
	bench/.env/own/bin/python bench/report.py

clean:                  ## remove what the targets made
	rm -rf $(VENV) web/node_modules out .mypy_cache .pytest_cache .ruff_cache .hypothesis bench/.env

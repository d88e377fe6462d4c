# Everything here needs Python 3.11 or newer and make; `make` alone lists the targets.
# Another interpreter: make PYTHON=python3.12 <target>

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PIP_INSTALL := $(BIN)/python -m pip install --quiet --disable-pip-version-check

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.NOTPARALLEL:
.PHONY: help demo test slow lint bench numbers maps studies library pictures docs clean

help: ## list the targets
	@sed -n 's/^\([a-z]*\):.*## /  make \1	/p' $(MAKEFILE_LIST) | expand -t 14

demo: $(VENV)/.installed ## drive the paper's scenario; a table here, figures in demo/
	$(BIN)/swerve run paper --out demo

test: $(VENV)/.installed-dev $(VENV)/.browser ## run the tests, but for the slow ones
	$(BIN)/python -m pytest -n 2 -m "not slow"

slow: $(VENV)/.installed-dev ## run the tests that take longer than ten seconds each
	$(BIN)/python -m pytest -n 2 -m slow

lint: $(VENV)/.installed-dev ## check style, format, types and the layers' imports
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

bench: $(VENV)/.installed-dev ## time the controller's step, part by part, and its peers
	$(BIN)/python -m bench

numbers: $(VENV)/.installed ## measure the tables and figures that the documentation shows
	$(BIN)/swerve reproduce --out build/paper
	mkdir -p docs/measured
	cp build/paper/*.md build/paper/*.png docs/measured/
	$(BIN)/swerve compare paper wet stopped-car-town slower-lead pedestrian-running both-lanes-blocked ice-patch --out build/compare
	cp build/compare/comparison.md docs/measured/compare.md
	cp build/compare/paper.png docs/measured/compare-paper.png

maps: $(VENV)/.installed-dev ## make the maps that the documentation shows, for an hour or more; they go on where they were stopped
	for plant in planar multibody; do \
		$(BIN)/swerve map paper --controllers unified --plant $$plant --out build/envelope-$$plant && \
		cp build/envelope-$$plant/map.md docs/measured/envelope-$$plant.md && \
		cp build/envelope-$$plant/map.png docs/measured/envelope-$$plant.png || exit 1; \
	done
	$(BIN)/swerve map paper --plant planar --out build/map
	cp build/map/map.md build/map/map.png docs/measured/

studies: $(VENV)/.installed ## run random scenes and fuzzed measurements, for an hour or more, and put what they find into the documentation
	$(BIN)/swerve study random-scenes --workers $$(nproc) --out build/random-scenes
	$(BIN)/swerve study fuzz --out build/fuzz
	cp build/random-scenes/random_scenes.md build/fuzz/fuzz.md docs/measured/

library: $(VENV)/.installed ## write the documentation's page of the scenario library
	$(BIN)/python docs/hooks/library.py > docs/library.md

pictures: $(VENV)/.installed-dev $(VENV)/.browser ## photograph a run's report and the studio for the documentation
	rm -rf build/pictures
	for scenario in static-15.5 wet slower-lead paper; do $(BIN)/swerve run $$scenario --out build/pictures/$$scenario; done
	mkdir -p docs/measured
	$(BIN)/python docs/hooks/pictures.py build/pictures docs/measured

docs: $(VENV)/.installed-docs ## build the documentation into site/
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict

clean: ## remove what the other targets made, but for .venv
	rm -rf demo site build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis .import_linter_cache
	find src tests bench docs -name __pycache__ -type d -prune -exec rm -rf {} + 2>/dev/null || true

$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { \
		echo "swerve needs Python 3.11 or newer, and '$(PYTHON)' is $$($(PYTHON) --version 2>&1 | head -n 1)." >&2; \
		echo "Name one that is: make PYTHON=python3.11 $(MAKECMDGOALS)" >&2; \
		exit 1; }
	$(PYTHON) -m venv $(VENV)

# One stamp for each set of requirements: installed once, and again when pyproject.toml changes.
$(VENV)/.installed: pyproject.toml | $(BIN)/python
	@echo "Installing swerve into $(VENV)"
	$(PIP_INSTALL) --editable .
	@touch $@

$(VENV)/.installed-%: pyproject.toml | $(BIN)/python
	@echo "Installing swerve and its $* tools into $(VENV)"
	$(PIP_INSTALL) --editable '.[$*]'
	@touch $@

# A browser for the report's page: the machine's own, else Debian's, else Playwright's. Without one its tests are skipped.
$(VENV)/.browser: | $(VENV)/.installed-dev
	@if which chromium chromium-browser google-chrome | grep -q . || \
		{ [ "$$(id -u)" = 0 ] && which apt-get && apt-get update -qq && apt-get install -qq -y chromium; } || \
		$(BIN)/playwright install chromium; \
	then touch $@; else echo "No browser could be installed: the tests of the report in one are skipped" >&2; fi

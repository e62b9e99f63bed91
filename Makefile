# The verbs of the project; CI calls the same ones. `make help` lists them.
# Everything is installed inside the tree (.venv, node_modules); a file under .make/ says that a step is done.

SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
DONE := .make
RESULTS := $(DONE)/results

BOARD ?=
XPLANE ?=
PORT ?= 8000
ARGS ?=
MINUTES ?= 30

# Modules stay compiled, whatever this computer's habit is: the tests start the station some hundreds of times.
export PYTHONDONTWRITEBYTECODE :=

.PHONY: help setup images generate check test test-backend test-protocol test-firmware test-frontend e2e soak fuzz fuzz-interface mutate mutate-page run board wheel wheelhouse deb sdist container docs docs-archive release check-platforms check-workflows bench clean

help: ## list the verbs
	@awk -F':.*## ' '/^[a-z-]+:.*## / { printf "  make %-14s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

# ---- what has to be on the machine --------------------------------------------------------------

$(DONE)/tools: .ci/require
	@mkdir -p $(DONE)
	@PYTHON=$(PYTHON) bash .ci/require
	@touch $@

# ---- installing inside the tree ------------------------------------------------------------------

# One virtual environment: `run` puts the run-time packages into it, the tests add the tools.
$(DONE)/venv: backend/requirements.lock backend/pyproject.toml .ci/install $(DONE)/tools
	@echo "Installing the gateway's packages (once) ..."
	@test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	@bash .ci/install backend/requirements.lock
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e backend
	@touch $@

$(DONE)/venv-dev: backend/requirements-dev.lock $(DONE)/venv
	@echo "Installing the test tools (once) ..."
	@bash .ci/install backend/requirements-dev.lock
	@touch $@

$(DONE)/frontend: frontend/package-lock.json $(DONE)/tools
	@echo "Installing the page's packages (once) ..."
	@cd frontend && npm ci --no-audit --no-fund --loglevel=error
	@touch $@

$(DONE)/e2e: e2e/package-lock.json $(DONE)/tools
	@cd e2e && npm ci --no-audit --no-fund --loglevel=error
	@touch $@

# Not remembered while something is missing, so that it is looked for again. One after the other: Debian installs one
# thing at a time.
machine := $(DONE)/arm $(DONE)/clang $(DONE)/browser
$(machine): $(DONE)/%: .ci/% $(DONE)/tools
	@bash .ci/$*
	@if [ -z "$$(bash .ci/$* --lacking)" ]; then touch $@; fi
$(DONE)/clang: | $(DONE)/arm
$(DONE)/browser: $(DONE)/e2e | $(DONE)/clang

# Each waits for the network or for one processor: three at a time.
setup: $(DONE)/tools ## install everything that tests and development need
	@$(MAKE) --no-print-directory -j 3 $(DONE)/venv-dev $(DONE)/frontend $(machine)

# ---- building -------------------------------------------------------------------------------------

frontend_sources := $(shell find frontend/src frontend/public -type f 2>/dev/null) $(wildcard frontend/*.html frontend/*.ts frontend/*.json)

frontend/dist/index.html: $(frontend_sources) $(DONE)/frontend
	@echo "Building the page ..."
	@cd frontend && npm run --silent build
	@touch $@

board: $(DONE)/tools ## build the board's firmware for this machine
	@$(MAKE) --no-print-directory -C firmware board laws

# The board's program of another processor needs its compiler: on Debian, gcc-aarch64-linux-gnu.
PLATFORM ?= $(shell uname -m)
OUT ?= dist
wheel: $(DONE)/venv frontend/dist/index.html ## one file in dist/ that installs the whole station, without Node and without a compiler; PLATFORM=aarch64, or none: without a board's program
	@if [ $(PLATFORM) = "$$(uname -m)" ]; then $(MAKE) --no-print-directory -C firmware board-static laws; \
	elif [ $(PLATFORM) != none ]; then \
	  $(MAKE) --no-print-directory -C firmware board-static laws BUILD=build/$(PLATFORM) CC=$(PLATFORM)-linux-gnu-gcc; fi
	@$(BIN)/python .ci/wheel.py . $(OUT) $(PLATFORM)
	@ls $(OUT)/*.whl

# Those of Debian 12 and 13.
PYTHONS ?= 3.11 3.13
wheelhouse: wheel ## one archive in dist/ with all wheels, for a computer without internet; PLATFORM=aarch64, PYTHONS="3.12 3.14"
	@$(BIN)/python .ci/wheelhouse.py . $(OUT) $(PLATFORM) $(PYTHONS)
	@ls $(OUT)/*-wheels-$(PLATFORM).tar

deb: wheelhouse ## a package in dist/ for Debian 12 and 13, with the service; PLATFORM=aarch64
	@$(BIN)/python .ci/deb.py . $(OUT) $(PLATFORM) $(PYTHONS)

sdist: $(DONE)/venv frontend/dist/index.html ## a source archive in dist/ with the built page inside
	@$(BIN)/python .ci/wheel.py . $(OUT) sdist
	@ls $(OUT)/*.tar.gz

# ENGINE=podman where docker is not; its own format has no health check.
ENGINE ?= docker
IMAGE ?= epf-gcs
container: ## build the container's image for this processor; ENGINE=podman, IMAGE=name:tag
	$(ENGINE) build $(if $(filter podman,$(notdir $(ENGINE))),--format docker) --tag $(IMAGE) \
	  --build-arg VERSION="$$(sed -n 's/^version = "\(.*\)"$$/\1/p' backend/pyproject.toml)" \
	  --build-arg REVISION="$$(git rev-parse HEAD 2>/dev/null || echo unknown)" .

# ---- documents and releases --------------------------------------------------------------------------

$(DONE)/venv-publish: backend/requirements-publish.lock $(DONE)/venv-dev
	@bash .ci/install backend/requirements-publish.lock
	@touch $@

docs: $(DONE)/venv-publish ## the documents as a site in dist/docs that needs no network; fails on a broken link
	@$(BIN)/python docs/build.py . dist/docs

docs-archive: docs
	@mkdir -p $(OUT)
	@$(BIN)/python -c 'import shutil; shutil.make_archive("$(OUT)/epf-gcs-docs", "zip", "dist/docs")'

release: $(DONE)/venv-publish frontend/dist/index.html ## all files of a release in dist/release, with checksums and notes; TAG=v1.2.3 holds it against the version. Red where one is missing
	@$(BIN)/python .ci/release.py . dist/release $(TAG)

check-workflows: $(DONE)/venv-publish ## what the forge and the container engine read (workflows, updates, forms, compose files) against their schemas, and for what an attacker could use
	@$(BIN)/check-jsonschema --builtin-schema vendor.github-workflows .github/workflows/*.yml
	@$(BIN)/check-jsonschema --builtin-schema custom.github-workflows-require-timeout .github/workflows/*.yml
	@$(BIN)/check-jsonschema --builtin-schema vendor.dependabot .github/dependabot.yml
	@$(BIN)/check-jsonschema --builtin-schema vendor.github-issue-config .github/ISSUE_TEMPLATE/config.yml
	@$(BIN)/check-jsonschema --builtin-schema vendor.github-issue-forms .github/ISSUE_TEMPLATE/[!c]*.yml
	@for file in docker-compose*.yml; do sed 's/!override//' $$file | \
	  $(BIN)/check-jsonschema --builtin-schema vendor.compose-spec --default-filetype yaml - || exit 1; done
	@$(BIN)/zizmor --offline --quiet .github

images: $(DONE)/tools $(DONE)/arm ## build the board's firmware for its processors (STM32F405, and LM3S6965 in QEMU)
	@$(MAKE) --no-print-directory -C firmware images

generate: $(DONE)/venv-dev $(DONE)/frontend ## write every generated file again: from protocol/definition, the interface, the magnetic model
	cd protocol && ../$(BIN)/python -m generator
	$(BIN)/python firmware/tools/magnetic_model.py
	$(BIN)/python -m epf_gcs.web --print-openapi > $(DONE)/openapi.json
	cd frontend && npm run --silent generate -- ../$(DONE)/openapi.json

# ---- running --------------------------------------------------------------------------------------

run: $(DONE)/venv frontend/dist/index.html board $(if $(filter qemu%,$(BOARD)),images) ## fly the demonstration; BOARD=/dev/ttyUSB0 and XPLANE=host put real ones in its place, BOARD=qemu the processor's image
	@exec $(BIN)/epf-run --port $(PORT) $(if $(BOARD),--board "$(BOARD)") $(if $(XPLANE),--xplane "$(XPLANE)") $(ARGS)

# the firmware's own verbs, with the tools of the virtual environment
FIRMWARE = $(MAKE) --no-print-directory -C firmware RESULTS=$(abspath $(RESULTS)) CLANG=$$(bash .ci/clang --name) \
  CLANG_FORMAT=$(abspath $(BIN)/clang-format) CLANG_TIDY=$(abspath $(BIN)/clang-tidy) \
  CPPCHECK=$(abspath $(BIN)/cppcheck) GCOVR=$(abspath $(BIN)/gcovr) PYTHON=$(abspath $(BIN)/python)

# Percent of the gateway's lines and branches that its tests run: where it stands, raised when it grows, never lowered.
# The core is what decodes, commands, proves and flies.
COVERED := 94
COVERED_CORE := 97
CORE := */codec/*,*/xplane/*,*/vehicle/*,*/bus/*,*/flight/board/*,*/flight/hil/*

# ---- proving --------------------------------------------------------------------------------------

CHECKS := check-generated check-gateway check-types check-firmware check-page check-journeys

check: setup ## format, lint, types, import rules, generated files up to date
	@$(MAKE) --no-print-directory -j 2 --output-sync=target $(CHECKS)

.PHONY: $(CHECKS)

check-generated: $(DONE)/venv-dev $(DONE)/frontend
	cd protocol && ../$(BIN)/python -m generator --check
	$(BIN)/python firmware/tools/magnetic_model.py --check
	$(BIN)/python -m epf_gcs.web --print-openapi > $(DONE)/openapi.json
	cd frontend && npm run --silent generate:check -- ../$(DONE)/openapi.json
	$(BIN)/python .ci/one_version.py .
	$(BIN)/python .ci/licences.py .
	$(BIN)/python .ci/containers.py .
	$(BIN)/python docs/links.py .

check-gateway: $(DONE)/venv-dev
	$(BIN)/ruff format --check backend protocol .ci docs
	$(BIN)/ruff check backend protocol .ci docs
	cd backend && ../$(BIN)/lint-imports
	$(BIN)/python -m pip --disable-pip-version-check check

check-types: $(DONE)/venv-dev
	cd backend && ../$(BIN)/mypy

check-firmware: $(DONE)/venv-dev
	+$(FIRMWARE) format-check layers-check

check-page: $(DONE)/frontend
	cd frontend && npm run --silent check

check-journeys: $(DONE)/e2e
	cd e2e && npm run --silent check

check-platforms: $(DONE)/venv-dev ## types as macOS and Windows see them (half a minute)
	cd backend && ../$(BIN)/mypy --no-warn-unreachable --platform darwin --cache-dir .mypy_cache/darwin src
	cd backend && ../$(BIN)/mypy --no-warn-unreachable --platform win32 --cache-dir .mypy_cache/win32 src

# All that `make test` does, one after the other whatever -j says: each uses all of the machine.
PARTS := check build test-firmware test-frontend test-tools test-protocol test-backend e2e
MADE := $(firstword $(MAKEFILE_LIST))

test: fresh-results setup ## everything, from nothing; what failed or could not run on this machine is told at the end, which is red then
	@$(MAKE) --no-print-directory -f $(MADE) -j 1 $(PARTS:%=part-%)
	@python3 .ci/summary.py $(RESULTS)

.PHONY: $(PARTS) $(PARTS:%=part-%)
$(PARTS:%=part-%): part-%:
	@python3 .ci/timed.py $(RESULTS) $* $(MAKE) --no-print-directory -k -f $(MADE) $*

# What the tests fly and look at.
build: frontend/dist/index.html $(DONE)/arm
	@$(MAKE) --no-print-directory -C firmware -j 2 board board-asan flight-lib $(if $(shell bash .ci/arm --lacking),,images)

.PHONY: fresh-results
fresh-results:
	@rm -rf $(RESULTS) && mkdir -p $(RESULTS)

# Where this machine lacks what a part of the tests needs, the results say so.
PART = bash .ci/part $(abspath $(RESULTS))

test-tools: $(DONE)/venv-dev
	cd .ci/tests && ../../$(BIN)/pytest -q --junitxml=$(abspath $(RESULTS))/ci.xml

test-protocol: $(DONE)/venv-dev
	cd protocol && ../$(BIN)/pytest -q --junitxml=../$(RESULTS)/protocol.xml

FIRMWARE_TESTS := test-firmware-gcc test-firmware-clang test-firmware-images
.PHONY: $(FIRMWARE_TESTS)
test-firmware: $(FIRMWARE_TESTS)

test-firmware-gcc: $(DONE)/venv-dev
	$(FIRMWARE) -k -j 2 test coverage analyse-tidy analyse-misra

test-firmware-clang: $(DONE)/venv-dev $(DONE)/clang
	@$(PART) firmware clang $(FIRMWARE) -k -j 2 fuzz-test analyse-clang

test-firmware-images: $(DONE)/arm
	@$(PART) firmware arm $(MAKE) --no-print-directory -C firmware images size

# More workers than cores: half of the time they wait for lines, processes and clocks.
test-backend: $(DONE)/venv-dev $(DONE)/arm board frontend/dist/index.html
	$(MAKE) --no-print-directory -C firmware flight-lib
	cd backend && ../$(BIN)/pytest -q -n 4 --dist worksteal --junitxml=../$(RESULTS)/backend.xml --cov --cov-report=
	cd backend && ../$(BIN)/coverage report --format=total --fail-under=$(COVERED)
	cd backend && ../$(BIN)/coverage report --format=total --fail-under=$(COVERED_CORE) --include='$(CORE)'

test-frontend: $(DONE)/frontend
	cd frontend && npm run --silent test -- --coverage --reporter=default --reporter=junit --outputFile.junit=../$(RESULTS)/frontend.xml

e2e: $(DONE)/venv $(DONE)/browser board frontend/dist/index.html ## journeys in a real browser through the real gateway, board and simulator
	@$(PART) e2e browser env PLAYWRIGHT_JUNIT_OUTPUT_FILE=$(abspath $(RESULTS))/e2e.xml npm --prefix e2e run --silent test

soak: $(DONE)/venv $(DONE)/browser board frontend/dist/index.html ## a long flight at real time; MINUTES=30
	cd e2e && SOAK_MINUTES=$(MINUTES) npm run --silent soak

fuzz: $(DONE)/venv-dev $(DONE)/clang ## fuzz the board's code: RUNS=1000000 of each target, or FUZZ_MINUTES=10 of each
	$(FIRMWARE) -j 2 fuzz

fuzz-interface: $(DONE)/venv-dev ## ask every route as stranger, viewer, operator and owner with made-up requests: EXAMPLES=60 of each (minutes)
	cd backend && INTERFACE_EXAMPLES=$(or $(EXAMPLES),60) ../$(BIN)/pytest -n 0 -q tests/web/test_openapi.py

bench: $(DONE)/venv-dev $(DONE)/browser board frontend/dist/index.html ## the numbers of the design, each beside its peer in the same run
	$(MAKE) --no-print-directory -C firmware flight-lib
	cd backend && ../$(BIN)/python -m bench $(ARGS)

$(DONE)/venv-mutate: backend/requirements-mutate.lock $(DONE)/venv-dev
	@bash .ci/install backend/requirements-mutate.lock
	@touch $@

mutate: $(DONE)/venv-mutate ## change the gateway's code in small places and see whether its tests notice; ARGS="codec/frame.py --most 20"
	cd backend && ../$(BIN)/python -m mutation $(ARGS)

$(DONE)/mutation: frontend/mutation/package-lock.json $(DONE)/frontend
	@cd frontend/mutation && npm ci --no-audit --no-fund --loglevel=error
	@touch $@

mutate-page: $(DONE)/mutation ## the same for the page's lib, store and instruments; ARGS="src/lib/angles.ts" or ARGS="--share 0.1"
	cd frontend && node mutation/mutate.mjs $(ARGS)

clean: ## remove everything that was built or installed
	rm -rf $(VENV) $(DONE) frontend/node_modules frontend/mutation/node_modules frontend/mutation/build frontend/dist e2e/node_modules e2e/test-results e2e/playwright-report
	$(MAKE) --no-print-directory -C firmware clean

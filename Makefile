# The front door. `make` alone lists what there is.
#
#   BUILD=dir         build tree (default: build)
#   JOBS=n            parallel jobs (default: all cores)
#   CMAKE_FLAGS=...   more flags for CMake's configure step
#   NO_INSTALL=1      never install packages

BUILD       ?= build
SANITIZE    ?= build-sanitize
JOBS        ?= $(shell nproc 2>/dev/null || echo 2)
PREFIX      ?= /usr/local
DEMO_OUTPUT ?= demo-output

install_deps := $(if $(NO_INSTALL),:,scripts/install-deps.sh)
missing_packages := $(if $(NO_INSTALL),:,scripts/install-deps.sh --missing)
configure    := scripts/configure.sh

FUZZ_FIRST  ?= 1000
FUZZ_COUNT  ?= 10000
RUNS_FIRST  ?= 1
RUNS_COUNT  ?= 20

.PHONY: help demo pictures test fuzz test-runs build bench why-exact sanitize install format lint clean

help:
	@echo "make demo      build, run the three commands on a mesh of data/, name the files they wrote"
	@echo "make pictures  make the pictures of the documents again, with headless Chromium"
	@echo "make test      build and run every test"
	@echo "make fuzz      random soups and generators through everything: FUZZ_COUNT seeds ($(FUZZ_COUNT))"
	@echo "make test-runs thousands of diagrams on the corpus: RUNS_COUNT for each mesh ($(RUNS_COUNT))"
	@echo "make build     build the library and the three commands"
	@echo "make bench     time the steps of a diagram against a plain Dijkstra"
	@echo "make why-exact compare labels by Euclidean, edge and heat distances with the exact ones"
	@echo "make sanitize  run the tests under the address and undefined-behaviour sanitizers"
	@echo "make install   install library, headers and commands under PREFIX ($(PREFIX))"
	@echo "make format    lay out the sources with clang-format"
	@echo "make lint      check layout, names, includes, sizes, and what the documents link to and name"
	@echo "make clean     remove the build trees and the demo's output"

build:
	@$(install_deps) build
	@$(configure) release $(BUILD) -DGVD_BUILD_TESTS=OFF $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS)

demo:
	@scripts/demo.sh --announce $(BUILD) $(DEMO_OUTPUT) "$$($(missing_packages) build)"
	@$(MAKE) --no-print-directory build
	@scripts/demo.sh $(BUILD)/bin $(DEMO_OUTPUT)

# Commit the pictures only where something in them has changed: another version of the browser makes other bytes.
pictures: build
	@$(install_deps) pictures
	@scripts/make_pictures.sh $(BUILD)/bin $(BUILD)/pictures docs/pictures

test:
	@$(install_deps) build test
	@$(configure) release $(BUILD) -DGVD_BUILD_TESTS=ON $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS)
	@scripts/check_examples.sh $(BUILD)/bin
	@ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS)

# What is known to fail is left out without FUZZ_ALL=1.
fuzz:
	@$(install_deps) build test
	@$(configure) release $(BUILD) -DGVD_BUILD_TESTS=ON $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target test_fuzz
	@GVD_FUZZ_FIRST=$(FUZZ_FIRST) GVD_FUZZ_COUNT=$(FUZZ_COUNT) $(if $(FUZZ_ALL),GVD_FUZZ_ALL=1) \
	  $(BUILD)/bin/test_fuzz "[.by-hand]"

test-runs:
	@$(install_deps) build test
	@$(configure) release $(BUILD) -DGVD_BUILD_TESTS=ON $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target test_corpus
	@ctest --test-dir $(BUILD) -R "corpus: unpack" --output-on-failure
	@GVD_RUNS_FIRST=$(RUNS_FIRST) GVD_RUNS_COUNT=$(RUNS_COUNT) \
	  GVD_UNPACKED_CORPUS=$(BUILD)/tests/corpus/data/meshes $(BUILD)/bin/test_corpus "[.by-hand]"

bench:
	@$(install_deps) build
	@$(configure) release $(BUILD) -DGVD_BUILD_BENCH=ON -DGVD_BUILD_TESTS=OFF $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target gvd-bench
	@$(BUILD)/bin/gvd-bench $(BENCH_FLAGS)

why-exact:
	@$(install_deps) build
	@$(configure) release $(BUILD) -DGVD_BUILD_BENCH=ON -DGVD_BUILD_TESTS=OFF $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target gvd-why-exact
	@$(BUILD)/bin/gvd-why-exact $(WHY_FLAGS)

# Not here: tests labelled `slow`, and `install`, which builds against an installed library without sanitizers.
sanitize:
	@$(install_deps) build test
	@$(configure) sanitizers $(SANITIZE) $(CMAKE_FLAGS)
	@cmake --build $(SANITIZE) -j $(JOBS)
	@ctest --test-dir $(SANITIZE) --output-on-failure -j $(JOBS) -LE "slow|install"

install: build
	@cmake --install $(BUILD) --prefix $(PREFIX)

format:
	@$(install_deps) lint
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

lint:
	@$(install_deps) build test lint
	@scripts/check_layout.sh
	@scripts/check_links.py
	@scripts/check_names.py
	@scripts/check_includes.py
	@scripts/check_sizes.py
	@$(configure) development build-lint -DGVD_PRECOMPILE_HEADERS=OFF
	@run-clang-tidy -quiet -p build-lint -j $(JOBS) '$(CURDIR)/(libgvd|apps|tests|bench|data)/.*\.cpp'

clean:
	@rm -rf build build-* $(DEMO_OUTPUT)

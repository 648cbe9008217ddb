# The front door. `make` alone lists what there is.
#
#   BUILD=dir         build tree (default: build)
#   JOBS=n            parallel jobs (default: all cores)
#   CMAKE_FLAGS=...   more flags for CMake's configure step
#   NO_INSTALL=1      never install packages

BUILD       ?= build
SANITIZE    ?= build-sanitize
THREADS     ?= build-threads
JOBS        ?= $(shell nproc 2>/dev/null || echo 2)
# Tests of pages and pipes wait for much of their time.
TEST_JOBS   ?= $(shell expr $(JOBS) + 2)
PREFIX      ?= /usr/local
DEMO_OUTPUT ?= demo-output

install_deps := $(if $(NO_INSTALL),:,scripts/install-deps.sh)
missing_packages := $(if $(NO_INSTALL),:,scripts/install-deps.sh --missing)
configure    := scripts/configure.sh
# The Python package, unless its Debian packages are missing.
python_if_possible = -DGVD_BUILD_PYTHON=$$([ -z "$$(scripts/install-deps.sh --missing python)" ] && echo ON || echo OFF)

# For targets that build some programs only: a new tree has no tests, so that it needs no Catch2, and a tree of `make test` keeps
# them. `make build` and `make package` build whatever the tree has, so they switch tests off; `make test` goes on where it ended.
without_tests = $$(grep -qsx GVD_BUILD_TESTS:BOOL=ON $(BUILD)/CMakeCache.txt || echo -DGVD_BUILD_TESTS=OFF)

FUZZ        ?= build-fuzz
FUZZ_SECONDS ?= 60
SOUPS_FIRST ?= 1000
SOUPS_COUNT ?= 10000
BATTERY_SEEDS ?= 1:21
PAPER_RUNS  ?= 3
PAPER_MODELS ?= $(GVD_MODELS)
RUNS_FIRST  ?= 1
RUNS_COUNT  ?= 20

.PHONY: help demo python web playground site pictures figures test fuzz soups battery test-runs build count performance bench bench-lloyd bench-remesh why-exact paper sanitize sanitize-threads install package release-check format lint tidy clean

help:
	@echo "make demo      build, run the commands on a mesh of data/, name the files they wrote"
	@echo "make site      build the documents as a site in BUILD/site, and run their examples"
	@echo "make pictures  make the pictures of the documents again, with headless Chromium"
	@echo "make figures   measure the figures of the documents again, and write them"
	@echo "make test      build and run every test"
	@echo "make fuzz      damaged files for every reader: FUZZ_SECONDS for each ($(FUZZ_SECONDS))"
	@echo "make soups     random soups and generators through everything: SOUPS_COUNT seeds ($(SOUPS_COUNT))"
	@echo "make battery   hostile meshes through the commands: BATTERY_SEEDS ($(BATTERY_SEEDS)), BATTERY_CORPUS=FOLDER"
	@echo "make test-runs thousands of diagrams on the corpus: RUNS_COUNT for each mesh ($(RUNS_COUNT))"
	@echo "make build     build the library and the commands"
	@echo "make python    build the Python package in BUILD/python; 'pip install .' installs it"
	@echo "make web       build the page that computes and the npm package in BUILD/web, with emscripten"
	@echo "make playground  make web, and put its page into docs/playground.html, as for a release"
	@echo "make count     count instructions of the commands, compared with bench/instructions.tsv: COUNT_FLAGS"
	@echo "make performance  measure the tables of docs/developer/performance.md again, and write them"
	@echo "make bench     time the steps of a diagram against a plain Dijkstra"
	@echo "make bench-lloyd  time relaxations and measure their energies, beside the goals: LLOYD_BENCH_FLAGS"
	@echo "make bench-remesh  measure remeshes, beside the figures of other programs: REMESH_BENCH_FLAGS"
	@echo "make why-exact compare labels by Euclidean, edge and heat distances with the exact ones"
	@echo "make paper     measure section 5 of the paper: PAPER_RUNS runs ($(PAPER_RUNS)), on the meshes of the folders PAPER_MODELS"
	@echo "make sanitize  run the tests under the address and undefined-behaviour sanitizers"
	@echo "make sanitize-threads  run the tests of threads under the thread sanitizer"
	@echo "make install   install library, headers and commands under PREFIX ($(PREFIX))"
	@echo "make package   make Debian packages of libraries, commands and the Python package in $(BUILD)/packages"
	@echo "make format    lay out the sources with clang-format"
	@echo "make lint      check layout, names, includes, long files, and what the documents link to and name"
	@echo "make tidy      run clang-tidy on all sources: TIDY_FLAGS='--last 30' for those of the last thirty commits"
	@echo "make release-check  check the packages in bare roots, and every command of README and guide in one of its own"
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

# PYTHONPATH=BUILD/python then finds the package.
python:
	@$(install_deps) build python
	@$(configure) release $(BUILD) -DGVD_BUILD_PYTHON=ON $(without_tests) $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target gvd_python

# BUILD/web/index.html is one file that works from a disk; beside it is the npm package.
web:
	@echo "make web: compiles libgvd for WebAssembly, which takes 2 to 4 minutes the first time, then packs the page and the npm package"
	@$(install_deps) web
	@$(configure) web $(BUILD)/web/module $(CMAKE_FLAGS)
	@cmake --build $(BUILD)/web/module -j $(JOBS)
	@echo "Packing the page and the npm package. The first time, npm fetches three.js and esbuild"
	@web/make_web.sh $(BUILD)/web/module $(BUILD)/web
	@echo "$(BUILD)/web/index.html"

# At a release: the page of the checkout, which README opens.
playground: web
	@cp $(BUILD)/web/index.html docs/playground.html

# Builds without the network, once the packages are there. GVD_SOURCE_URL: see mkdocs.yml.
site: build python
	@$(install_deps) site
	@scripts/check_examples.py $(BUILD)/bin
	@mkdocs build --strict --quiet --site-dir $(abspath $(BUILD))/site
	@echo "$(BUILD)/site/index.html"

# Some figures need models that are not in data/: see scripts/figures.py.
figures:
	@$(install_deps) build scripts
	@$(configure) release $(BUILD) -DGVD_BUILD_BENCH=ON $(without_tests) $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target gvd-segment gvd-lloyd gvd-remesh gvd-bench gvd-why-exact
	@scripts/figures.py write $(BUILD)/bin

test:
	@$(install_deps) build test python
	@$(configure) release $(BUILD) -DGVD_BUILD_TESTS=ON $(python_if_possible) $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS)
	@scripts/check_examples.py $(BUILD)/bin
	@ctest --test-dir $(BUILD) --output-on-failure -j $(TEST_JOBS)

# libFuzzer, FUZZ_TARGETS of it (off obj ply stl vtp vtu vtk glb gltf gii mni fs values generators config) or all. The next run goes on where this one ends.
fuzz:
	@$(install_deps) build fuzz
	@$(configure) sanitizers $(FUZZ) -DCMAKE_CXX_COMPILER=clang++ -DGVD_BUILD_FUZZERS=ON -DGVD_BUILD_TESTS=OFF $(CMAKE_FLAGS)
	@cmake --build $(FUZZ) -j $(JOBS) --target gvd_fuzzers
	@JOBS=$(JOBS) tests/fuzz/targets/run $(FUZZ)/bin $(FUZZ)/fuzz $(FUZZ_SECONDS) $(FUZZ_TARGETS)

# Findings are left in BUILD/battery/findings.
battery: build
	@$(install_deps) scripts
	@tests/battery/battery.py $(BUILD)/bin $(BUILD)/battery --seeds $(BATTERY_SEEDS) --jobs $(JOBS) \
	  $(if $(BATTERY_CORPUS),--corpus $(BATTERY_CORPUS))

# What is known to fail is left out without SOUPS_ALL=1.
soups:
	@$(install_deps) build test
	@$(configure) release $(BUILD) -DGVD_BUILD_TESTS=ON $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target test_fuzz
	@GVD_FUZZ_FIRST=$(SOUPS_FIRST) GVD_FUZZ_COUNT=$(SOUPS_COUNT) $(if $(SOUPS_ALL),GVD_FUZZ_ALL=1) \
	  $(BUILD)/bin/test_fuzz "[.by-hand]"

test-runs:
	@$(install_deps) build test
	@$(configure) release $(BUILD) -DGVD_BUILD_TESTS=ON $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target test_corpus
	@ctest --test-dir $(BUILD) -R "corpus: unpack" --output-on-failure
	@GVD_RUNS_FIRST=$(RUNS_FIRST) GVD_RUNS_COUNT=$(RUNS_COUNT) \
	  GVD_UNPACKED_CORPUS=$(BUILD)/tests/corpus/data/meshes $(BUILD)/bin/test_corpus "[.by-hand]"

# COUNT_FLAGS='--write "REASON"' writes the figures that have changed. 77: those of another compiler or system, so nothing is compared.
count:
	@$(install_deps) build bench
	@$(configure) release $(BUILD) -DGVD_BUILD_BENCH=ON $(without_tests) $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target gvd-segment gvd-lloyd gvd-remesh gvd-bench
	@scripts/count_instructions.py $(BUILD)/bin $(COUNT_FLAGS) || [ $$? -eq 77 ]

# Meshes that are not in data/ are found as scripts/figures.py tells.
performance:
	@$(install_deps) build scripts
	@$(configure) release $(BUILD) -DGVD_BUILD_BENCH=ON $(without_tests) $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target gvd-segment gvd-bench
	@scripts/make_performance.py $(BUILD)/bin

bench:
	@$(install_deps) build
	@$(configure) release $(BUILD) -DGVD_BUILD_BENCH=ON $(without_tests) $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target gvd-bench
	@$(BUILD)/bin/gvd-bench $(BENCH_FLAGS)

bench-lloyd:
	@$(install_deps) build
	@$(configure) release $(BUILD) -DGVD_BUILD_BENCH=ON $(without_tests) $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target gvd-bench-lloyd
	@$(BUILD)/bin/gvd-bench-lloyd $(LLOYD_BENCH_FLAGS)

bench-remesh:
	@$(install_deps) build
	@$(configure) release $(BUILD) -DGVD_BUILD_BENCH=ON $(without_tests) $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target gvd-bench-remesh
	@$(BUILD)/bin/gvd-bench-remesh $(REMESH_BENCH_FLAGS)

why-exact:
	@$(install_deps) build
	@$(configure) release $(BUILD) -DGVD_BUILD_BENCH=ON $(without_tests) $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target gvd-why-exact
	@$(BUILD)/bin/gvd-why-exact $(WHY_FLAGS)

# Models that PAPER_MODELS has not are replaced by data/figure.obj.
paper:
	@$(install_deps) build scripts
	@$(configure) release $(BUILD) -DGVD_BUILD_BENCH=ON $(without_tests) $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS) --target gvd-paper gvd-segment gvd-compare
	@mkdir -p $(BUILD)/paper
	@$(BUILD)/bin/gvd-paper --runs $(PAPER_RUNS) $(addprefix --models=,$(PAPER_MODELS)) -o $(BUILD)/paper/paper.json
	@scripts/make_gallery.sh $(BUILD)/bin $(BUILD)/paper $(PAPER_MODELS)
	@scripts/make_paper.py $(BUILD)/paper/paper.json $(BUILD)/paper $(if $(PAPER_NOTE),"$(PAPER_NOTE)")

# Not here: tests labelled `slow`; `install`, which builds against an installed library without sanitizers; `browser`, which tests a
# page; `formats`, which tests what other programs read; and those that tests/CMakeLists.txt leaves out.
sanitize:
	@$(install_deps) build test
	@$(configure) sanitizers $(SANITIZE) $(CMAKE_FLAGS)
	@cmake --build $(SANITIZE) -j $(JOBS)
	@ctest --test-dir $(SANITIZE) --output-on-failure -j $(JOBS) -LE "slow|install|browser|formats"

# The tests of threads only: everything else works in one thread.
sanitize-threads:
	@$(install_deps) build test fuzz
	@$(configure) sanitizers $(THREADS) -DCMAKE_CXX_COMPILER=clang++ -DGVD_SANITIZE=thread -DGVD_BUILD_APPS=OFF \
	  -DGVD_WITH_CGAL_GPL=OFF -DGVD_WITH_VIEWER=OFF $(CMAKE_FLAGS)
	@cmake --build $(THREADS) -j $(JOBS) --target test_threads
	@ctest --test-dir $(THREADS) --output-on-failure -j $(JOBS) --timeout 300 -L "^threads$$"

install: build
	@cmake --install $(BUILD) --prefix $(PREFIX)

# The same sources give the same packages: files are dated by the last commit. `scripts/install-deps.sh python` first, for python3-gvd.
package:
	@$(install_deps) build package
	@$(configure) release $(BUILD) -DGVD_BUILD_TESTS=OFF -DCMAKE_INSTALL_LIBDIR=lib/$$(dpkg-architecture -qDEB_HOST_MULTIARCH) \
	  $(python_if_possible) $(CMAKE_FLAGS)
	@cmake --build $(BUILD) -j $(JOBS)
	@rm -rf $(BUILD)/packages
	@SOURCE_DATE_EPOCH=$$(git log -1 --format=%ct || date +%s) cpack --config $(BUILD)/CPackConfig.cmake
	@ls $(BUILD)/packages/*.deb

# Hours; needs network, and root or sudo. RELEASE_FLAGS='--keep packages python': some checks only, and their roots are kept; --ccache
# shares what the checks compile.
release-check:
	@$(install_deps) release
	@scripts/release_check.sh $(BUILD)/release $(RELEASE_FLAGS)

format:
	@$(install_deps) lint
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

lint:
	@$(install_deps) build test lint
	@scripts/check_layout.sh
	@scripts/check_links.py
	@scripts/check_names.py
	@scripts/check_api_page.py
	@scripts/check_questions.py
	@scripts/check_commands.py
	@scripts/check_type_names.py
	@scripts/check_includes.py
	@scripts/check_long_files.py

# All sources, which takes half an hour on two cores; TIDY_FLAGS='--last 30': those that the last thirty commits changed.
tidy:
	@$(install_deps) build test lint
	@JOBS=$(JOBS) scripts/run_tidy.sh $(TIDY_FLAGS)

clean:
	@rm -rf build build-* $(DEMO_OUTPUT)

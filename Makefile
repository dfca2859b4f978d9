# The front door: on a bare Debian 12 with git and make, each of these does everything it needs.
#   make demo    render the demo pictures into demo/ and say where to look
#   make test    build and run every test
#   make build   the program, at build/release/bin/burnish
#   make view    the program and its window, build/release/bin/burnish-view
#   make check   format, shell scripts, links of the pages, map of the layers
#   make bench   budgets and what was reached, into bench/results/
#   make dev     build with assertions; LAYER=capture runs the tests of one folder
#   make tidy    clang-tidy over what changed since main; ALL=1 over everything
#   make asan    the tests under address and undefined-behaviour sanitizers
#   make docs    the documentation as a site, build/site/index.html
#   make tsan    the parallel parts under the thread sanitizer
#   make format  clang-format over the tree
#   make clean   remove what was built

PRESET ?= release
BUILD := build/$(PRESET)
JOBS ?= $(shell nproc)
BURNISH := $(BUILD)/bin/burnish
CONFIGURE = [ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET)

.PHONY: demo test build view all dev bench check tidy asan tsan docs format clean packages packages_view packages_check

build: packages
	@$(CONFIGURE)
	cmake --build $(BUILD) -j $(JOBS) --target burnish_cli

# CMake looks for the window's packages when it configures.
view: packages packages_view
	cmake --preset $(PRESET)
	cmake --build $(BUILD) -j $(JOBS) --target burnish_cli burnish_view

all: packages packages_view
	cmake --preset $(PRESET)
	cmake --build $(BUILD) -j $(JOBS)

packages:
	@scripts/install_packages.sh packages.txt

packages_view:
	@scripts/install_packages.sh packages_view.txt

packages_check:
	@scripts/install_packages.sh packages_check.txt

demo: build
	scripts/demo.sh $(BURNISH) demo

test: all
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS)

# The tests of one folder of tests/, or of all of them: make dev LAYER=capture.
dev:
	$(MAKE) all PRESET=dev
	ctest --test-dir build/dev --output-on-failure -j $(JOBS) $(if $(LAYER),-L '^$(LAYER)$$')

bench: all
	scripts/bench.sh $(BUILD)

# The generated references are compared by `make test`: they need every program.
check: packages packages_view packages_check
	scripts/check.sh
	@$(CONFIGURE)
	cmake --build $(BUILD) -j $(JOBS) --target burnish_check_tests
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -R '^(Layers|Pages)\.'

tidy: packages packages_check
	scripts/tidy.sh $(if $(ALL),all)

# Without the search for leaks: Mesa leaves a few blocks behind when its driver is unloaded, which
# no suppression can name by then (docs/develop/testing.md).
asan:
	ASAN_OPTIONS=detect_leaks=0 $(MAKE) test PRESET=asan

docs:
	@scripts/install_packages.sh packages_docs.txt
	scripts/docs.sh

tsan: packages
	scripts/tsan.sh

format: packages_check
	git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 -i

clean:
	rm -rf build demo

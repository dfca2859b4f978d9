# The front door: on a bare Debian 12 with git and make, each of these does everything it needs.
#   make demo    render the demo pictures into demo/ and say where to look
#   make test    build and run every test
#   make build   the program, at build/release/bin/burnish
#   make bench   budgets and what was reached, into bench/results/
#   make asan    the tests under address and undefined-behaviour sanitizers
#   make docs    the documentation as a site, build/site/index.html
#   make format  clang-format over the tree
#   make clean   remove what was built

PRESET ?= release
BUILD := build/$(PRESET)
JOBS ?= $(shell nproc)
BURNISH := $(BUILD)/bin/burnish

.PHONY: demo test build bench asan docs format clean packages

build: packages
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET)
	cmake --build $(BUILD) -j $(JOBS)

packages:
	@scripts/install_packages.sh

demo: packages
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET)
	cmake --build $(BUILD) -j $(JOBS) --target burnish_cli
	scripts/demo.sh $(BURNISH) demo

test: build
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS)

bench: build
	scripts/bench.sh $(BUILD)

# Without the search for leaks: Mesa leaves a few blocks behind when its driver is unloaded, which
# no suppression can name by then (docs/develop/testing.md).
asan:
	ASAN_OPTIONS=detect_leaks=0 $(MAKE) test PRESET=asan

docs:
	@scripts/install_packages.sh packages_docs.txt
	scripts/docs.sh

format:
	@command -v clang-format >/dev/null || { echo "burnish: clang-format is not installed"; exit 1; }
	git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

clean:
	rm -rf build demo

// scratch.json: the recipe beside a set of scratch maps.
#include "harness.hpp"
#include "jobs/maps/scratch.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto path = burnish::fuzz::put("scratch.json", burnish::fuzz::Bytes(data, size));
    burnish::fuzz::expect_answer([&] { burnish::load_scratch_recipe(path); });
    return 0;
}

// Tabulated materials: what is read must be what the header promises.
#include <cmath>

#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "harness.hpp"

namespace {

using burnish::TabulatedMaterial;
using burnish::fuzz::broken;

void check(const TabulatedMaterial& m) {
    const auto tables = static_cast<std::size_t>(m.exemplars);
    if (m.D.size() != tables * static_cast<std::size_t>(m.grid.cells())) broken("a table");
    if (m.origin.size() != m.D.size() || m.groove.size() != tables) broken("an exemplar");
    if (m.exemplar.size() != m.texels() || m.angle.size() != m.texels()) broken("texels");
    if (m.normal.pixels.size() != 3 * m.texels()) broken("normals");
    for (const float D : m.D)
        if (!(D >= 0 && std::isfinite(D))) broken("a distribution");
    for (const std::uint16_t index : m.exemplar)
        if (index != TabulatedMaterial::kNoExemplar && index >= m.exemplars) broken("an index");
    if (!(burnish::ndf_areas(m.grid, m.table(0), {4, 4})[0] < 2)) broken("an area");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto path = burnish::fuzz::put("material.exr", burnish::fuzz::Bytes(data, size));
    burnish::fuzz::expect_answer([&] {
        static_cast<void>(burnish::is_tabulated_material(path));
        check(burnish::read_tabulated_material(path));
    });
    return 0;
}

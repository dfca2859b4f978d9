#include "burnish/load_tabulated.hpp"

#include "burnish/error.hpp"
#include "burnish/rgl_material.hpp"
#include "burnish/tabulated_file.hpp"
#include "formats/bsdf/tensor_file.hpp"

namespace burnish {

std::shared_ptr<const TabulatedMaterial> load_tabulated(const std::filesystem::path& path) {
    if (is_tensor_file(path))
        return std::make_shared<const TabulatedMaterial>(tabulated_from_bsdf(path));
    if (is_tabulated_material(path))
        return std::make_shared<const TabulatedMaterial>(read_tabulated_material(path));
    throw Error(path.string(), "",
                "a tabulated material (of burnish capture fit) or an RGL .bsdf file",
                "another file");
}

}  // namespace burnish

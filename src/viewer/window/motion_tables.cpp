#include "viewer/window/motion_tables.hpp"

#include <algorithm>
#include <chrono>

#include "gpu/device/albedo_tables.hpp"
#include "models/albedo_table.hpp"

namespace burnish::viewer {

bool MotionTables::ready(gpu::Context& context, const std::vector<std::pair<Brdf, Mdf>>& models) {
    if (work_.valid() && work_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const std::vector<float> table = work_.get();
        if (!context.albedos().has(computed_.first, computed_.second))
            context.albedos().put(computed_.first, computed_.second, table);
    }
    for (const std::pair<Brdf, Mdf>& model : models) {
        if (context.albedos().has(model.first, model.second)) continue;
        if (!work_.valid()) {
            computed_ = model;
            work_ = std::async(std::launch::async,
                               [model] { return albedo_table(model.first, model.second); });
        }
        return false;
    }
    return true;
}

std::vector<std::pair<Brdf, Mdf>> models_with_tables(const Scene& scene) {
    std::vector<std::pair<Brdf, Mdf>> models;
    for (const Material& material : scene.materials) {
        const std::pair model{material.brdf, material.mdf};
        if (tabulated_of(material) == nullptr && has_half_vectors(material.brdf) &&
            std::ranges::find(models, model) == models.end())
            models.push_back(model);
    }
    return models;
}

}  // namespace burnish::viewer

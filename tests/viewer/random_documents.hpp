// Documents of any kind, for properties that hold for all of them.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "burnish/error.hpp"
#include "stage/value_samples.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/viewer_support.hpp"

namespace burnish::test {

class RandomDocuments {
  public:
    explicit RandomDocuments(unsigned seed) : random_(seed) {
        inputs_ = {"builtin:plane", "builtin:sphere", two_materials(folder_, "two.glb").string(),
                   two_materials(folder_, "lit.glb", true, true).string()};
        folder_.write("scene.json", R"({"format": "burnish-scene", "version": 1,
            "objects": [
              {"model": "two.glb", "material": {"brass": "worn", "#1": "cloth"}, "hidden": [1]},
              {"model": "two.glb", "material": "worn", "translate": [0.1, 0.7, -3], "scale": [1, 2, 0.3],
               "rotate_deg": [10, -25.5, 33]},
              {"model": "two.glb", "translate": [0, 3, 0]},
              {"model": "lit.glb", "material": {"*": "bare"}, "rotate_deg": [0, 40, 0]},
              {"model": "builtin:plane", "material": "worn"}],
            "materials": {"worn": {"alpha_x": 0.21, "base_color": "#604020"},
                          "cloth": {"weave": "plain", "weave_gap": 0.2}, "bare": {}},
            "lights": [{"type": "point", "position": [1, 2, 3], "intensity": 3}],
            "environment": "builtin:white",
            "parameters": {"exposure": 0.7, "anisotropy_rotation": 12, "width": 640}})");
        inputs_.push_back((folder_ / "scene.json").string());
    }

    // A document that can be drawn.
    viewer::Document next() {
        for (;;) {
            viewer::Document document = any();
            try {
                viewer::load_stage(document);
                return document;
            } catch (const UsageError&) {  // values that contradict each other
                ++refused;
            } catch (const Error&) {  // contradict those of the scene file
                ++refused;
            }
        }
    }

    viewer::Document any() {
        viewer::Document document;
        document.input = inputs_[random_() % inputs_.size()];
        constexpr const char* kEnvironments[] = {"", "none", "builtin:white", "builtin:black"};
        document.environment = kEnvironments[random_() % 4];
        if (document.environment.empty() && !document.input.ends_with(".json"))
            document.environment = "none";  // the studio takes long to make
        document.values = values(8, true);
        for (int material = 0; material < 2; ++material)
            if (random_() % 2 == 0 && document.input.find("two") != std::string::npos)
                document.material_values[material] = values(12, false);
        if (random_() % 2 == 0) document.lights = lights();
        if (document.lights)
            for (std::size_t i = 0; i < document.lights->size(); ++i)
                if (random_() % 4 == 0) document.dark.insert(static_cast<int>(i));
        if (random_() % 2 == 0) {
            const glm::vec3 target = 0.3f * any_direction(random_);
            viewer::set_camera(document, target + 4.0f * any_direction(random_), target, 37.7);
        }
        for (int i = 0; i < 3; ++i)
            if (document.input.find("builtin") == std::string::npos && random_() % 3 == 0)
                document.hidden.insert(i);
        if (random_() % 3 == 0) {
            document.bookmarks.push_back({"\"front\" \xc3\xa9", any_direction(random_), {}, 33.3});
            document.compare = {viewer::CompareMode::split,
                                {Method::none, Method::follow_grain, Method::normal_map},
                                {0.1, 0.73},
                                2.5};
        }
        return document;
    }

    std::mt19937& random() { return random_; }
    const ScratchFolder& folder() const { return folder_; }
    int refused = 0;

  private:
    // One parameter of `one_of`; `all_groups`: not of materials alone.
    ParameterValues values(unsigned one_of, bool all_groups) {
        ParameterValues out;
        for (const Parameter& p : parameter_table()) {
            if (random_() % one_of != 0 || p.name == "camera_index") continue;
            if (p.group != ParameterGroup::material && !all_groups) continue;
            if (p.name == "width" || p.name == "height" || p.group == ParameterGroup::mesh) {
                out.set_value(p.name, static_cast<int>(50 + random_() % 700));
                continue;
            }
            if (p.kind == ParameterKind::integer) {
                const int value = static_cast<int>(1 + random_() % 40);
                out.set_value(p.name, std::clamp(value, static_cast<int>(p.low),
                                                 static_cast<int>(std::min(p.high, 1e6))));
                continue;
            }
            out.merge(samples_.values(p, static_cast<int>(random_() % 2)));
            if (p.kind == ParameterKind::real)
                out.set_value(p.name, p.low + (std::min(p.high, 10.0) - p.low) *
                                                  std::uniform_real_distribution<>()(random_));
        }
        return out;
    }

    std::vector<Light> lights() {
        std::vector<Light> all;
        std::uniform_real_distribution<float> part;
        for (auto i = random_() % 4; i > 0; --i) {
            Light light;
            light.type = static_cast<LightType>(random_() % 6);
            light.color = {part(random_), part(random_), random_() % 2 == 0 ? 1.0f : 0.5f};
            light.intensity = 100.0f * part(random_);
            if (light.type != LightType::directional) {
                light.position = 7.0f * any_direction(random_);
                if (!has_area(light))
                    light.range = random_() % 2 == 0 ? 0.0f : 12.0f * part(random_);
            }
            if (light.type != LightType::point) light.direction = any_direction(random_);
            if (light.type == LightType::spot) {
                light.outer_cone = random_() % 4 == 0 ? 1.57079637f : 1.5f * part(random_);
                light.inner_cone = light.outer_cone * part(random_);
            }
            if (has_area(light)) {
                light.size = {0.01f + part(random_), 0.01f + part(random_)};
                light.visible = random_() % 2 == 0;
            }
            if (light.type == LightType::rectangle || light.type == LightType::disc) {
                light.up = glm::normalize(glm::cross(light.direction, any_direction(random_)));
                light.two_sided = random_() % 2 == 0;
            }
            all.push_back(light);
        }
        return all;
    }

    ScratchFolder folder_;
    ValueSamples samples_;
    std::vector<std::string> inputs_;
    std::mt19937 random_;
};

}  // namespace burnish::test

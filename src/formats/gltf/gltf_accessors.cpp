#include "formats/gltf/gltf_accessors.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace burnish {
namespace {

// Equally spaced elements inside a view; the range is checked before construction.
struct Elements {
    const std::byte* data = nullptr;
    std::size_t stride = 0;
};

std::size_t component_size(int type, const GltfReport& report, std::string_view key) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            report.fail(fmt::format("{}.componentType", key),
                        "5120, 5121, 5122, 5123, 5125 or 5126", fmt::format("{}", type));
    }
}

Elements elements_in(std::span<const std::byte> view, std::size_t offset, std::size_t stride,
                     std::size_t element, std::size_t count, std::string_view key,
                     const GltfReport& report) {
    if (stride == 0) stride = element;
    const bool fits = count == 0 || (offset <= view.size() && element <= view.size() - offset &&
                                     count - 1 <= (view.size() - offset - element) / stride);
    if (!fits) {
        report.fail(key, fmt::format("elements inside the {} bytes of the view", view.size()),
                    fmt::format("count {}, byteOffset {}, stride {}", count, offset, stride));
    }
    return {count == 0 ? nullptr : view.data() + offset, stride};
}

template <class Component>
Component load(const std::byte* bytes) {
    Component value;  // copied bytewise: views need not be aligned
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

template <class Component>
void convert(const Elements& from, int components, std::size_t count, bool normalized, float* out) {
    float scale = 1.0f;
    if constexpr (std::is_integral_v<Component>) {
        if (normalized) scale = 1.0f / static_cast<float>(std::numeric_limits<Component>::max());
    }
    const auto width = static_cast<std::size_t>(components);
    for (std::size_t i = 0; i < count; ++i) {
        const std::byte* element = from.data + i * from.stride;
        for (std::size_t c = 0; c < width; ++c) {
            const auto value = load<Component>(element + c * sizeof(Component));
            // The most negative signed integer lies just below -1 (glTF 3.11).
            const float number = scale * static_cast<float>(value);
            out[i * width + c] = normalized ? std::max(number, -1.0f) : number;
        }
    }
}

void convert_any(const Elements& from, int type, int components, std::size_t count, bool normalized,
                 float* out) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return convert<std::int8_t>(from, components, count, normalized, out);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return convert<std::uint8_t>(from, components, count, normalized, out);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return convert<std::int16_t>(from, components, count, normalized, out);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return convert<std::uint16_t>(from, components, count, normalized, out);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return convert<std::uint32_t>(from, components, count, normalized, out);
        default:
            break;
    }
    const std::size_t element = sizeof(float) * static_cast<std::size_t>(components);
    if (count > 0 && from.stride == element)
        std::memcpy(out, from.data, count * element);
    else
        convert<float>(from, components, count, false, out);
}

template <class Index>
void widen(const Elements& from, std::size_t count, std::uint32_t* out) {
    for (std::size_t i = 0; i < count; ++i) out[i] = load<Index>(from.data + i * from.stride);
}

void widen_any(const Elements& from, int type, std::size_t count, std::uint32_t* out,
               const GltfReport& report, std::string_view key) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return widen<std::uint8_t>(from, count, out);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return widen<std::uint16_t>(from, count, out);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return widen<std::uint32_t>(from, count, out);
        default:
            report.fail(fmt::format("{}.componentType", key), "5121, 5123 or 5125 for indices",
                        fmt::format("{}", type));
    }
}

void check_indices(const std::vector<std::uint32_t>& indices, std::size_t limit,
                   std::string_view key, const GltfReport& report) {
    const auto largest = std::max_element(indices.begin(), indices.end());
    if (largest != indices.end() && *largest >= limit) {
        report.fail(key, fmt::format("indices below {}", limit), fmt::format("{}", *largest));
    }
}

}  // namespace

std::vector<glm::vec2> GltfAccessors::vec2s(int accessor, std::size_t first, std::size_t count,
                                            std::string_view user) {
    report_.pay(count * sizeof(glm::vec2), user);
    std::vector<glm::vec2> out(count);
    read_floats(accessor, 2, first, count, reinterpret_cast<float*>(out.data()), user);
    return out;
}

std::vector<glm::vec3> GltfAccessors::vec3s(int accessor, std::size_t first, std::size_t count,
                                            std::string_view user) {
    report_.pay(count * sizeof(glm::vec3), user);
    std::vector<glm::vec3> out(count);
    read_floats(accessor, 3, first, count, reinterpret_cast<float*>(out.data()), user);
    return out;
}

std::vector<glm::vec4> GltfAccessors::vec4s(int accessor, std::size_t first, std::size_t count,
                                            std::string_view user) {
    report_.pay(count * sizeof(glm::vec4), user);
    std::vector<glm::vec4> out(count);
    read_floats(accessor, 4, first, count, reinterpret_cast<float*>(out.data()), user);
    return out;
}

std::vector<glm::vec4> GltfAccessors::colors(int accessor, std::size_t first, std::size_t count,
                                             std::string_view user) {
    if (item_at(model_.accessors, accessor, report_, user).type == TINYGLTF_TYPE_VEC4)
        return vec4s(accessor, first, count, user);
    const auto opaque = vec3s(accessor, first, count, user);
    report_.pay(count * sizeof(glm::vec4), user);
    std::vector<glm::vec4> out(count);
    std::transform(opaque.begin(), opaque.end(), out.begin(),
                   [](glm::vec3 rgb) { return glm::vec4(rgb, 1.0f); });
    return out;
}

std::size_t GltfAccessors::element_count(int accessor, std::string_view user) const {
    return item_at(model_.accessors, accessor, report_, user).count;
}

void GltfAccessors::read_floats(int index, int components, std::size_t first, std::size_t count,
                                float* out, std::string_view user) {
    const auto& accessor = item_at(model_.accessors, index, report_, user);
    const std::string key = fmt::format("accessors[{}]", index);
    if (accessor.type != components) {  // tinygltf's VEC2, VEC3 and VEC4 are 2, 3 and 4
        report_.fail(fmt::format("{}.type", key), fmt::format("VEC{} for {}", components, user),
                     "another type");
    }
    if (const auto it = decoded_.find(index); it != decoded_.end()) {
        const auto width = static_cast<std::size_t>(components);
        if (it->second.components != components)
            report_.fail(key, fmt::format("compressed data of {} components", components),
                         fmt::format("{}", it->second.components));
        std::copy_n(it->second.values->data() + first * width, count * width, out);
        return;
    }
    const std::size_t component = component_size(accessor.componentType, report_, key);
    if (accessor.normalized && component == 4)
        report_.fail(fmt::format("{}.normalized", key), "8 or 16-bit integers", "32 bits");
    if (accessor.bufferView >= 0) {
        const auto view = buffers_.view(accessor.bufferView, fmt::format("{}.bufferView", key));
        const auto& layout = model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
        Elements elements = elements_in(view, accessor.byteOffset, layout.byteStride,
                                        component * static_cast<std::size_t>(components),
                                        accessor.count, key, report_);
        if (count > 0) elements.data += first * elements.stride;
        convert_any(elements, accessor.componentType, components, count, accessor.normalized, out);
    } else {
        std::fill_n(out, count * static_cast<std::size_t>(components), 0.0f);
    }
    if (accessor.sparse.isSparse) apply_sparse(accessor, components, first, count, out, key);
}

std::vector<std::uint32_t> GltfAccessors::sparse_indices(const tinygltf::Accessor& accessor,
                                                         std::string_view key) {
    const auto& sparse = accessor.sparse;
    const std::string where = fmt::format("{}.sparse.indices", key);
    const auto count = static_cast<std::size_t>(sparse.count);
    const auto view = buffers_.view(sparse.indices.bufferView, fmt::format("{}.bufferView", where));
    const auto elements = elements_in(view, static_cast<std::size_t>(sparse.indices.byteOffset), 0,
                                      component_size(sparse.indices.componentType, report_, where),
                                      count, where, report_);
    report_.pay(count * sizeof(std::uint32_t), where);
    std::vector<std::uint32_t> indices(count);
    widen_any(elements, sparse.indices.componentType, count, indices.data(), report_, where);
    check_indices(indices, accessor.count, where, report_);
    return indices;
}

void GltfAccessors::apply_sparse(const tinygltf::Accessor& accessor, int components,
                                 std::size_t first, std::size_t count, float* out,
                                 std::string_view key) {
    const auto indices = sparse_indices(accessor, key);
    const std::string where = fmt::format("{}.sparse.values", key);
    const auto width = static_cast<std::size_t>(components);
    const auto view =
        buffers_.view(accessor.sparse.values.bufferView, fmt::format("{}.bufferView", where));
    const auto elements =
        elements_in(view, static_cast<std::size_t>(accessor.sparse.values.byteOffset), 0,
                    width * component_size(accessor.componentType, report_, where), indices.size(),
                    where, report_);
    report_.pay(indices.size() * width * sizeof(float), where);
    std::vector<float> values(indices.size() * width);
    convert_any(elements, accessor.componentType, components, indices.size(), accessor.normalized,
                values.data());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] < first || indices[i] - first >= count) continue;
        std::copy_n(values.data() + i * width, width, out + (indices[i] - first) * width);
    }
}

void GltfAccessors::apply_sparse(const tinygltf::Accessor& accessor,
                                 std::vector<std::uint32_t>& out, std::string_view key) {
    const auto indices = sparse_indices(accessor, key);
    const std::string where = fmt::format("{}.sparse.values", key);
    const auto view =
        buffers_.view(accessor.sparse.values.bufferView, fmt::format("{}.bufferView", where));
    const auto elements = elements_in(
        view, static_cast<std::size_t>(accessor.sparse.values.byteOffset), 0,
        component_size(accessor.componentType, report_, where), indices.size(), where, report_);
    std::vector<std::uint32_t> values(indices.size());
    widen_any(elements, accessor.componentType, values.size(), values.data(), report_, where);
    for (std::size_t i = 0; i < indices.size(); ++i) out[indices[i]] = values[i];
}

std::vector<std::uint32_t> GltfAccessors::indices(int index, std::size_t limit,
                                                  std::string_view user) {
    const auto& accessor = item_at(model_.accessors, index, report_, user);
    const std::string key = fmt::format("accessors[{}]", index);
    if (accessor.type != TINYGLTF_TYPE_SCALAR)
        report_.fail(fmt::format("{}.type", key), fmt::format("SCALAR for {}", user),
                     "another type");
    const std::size_t component = component_size(accessor.componentType, report_, key);
    const auto view = buffers_.view(accessor.bufferView, fmt::format("{}.bufferView", key));
    const auto& layout = model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    const auto elements = elements_in(view, accessor.byteOffset, layout.byteStride, component,
                                      accessor.count, key, report_);
    report_.pay(accessor.count * sizeof(std::uint32_t), key);
    std::vector<std::uint32_t> out(accessor.count);
    widen_any(elements, accessor.componentType, accessor.count, out.data(), report_, key);
    if (accessor.sparse.isSparse) apply_sparse(accessor, out, key);
    check_indices(out, limit, key, report_);
    return out;
}

}  // namespace burnish

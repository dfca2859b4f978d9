#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {

namespace {

constexpr std::array<std::string_view, 4> kMdfNames = {"ashikhmin-shirley", "ward", "beckmann",
                                                       "ggx"};
constexpr std::array<std::string_view, 9> kBrdfNames = {"microfacet",
                                                        "microfacet-separable",
                                                        "ashikhmin-shirley",
                                                        "ward-gmd",
                                                        "ward",
                                                        "ward-duer",
                                                        "cook-torrance",
                                                        "phong",
                                                        "lafortune"};
constexpr std::array<std::string_view, 11> kMethodNames = {
    "none",         "normal-map",    "gram-schmidt",  "rotate-exact", "rotate-approx", "rotate-arc",
    "follow-grain", "deform-linear", "deform-smooth", "slope-shift",  "stretch"};
constexpr std::array<std::string_view, 4> kProcessNames = {"embossed", "bent", "stamped",
                                                           "brushed-after"};

// What `brdf eval` calls by another name or computes alone, and what draws it or comes nearest.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kUndrawn = {
    {{"he", "brdf eval computes it, no picture: cook-torrance is nearest"},
     {"ashikhmin-premoze-shirley",
      "brdf eval computes it, no picture: microfacet with mdf ashikhmin-shirley is nearest"},
     {"ashikhmin-shirley-diffuse", "part of ashikhmin-shirley on what is no metal"},
     {"ggx", "microfacet with mdf ggx"},
     {"ggx-separable", "microfacet-separable with mdf ggx"},
     {"beckmann", "microfacet with mdf beckmann"}}};

template <typename Enum>
std::string_view name_in(std::span<const std::string_view> names, Enum value) {
    return names[static_cast<std::size_t>(value)];
}

}  // namespace

std::span<const std::string_view> mdf_names() {
    return kMdfNames;
}
std::span<const std::string_view> brdf_names() {
    return kBrdfNames;
}
std::span<const std::string_view> method_names() {
    return kMethodNames;
}
std::span<const std::string_view> process_names() {
    return kProcessNames;
}

Method method_of(Process process) {
    switch (process) {
        case Process::bent:
            return Method::rotate_arc;
        case Process::stamped:
            return Method::stretch;
        case Process::brushed_after:
            return Method::slope_shift;
        default:
            return Method::follow_grain;
    }
}

std::string_view instead_of_undrawn(std::string_view brdf) {
    for (const auto& [name, instead] : kUndrawn)
        if (name == brdf) return instead;
    return {};
}

std::string_view name_of(Mdf mdf) {
    return name_in(kMdfNames, mdf);
}
std::string_view name_of(Brdf brdf) {
    return name_in(kBrdfNames, brdf);
}
std::string_view name_of(Method method) {
    return name_in(kMethodNames, method);
}
std::string_view name_of(Process process) {
    return name_in(kProcessNames, process);
}

}  // namespace burnish

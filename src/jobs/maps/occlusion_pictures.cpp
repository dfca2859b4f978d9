#include "jobs/maps/occlusion_pictures.hpp"

#include <algorithm>

namespace burnish {

std::vector<NamedPicture> occlusion_pictures(const Image& occlusion, float roughness,
                                             float metallic) {
    const auto count = [&occlusion](int begin, int end) {
        return static_cast<std::ptrdiff_t>(end - begin) * occlusion.width;
    };
    std::vector<NamedPicture> all;
    all.push_back(
        {"ao.png", picture_of_rows(DataFormat::png16, {"Y"}, occlusion.width, occlusion.height,
                                   [=, &occlusion](int begin, int end, float* to) {
                                       std::copy_n(occlusion.at(0, begin), count(begin, end), to);
                                   })});
    all.push_back(
        {"orm.png", picture_of_rows(DataFormat::png16, kRgb, occlusion.width, occlusion.height,
                                    [=, &occlusion](int begin, int end, float* to) {
                                        const float* from = occlusion.at(0, begin);
                                        for (std::ptrdiff_t i = 0; i < count(begin, end); ++i) {
                                            *to++ = from[i];
                                            *to++ = roughness;
                                            *to++ = metallic;
                                        }
                                    })});
    return all;
}

}  // namespace burnish

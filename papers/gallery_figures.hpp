// The figures of the gallery, one function each. Private to papers/gallery*.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/frame/frame_cost.hpp"
#include "burnish/shading_names.hpp"
#include "papers/gallery_page.hpp"
#include "papers/gallery_studio.hpp"

namespace burnish {

// Objects that all figures of a run share.
struct GalleryTools {
    GalleryStudio& studio;
    const GalleryRequest& request;
    Progress progress;  // of the current figure
    std::vector<std::string>& warnings;
    std::optional<FrameCost>& cost;  // measured by the first figure that needs it

    bool quick() const { return studio.quick(); }
};

struct GalleryFigure {
    GalleryEntry entry;
    // Empty: the figure cannot be made here, and a warning gives the reason.
    std::optional<GalleryPage> (*make)(GalleryTools& tools);
};
std::span<const GalleryFigure> gallery_figures();

// Surface of K11 Eq 1 at the papers' exponents; Ward's distribution at K12 Fig 5's alphas.
using ParameterList = std::vector<std::pair<std::string, std::string>>;
ParameterList shirley_surface();
ParameterList ward_surface();

// A rendered panel; adds its command to the page.
plot::Panel rendered(GalleryPage& page, const Picture& picture, std::string title, double side);

// Renders pictures of one surface by method.
struct MethodShots {
    GalleryTools& tools;
    const PictureSpec& spec;
    double side;

    Picture operator()(const char* method) const {
        return tools.studio.picture(spec.with("method", method), side, tools.progress);
    }
};

// ---- figures of distributions (gallery_lobes.cpp)
std::optional<GalleryPage> k11_fig2(GalleryTools& tools);
std::optional<GalleryPage> k11_fig6(GalleryTools& tools);
std::optional<GalleryPage> k11_fig7(GalleryTools& tools);
std::optional<GalleryPage> k11_fig8(GalleryTools& tools);
std::optional<GalleryPage> k12_fig2(GalleryTools& tools);
std::optional<GalleryPage> k12_fig3(GalleryTools& tools);
std::optional<GalleryPage> k12_fig4(GalleryTools& tools);
std::optional<GalleryPage> k12_fig5(GalleryTools& tools);

// ---- surfaces of K11 (gallery_k11.cpp), of K12 (gallery_k12.cpp)
std::optional<GalleryPage> k11_fig1(GalleryTools& tools);
std::optional<GalleryPage> k11_fig3(GalleryTools& tools);
std::optional<GalleryPage> k11_fig4(GalleryTools& tools);
std::optional<GalleryPage> k11_fig5(GalleryTools& tools);
std::optional<GalleryPage> k11_fig9(GalleryTools& tools);
std::optional<GalleryPage> k11_fig10(GalleryTools& tools);
std::optional<GalleryPage> k11_fig12(GalleryTools& tools);
std::optional<GalleryPage> k11_fig13(GalleryTools& tools);
std::optional<GalleryPage> k11_fig14(GalleryTools& tools);
std::optional<GalleryPage> k11_fig15(GalleryTools& tools);
std::optional<GalleryPage> k12_fig1(GalleryTools& tools);
std::optional<GalleryPage> k12_fig6(GalleryTools& tools);
std::optional<GalleryPage> k12_fig8(GalleryTools& tools);
std::optional<GalleryPage> k12_fig9(GalleryTools& tools);
std::optional<GalleryPage> k12_fig10(GalleryTools& tools);

// ---- cost (gallery_cost.cpp)
std::optional<GalleryPage> k11_fig11(GalleryTools& tools);
std::optional<GalleryPage> k12_fig7(GalleryTools& tools);
std::optional<GalleryPage> k12_table1(GalleryTools& tools);

// ---- reflection models of B12's slide (gallery_models.cpp)
std::optional<GalleryPage> b12_models(GalleryTools& tools);
std::optional<GalleryPage> b12_measured(GalleryTools& tools);

}  // namespace burnish

// The lobe over the hemisphere, drawn with a depth buffer. Letters are drawn over it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/plot/brdf_plot.hpp"
#include "core/constants.hpp"
#include "plot/axes.hpp"
#include "plot/depth_picture.hpp"
#include "plot/surface_mesh.hpp"

namespace burnish::plot {
namespace {

using Vec = Direction<double>;

constexpr int kFiner = 2;  // pixels of the depth buffer per pixel of the plot, along each axis
constexpr double kAxisLength = 1.18;
// Half the width of the view, with room for the letters.
constexpr double kHalfView = 1.32, kLetter = 0.13;
const Rgb kLobe{0.36, 0.60, 0.86};
const Rgb kGround{0.925, 0.925, 0.94};
const Rgb kLight = {0.78, 0.46, 0.0};

// Orthographic: parallel lines stay parallel, lengths can be compared.
class View {
  public:
    View(const SurfaceView& view, double width) : width_(width) {
        const double azimuth = view.azimuth_deg * kDegree;
        const double elevation = std::clamp(view.elevation_deg, -89.9, 89.9) * kDegree;
        towards_ = {std::cos(elevation) * std::cos(azimuth),
                    std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
        right_ = {-std::sin(azimuth), std::cos(azimuth), 0};
        up_ = cross(towards_, right_);
    }
    // The extent of the view above and below the origin, in units of the tangent plane's radius:
    // the axes, and the lobe, which is no longer than the axes.
    double above() const { return kAxisLength * std::max(up_.z, towards_.z) + kLetter; }
    double below() const { return kAxisLength * towards_.z + kLetter; }
    double height() const { return (above() + below()) / (2 * kHalfView) * width_; }
    DepthPoint operator()(Vec p) const {
        const double scale = width_ / (2 * kHalfView);
        return {width_ / 2 + scale * dot(p, right_), scale * (above() - dot(p, up_)),
                dot(p, towards_)};
    }
    Vec towards() const { return towards_; }
    Vec right() const { return right_; }
    Vec up() const { return up_; }

  private:
    double width_;
    Vec towards_, right_, up_;
};

struct Scene {
    SurfaceMesh mesh;
    Vec wi, mirror;
};

void draw_ground(DepthPicture& picture, const View& view, double pixel) {
    constexpr int kSteps = 144;
    const auto rim = [&](int i, double r) {
        const double phi = 2 * std::numbers::pi * i / kSteps;
        // Below the plane by less than a pixel, so that the lobe's foot lies on it.
        return view({r * std::cos(phi), r * std::sin(phi), -0.002});
    };
    for (int i = 0; i < kSteps; ++i)
        picture.triangle({view({0, 0, -0.002}), 1}, {rim(i, 1), 1}, {rim(i + 1, 1), 1}, kGround);
    const DepthPicture::Line faint{{0.72, 0.72, 0.76}, 1.2 * pixel, 0.01};
    for (const double r : {0.25, 0.5, 0.75, 1.0})
        for (int i = 0; i < kSteps; ++i) picture.line(rim(i, r), rim(i + 1, r), faint);
    for (int i = 0; i < kSteps; i += kSteps / 12) picture.line(rim(i, 0), rim(i, 1), faint);
}

void draw_lobe(DepthPicture& picture, const View& view, const SurfaceMesh& mesh, double pixel) {
    // Light from over the viewer's left shoulder. A lobe is thin, so both sides are lit.
    Vec lamp = view.towards() + view.up() * 0.8 - view.right() * 0.6;
    make_unit(lamp);
    const auto corner = [&](std::size_t i) {
        Vec n = mesh.normals[i];
        if (dot(n, view.towards()) < 0) n = -n;
        const double lit = std::max(dot(n, lamp), 0.0);
        return DepthPicture::Corner{view(mesh.points[i]), 0.30 + 0.75 * lit};
    };
    for (const auto& t : mesh.triangles)
        picture.triangle(corner(t[0]), corner(t[1]), corner(t[2]), kLobe);
    const DepthPicture::Line style{{0.05, 0.16, 0.33}, 0.8 * pixel, 0.012, 0.22};
    for (const auto& line : mesh.lines)
        for (std::size_t i = 1; i < line.size(); ++i)
            picture.line(view(mesh.points[line[i - 1]]), view(mesh.points[line[i]]), style);
}

// A line with a cone at `to`.
void draw_arrow(DepthPicture& picture, const View& view, Vec from, Vec to,
                const DepthPicture::Line& style, double pixel) {
    const DepthPoint a = view(from), b = view(to);
    picture.line(a, b, style);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length < 8 * pixel) return;  // the arrow points at the viewer
    const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
    const double head = 9 * pixel, half = 3.4 * pixel;
    const double depth = b.depth + 0.002;
    picture.triangle({{b.x + ux * head * 0.3, b.y + uy * head * 0.3, depth}, 1},
                     {{b.x - ux * head - uy * half, b.y - uy * head + ux * half, depth}, 1},
                     {{b.x - ux * head + uy * half, b.y - uy * head - ux * half, depth}, 1},
                     style.color);
}

Image draw_scene(const Scene& scene, const SurfaceView& at, int width, int height, double ratio) {
    const double pixel = ratio * kFiner;
    const View view(at, width * kFiner);
    DepthPicture picture(width * kFiner, height * kFiner, kWhite);
    draw_ground(picture, view, pixel);
    draw_lobe(picture, view, scene.mesh, pixel);
    const DepthPicture::Line axis{kInk, 1.3 * pixel, 0.003};
    for (const Vec end : {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}})
        draw_arrow(picture, view, {0, 0, 0}, end * kAxisLength, axis, pixel);
    draw_arrow(picture, view, scene.wi * kAxisLength, scene.wi * 0.06, {kLight, 2.2 * pixel, 0.003},
               pixel);
    picture.line(view({0, 0, 0}), view(scene.mirror * kAxisLength),
                 {kLight, 1.4 * pixel, 0.003, 1, 3 * pixel, 5 * pixel});
    return picture.reduced(kFiner);
}

void draw_letters(Canvas& canvas, const Box& box, const SurfaceView& at, Vec wi) {
    const View view(at, box.width);
    const auto letter = [&](Vec end, const std::string& text, const Rgb& color) {
        const DepthPoint foot = view({0, 0, 0}), p = view(end * kAxisLength);
        const double length = std::max(std::hypot(p.x - foot.x, p.y - foot.y), 1.0);
        TextStyle style{.size = 13, .bold = true, .color = color};
        style.align = Align::center;
        style.stand = Stand::middle;
        style.halo = kWhite;
        canvas.text({box.x + p.x + 12 * (p.x - foot.x) / length,
                     box.y + p.y + 12 * (p.y - foot.y) / length},
                    text, style);
    };
    letter({1, 0, 0}, "x", kInk);
    letter({0, 1, 0}, "y", kInk);
    letter({0, 0, 1}, "n", kInk);
    letter(wi, "light", kLight);
}

}  // namespace

Panel surface_panel(const BrdfSubject& subject, double incidence_deg, double azimuth_deg,
                    ScaleKind kind, const SurfaceView& view, std::string title, double width) {
    const Vec wi = incident(incidence_deg, azimuth_deg);
    const BrdfPeak peak = peak_of(subject, wi);
    const Scale scale = scale_to(kind, peak.f);
    auto scene = std::make_shared<Scene>();
    scene->mesh = surface_mesh(subject, wi, scale, peak.wo);
    scene->wi = wi;
    scene->mirror = {-wi.x, -wi.y, wi.z};
    const double height = std::ceil(View(view, width).height());
    Panel panel{std::move(title), width, height, {}, {}};
    panel.note = (kind == ScaleKind::log     ? "log, four decades; largest f "
                  : kind == ScaleKind::gamma ? "gamma 2.2; largest f "
                                             : "linear; largest f ") +
                 number_text(peak.f) + " /sr";
    panel.draw = [scene, view](Canvas& canvas, const Box& box) {
        const double ratio = canvas.pixel_ratio();
        const auto pixels = [&](double px) {
            return std::max(static_cast<int>(std::lround(px * ratio)), 1);
        };
        canvas.image(box, draw_scene(*scene, view, pixels(box.width), pixels(box.height), ratio));
        draw_letters(canvas, box, view, scene->wi);
        canvas.mark_area("surface", box);
    };
    return panel;
}

}  // namespace burnish::plot

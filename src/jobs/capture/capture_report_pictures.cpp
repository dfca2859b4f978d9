// Pictures of half vectors, of exemplars before and after completion, and of maps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "burnish/image_io.hpp"
#include "burnish/material_textures.hpp"
#include "burnish/plot/panels.hpp"
#include "core/constants.hpp"
#include "core/statistics.hpp"
#include "jobs/capture/capture_report_parts.hpp"
#include "plot/axes.hpp"

namespace burnish::report {

namespace {

using plot::Box;
using plot::Canvas;
using plot::Point;
using plot::Rgb;

constexpr int kLeastSide = 288, kMostSide = 1024;  // pixels of a picture on the page
constexpr double kDecades = 5.0;                   // visible range of D
const Rgb kOutside{0.80, 0.80, 0.81};              // outside the mask
const Rgb kExtrapolated{0.90, 0.90, 0.91}, kCompleted{0.84, 0.84, 0.85}, kHatch{0.55, 0.55, 0.58};

void put(Image& image, std::size_t pixel, const Rgb& color) {
    image.pixels[3 * pixel] = static_cast<float>(std::clamp(color.r, 0.0, 1.0));
    image.pixels[3 * pixel + 1] = static_cast<float>(std::clamp(color.g, 0.0, 1.0));
    image.pixels[3 * pixel + 2] = static_cast<float>(std::clamp(color.b, 0.0, 1.0));
}

// color(x, y) for every pixel of a disc of radius 1 in a square, y up.
template <typename Color>
Image disc_image(int side, Color color) {
    Image image(side, side, 3, 1.0f);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double x = 2 * (column + 0.5) / side - 1, y = 1 - 2 * (row + 0.5) / side;
            // Slightly beyond the rim, where the disc is cut off.
            if (std::hypot(x, y) < 1 + 4.0 / side)
                put(image, static_cast<std::size_t>(row * side + column), color(x, y));
        }
    return image;
}

struct Disc {
    Point center;
    double radius;
    Point at(double r, double azimuth) const {
        return {center.x + radius * r * std::cos(azimuth),
                center.y - radius * r * std::sin(azimuth)};
    }
};

Disc draw_disc(Canvas& canvas, const Box& box, const Image& image) {
    const Disc disc{box.center(), box.width / 2 - 14};
    const Box inner = box.inset(14, 14, 14, 14);
    {
        const auto clip = canvas.clip_to_circle(disc.center, disc.radius);
        canvas.image(inner, image);
    }
    canvas.circle(disc.center, disc.radius, {.color = plot::kInk, .width = 1});
    canvas.mark_area("disc", inner);
    return disc;
}

// Circles of equal angle to the normal, at the radius place(angle).
template <typename Place>
void draw_tilts(Canvas& canvas, const Disc& disc, std::initializer_list<int> tilts, Place place,
                const plot::Stroke& stroke) {
    for (const int tilt : tilts) canvas.circle(disc.center, place(tilt) * disc.radius, stroke);
}

template <typename Place>
void label_tilts(Canvas& canvas, const Disc& disc, std::initializer_list<int> tilts, Place place) {
    plot::TextStyle style{.size = 10.5, .color = plot::kInk, .align = plot::Align::center};
    style.halo = plot::kWhite;
    style.stand = plot::Stand::middle;
    for (const int tilt : tilts)
        canvas.text(disc.at(place(tilt), 65 * kDegree), fmt::format("{}\u00b0", tilt), style);
}

// ---- coverage

const Rgb kSeen{0.72, 0.83, 0.93}, kTurned{0.89, 0.94, 0.98}, kUnseen{1, 1, 1};
const Rgb kLimit{0.75, 0.2, 0.15};

Image seen_image(const PointCoverage& c, int side) {
    const double cos_reach = std::cos(c.reach * kDegree);
    std::vector<double> tilts;
    for (const Vec3d& h : c.half_vectors)
        tilts.push_back(std::atan2(std::hypot(h[0], h[1]), h[2]) / kDegree);
    std::sort(tilts.begin(), tilts.end());
    return disc_image(side, [&](double x, double y) {
        const double tilt = std::min(std::hypot(x, y), 1.0) * 90.0, azimuth = std::atan2(y, x);
        const double sine = std::sin(tilt * kDegree);
        const Vec3d v = {sine * std::cos(azimuth), sine * std::sin(azimuth),
                         std::cos(tilt * kDegree)};
        for (const Vec3d& h : c.half_vectors)
            if (v[0] * h[0] + v[1] * h[1] + v[2] * h[2] >= cos_reach) return kSeen;
        const auto next = std::lower_bound(tilts.begin(), tilts.end(), tilt - c.reach);
        return next != tilts.end() && *next <= tilt + c.reach ? kTurned : kUnseen;
    });
}

// ---- exemplars

double share_of_origin(const TabulatedMaterial& m, int exemplar, NdfOrigin origin) {
    double sum = 0.0, all = 0.0;
    for (int cell = 0; cell < m.grid.cells(); ++cell) {
        const double w = m.grid.solid_angle(cell / m.grid.azimuths);
        const auto at =
            static_cast<std::size_t>(exemplar) * static_cast<std::size_t>(m.grid.cells()) +
            static_cast<std::size_t>(cell);
        all += w;
        if (m.origin[at] == origin) sum += w;
    }
    return sum / all;
}

Image table_image(const TabulatedMaterial& m, int exemplar, const plot::Scale& scale,
                  bool measured_only, int side) {
    const float* table = m.table(exemplar);
    const NdfOrigin* origin =
        m.origin.data() + static_cast<std::ptrdiff_t>(exemplar) * m.grid.cells();
    return disc_image(side, [&](double x, double y) {
        const double u = std::min(std::hypot(x, y), 1.0);
        double phi = std::atan2(y, x);
        if (phi < 0) phi += 2 * kPi;
        if (measured_only) {
            const int ring = std::min(static_cast<int>(u * m.grid.rings), m.grid.rings - 1);
            const int column =
                static_cast<int>(std::lround(phi / (2 * kPi) * m.grid.azimuths)) % m.grid.azimuths;
            const NdfOrigin known = origin[ring * m.grid.azimuths + column];
            if (known == NdfOrigin::extrapolated) return kExtrapolated;
            // Hatched: stripes of a 24th of the disc's radius.
            if (known == NdfOrigin::completed)
                return std::fmod(24 * (x + y + 4), 2.0) < 0.5 ? kHatch : kCompleted;
        }
        const double D = static_cast<double>(
            ndf_lookup(m.grid, table, static_cast<float>(u), static_cast<float>(phi)));
        return plot::sequential_color(scale.position(std::max(D, scale.low)));
    });
}

plot::Panel table_panel(const TabulatedMaterial& m, int exemplar, const LobeFit& lobe,
                        const plot::Scale& scale, bool measured_only) {
    plot::Panel panel{
        measured_only ? "before: what was measured" : "after: all cells", 228, 228, {}, {}};
    panel.draw = [&m, exemplar, lobe, scale, measured_only](Canvas& canvas, const Box& box) {
        const int side = static_cast<int>(std::lround((box.width - 28) * canvas.pixel_ratio()));
        const Disc disc =
            draw_disc(canvas, box, table_image(m, exemplar, scale, measured_only, side));
        const std::initializer_list<int> tilts = {10, 30, 60};
        const auto place = [](int tilt) { return std::sqrt(tilt / 90.0); };
        draw_tilts(canvas, disc, tilts, place,
                   {.color = plot::kWhite, .width = 0.7, .opacity = 0.6});
        label_tilts(canvas, disc, tilts, place);
        // Marks of the groove's direction, outside the rim.
        for (const double end : {0.0, kPi})
            canvas.line(disc.at(1.02, lobe.groove + end),
                        disc.at(1.0 + 12 / disc.radius, lobe.groove + end),
                        {.color = kLimit, .width = 2.4});
    };
    return panel;
}

// A distinct hue for each rank; adjacent ranks differ most.
Rgb rank_color(std::size_t rank) {
    const double hue = 2 * kPi * std::fmod(0.08 + static_cast<double>(rank) * 0.618034, 1.0);
    const double lightness = 0.78 - 0.12 * static_cast<double>(rank % 3);
    return plot::display_of({lightness, 0.11 * std::cos(hue), 0.11 * std::sin(hue)});
}

// ---- maps

bool is_outside(const TabulatedMaterial& m, std::size_t texel) {
    return m.exemplar[texel] == TabulatedMaterial::kNoExemplar;
}

template <typename Color>
Image map_image(const TabulatedMaterial& m, Color color) {
    Image image(m.width, m.height, 3);
    for (std::size_t t = 0; t < m.texels(); ++t)
        put(image, t, is_outside(m, t) ? kOutside : color(t));
    return image;
}

template <typename Value>
std::vector<double> values_of(const TabulatedMaterial& m, Value value) {
    std::vector<double> values;
    for (std::size_t t = 0; t < m.texels(); ++t)
        if (!is_outside(m, t)) values.push_back(value(t));
    return values;
}

plot::Panel map_panel(const Image& image) {
    const double side = 330.0;
    const double shape = static_cast<double>(image.width) / image.height;
    return plot::picture_panel(image, "", shape >= 1 ? side : std::max(side * shape, 8.0));
}

void add_map(const char* file, std::string title, std::string text, const plot::Figure& figure,
             Page& page, Pictures& pictures) {
    page.maps.push_back({std::move(title), std::move(text), file});
    pictures.push_back({file, plot::draw_figure(figure).image});
}

void add_color_map(const TabulatedMaterial& m, const Image& colors, const char* file,
                   const char* title, const char* what, Page& page, Pictures& pictures) {
    const double high =
        quantile(values_of(m,
                           [&](std::size_t t) {
                               const float* c = colors.pixels.data() + 3 * t;
                               return static_cast<double>(std::max({c[0], c[1], c[2]}));
                           }),
                 0.995);
    // Rounded up to a short number.
    double white = 1.0;
    if (high > 1e-6 && std::isfinite(high)) {
        const double step = std::pow(10.0, std::floor(std::log10(high)));
        white = step * std::ceil(high / step);
    }
    const Image image = map_image(m, [&](std::size_t t) {
        const float* c = colors.pixels.data() + 3 * t;
        const auto shown_at = [&](std::size_t k) {
            return static_cast<double>(
                srgb_from_linear(std::clamp(c[k] / static_cast<float>(white), 0.0f, 1.0f)));
        };
        return Rgb{shown_at(0), shown_at(1), shown_at(2)};
    });
    plot::Figure figure;
    figure.rows.push_back({"", {map_panel(image)}});
    add_map(file, title, fmt::format("{}; white is {:g}.", what, white), figure, page, pictures);
}

template <typename Value>
void add_scalar_map(const TabulatedMaterial& m, const char* file, std::string title,
                    std::string text, const char* label, double high, Value value, Page& page,
                    Pictures& pictures) {
    const plot::Scale scale = plot::scale_to(plot::ScaleKind::linear, high);
    double most = 0.0;
    const Image image = map_image(m, [&](std::size_t t) {
        const double v = value(t);
        most = std::max(most, v);
        return plot::sequential_color(scale.position(v));
    });
    plot::ColorBar bar{scale, label};
    if (most > 1.001 * scale.high) bar.above = most;
    plot::Figure figure;
    figure.rows.push_back({"", {map_panel(image)}, bar});
    add_map(file, std::move(title), std::move(text), figure, page, pictures);
}

// The hue has a period of half a turn; the color is grayer for rounder lobes.
Rgb grain_color(double groove, double anisotropy) {
    const double chroma = 0.125 * anisotropy;
    return plot::display_of({0.72, chroma * std::cos(2 * groove), chroma * std::sin(2 * groove)});
}

plot::Panel grain_key() {
    plot::Panel panel{"key", 120, 120, {}, {}};
    panel.draw = [](Canvas& canvas, const Box& box) {
        const int side = static_cast<int>(std::lround((box.width - 28) * canvas.pixel_ratio()));
        draw_disc(canvas, box, disc_image(side, [](double x, double y) {
                      return grain_color(std::atan2(y, x), std::min(std::hypot(x, y), 1.0));
                  }));
    };
    return panel;
}

double anisotropy_of(const LobeFit& lobe) {
    return lobe.alpha_across > 0.0 ? 1.0 - lobe.alpha_along / lobe.alpha_across : 0.0;
}

bool is_flat(const TabulatedMaterial& m) {
    constexpr float kFlat = 1e-4f;  // 0.006 degrees
    for (std::size_t t = 0; t < m.texels(); ++t)
        if (!is_outside(m, t) &&
            std::hypot(m.normal.pixels[3 * t], m.normal.pixels[3 * t + 1]) > kFlat)
            return false;
    return true;
}

}  // namespace

Image at_viewing_size(const Image& image) {
    const int side = std::max(image.width, image.height);
    if (side < kLeastSide) {
        const int k = (kLeastSide + side - 1) / side;
        Image out(image.width * k, image.height * k, image.channels);
        for (int y = 0; y < out.height; ++y)
            for (int x = 0; x < out.width; ++x)
                std::copy_n(image.at(x / k, y / k), image.channels, out.at(x, y));
        return out;
    }
    if (side <= kMostSide) return image;
    const int k = (side + kMostSide - 1) / kMostSide;
    Image out((image.width + k - 1) / k, (image.height + k - 1) / k, image.channels);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            int count = 0;
            for (int v = y * k; v < std::min((y + 1) * k, image.height); ++v)
                for (int u = x * k; u < std::min((x + 1) * k, image.width); ++u, ++count)
                    for (int c = 0; c < image.channels; ++c) out.at(x, y)[c] += image.at(u, v)[c];
            for (int c = 0; c < image.channels; ++c) out.at(x, y)[c] /= static_cast<float>(count);
        }
    return out;
}

Picture coverage_picture(const RigCoverage& coverage, const std::vector<std::uint8_t>& keep) {
    const PointCoverage& c = coverage.center;
    plot::Panel panel{"half vectors at the centre of the sample", 420, 420, {}, {}};
    panel.draw = [&](Canvas& canvas, const Box& box) {
        const Disc disc = draw_disc(canvas, box, seen_image(c, 392));
        const std::initializer_list<int> tilts = {15, 30, 45, 60, 75};
        const auto place = [](int tilt) { return tilt / 90.0; };
        draw_tilts(canvas, disc, tilts, place,
                   {.color = plot::kGray, .width = 0.6, .opacity = 0.6});
        canvas.circle(disc.center, disc.radius * c.theta_h_limit / 90.0,
                      {.color = kLimit, .width = 1.8, .dash = {6, 4}});
        // Dots of half vectors stay smaller than their reach where that is wide enough to be
        // visible.
        const double size = std::clamp(0.55 * c.reach / 90.0 * disc.radius, 1.2, 2.4);
        for (std::size_t k = 0; k < c.half_vectors.size(); ++k) {
            const Vec3d& h = c.half_vectors[k];
            const double tilt = std::atan2(std::hypot(h[0], h[1]), h[2]) / (kPi / 2);
            canvas.disk(disc.at(tilt, std::atan2(h[1], h[0])), keep[k] ? size : 1.4 * size,
                        keep[k] ? plot::series_color(0) : plot::series_color(1));
        }
        label_tilts(canvas, disc, tilts, place);
        plot::TextStyle axis{.size = 12.5, .align = plot::Align::center};
        axis.stand = plot::Stand::middle;
        canvas.text(disc.at(1 + 8 / disc.radius, 0), "x", axis);
        canvas.text(disc.at(1 + 8 / disc.radius, kPi / 2), "y", axis);
    };
    plot::Figure figure;
    figure.rows.push_back({"", {panel}});
    figure.legend = {{"a light", plot::series_color(0)},
                     {"a light that judges", plot::series_color(1)},
                     {"tilt that no pair reaches beyond", kLimit, {6, 4}},
                     {"covered", kSeen},
                     {"covered when turned", kTurned}};
    return {"coverage.png", plot::draw_figure(figure).image};
}

void add_exemplars(const TabulatedMaterial& m, const std::vector<LobeFit>& lobes, Page& page,
                   Pictures& pictures) {
    const auto count = static_cast<std::size_t>(m.exemplars);
    std::vector<std::size_t> uses(count), order(count);
    std::size_t all = 0;
    for (const std::uint16_t e : m.exemplar)
        if (e != TabulatedMaterial::kNoExemplar) {
            ++uses[e];
            ++all;
        }
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return uses[a] > uses[b]; });
    double most = 0.0;
    for (std::size_t rank = 0; rank < count; ++rank) {
        const int e = static_cast<int>(order[rank]);
        ExemplarEntry entry;
        entry.index = e;
        entry.share = static_cast<double>(uses[order[rank]]) /
                      static_cast<double>(std::max<std::size_t>(all, 1));
        entry.lobe = lobes[order[rank]];
        entry.color = rank_color(rank);
        for (std::size_t o = 0; o < 3; ++o)
            entry.known[o] = share_of_origin(m, e, static_cast<NdfOrigin>(o));
        if (rank < kMostExemplars) {
            most = std::max(most, static_cast<double>(
                                      *std::max_element(m.table(e), m.table(e) + m.grid.cells())));
            entry.picture = fmt::format("exemplar_{:02}.png", rank);
        }
        page.exemplars.push_back(entry);
    }
    // One scale for all exemplars, so that brightness can be compared.
    const plot::Scale scale = plot::scale_to(plot::ScaleKind::log, most, kDecades);
    for (const ExemplarEntry& entry : page.exemplars) {
        if (entry.picture.empty()) continue;
        plot::Figure figure;
        figure.rows.push_back({"",
                               {table_panel(m, entry.index, entry.lobe, scale, true),
                                table_panel(m, entry.index, entry.lobe, scale, false)},
                               plot::ColorBar{scale, "D [1/sr], logarithmic"}});
        pictures.push_back({entry.picture, plot::draw_figure(figure).image});
    }
}

void add_maps(const TabulatedMaterial& m, const std::vector<LobeFit>& lobes, Page& page,
              Pictures& pictures) {
    add_color_map(m, m.diffuse, "map_diffuse.png", "Diffuse", "Albedo", page, pictures);
    add_color_map(m, m.specular, "map_specular.png", "Specular", "k_s F(1)", page, pictures);
    const Image grain = map_image(m, [&](std::size_t t) {
        return grain_color(groove_at(m, lobes, t), anisotropy_of(lobes[m.exemplar[t]]));
    });
    plot::Figure figure;
    figure.rows.push_back({"", {map_panel(grain), grain_key()}});
    add_map("map_grain.png", "Grain",
            "Direction of the groove: a point of the key has the color of a groove that runs from "
            "the key's centre through it; the greyer, the rounder the lobe.",
            figure, page, pictures);
    std::vector<Rgb> colors(static_cast<std::size_t>(m.exemplars));
    for (const ExemplarEntry& entry : page.exemplars)
        colors[static_cast<std::size_t>(entry.index)] = entry.color;
    figure = {};
    figure.rows.push_back(
        {"", {map_panel(map_image(m, [&](std::size_t t) { return colors[m.exemplar[t]]; }))}});
    add_map("map_exemplar.png", "Exemplar", "In the colors of the palette above.", figure, page,
            pictures);
    if (!is_flat(m)) {
        figure = {};
        figure.rows.push_back({"", {map_panel(map_image(m, [&](std::size_t t) {
                                   const float* n = m.normal.pixels.data() + 3 * t;
                                   const auto half = [&](std::size_t k) {
                                       return 0.5 + 0.5 * static_cast<double>(n[k]);
                                   };
                                   return Rgb{half(0), half(1), half(2)};
                               }))}});
        add_map("map_normal.png", "Normal",
                "x, y, z as red, green, blue, -1 to 1 as black to full.", figure, page, pictures);
    } else {
        page.notes.push_back("Every normal is +z: the sample was taken as flat.");
    }
    double widest = 0.0;
    for (const std::uint16_t e : m.exemplar)
        if (e != TabulatedMaterial::kNoExemplar) widest = std::max(widest, lobes[e].alpha_across);
    add_scalar_map(
        m, "map_alpha_across.png", "Alpha across the groove",
        "Of the GGX lobe nearest to the "
        "texel's exemplar.",
        "alpha", widest, [&](std::size_t t) { return lobes[m.exemplar[t]].alpha_across; }, page,
        pictures);
    add_scalar_map(
        m, "map_alpha_along.png", "Alpha along the groove", "On the same scale.", "alpha", widest,
        [&](std::size_t t) { return lobes[m.exemplar[t]].alpha_along; }, page, pictures);
    const auto error = m.maps.find("fit.error");
    if (error == m.maps.end()) {
        page.notes.push_back("The material has no map of what the fit left unexplained.");
        return;
    }
    const auto value = [&](std::size_t t) {
        return 100.0 * std::sqrt(std::max(static_cast<double>(error->second[t]), 0.0));
    };
    add_scalar_map(m, "map_error.png", "Residual of the fit",
                   "How much of each texel's light is not explained: the root of fit.error. The "
                   "scale ends where 99 % of the texels do.",
                   "% of the light", quantile(values_of(m, value), 0.99), value, page, pictures);
}

}  // namespace burnish::report

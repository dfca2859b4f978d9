#include <fmt/format.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/brdf_models.hpp"
#include "burnish/shading_names.hpp"
#include "burnish/surface.hpp"
#include "viewer/inspect/inspector.hpp"

namespace burnish::viewer {
namespace {

constexpr std::array<std::string_view, 3> kChannels = {"red", "green", "blue"};

// The frame in which the unperturbed model has the same value; none: no frame does that.
std::optional<f64::Frame> frame_of_row(const PointLobe& lobe, const f64::Perturbation& p) {
    // Phong is a lobe about the mirror direction about n~, whatever the method.
    if (lobe.surface().brdf == f64::kBrdfPhong) return f64::frame_shortest_arc(p.n);
    switch (p.method) {
        case f64::kMethodNone:
        case f64::kMethodGramSchmidt:
        case f64::kMethodRotateExact:
        case f64::kMethodRotateArc:
        case f64::kMethodFollowGrain:
            return p.frame;
        default:
            return std::nullopt;
    }
}

// The F0 of Schlick's formula that has the value F.
double schlick_f0(double F, double cosine) {
    const double m = std::pow(1 - cosine, 5);
    return m < 1 ? (F - m) / (1 - m) : F;
}

struct ModelRow {
    std::string_view name;
    std::vector<double> p;
    std::string_view mdf, smith;  // "": the model has its own
};

std::optional<ModelRow> model_row(const f64::SurfaceMaterial& s, double F, double cosine) {
    const double p0 = s.lobe.p0, p1 = s.lobe.p1, f0 = schlick_f0(F, cosine);
    const std::string_view mdf = s.lobe.mdf >= 0 ? name_of(static_cast<Mdf>(s.lobe.mdf)) : "";
    switch (s.brdf) {
        case f64::kBrdfMicrofacet:
            return ModelRow{"microfacet", {p0, p1, f0}, mdf, "correlated"};
        case f64::kBrdfMicrofacetSeparable:
            return ModelRow{"microfacet", {p0, p1, f0}, mdf, "separable"};
        case f64::kBrdfAshikhminShirley:
            return ModelRow{"ashikhmin-shirley", {p0, p1, f0}, "", ""};
        case f64::kBrdfWardGmd:
            return ModelRow{"ward-gmd", {F, p0, p1}, "", ""};
        case f64::kBrdfWard:
            return ModelRow{"ward", {F, p0, p1}, "", ""};
        case f64::kBrdfWardDuer:
            return ModelRow{"ward-duer", {F, p0, p1}, "", ""};
        case f64::kBrdfCookTorrance:
            if (p0 != p1) return std::nullopt;
            return ModelRow{"cook-torrance", {1.0, p0, f0}, "", ""};
        case f64::kBrdfPhong:
            return ModelRow{"phong", {s.cosine.ks * F, s.cosine.n}, "", ""};
        case f64::kBrdfLafortune:
            return ModelRow{"lafortune",
                            {s.cosine.ks * F, s.cosine.c.x, s.cosine.c.y, s.cosine.c.z, s.cosine.n},
                            "",
                            ""};
        default:
            return std::nullopt;
    }
}

std::span<const ShapeParameter> parameters_of(const ModelRow& row) {
    if (row.name == "microfacet")
        return microfacet_model(mdf_named(row.mdf), Smith::correlated).parameters;
    for (const BrdfModel& model : brdf_models())
        if (model.name == row.name) return model.parameters;
    return {};
}

bool within(std::span<const ShapeParameter> parameters, std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!(values[i] >= parameters[i].low && values[i] <= parameters[i].high)) return false;
    return true;
}

std::string joined(std::initializer_list<double> values) {
    return fmt::format("{}", fmt::join(values, ","));
}

}  // namespace

std::string csv_header() {
    return "brdf,ix,iy,iz,ox,oy,oz,p0,p1,p2,p3,p4,mdf,smith,method,channel,f_specular";
}

std::optional<std::string> csv_rows(const LobeReport& report, const MethodReport& method) {
    const PointLobe& lobe = method.lobe;
    if (!lobe.has_meaning() || !report.surface.reflects()) return std::nullopt;
    const f64::Perturbation p = lobe.seen_from(report.to_eye);
    const std::optional<f64::Frame> frame = frame_of_row(lobe, p);
    if (!frame) return std::nullopt;
    const f64::vec3 wi = f64::frame_to_local(*frame, lobe.local(report.to_light));
    const f64::vec3 wo = f64::frame_to_local(*frame, lobe.local(report.to_eye));
    const double cosine = f64::half_angle_cosine(wi, wo);
    std::string rows;
    for (int c = 0; c < 3; ++c) {
        std::optional<ModelRow> row = model_row(lobe.surface(), method.F[c], cosine);
        if (!row || !within(parameters_of(*row), row->p)) return std::nullopt;
        std::string parameters;
        for (std::size_t i = 0; i < kMostBrdfParameters; ++i)
            parameters += i < row->p.size() ? fmt::format(",{}", row->p[i]) : ",";
        rows += fmt::format("{},{},{}{},{},{},{},{},{}\n", row->name, joined({wi.x, wi.y, wi.z}),
                            joined({wo.x, wo.y, wo.z}), parameters, row->mdf, row->smith,
                            name_of(method.method), kChannels[static_cast<std::size_t>(c)],
                            method.f_specular[c]);
    }
    return rows;
}

std::string mdf_csv_header() {
    return "mdf,p0,p1,method,nx,ny,nz,hx,hy,hz,D_shown";
}

std::optional<std::string> mdf_csv_row(const LobeReport& report, const MethodReport& method) {
    const PointLobe& lobe = method.lobe;
    if (report.surface.exemplar || !lobe.has_half_vectors() || !report.surface.reflects())
        return std::nullopt;
    const f64::Lobe& shape = lobe.surface().lobe;
    const std::array<double, 2> numbers = {shape.p0, shape.p1};
    const auto mdf = static_cast<Mdf>(shape.mdf);
    if (!within(mdf_parameters(mdf), numbers)) return std::nullopt;
    const f64::Perturbation p = lobe.seen_from(report.to_eye);
    const f64::vec3 h = lobe.local(report.half);
    return fmt::format("{},{},{},{},{},{}\n", name_of(mdf), joined({shape.p0, shape.p1}),
                       name_of(static_cast<Method>(p.method)), joined({p.n.x, p.n.y, p.n.z}),
                       joined({h.x, h.y, h.z}), method.D);
}

}  // namespace burnish::viewer

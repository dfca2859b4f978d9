#include "jobs/models/eval.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <exception>
#include <type_traits>
#include <vector>

#include "burnish/brdf_models.hpp"
#include "burnish/error.hpp"
#include "burnish/mdf.hpp"
#include "core/csv_columns.hpp"
#include "jobs/models/measured_lobe.hpp"
#include "models/batch/mdf_batch.hpp"

namespace burnish {
namespace {

constexpr std::array<std::string_view, 2> kPrecisionNames = {"f32", "f64"};
constexpr std::string_view kMicrofacet = "microfacet";

// ---- reading and writing of both tables ---------------------------------------------------------

template <typename Float>
Float shape_parameter(const CsvRow& row, std::size_t column, const ShapeParameter& parameter) {
    const auto expected = [&] {
        return fmt::format("{} from {} to {}", parameter.name, parameter.low, parameter.high);
    };
    if (row.text(column).empty()) row.fail(column, expected(), "nothing");
    const auto value = row.number<Float>(column);
    if (value < static_cast<Float>(parameter.low) || value > static_cast<Float>(parameter.high)) {
        row.fail(column, expected(), shown(row.text(column)));
    }
    return value;
}

// A unit direction from three columns.
template <typename Float>
Direction<Float> direction(const CsvRow& row, std::size_t first_column) {
    Direction<Float> v{row.number<Float>(first_column), row.number<Float>(first_column + 1),
                       row.number<Float>(first_column + 2)};
    if (!make_unit(v)) row.fail(first_column, "the start of a direction", "a zero vector");
    return v;
}

// The shortest digits that read back as the same number.
template <typename Float>
void append_value(const CsvRow& row, std::size_t column, Float value, std::string& line) {
    if (!std::isfinite(value)) {
        row.fail(column, fmt::format("a value that f{} can hold", 8 * sizeof(Float)),
                 "a larger one");
    }
    std::array<char, 32> digits;  // the longest double takes 24
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    line.append(",").append(digits.data(), end);
}

// ---- mdf ----------------------------------------------------------------------------------------

namespace mdf_column {
enum : std::size_t { mdf, p0, p1, method, nx, ny, nz, hx, hy, hz };
}

constexpr std::array<std::string_view, 10> kMdfReads = {"mdf", "p0", "p1", "method", "nx",
                                                        "ny",  "nz", "hx", "hy",     "hz"};
constexpr std::array<std::string_view, 3> kMdfAdds = {"D", "D_proj", "D_conserving"};

// Rows of one distribution and method, to be evaluated together.
template <typename Float>
struct MdfGroup {
    std::vector<std::size_t> rows;
    std::array<std::vector<Float>, 8> in;   // p0 p1 nx ny nz hx hy hz
    std::array<std::vector<Float>, 3> out;  // in the order of kMdfAdds

    void add(std::size_t row, Float p0, Float p1, Direction<Float> n, Direction<Float> h) {
        rows.push_back(row);
        const Float values[] = {p0, p1, n.x, n.y, n.z, h.x, h.y, h.z};
        for (std::size_t i = 0; i < in.size(); ++i) in[i].push_back(values[i]);
    }
    void evaluate(Mdf mdf, Method method) {
        for (auto& column : out) column.resize(rows.size());
        mdf_values(mdf, method,
                   MdfRows<Float>{in[0], in[1], {in[2], in[3], in[4]}, {in[5], in[6], in[7]}},
                   MdfResults<Float>{out[0], out[1], out[2]});
    }
};

template <typename Float>
class MdfGroups {
  public:
    void add(const CsvRow& row, std::size_t index) {
        namespace column = mdf_column;
        const std::size_t mdf = row.choice(column::mdf, mdf_names());
        const std::size_t method = row.choice(column::method, method_names());
        const auto parameters = mdf_parameters(static_cast<Mdf>(mdf));
        const auto p0 = shape_parameter<Float>(row, column::p0, parameters[0]);
        const auto p1 = shape_parameter<Float>(row, column::p1, parameters[1]);
        const auto n = direction<Float>(row, column::nx);
        const auto h = direction<Float>(row, column::hx);
        if (!(n.z > Float(0))) {
            row.fail(column::nz, "a normal of the upper hemisphere, nz > 0",
                     shown(row.text(column::nz)));
        }
        groups_[mdf * method_names().size() + method].add(index, p0, p1, n, h);
    }
    // The values of all added rows, in the order of the rows.
    std::vector<std::array<Float, 3>> values(std::size_t count) {
        std::vector<std::array<Float, 3>> result(count);
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            MdfGroup<Float>& group = groups_[g];
            group.evaluate(static_cast<Mdf>(g / method_names().size()),
                           static_cast<Method>(g % method_names().size()));
            for (std::size_t i = 0; i < group.rows.size(); ++i) {
                result[group.rows[i]] = {group.out[0][i], group.out[1][i], group.out[2][i]};
            }
        }
        return result;
    }

  private:
    std::vector<MdfGroup<Float>> groups_{mdf_names().size() * method_names().size()};
};

template <typename Float>
void add_mdf_values(std::span<const CsvRow> rows, std::span<std::string> added) {
    MdfGroups<Float> groups;
    std::size_t good = 0;
    std::exception_ptr bad;
    try {
        for (; good < rows.size(); ++good) groups.add(rows[good], good);
    } catch (...) {
        bad = std::current_exception();  // rethrown after the earlier rows are written
    }
    const auto values = groups.values(good);
    for (std::size_t i = 0; i < good; ++i) {
        for (const Float value : values[i]) {
            append_value(rows[i], mdf_column::mdf, value, added[i]);
        }
    }
    if (bad) std::rethrow_exception(bad);
}

// ---- brdf ---------------------------------------------------------------------------------------

namespace brdf_column {
enum : std::size_t { brdf, ix, iy, iz, ox, oy, oz, p0, p1, p2, p3, p4, mdf, smith };
}
static_assert(brdf_column::p4 - brdf_column::p0 + 1 == kMostBrdfParameters);

constexpr std::array<std::string_view, 7> kBrdfReads = {"brdf", "ix", "iy", "iz", "ox", "oy", "oz"};
constexpr std::array<std::string_view, 7> kBrdfMayRead = {"p0", "p1",  "p2",   "p3",
                                                          "p4", "mdf", "smith"};
constexpr std::array<std::string_view, 4> kBrdfAdds = {"f", "f_r", "f_g", "f_b"};

const BrdfModel& brdf_model(const CsvRow& row) {
    namespace column = brdf_column;
    const std::size_t named = row.choice(column::brdf, brdf_table_names());
    if (named < brdf_models().size()) return brdf_models()[named];
    const auto mdf = static_cast<Mdf>(row.choice(column::mdf, mdf_names()));
    const auto smith = row.text(column::smith).empty()
                           ? Smith::correlated
                           : static_cast<Smith>(row.choice(column::smith, smith_names()));
    return microfacet_model(mdf, smith);
}

template <typename Float>
BrdfFunction<Float> function_of(const BrdfModel& model) {
    if constexpr (std::is_same_v<Float, float>) return model.value_f32;
    if constexpr (std::is_same_v<Float, double>) return model.value_f64;
}

// A measured material is evaluated in double precision, whichever the table has.
template <typename Float>
void append_measured(const CsvRow& row, MeasuredFiles& files, bool rgb, std::string& line) {
    namespace column = brdf_column;
    const auto wi = direction<double>(row, column::ix), wo = direction<double>(row, column::ox);
    RglBrdf::Rgb f{};
    try {
        f = measured_f(files.at(std::string(row.text(column::brdf))), wi, wo);
    } catch (const Error& error) {
        row.fail(column::brdf, "a measured material", error.what());
    }
    append_value(row, column::brdf, static_cast<Float>(luminance_of(f)), line);
    if (!rgb) return;
    for (const double value : f) append_value(row, column::brdf, static_cast<Float>(value), line);
}

template <typename Float>
void append_brdf_value(const CsvRow& row, bool rgb, std::string& line) {
    namespace column = brdf_column;
    const BrdfModel& model = brdf_model(row);
    std::array<Float, kMostBrdfParameters> p{};
    for (std::size_t i = 0; i < model.parameters.size(); ++i) {
        p[i] = shape_parameter<Float>(row, column::p0 + i, model.parameters[i]);
    }
    const auto wi = direction<Float>(row, column::ix);
    const auto wo = direction<Float>(row, column::ox);
    const Float f = function_of<Float>(model)(p, wi, wo);
    for (int i = 0; i < (rgb ? 4 : 1); ++i) append_value(row, column::brdf, f, line);
}

template <typename Float>
void add_brdf_values(std::span<const CsvRow> rows, std::span<std::string> added,
                     MeasuredFiles& files, bool rgb) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (names_measured(rows[i].text(brdf_column::brdf))) {
            append_measured<Float>(rows[i], files, rgb, added[i]);
        } else {
            append_brdf_value<Float>(rows[i], rgb, added[i]);
        }
    }
}

}  // namespace

std::span<const std::string_view> precision_names() {
    return kPrecisionNames;
}

std::span<const std::string_view> brdf_table_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const BrdfModel& model : brdf_models()) all.push_back(model.name);
        all.push_back(kMicrofacet);
        return all;
    }();
    return names;
}

void eval_mdf_table(const EvalRequest& request, const Progress& progress) {
    const bool single = request.precision == Precision::f32;
    const CsvTask task{
        kMdfReads, {}, kMdfAdds, single ? add_mdf_values<float> : add_mdf_values<double>};
    add_csv_columns(request.input, request.output, task, progress);
}

void eval_brdf_table(const EvalRequest& request, const Progress& progress) {
    const bool single = request.precision == Precision::f32;
    MeasuredFiles files;
    const auto evaluate = [&](std::span<const CsvRow> rows, std::span<std::string> added) {
        single ? add_brdf_values<float>(rows, added, files, request.rgb)
               : add_brdf_values<double>(rows, added, files, request.rgb);
    };
    const CsvTask task{kBrdfReads, kBrdfMayRead,
                       std::span(kBrdfAdds).first(request.rgb ? kBrdfAdds.size() : 1), evaluate};
    add_csv_columns(request.input, request.output, task, progress);
}

}  // namespace burnish

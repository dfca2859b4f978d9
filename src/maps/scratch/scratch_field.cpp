#include "maps/scratch/scratch_field.hpp"

#include <cmath>

#include "core/constants.hpp"

namespace burnish {

namespace {

DoubleAngle of_angle(double radians) {
    return {std::cos(2.0 * radians), std::sin(2.0 * radians)};
}

DoubleAngle unit(double c, double s) {
    const double length = std::hypot(c, s);
    // Below this length the codes of a picture are gray within rounding: a step of 8 bits is 0.008.
    if (!(length > 0.02)) return {};
    return {c / length, s / length};
}

// Converts arrows, (r, g) = (1 + d) / 2 with y up, to lines in double angle. Opposite arrows are
// the same line, and only lines can be averaged.
Image double_angle_of(const Image& picture, bool is_double) {
    Image field(picture.width, picture.height, 2);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const float* from = picture.at(x, y);
            const double r = 2.0 * static_cast<double>(from[0]) - 1.0;
            const double g = 2.0 * static_cast<double>(from[1]) - 1.0;
            const DoubleAngle line = is_double ? unit(r, g) : unit(r * r - g * g, 2.0 * r * g);
            const bool none = !is_double && std::hypot(r, g) < 0.02;
            field.at(x, y)[0] = none ? 0.0f : static_cast<float>(line.c);
            field.at(x, y)[1] = none ? 0.0f : static_cast<float>(line.s);
        }
    }
    return field;
}

}  // namespace

double DoubleAngle::angle() const {
    return 0.5 * std::atan2(s, c);
}

double sample_tile(const Image& image, int channel, TilePoint p) {
    const int w = image.width, h = image.height;
    const double x = (p.x - std::floor(p.x)) * w - 0.5, y = (p.y - std::floor(p.y)) * h - 0.5;
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    const int x0 = (static_cast<int>(std::floor(x)) + w) % w, x1 = (x0 + 1) % w;
    const int y0 = (static_cast<int>(std::floor(y)) + h) % h, y1 = (y0 + 1) % h;
    const auto value = [&](int column, int row) {
        return static_cast<double>(image.at(column, row)[channel]);
    };
    return (1.0 - fy) * ((1.0 - fx) * value(x0, y0) + fx * value(x1, y0)) +
           fy * ((1.0 - fx) * value(x0, y1) + fx * value(x1, y1));
}

GrainField::GrainField(const ScratchLayer& layer, const ScratchInputs& inputs)
    : kind_(layer.field), turn_(layer.angle_deg * kDegree) {
    if (kind_ == ScratchField::image)
        image_ = double_angle_of(inputs.direction, inputs.direction_is_double_angle);
}

bool GrainField::full_face() const {
    return kind_ == ScratchField::circular || kind_ == ScratchField::radial;
}

DoubleAngle GrainField::unturned(TilePoint p) const {
    const double x = p.x - 0.5, up = 0.5 - p.y;
    switch (kind_) {
        case ScratchField::random:
            return {};
        case ScratchField::constant:
            return {1.0, 0.0};
        case ScratchField::circular:
        case ScratchField::radial: {
            const double squared = x * x + up * up;
            if (squared == 0.0) return {};
            const double sign = kind_ == ScratchField::radial ? 1.0 : -1.0;
            return {sign * (x * x - up * up) / squared, sign * 2.0 * x * up / squared};
        }
        case ScratchField::image:
            return unit(sample_tile(image_, 0, p), sample_tile(image_, 1, p));
    }
    return {};
}

DoubleAngle GrainField::at(TilePoint p) const {
    const DoubleAngle field = unturned(p);
    if (!field || turn_ == 0.0) return field;
    const DoubleAngle turn = of_angle(turn_);
    return {field.c * turn.c - field.s * turn.s, field.c * turn.s + field.s * turn.c};
}

double GrainField::curvature_at(TilePoint p) const {
    if (kind_ != ScratchField::circular && kind_ != ScratchField::radial &&
        kind_ != ScratchField::image)
        return 0.0;
    const DoubleAngle here = at(p);
    if (!here) return 0.0;
    if (kind_ != ScratchField::image) {
        // Lines at a constant angle to the radius are logarithmic spirals: curvature sin(a) / r.
        const double x = p.x - 0.5, up = 0.5 - p.y;
        const double r2 = x * x + up * up, a = here.angle();
        return (x * std::sin(a) - up * std::cos(a)) / r2;
    }
    // A central difference over 1/64 of the tile, precise enough for hand-painted fields.
    constexpr double kStep = 1.0 / 128.0;
    const double dx = kStep * std::cos(here.angle()), dy = -kStep * std::sin(here.angle());
    const DoubleAngle before = at({p.x - dx, p.y - dy}), after = at({p.x + dx, p.y + dy});
    if (!before || !after) return 0.0;
    const double turned = 0.5 * std::atan2(after.s * before.c - after.c * before.s,
                                           after.c * before.c + after.s * before.s);
    return turned / (2.0 * kStep);
}

}  // namespace burnish

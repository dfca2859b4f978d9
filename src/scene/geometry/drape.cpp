#include "scene/geometry/drape.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/ext/vector_int3.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace burnish {

namespace {

// The cloth is a meter square; the plinth it hangs over is round, its top at y = 0, with a rounded
// rim. The plinth itself is not part of the mesh.
constexpr float kSide = 1.0f;
constexpr float kRadius = 0.22f, kRim = 0.14f;

// Positions of the cloth's nodes, `nodes` a side, row after row: columns along the warp (+x at
// rest), rows along the weft (+z at rest).
struct Sheet {
    int nodes = 0;
    std::vector<glm::vec3> now, before;

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(nodes) +
               static_cast<std::size_t>(column);
    }
    float spacing() const { return kSide / static_cast<float>(nodes - 1); }
};

// One family of threads: each node and the node (columns, rows) further keep their distance.
// `stiffness` is the fraction of the error that one pass corrects.
struct Threads {
    int columns, rows;
    float stiffness;
};

// Warp and weft hardly stretch. Shear is soft, which makes cloth hang in cones. The threads over
// two nodes resist bending.
constexpr Threads kThreads[] = {{1, 0, 1.0f},  {0, 1, 1.0f}, {1, 1, 0.7f},
                                {-1, 1, 0.7f}, {2, 0, 0.3f}, {0, 2, 0.3f}};

// `backwards` walks the nodes in the opposite order. Alternating the order keeps it from pushing
// the cloth off the plinth.
void pull(Sheet& cloth, const Threads& threads, bool backwards) {
    const float rest = cloth.spacing() * std::hypot(static_cast<float>(threads.columns),
                                                    static_cast<float>(threads.rows));
    const int first = std::max(0, -threads.columns);
    const int end = cloth.nodes - std::max(0, threads.columns);
    const int rows = cloth.nodes - threads.rows;
    for (int j = 0; j < rows; ++j) {
        const int row = backwards ? rows - 1 - j : j;
        for (int i = first; i < end; ++i) {
            const int column = backwards ? end - 1 - (i - first) : i;
            glm::vec3& a = cloth.now[cloth.index(column, row)];
            glm::vec3& b = cloth.now[cloth.index(column + threads.columns, row + threads.rows)];
            const glm::vec3 between = b - a;
            // Coincident nodes have no direction to separate in; 1 micrometer keeps the division
            // finite.
            const float length = std::max(glm::length(between), 1e-6f);
            const glm::vec3 step = between * (0.5f * threads.stiffness * (1.0f - rest / length));
            a += step;
            b -= step;
        }
    }
}

// Moves nodes out of the plinth, an endless column with a rounded rim. Nodes that touch it are held
// by friction.
void push_out(Sheet& cloth) {
    constexpr float kFriction = 0.3f;
    for (std::size_t i = 0; i < cloth.now.size(); ++i) {
        glm::vec3& p = cloth.now[i];
        const float distance = std::hypot(p.x, p.z);
        if (p.y >= 0.0f || distance >= kRadius) continue;
        // The nearest point of the core, which is the plinth without the rim's thickness.
        const float core = std::min(1.0f, (kRadius - kRim) / std::max(distance, 1e-6f));
        const glm::vec3 nearest(p.x * core, std::min(p.y, -kRim), p.z * core);
        const glm::vec3 away = p - nearest;
        const float depth = glm::length(away);
        if (depth >= kRim) continue;
        // A node inside the core leaves upwards, because the cloth came from above.
        const glm::vec3 normal = depth > 0.0f ? away / depth : glm::vec3(0.0f, 1.0f, 0.0f);
        p = depth > 0.0f ? nearest + normal * kRim : glm::vec3(p.x, 0.0f, p.z);
        const glm::vec3 moved = p - cloth.before[i];
        p -= kFriction * (moved - normal * glm::dot(moved, normal));
    }
}

// Two nodes of different parts of the cloth that may touch before the next search.
struct Contact {
    std::size_t a, b;
};

// Layers of the cloth keep this many spacings between their nodes: more than half the diagonal of a
// square of four nodes, so that no node slips between the nodes of another layer.
constexpr float kApart = 0.9f;

// Nodes in buckets by the cell of space that they are in. Cells are as wide as `reach`, so that
// whatever is within reach of a node is in its own cell or in one of the 26 about it.
class Buckets {
  public:
    Buckets(const Sheet& cloth, float reach) : cloth_(cloth), reach_(reach), starts_(kCount + 1) {
        for (const glm::vec3& p : cloth.now) ++starts_[bucket(cell_of(p)) + 1];
        for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
        std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
        nodes_.resize(cloth.now.size());
        for (std::size_t i = 0; i < cloth.now.size(); ++i)
            nodes_[next[bucket(cell_of(cloth.now[i]))]++] = i;
    }
    // Calls visit(b) for every node b after a that is within reach of it.
    template <typename Visit>
    void within_reach(std::size_t a, const Visit& visit) const {
        const glm::vec3 p = cloth_.now[a];
        const glm::ivec3 cell = cell_of(p);
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const glm::ivec3 other = cell + glm::ivec3(dx, dy, dz);
                    const std::size_t at = bucket(other);
                    for (std::size_t k = starts_[at]; k < starts_[at + 1]; ++k) {
                        const glm::vec3 q = cloth_.now[nodes_[k]];
                        if (nodes_[k] <= a || glm::dot(q - p, q - p) >= reach_ * reach_) continue;
                        // Cells share buckets: one that holds two of them is looked at twice.
                        if (cell_of(q) == other) visit(nodes_[k]);
                    }
                }
    }

  private:
    static constexpr std::size_t kCount = 8192;
    glm::ivec3 cell_of(glm::vec3 p) const { return glm::ivec3(glm::floor(p / reach_)); }
    static std::size_t bucket(glm::ivec3 cell) {
        // Three large primes (Teschner et al. 2003, "Optimized spatial hashing").
        const auto mixed = static_cast<std::uint32_t>(cell.x) * 73856093u ^
                           static_cast<std::uint32_t>(cell.y) * 19349663u ^
                           static_cast<std::uint32_t>(cell.z) * 83492791u;
        return mixed % kCount;
    }

    const Sheet& cloth_;
    float reach_;
    std::vector<std::size_t> starts_, nodes_;
};

// Pairs that are within `reach` of each other.
std::vector<Contact> contacts_of(const Sheet& cloth, float reach) {
    const Buckets buckets(cloth, reach);
    const auto nodes = static_cast<std::size_t>(cloth.nodes);
    const auto steps = [](std::size_t i, std::size_t j) { return i > j ? i - j : j - i; };
    std::vector<Contact> contacts;
    for (std::size_t a = 0; a < cloth.now.size(); ++a)
        buckets.within_reach(a, [&](std::size_t b) {
            // Nodes up to two steps apart are kept apart by the threads.
            if (std::max(steps(a / nodes, b / nodes), steps(a % nodes, b % nodes)) > 2)
                contacts.push_back({a, b});
        });
    return contacts;
}

// Contacts that are searched again only after a node has moved far enough to make a new one.
class Contacts {
  public:
    const std::vector<Contact>& now(const Sheet& cloth) {
        const float apart = kApart * cloth.spacing();
        // Two nodes that were 2 apart and have moved by 0.5 apart each are apart still.
        if (moved_by(cloth, 0.5f * apart)) {
            contacts_ = contacts_of(cloth, 2.0f * apart);
            searched_at_ = cloth.now;
        }
        return contacts_;
    }

  private:
    bool moved_by(const Sheet& cloth, float distance) const {
        if (searched_at_.empty()) return true;
        for (std::size_t i = 0; i < cloth.now.size(); ++i) {
            const glm::vec3 moved = cloth.now[i] - searched_at_[i];
            if (glm::dot(moved, moved) > distance * distance) return true;
        }
        return false;
    }

    std::vector<Contact> contacts_;
    std::vector<glm::vec3> searched_at_;
};

void keep_apart(Sheet& cloth, const std::vector<Contact>& contacts) {
    const float apart = kApart * cloth.spacing();
    for (const Contact& contact : contacts) {
        glm::vec3& a = cloth.now[contact.a];
        glm::vec3& b = cloth.now[contact.b];
        const glm::vec3 between = b - a;
        const float length = std::max(glm::length(between), 1e-6f);  // as in `pull`
        if (length >= apart) continue;
        const glm::vec3 step = between * (0.5f * (1.0f - apart / length));
        a += step;
        b -= step;
    }
}

// Position-based dynamics (Mueller et al. 2007, "Position based dynamics"): Verlet steps, then
// passes over the threads, always in the same order so that every run gives the same cloth.
void simulate(Sheet& cloth, int steps, int passes) {
    constexpr float kStep = 1.0f / 60.0f, kGravity = -1.5f, kKept = 0.97f;
    Contacts contacts;
    for (int step = 0; step < steps; ++step) {
        for (std::size_t i = 0; i < cloth.now.size(); ++i) {
            const glm::vec3 moved = (cloth.now[i] - cloth.before[i]) * kKept;
            cloth.before[i] = cloth.now[i];
            cloth.now[i] += moved + glm::vec3(0.0f, kGravity * kStep * kStep, 0.0f);
        }
        for (int pass = 0; pass < passes; ++pass) {
            for (const Threads& threads : kThreads) pull(cloth, threads, pass % 2 == 1);
            keep_apart(cloth, contacts.now(cloth));
            push_out(cloth);
        }
    }
}

// Flat above the table and off its middle, with low waves: perfect symmetry would give folds that
// no cloth has.
Sheet lay_out(int nodes) {
    Sheet cloth;
    cloth.nodes = nodes;
    for (int row = 0; row < nodes; ++row) {
        for (int column = 0; column < nodes; ++column) {
            const float x = cloth.spacing() * static_cast<float>(column) - 0.5f * kSide;
            const float z = cloth.spacing() * static_cast<float>(row) - 0.5f * kSide;
            const float wave =
                std::sin(9.0f * x + 4.0f * z) + std::sin(5.0f * x - 11.0f * z + 1.0f);
            cloth.now.emplace_back(x + 0.020f, 0.01f + 0.003f * wave, z - 0.014f);
        }
    }
    cloth.before = cloth.now;
    return cloth;
}

// Weights of the uniform cubic B-spline and of its derivative at t in [0,1] between the middle two
// of four control points.
struct Weights {
    float value[4], slope[4];
};

Weights spline_weights(float t) {
    const float s = 1.0f - t;
    return {{s * s * s / 6.0f, (3.0f * t * t * t - 6.0f * t * t + 4.0f) / 6.0f,
             (3.0f * s * s * s - 6.0f * s * s + 4.0f) / 6.0f, t * t * t / 6.0f},
            {-0.5f * s * s, 1.5f * t * t - 2.0f * t, 2.0f * s - 1.5f * s * s, 0.5f * t * t}};
}

// A node; beyond the hem, the mirror image of the inner node about the hem, so that the surface
// ends there.
glm::vec3 control_point(const Sheet& cloth, int column, int row) {
    const int last = cloth.nodes - 1;
    const int c = std::clamp(column, 0, last), r = std::clamp(row, 0, last);
    const glm::vec3 hem = cloth.now[cloth.index(c, r)];
    if (c == column && r == row) return hem;
    return 2.0f * hem - cloth.now[cloth.index(std::clamp(2 * c - column, 0, last),
                                              std::clamp(2 * r - row, 0, last))];
}

struct SheetPoint {
    glm::vec3 position, along_u, along_v;
};

// The surface whose control points are the nodes: curvature is continuous, so highlights are
// smooth at any resolution, and the tangents are its exact derivatives.
SheetPoint surface_at(const Sheet& cloth, float u, float v) {
    const float x = u * static_cast<float>(cloth.nodes - 1);
    const float y = v * static_cast<float>(cloth.nodes - 1);
    const int column = std::min(static_cast<int>(x), cloth.nodes - 2);
    const int row = std::min(static_cast<int>(y), cloth.nodes - 2);
    const Weights wx = spline_weights(x - static_cast<float>(column));
    const Weights wy = spline_weights(y - static_cast<float>(row));
    SheetPoint out{glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f)};
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
            const glm::vec3 p = control_point(cloth, column + i - 1, row + j - 1);
            out.position += p * (wx.value[i] * wy.value[j]);
            out.along_u += p * (wx.slope[i] * wy.value[j]);
            out.along_v += p * (wx.value[i] * wy.slope[j]);
        }
    }
    return out;
}

Sheet refined(const Sheet& coarse, int nodes) {
    Sheet fine;
    fine.nodes = nodes;
    for (int row = 0; row < nodes; ++row)
        for (int column = 0; column < nodes; ++column)
            fine.now.push_back(
                surface_at(coarse, static_cast<float>(column) / static_cast<float>(nodes - 1),
                           static_cast<float>(row) / static_cast<float>(nodes - 1))
                    .position);
    fine.before = fine.now;
    return fine;
}

// Coarse first: long waves need many steps, which are cheap on a coarse grid.
Sheet hang() {
    Sheet cloth = lay_out(25);
    simulate(cloth, 300, 12);
    cloth = refined(cloth, 49);
    simulate(cloth, 90, 10);
    cloth = refined(cloth, 73);
    simulate(cloth, 30, 10);
    return cloth;
}

}  // namespace

Mesh make_drape(int triangles) {
    static const Sheet cloth = hang();
    const double quads = (triangles > 0 ? triangles : 40000) / 2.0;
    const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(quads))));
    Mesh mesh;
    for (int row = 0; row <= side; ++row) {
        for (int column = 0; column <= side; ++column) {
            const float u = static_cast<float>(column) / static_cast<float>(side);
            const float v = static_cast<float>(row) / static_cast<float>(side);
            const SheetPoint at = surface_at(cloth, u, v);
            const glm::vec3 tangent = glm::normalize(at.along_u);
            mesh.positions.push_back(at.position);
            mesh.normals.push_back(glm::normalize(glm::cross(at.along_v, at.along_u)));
            mesh.tangents.emplace_back(tangent, 1.0f);
            mesh.texcoord0.emplace_back(u, v);
        }
    }
    const auto columns = static_cast<std::uint32_t>(side) + 1;
    for (std::uint32_t j = 0; j + 1 < columns; ++j) {
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const std::uint32_t a = j * columns + i, b = a + columns;
            mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    }
    return mesh;
}

}  // namespace burnish

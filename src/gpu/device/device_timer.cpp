#include "gpu/device/device_timer.hpp"

namespace burnish::gpu {

namespace {

// GL_TIME_ELAPSED and GL_TIME_ELAPSED_EXT are the same number.
static_assert(GL_TIME_ELAPSED == GL_TIME_ELAPSED_EXT);

constexpr double kNanosecond = 1e-9;

}  // namespace

DeviceTimer::DeviceTimer(const Context& context) : disjoint_(context.is_es()) {
    if (disjoint_ && !context.has_extension("GL_EXT_disjoint_timer_query")) return;
    GLint bits = 0;
    if (disjoint_) {
        glGetQueryivEXT(GL_TIME_ELAPSED_EXT, GL_QUERY_COUNTER_BITS_EXT, &bits);
    } else {
        glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    }
    if (bits == 0) return;  // allowed by the specification: the query exists but counts nothing
    if (disjoint_) {
        glGenQueriesEXT(1, &query_);
    } else {
        glGenQueries(1, &query_);
    }
}

DeviceTimer::~DeviceTimer() {
    if (query_ == 0) return;
    if (disjoint_) {
        glDeleteQueriesEXT(1, &query_);
    } else {
        glDeleteQueries(1, &query_);
    }
}

void DeviceTimer::begin() const {
    if (query_ == 0) return;
    if (disjoint_) {
        GLint forgotten = 0;  // reading it clears earlier disjoint events
        glGetIntegerv(GL_GPU_DISJOINT_EXT, &forgotten);
        glBeginQueryEXT(GL_TIME_ELAPSED_EXT, query_);
    } else {
        glBeginQuery(GL_TIME_ELAPSED, query_);
    }
}

void DeviceTimer::end() const {
    if (query_ == 0) return;
    if (disjoint_) {
        glEndQueryEXT(GL_TIME_ELAPSED_EXT);
    } else {
        glEndQuery(GL_TIME_ELAPSED);
    }
}

std::optional<double> DeviceTimer::seconds() const {
    if (query_ == 0) return std::nullopt;
    GLuint64 nanoseconds = 0;
    if (!disjoint_) {
        glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
        return kNanosecond * static_cast<double>(nanoseconds);
    }
    glGetQueryObjectui64vEXT(query_, GL_QUERY_RESULT_EXT, &nanoseconds);
    GLint disturbed = 0;
    glGetIntegerv(GL_GPU_DISJOINT_EXT, &disturbed);
    if (disturbed != 0) return std::nullopt;
    return kNanosecond * static_cast<double>(nanoseconds);
}

}  // namespace burnish::gpu

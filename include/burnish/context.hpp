// An OpenGL context: one of our own without a window (EGL on a device or on Mesa's surfaceless
// platform), or one that the host program has made.
//
// Threads: a context is current on one thread at a time, and everything made in it is used on that
// thread. Lifetime: whatever was made in a context must be destroyed before it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "burnish/api.hpp"

namespace burnish {
namespace BURNISH_API gpu {

class AlbedoTables;
class ClothStore;
class ProgramCache;

struct DeviceInfo {
    int index = 0;  // for --gl-device
    std::string
        description;  // renderer string where EGL tells it without a context, else EGL's name
    bool software = false;
};

// Devices EGL can open, in EGL's order. Empty when EGL offers none. Never throws. Mesa writes a
// warning to standard error for a device that it cannot open unless the environment variable
// EGL_LOG_LEVEL is `fatal`; the library leaves the environment alone, the command line sets it.
std::vector<DeviceInfo> list_devices();

enum class GlApi {
    automatic,  // OpenGL 3.3 core where offered, else ES 3.0
    desktop,
    es
};

class Context {
  public:
    // A context of our own, current on this thread. Several may follow each other or live side by
    // side. device -1: the first hardware device that works, else Mesa's software renderer; devices
    // that did not work are named by warnings(). Throws Error in words when no context can be made.
    explicit Context(int device = -1, GlApi api = GlApi::automatic);

    // The context that is current on this thread, made by GLFW, Qt, SDL, a browser or EGL: OpenGL
    // 3.3 or ES 3.0 at least. It is not destroyed with this object, which must end while it is
    // current. Throws Error when none is current or its version is too old.
    //
    // A renderer in an adopted context restores, at the end of each of its calls, the state that
    // hosts rely on: framebuffers, viewport, scissor, blending, depth, stencil, culling, color and
    // depth masks, polygon offset, sRGB encoding, program, vertex array, array and pixel buffers,
    // alignment of pixels, active texture unit. It does not restore the textures of units 0 to 25,
    // leaves these units without a sampler object, and leaves cube maps seamless. It expects the
    // state that draw_state.hpp does not name to be OpenGL's default.
    static Context adopt_current();

    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    // Throws Error when the context is lost; for an adopted one, when another context is current:
    // only its host can change that.
    void make_current();
    bool is_adopted() const { return handles_ == nullptr; }

    const std::string& renderer() const { return renderer_; }  // GL_RENDERER
    const std::string& version() const { return version_; }    // GL_VERSION
    bool is_es() const { return is_es_; }
    bool is_software() const { return is_software_; }
    int max_texture_size() const { return max_texture_size_; }
    bool has_extension(const char* name) const;  // "GL_EXT_..."
    const std::vector<std::string>& warnings() const { return warnings_; }

    // What all renderers of the context share: each program is compiled once, each table made once.
    ProgramCache& programs() const { return *programs_; }
    AlbedoTables& albedos() const { return *albedos_; }
    ClothStore& cloths() const { return *cloths_; }

  private:
    struct Handles;
    struct Adopt {};
    explicit Context(Adopt);
    void describe();

    std::unique_ptr<Handles> handles_;  // none: adopted
    void* adopted_ = nullptr;
    std::string renderer_, version_;
    std::vector<std::string> warnings_;
    bool is_es_ = false;
    bool is_software_ = false;
    int max_texture_size_ = 0;
    std::unique_ptr<ProgramCache> programs_;
    std::unique_ptr<AlbedoTables> albedos_;
    std::unique_ptr<ClothStore> cloths_;
};

}  // namespace gpu
}  // namespace burnish

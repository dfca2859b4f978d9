// An OpenGL context without a window: EGL on a device or on Mesa's surfaceless platform.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace burnish::gpu {

struct DeviceInfo {
    int index = 0;            // for --gl-device
    std::string description;  // renderer string where it can be learnt cheaply, else the EGL name
    bool software = false;
};

// Devices EGL can open, in EGL's order. Empty when EGL offers none. Never throws.
std::vector<DeviceInfo> list_devices();

enum class GlApi {
    automatic,  // OpenGL 3.3 core where offered, else ES 3.0
    desktop,
    es
};

// One context, current on the thread that made it. Contexts may follow each other or live side by
// side; whatever was made in one must be destroyed before it.
//
// device -1: the first hardware device that works, else Mesa's software renderer; what did not work
// on the way is told by warnings(). Throws Error in words when no context can be made.
class Context {
  public:
    explicit Context(int device = -1, GlApi api = GlApi::automatic);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    void make_current();
    const std::string& renderer() const { return renderer_; }  // GL_RENDERER
    const std::string& version() const { return version_; }    // GL_VERSION
    bool is_es() const { return is_es_; }
    bool is_software() const { return is_software_; }
    int max_texture_size() const { return max_texture_size_; }
    bool has_extension(const char* name) const;  // "GL_EXT_..."
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    struct Handles;
    void describe();

    std::unique_ptr<Handles> handles_;
    std::string renderer_, version_;
    std::vector<std::string> warnings_;
    bool is_es_ = false;
    bool is_software_ = false;
    int max_texture_size_ = 0;
};

}  // namespace burnish::gpu

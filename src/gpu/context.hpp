// An OpenGL context without a window: EGL on a device or on Mesa's surfaceless platform.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace burnish::gpu {

struct DeviceInfo {
    int index = 0;             // for --gl-device
    std::string description;   // renderer string where it can be learnt cheaply, else the EGL name
    bool software = false;
};

// Devices EGL can open, in EGL's order. Empty when EGL offers none. Never throws.
std::vector<DeviceInfo> list_devices();

// One context, current on the thread that made it. OpenGL 3.3 core where offered, else ES 3.0.
// device -1: the first hardware device, else Mesa's software renderer. Throws Error in words when
// no context can be made.
class Context {
  public:
    explicit Context(int device = -1);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    void make_current();
    const std::string& renderer() const { return renderer_; }  // GL_RENDERER
    const std::string& version() const { return version_; }    // GL_VERSION
    bool is_es() const { return is_es_; }
    bool is_software() const { return is_software_; }
    int max_texture_size() const { return max_texture_size_; }

  private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
    std::string renderer_, version_;
    bool is_es_ = false;
    bool is_software_ = false;
    int max_texture_size_ = 0;
};

}  // namespace burnish::gpu

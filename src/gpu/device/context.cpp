#include "burnish/context.hpp"

#include <dlfcn.h>
#include <epoxy/egl.h>

#include <array>
#include <map>
#include <mutex>
#include <optional>

#include "burnish/error.hpp"
#include "gpu/device/albedo_tables.hpp"
#include "gpu/device/cloth_store.hpp"
#include "gpu/device/gl.hpp"
#include "gpu/device/program.hpp"

namespace burnish::gpu {
namespace {

constexpr EGLint kRendererName = 0x335F;  // EGL_RENDERER_EXT, newer than epoxy's headers

bool has_client_extension(const char* name) {
    return epoxy_has_egl_extension(EGL_NO_DISPLAY, name);
}

std::vector<EGLDeviceEXT> egl_devices() {
    const bool enumerates = has_client_extension("EGL_EXT_device_enumeration") ||
                            has_client_extension("EGL_EXT_device_base");
    if (!enumerates || !has_client_extension("EGL_EXT_platform_device") ||
        !has_client_extension("EGL_EXT_platform_base")) {
        return {};
    }
    EGLint count = 0;
    if (!eglQueryDevicesEXT(0, nullptr, &count) || count <= 0) return {};
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (!eglQueryDevicesEXT(count, devices.data(), &count)) return {};
    devices.resize(static_cast<std::size_t>(count));
    return devices;
}

std::string device_string(EGLDeviceEXT device, EGLint name) {
    const char* text = eglQueryDeviceStringEXT(device, name);
    return text == nullptr ? std::string() : std::string(text);
}

DeviceInfo describe_device(EGLDeviceEXT device, int index) {
    DeviceInfo info;
    info.index = index;
    const std::string extensions = device_string(device, EGL_EXTENSIONS);
    const auto has = [&](const char* name) { return extensions.find(name) != std::string::npos; };
    info.software = has("EGL_MESA_device_software");
    if (has("EGL_EXT_device_query_name")) {
        info.description = device_string(device, kRendererName);
    }
    if (info.description.empty() && has("EGL_EXT_device_drm")) {
        info.description = device_string(device, EGL_DRM_DEVICE_FILE_EXT);
    }
    if (info.description.empty()) {
        info.description = info.software ? "Mesa software renderer" : "EGL device";
    }
    return info;
}

// A display is shared by all contexts of its device, and eglTerminate ends it for all of them. The
// first context initializes it and the last terminates it.
class SharedDisplay {
  public:
    explicit SharedDisplay(EGLDisplay display) : display_(display) {
        if (display == EGL_NO_DISPLAY) throw Error("EGL has no display for it");
        const std::lock_guard lock(mutex());
        if (users()[display] == 0 && !eglInitialize(display, nullptr, nullptr)) {
            users().erase(display);
            throw Error("EGL cannot initialize it");
        }
        ++users()[display];
    }
    ~SharedDisplay() {
        const std::lock_guard lock(mutex());
        if (--users()[display_] > 0) return;
        users().erase(display_);
        eglTerminate(display_);
    }
    SharedDisplay(const SharedDisplay&) = delete;
    SharedDisplay& operator=(const SharedDisplay&) = delete;
    EGLDisplay get() const { return display_; }

  private:
    static std::mutex& mutex() {
        static std::mutex one;
        return one;
    }
    static std::map<EGLDisplay, int>& users() {
        static std::map<EGLDisplay, int> one;
        return one;
    }
    EGLDisplay display_;
};

}  // namespace

std::vector<DeviceInfo> list_devices() {
    std::vector<DeviceInfo> list;
    for (EGLDeviceEXT device : egl_devices()) {
        list.push_back(describe_device(device, static_cast<int>(list.size())));
    }
    return list;
}

struct Context::Handles {
    explicit Handles(EGLDisplay egl_display) : display(egl_display) {}
    ~Handles() {
        if (context == EGL_NO_CONTEXT) return;
        if (eglGetCurrentContext() == context) {
            eglMakeCurrent(display.get(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        release();
    }
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;

    bool try_api(bool es);
    void release();

    SharedDisplay display;
    EGLContext context = EGL_NO_CONTEXT;
    EGLSurface surface = EGL_NO_SURFACE;
};

void Context::Handles::release() {
    eglDestroyContext(display.get(), context);
    if (surface != EGL_NO_SURFACE) eglDestroySurface(display.get(), surface);
    context = EGL_NO_CONTEXT;
    surface = EGL_NO_SURFACE;
}

// Makes a context of one API and makes it current; false when the display has none.
bool Context::Handles::try_api(bool es) {
    EGLDisplay d = display.get();
    const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                          es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (!eglChooseConfig(d, wanted.data(), &config, 1, &found) || found < 1) return false;
    if (!eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) return false;
    const std::array<EGLint, 7> desktop = {EGL_CONTEXT_MAJOR_VERSION,
                                           3,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           3,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_NONE};
    const std::array<EGLint, 3> embedded = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    context = eglCreateContext(d, config, EGL_NO_CONTEXT, es ? embedded.data() : desktop.data());
    if (context == EGL_NO_CONTEXT) return false;
    if (!epoxy_has_egl_extension(d, "EGL_KHR_surfaceless_context")) {
        const std::array<EGLint, 5> one_pixel = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        surface = eglCreatePbufferSurface(d, config, one_pixel.data());
    }
    if (eglMakeCurrent(d, surface, surface, context)) return true;
    release();
    return false;
}

namespace {

struct Candidate {
    std::string name;
    EGLDeviceEXT device = EGL_NO_DEVICE_EXT;  // none: the surfaceless platform
};

EGLDisplay open_display(const Candidate& candidate) {
    if (candidate.device != EGL_NO_DEVICE_EXT) {
        return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, candidate.device, nullptr);
    }
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}

// Candidate displays, in the order in which they are tried.
std::vector<Candidate> candidates(int wanted) {
    const std::vector<EGLDeviceEXT> devices = egl_devices();
    const std::vector<DeviceInfo> infos = list_devices();
    const int count = static_cast<int>(devices.size());
    if (wanted >= count || wanted < -1) {
        throw Error("--gl-device", "",
                    count == 0 ? std::string("no number, since EGL lists no devices")
                               : "a number from 0 to " + std::to_string(count - 1),
                    std::to_string(wanted));
    }
    std::vector<Candidate> list;
    if (wanted >= 0) {
        const auto i = static_cast<std::size_t>(wanted);
        return {{infos[i].description, devices[i]}};
    }
    for (const bool software : {false, true}) {
        for (std::size_t i = 0; i < devices.size(); ++i) {
            if (infos[i].software == software) list.push_back({infos[i].description, devices[i]});
        }
    }
    if (has_client_extension("EGL_MESA_platform_surfaceless") &&
        has_client_extension("EGL_EXT_platform_base")) {
        list.push_back({"Mesa surfaceless", EGL_NO_DEVICE_EXT});
    }
    return list;
}

// The context that is current on this thread, whoever made it; null: none. GLX is queried only
// where the host has loaded it, so that neither X11 nor its library is needed.
void* current_context() {
    if (EGLContext context = eglGetCurrentContext(); context != EGL_NO_CONTEXT) return context;
    void* library = dlopen("libGL.so.1", RTLD_LAZY | RTLD_NOLOAD);
    if (library == nullptr) return nullptr;
    using Current = void* (*)();
    const auto current = reinterpret_cast<Current>(dlsym(library, "glXGetCurrentContext"));
    void* context = current != nullptr ? current() : nullptr;
    dlclose(library);
    return context;
}

// The context that is current on this thread, as EGL knows it.
class CurrentContext {
  public:
    EGLContext context() const { return context_; }
    void restore() const {
        if (context_ != EGL_NO_CONTEXT) eglMakeCurrent(display_, draw_, read_, context_);
    }

  private:
    EGLContext context_ = eglGetCurrentContext();
    EGLDisplay display_ = eglGetCurrentDisplay();
    EGLSurface draw_ = eglGetCurrentSurface(EGL_DRAW), read_ = eglGetCurrentSurface(EGL_READ);
};

bool is_software_name(const std::string& renderer) {
    for (const char* name : {"llvmpipe", "softpipe", "SwiftShader", "swrast"}) {
        if (renderer.find(name) != std::string::npos) return true;
    }
    return false;
}

}  // namespace

Context::Context(int device, GlApi api) {
    std::string tried;
    for (const Candidate& candidate : candidates(device)) {
        std::string reason = "it offers neither OpenGL 3.3 core nor OpenGL ES 3.0";
        try {
            handles_ = std::make_unique<Handles>(open_display(candidate));
            is_es_ = api == GlApi::es || !handles_->try_api(false);
            if (!is_es_ || (api != GlApi::desktop && handles_->try_api(true))) {
                describe();
                return;
            }
        } catch (const Error& error) {
            reason = error.what();
        }
        handles_.reset();
        warnings_.push_back("cannot render with " + candidate.name + ": " + reason);
        tried += (tried.empty() ? "" : "; ") + candidate.name + ": " + reason;
    }
    throw Error("no OpenGL context can be made (" +
                (tried.empty() ? "EGL offers no device and no surfaceless platform" : tried) + ")");
}

void Context::describe() {
    const auto text = [](GLenum name) {
        const GLubyte* value = glGetString(name);
        return value == nullptr ? std::string() : reinterpret_cast<const char*>(value);
    };
    renderer_ = text(GL_RENDERER);
    version_ = text(GL_VERSION);
    is_software_ = is_software_name(renderer_);
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &max_texture_size_);
    programs_ = std::make_unique<ProgramCache>(is_es_ ? ShaderDialect::es300 : ShaderDialect::gl330,
                                               has_extension("GL_KHR_parallel_shader_compile"));
    albedos_ = std::make_unique<AlbedoTables>();
    cloths_ = std::make_unique<ClothStore>();
}

Context::Context(Adopt) : adopted_(current_context()) {
    if (adopted_ == nullptr) throw Error("no OpenGL context is current that could be adopted");
    is_es_ = !epoxy_is_desktop_gl();
    const int least = is_es_ ? 30 : 33;
    if (epoxy_gl_version() < least) {
        throw Error("OpenGL", "", is_es_ ? "ES 3.0 at least" : "3.3 at least",
                    reinterpret_cast<const char*>(glGetString(GL_VERSION)));
    }
    describe();
}

Context Context::adopt_current() {
    return Context(Adopt{});
}

Context::~Context() {
    const CurrentContext before;
    try {
        make_current();
    } catch (const Error&) {  // the context is lost, with everything in it
    }
    albedos_.reset();
    programs_.reset();
    if (handles_ != nullptr && before.context() != handles_->context) before.restore();
}

void Context::make_current() {
    if (is_adopted()) {
        if (current_context() != adopted_)
            throw Error("the adopted OpenGL context of " + renderer_ + " is not current");
        return;
    }
    EGLDisplay display = handles_->display.get();
    eglBindAPI(is_es_ ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    if (!eglMakeCurrent(display, handles_->surface, handles_->surface, handles_->context)) {
        throw Error("the OpenGL context of " + renderer_ + " can no longer be made current");
    }
}

bool Context::has_extension(const char* name) const {
    return epoxy_has_gl_extension(name);
}

}  // namespace burnish::gpu

#include "viewer/window/window.hpp"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "burnish/error.hpp"

namespace burnish::viewer {
namespace {

std::string last_glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text == nullptr ? "no reason given" : one_line(text);
}

template <typename... Arguments>
void on_event(GLFWwindow* window, Arguments...) {
    static_cast<Window*>(glfwGetWindowUserPointer(window))->note_event();
}

}  // namespace

Window::Window(const WindowOptions& options) {
    if (glfwInit() != GLFW_TRUE)
        throw Error("burnish view", "display",
                    "an X display (DISPLAY; ssh -X gives one); `burnish render` needs none",
                    last_glfw_error());
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    // Where the driver can tell of a reset.
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_MAXIMIZED, options.maximized ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "burnish");
    handle_ = glfwCreateWindow(options.width, options.height, "Burnish", nullptr, nullptr);
    if (handle_ == nullptr) {
        const std::string reason = last_glfw_error();
        glfwTerminate();
        throw Error("burnish view", "OpenGL",
                    "3.3 or newer (Mesa's software renderer: LIBGL_ALWAYS_SOFTWARE=1)", reason);
    }
    if (options.x && options.y && !options.maximized)
        glfwSetWindowPos(handle_, *options.x, *options.y);
    glfwMakeContextCurrent(handle_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(handle_, this);
    // ImGui's own callbacks call these on, as they are installed first.
    glfwSetCursorPosCallback(handle_, on_event<double, double>);
    glfwSetMouseButtonCallback(handle_, on_event<int, int, int>);
    glfwSetScrollCallback(handle_, on_event<double, double>);
    glfwSetKeyCallback(handle_, on_event<int, int, int, int>);
    glfwSetCharCallback(handle_, on_event<unsigned>);
    glfwSetFramebufferSizeCallback(handle_, on_event<int, int>);
    glfwSetWindowRefreshCallback(handle_, on_event<>);
    glfwSetDropCallback(handle_, [](GLFWwindow* w, int count, const char** paths) {
        auto* window = static_cast<Window*>(glfwGetWindowUserPointer(w));
        window->events_ = true;
        for (int i = 0; i < count; ++i) window->dropped_.emplace_back(paths[i]);
    });
}

Window::~Window() {
    glfwDestroyWindow(handle_);
    glfwTerminate();
}

bool Window::should_close() const {
    return glfwWindowShouldClose(handle_) == GLFW_TRUE;
}
void Window::close() {
    glfwSetWindowShouldClose(handle_, GLFW_TRUE);
}
void Window::poll() {
    glfwPollEvents();
}
void Window::wait(double seconds) {
    glfwWaitEventsTimeout(seconds);
}
void Window::wake() {
    glfwPostEmptyEvent();
}
void Window::swap() {
    glfwSwapBuffers(handle_);
}

int Window::width() const {
    int w = 0, h = 0;
    glfwGetFramebufferSize(handle_, &w, &h);
    return std::max(w, 1);
}
int Window::height() const {
    int w = 0, h = 0;
    glfwGetFramebufferSize(handle_, &w, &h);
    return std::max(h, 1);
}

float Window::content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(handle_, &x, &y);
    return std::clamp(std::max(x, y), 0.5f, 4.0f);
}

WindowOptions Window::placement() const {
    WindowOptions options;
    int x = 0, y = 0;
    glfwGetWindowSize(handle_, &options.width, &options.height);
    glfwGetWindowPos(handle_, &x, &y);
    options.x = x;
    options.y = y;
    options.maximized = glfwGetWindowAttrib(handle_, GLFW_MAXIMIZED) == GLFW_TRUE;
    return options;
}

void Window::resize(int width, int height) {
    glfwSetWindowSize(handle_, width, height);
}
void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(handle_, title.c_str());
}
std::string Window::clipboard() const {
    const char* text = glfwGetClipboardString(handle_);
    return text == nullptr ? "" : text;
}
void Window::set_clipboard(const std::string& text) {
    glfwSetClipboardString(handle_, text.c_str());
}

bool Window::context_was_reset() const {
    if (pretends_reset_) return true;
    static const bool can_tell = epoxy_gl_version() >= 45 ||
                                 epoxy_has_gl_extension("GL_KHR_robustness") ||
                                 epoxy_has_gl_extension("GL_ARB_robustness");
    return can_tell && glGetGraphicsResetStatus() != GL_NO_ERROR;
}

bool Window::take_events() {
    return std::exchange(events_, false);
}
std::vector<std::string> Window::take_dropped() {
    return std::exchange(dropped_, {});
}

}  // namespace burnish::viewer

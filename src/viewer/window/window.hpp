// A window with an OpenGL context, by GLFW.
//
// Threads: the main thread; wake() may be called from any. Lifetime: one window at a time.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace burnish::viewer {

struct WindowOptions {
    int width = 1280, height = 720;  // screen coordinates
    std::optional<int> x, y;
    bool maximized = false;
};

class Window {
  public:
    // Throws Error in words when there is no display or no OpenGL 3.3.
    explicit Window(const WindowOptions& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return handle_; }
    bool should_close() const;
    void close();
    void poll();
    void wait(double seconds);  // until an event, or so long
    static void wake();         // ends a wait
    void swap();

    int width() const;  // device pixels
    int height() const;
    float content_scale() const;  // device pixels of a desktop's unit: 2 on HiDPI
    WindowOptions placement() const;
    void resize(int width, int height);
    void set_title(const std::string& title);
    std::string clipboard() const;
    void set_clipboard(const std::string& text);

    // The device or its driver was reset: what the context held is gone. False where the driver does not tell.
    bool context_was_reset() const;
    void pretend_reset() { pretends_reset_ = true; }  // for tests

    // Whether an event has come since the last call.
    void note_event() { events_ = true; }
    bool take_events();
    // Files dropped on the window since the last call.
    std::vector<std::string> take_dropped();

  private:
    GLFWwindow* handle_ = nullptr;
    bool events_ = true, pretends_reset_ = false;
    std::vector<std::string> dropped_;
};

}  // namespace burnish::viewer

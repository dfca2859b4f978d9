// A context that the host program made: adopted, left as it was, not destroyed.
#include <epoxy/egl.h>

#include <array>
#include <map>
#include <memory>

#include "edited_scenes.hpp"
#include "gpu/device/gl.hpp"
#include "gpu/device/handles.hpp"
#include "gpu_fixture.hpp"

namespace burnish::test {
namespace {

using gpu::Context;
using gpu::Renderer;

// The host: a context and habits of its own, on the device that a Context of ours is made on. So it is
// there wherever one of ours is.
class Host {
  public:
    // Throws Error where no context of the API can be made.
    explicit Host(bool es) : ours_(-1, es ? gpu::GlApi::es : gpu::GlApi::desktop) {
        display_ = eglGetCurrentDisplay();
        const EGLContext model = eglGetCurrentContext();
        const bool with_surface = eglGetCurrentSurface(EGL_DRAW) != EGL_NO_SURFACE;
        EGLint id = 0, found = 0;
        eglQueryContext(display_, model, EGL_CONFIG_ID, &id);
        const std::array<EGLint, 3> same = {EGL_CONFIG_ID, id, EGL_NONE};
        EGLConfig config = nullptr;
        eglChooseConfig(display_, same.data(), &config, 1, &found);
        eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
        const std::array<EGLint, 5> version = {EGL_CONTEXT_MAJOR_VERSION, 3,
                                               EGL_CONTEXT_MINOR_VERSION, es ? 0 : 3, EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version.data());
        if (with_surface) {
            const std::array<EGLint, 5> one_pixel = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
            surface_ = eglCreatePbufferSurface(display_, config, one_pixel.data());
        }
    }
    ~Host() {
        release();
        eglDestroyContext(display_, context_);
        if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
    }
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    bool make_current() const { return eglMakeCurrent(display_, surface_, surface_, context_); }
    void release() const {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    bool is_current() const { return eglGetCurrentContext() == context_; }
    Context& ours() { return ours_; }

  private:
    Context ours_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

// Skips in words where there is no context, as every test of a GPU.
std::unique_ptr<Host> host_of(bool es) {
    try {
        return std::make_unique<Host>(es);
    } catch (const Error& error) {
        [&] { GTEST_SKIP() << "SKIPPED, nothing was tested: " << error.what(); }();
        return nullptr;
    }
}

// The state that Context::adopt_current promises to restore, by its names.
std::map<GLenum, std::array<GLint, 4>> host_state(bool es) {
    std::map<GLenum, std::array<GLint, 4>> state;
    for (const GLenum name : {GL_BLEND,
                              GL_DEPTH_TEST,
                              GL_STENCIL_TEST,
                              GL_SCISSOR_TEST,
                              GL_CULL_FACE,
                              GL_POLYGON_OFFSET_FILL,
                              GL_VIEWPORT,
                              GL_SCISSOR_BOX,
                              GL_COLOR_WRITEMASK,
                              GL_DEPTH_WRITEMASK,
                              GL_DRAW_FRAMEBUFFER_BINDING,
                              GL_READ_FRAMEBUFFER_BINDING,
                              GL_BLEND_SRC_RGB,
                              GL_BLEND_DST_RGB,
                              GL_BLEND_SRC_ALPHA,
                              GL_BLEND_DST_ALPHA,
                              GL_BLEND_EQUATION_RGB,
                              GL_BLEND_EQUATION_ALPHA,
                              GL_DEPTH_FUNC,
                              GL_STENCIL_FUNC,
                              GL_STENCIL_REF,
                              GL_STENCIL_VALUE_MASK,
                              GL_STENCIL_WRITEMASK,
                              GL_STENCIL_FAIL,
                              GL_STENCIL_PASS_DEPTH_FAIL,
                              GL_STENCIL_PASS_DEPTH_PASS,
                              GL_STENCIL_BACK_FUNC,
                              GL_STENCIL_BACK_WRITEMASK,
                              GL_CULL_FACE_MODE,
                              GL_FRONT_FACE,
                              GL_POLYGON_OFFSET_FACTOR,
                              GL_POLYGON_OFFSET_UNITS,
                              GL_CURRENT_PROGRAM,
                              GL_VERTEX_ARRAY_BINDING,
                              GL_ARRAY_BUFFER_BINDING,
                              GL_PIXEL_PACK_BUFFER_BINDING,
                              GL_PIXEL_UNPACK_BUFFER_BINDING,
                              GL_ACTIVE_TEXTURE,
                              GL_PACK_ALIGNMENT,
                              GL_UNPACK_ALIGNMENT,
                              GL_UNPACK_ROW_LENGTH}) {
        glGetIntegerv(static_cast<GLenum>(name), state[static_cast<GLenum>(name)].data());
    }
    if (!es) state[GL_FRAMEBUFFER_SRGB][0] = glIsEnabled(GL_FRAMEBUFFER_SRGB);
    return state;
}

// As unlike the defaults, and the renderer's wishes, as a host may leave it.
void set_host_state(bool es, GLuint framebuffer, GLuint array, GLuint buffer) {
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glBlendEquationSeparate(GL_FUNC_SUBTRACT, GL_FUNC_ADD);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_NEVER);
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 3, 0x0F);
    glStencilMask(0x01);
    glStencilOp(GL_ZERO, GL_INVERT, GL_INCR);
    glEnable(GL_SCISSOR_TEST);
    glScissor(1, 2, 3, 4);
    glViewport(5, 6, 7, 8);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glFrontFace(GL_CW);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(7.0f, 9.0f);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    if (!es) glEnable(GL_FRAMEBUFFER_SRGB);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindVertexArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    glActiveTexture(GL_TEXTURE3);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 17);
}

class Adopt : public testing::TestWithParam<bool> {};

TEST_P(Adopt, DrawsAsInAContextOfOurOwnAndLeavesTheHostItsState) {
    const bool es = GetParam();
    const std::unique_ptr<Host> host = host_of(es);
    if (!host) return;
    ASSERT_TRUE(host->make_current());
    const Scene scene = busy_scene();
    const Environment sky = sky_environment();
    RenderSettings o = small_picture(40, 30, 2);
    o.image_light_samples = 4;
    o.shadows = true;
    o.ground = true;
    const Camera camera = camera_on_z(4.0f, 1.1f);
    Image found;
    {
        Context context = Context::adopt_current();
        EXPECT_TRUE(context.is_adopted());
        EXPECT_EQ(context.is_es(), es);
        const gpu::Framebuffer framebuffer;
        const gpu::VertexArray array;
        const gpu::Buffer buffer;
        set_host_state(es, framebuffer.get(), array.get(), buffer.get());
        const auto before = host_state(es);
        const auto expect_kept = [&](const char* call) {
            for (const auto& [name, value] : host_state(es))
                EXPECT_EQ(value, before.at(name)) << call << ", state " << std::hex << name;
            EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << call;
        };
        Renderer renderer(context, scene, &sky);
        expect_kept("Renderer");
        found = renderer.render(camera, o);
        expect_kept("render");
        renderer.begin(camera, o);
        expect_kept("begin");
        renderer.add_sample();
        expect_kept("add_sample");
        renderer.update_texture(1, scene.textures[1]);
        expect_kept("update_texture");
        renderer.add_sample();
        renderer.prepare(o);
        expect_kept("prepare");
        GLint sampler = 1;
        glGetIntegerv(GL_SAMPLER_BINDING, &sampler);
        EXPECT_EQ(sampler, 0);
    }
    EXPECT_TRUE(host->is_current());  // neither destroyed nor put away
    EXPECT_NE(glGetString(GL_VERSION), nullptr);
    host->release();
    Renderer renderer(host->ours(), scene, &sky);
    EXPECT_TRUE(equal_pictures(found, renderer.render(camera, o)));
}

INSTANTIATE_TEST_SUITE_P(Api, Adopt, testing::Bool(),
                         [](const auto& es) { return es.param ? "es" : "desktop"; });

TEST(AdoptNothing, IsRefusedInWords) {
    if (const std::unique_ptr<Host> host = host_of(false)) {
        host->release();
        EXPECT_THROW(Context::adopt_current(), Error);
    }
}

TEST(AdoptTwo, ACallUnderAnotherContextIsRefusedInWords) {
    const std::unique_ptr<Host> first = host_of(false), second = host_of(false);
    if (!first || !second) return;
    ASSERT_TRUE(second->make_current());
    ASSERT_TRUE(first->make_current());
    Context context = Context::adopt_current();
    Renderer renderer(context, busy_scene(), nullptr);
    ASSERT_TRUE(second->make_current());
    EXPECT_THROW(renderer.render(camera_on_z(), small_picture(8, 8)), Error);
    ASSERT_TRUE(first->make_current());
    EXPECT_NO_THROW(renderer.render(camera_on_z(), small_picture(8, 8)));
}

}  // namespace
}  // namespace burnish::test

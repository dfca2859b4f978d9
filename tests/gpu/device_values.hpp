// Random inputs, and the values that a fragment shader computes from them: one value per pixel,
// read back as floats.
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "burnish/f32.hpp"
#include "gpu/device/gl.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"
#include "gpu_fixture.hpp"

namespace burnish::test {

inline constexpr int kInputSide = 48;  // 2304 inputs a case
inline constexpr int kInputCount = kInputSide * kInputSide;

using Row = std::array<float, 4>;

// xyz: unit directions; w: uniform in [0, 1).
struct Inputs {
    std::vector<Row> wi, wo, n;

    Inputs() {
        std::mt19937 random(12345);
        std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
        const auto direction = [&](float lowest_z) {
            const float z = lowest_z + (1 - lowest_z) * uniform(random);
            const float phi = 6.2831853f * uniform(random);
            const float s = std::sqrt(1 - z * z);
            return Row{s * std::cos(phi), s * std::sin(phi), z, uniform(random)};
        };
        for (int i = 0; i < kInputCount; ++i) {
            wi.push_back(direction(0.02f));
            wo.push_back(direction(0.02f));
            n.push_back(direction(0.6f));  // tilts up to 53 degrees
        }
    }
};

inline f32::vec3 xyz(const Row& v) {
    return {v[0], v[1], v[2]};
}

class DeviceValues : public GpuTest {
  protected:
    // `stage`: a fragment shader that reads u_wi (xyz, xi.x), u_wo (xyz, xi.y), u_n (xyz, select)
    // at its pixel, and u_alpha. `defines`: whole lines.
    std::vector<Row> values_of(const std::string& stage, const std::string& defines,
                               glm::vec2 alpha = glm::vec2(0.3f)) {
        const gpu::ShaderDialect dialect =
            context->is_es() ? gpu::ShaderDialect::es300 : gpu::ShaderDialect::gl330;
        gpu::Program program(gpu::assemble_stage(dialect, "", "shaders/fullscreen.vert"),
                             gpu::assemble_text(dialect, defines, "test.frag", stage));
        const gpu::GlTexture textures[4];
        const gpu::Framebuffer target;
        const gpu::VertexArray empty;
        upload(0, textures[0], inputs.wi);
        upload(1, textures[1], inputs.wo);
        upload(2, textures[2], inputs.n);
        upload(3, textures[3], {});
        glBindFramebuffer(GL_FRAMEBUFFER, target.get());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                               textures[3].get(), 0);
        glViewport(0, 0, kInputSide, kInputSide);
        program.use();
        program.set("u_wi", 0);
        program.set("u_wo", 1);
        program.set("u_n", 2);
        program.set("u_alpha", alpha);
        program.set("u_depth", 0.0f);
        glBindVertexArray(empty.get());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<Row> values(kInputCount);
        glReadPixels(0, 0, kInputSide, kInputSide, GL_RGBA, GL_FLOAT, values.data());
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        return values;
    }

    Inputs inputs;

  private:
    static void upload(GLuint unit, const gpu::GlTexture& texture, const std::vector<Row>& values) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, texture.get());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kInputSide, kInputSide, 0, GL_RGBA, GL_FLOAT,
                     values.empty() ? nullptr : values.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
};

}  // namespace burnish::test

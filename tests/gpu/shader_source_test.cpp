#include "gpu/device/shader_source.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "burnish/error.hpp"

namespace burnish::test {
namespace {

using gpu::ShaderDialect;

TEST(ShaderSource, ShadingTextsComeOnceEachAndInOrder) {
    const std::string text =
        gpu::assemble_stage(ShaderDialect::gl330, "#define X 1\n", "shaders/surface.frag").text;
    EXPECT_TRUE(text.starts_with("#version 330 core\n#define X 1\n"));
    std::size_t from = 0;
    for (const gpu::ShaderText& one : gpu::shading_texts()) {
        const std::size_t at = text.find(one.text.substr(0, 60), from);
        ASSERT_NE(at, std::string::npos) << one.name;
        EXPECT_EQ(text.find(one.text.substr(0, 60), at + 1), std::string::npos) << one.name;
        from = at;
    }
    EXPECT_EQ(text.find("#include"), std::string::npos);
}

TEST(ShaderSource, EsHasPrecision) {
    const std::string text =
        gpu::assemble_stage(ShaderDialect::es300, "", "shaders/accumulate.frag").text;
    EXPECT_TRUE(text.starts_with("#version 300 es\nprecision highp float;"));
}

TEST(ShaderSource, UnknownFilesAreErrors) {
    EXPECT_THROW(gpu::assemble_stage(ShaderDialect::gl330, "", "shaders/none.frag"), Error);
}

TEST(ShaderSource, EditedFilesOnDiskWin) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("burnish_shaders_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder / "shaders");
    std::ofstream(folder / "shaders" / "gouraud.frag") << "// edited\n";
    setenv("BURNISH_SHADER_DIR", folder.c_str(), 1);
    const std::string edited =
        gpu::assemble_stage(ShaderDialect::gl330, "", "shaders/gouraud.frag").text;
    const std::string kept =
        gpu::assemble_stage(ShaderDialect::gl330, "", "shaders/accumulate.frag").text;
    unsetenv("BURNISH_SHADER_DIR");
    std::filesystem::remove_all(folder);
    EXPECT_NE(edited.find("// edited"), std::string::npos);
    EXPECT_NE(kept.find("texelFetch"), std::string::npos);
}

}  // namespace
}  // namespace burnish::test

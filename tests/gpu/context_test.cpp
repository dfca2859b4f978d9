#include "burnish/context.hpp"

#include <dirent.h>

#include "gpu_fixture.hpp"

namespace burnish::test {
namespace {

using gpu::Context;

TEST_F(GpuTest, NamesItsDevice) {
    EXPECT_FALSE(context->renderer().empty());
    EXPECT_FALSE(context->version().empty());
    EXPECT_GE(context->max_texture_size(), 2048);  // the minimum of ES 3.0
}

int open_files() {
    int count = 0;
    DIR* folder = opendir("/proc/self/fd");
    if (folder == nullptr) return -1;
    while (readdir(folder) != nullptr) ++count;
    closedir(folder);
    return count;
}

TEST_F(GpuTest, ContextsOneAfterAnotherKeepNoFileOpen) {
    context.reset();
    int before = 0;
    for (int i = 0; i < 8; ++i) {
        const Context one;
        EXPECT_FALSE(one.renderer().empty());
        if (i == 1) before = open_files();  // after the files that the first contexts keep open
        if (i == 7) {
            EXPECT_EQ(open_files(), before);
        }
    }
}

TEST_F(GpuTest, AnOlderContextSurvivesTheEndOfAYoungerOne) {
    { const Context younger; }
    context->make_current();
    EXPECT_GE(context->max_texture_size(), 2048);
    EXPECT_FALSE(context->has_extension("GL_BURNISH_no_such_extension"));
}

TEST(DeviceList, NumbersItsDevices) {
    const auto devices = gpu::list_devices();
    for (std::size_t i = 0; i < devices.size(); ++i) {
        EXPECT_EQ(devices[i].index, static_cast<int>(i));
        EXPECT_FALSE(devices[i].description.empty());
    }
}

TEST(DeviceList, RefusesADeviceThatIsNotThere) {
    try {
        const Context context(1000);
        FAIL() << "made a context on device 1000";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("1000"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace burnish::test

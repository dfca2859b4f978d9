// Loads burnish_codecs.so.
#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <string>

#include "burnish/error.hpp"
#include "burnish/version.hpp"
#include "image/codecs.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModule = "burnish_codecs.so";

// The program or the shared library that this code is in.
fs::path own_file() {
    Dl_info info{};
    if (dladdr(reinterpret_cast<const void*>(&codecs), &info) == 0 || info.dli_fname == nullptr)
        return {};
    std::error_code error;
    // A program started by a bare name is known to the loader by that name.
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    const fs::path named = fs::absolute(info.dli_fname, error);
    return fs::exists(named, error) ? fs::weakly_canonical(named, error) : self;
}

void* open_module(std::string& tried) {
    const fs::path folder = own_file().parent_path();
    for (const char* place : {".", "../lib", BURNISH_LIBRARY_FOLDER}) {
        const fs::path file = (folder / place / kModule).lexically_normal();
        std::error_code error;
        if (!fs::exists(file, error)) continue;
        // Local: its symbols, which are ours too, replace none of the program's. Lazy: most functions
        // of two hundred libraries are never called.
        if (void* module = dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL)) return module;
        tried = one_line(dlerror());
        return nullptr;
    }
    tried = fmt::format("none beside {}", folder.string());
    return nullptr;
}

const Codecs& load() {
    std::string tried;
    void* module = open_module(tried);
    if (module == nullptr)
        throw Error(kModule, "", "the module that reads and writes pictures, as installed", tried);
    using Entry = const Codecs* (*)(const char* version);
    const auto entry = reinterpret_cast<Entry>(dlsym(module, "burnish_codecs"));
    const Codecs* found = entry ? entry(std::string(version()).c_str()) : nullptr;
    if (found == nullptr)
        throw Error(kModule, "", fmt::format("the module of burnish {}", version()),
                    "that of another version");
    return *found;
}

}  // namespace

const Codecs& codecs() {
    // A failure is tried again at the next call.
    static const Codecs& loaded = load();
    return loaded;
}

}  // namespace burnish

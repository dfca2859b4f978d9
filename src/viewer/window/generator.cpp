#include "viewer/window/generator.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>

#include "burnish/error.hpp"
#include "viewer/window/app.hpp"

namespace burnish::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostCacheBytes = std::uintmax_t{1} << 30;

// The material whose scratches the panel tells: the selected one, else the first.
std::string scratches_now(const App& app, std::optional<int> material) {
    return scratches_of(app.editor.stage(), material.value_or(0));
}

}  // namespace

Generator::Generator(const fs::path& state_folder) : choice_(scratch_choice("brushed")) {
    background_.on_done([] { Window::wake(); });
    cache_is_own_ = state_folder.empty();
    if (cache_is_own_) {
        std::error_code error;
        const fs::path folder = fs::temp_directory_path(error);
        cache_ = (error ? fs::path("/tmp") : folder) /
                 fmt::format("burnish-scratches-{}", static_cast<long>(::getpid()));
    } else {
        cache_ = fs::absolute(state_folder) / "scratches";
        prune_scratch_cache(cache_, kMostCacheBytes);
    }
}

Generator::~Generator() {
    background_.stop();
    std::error_code error;
    if (cache_is_own_) fs::remove_all(cache_, error);
}

void Generator::change(App& app, const std::function<void(ScratchChoice&)>& what) {
    changed_ = Clock::now();
    background_.cancel();
    finish_ = false;
    what(choice_);
    try {
        const ScratchRecipe recipe = scratch_recipe(choice_);
        look_ = {coarse_scratches(recipe), app.material, recipe.settings.tile_mm};
        fresh_ = true;
        fault_.clear();
    } catch (const std::exception& error) {
        fault_ = one_line(error.what());
        changed_.reset();
    }
}

void Generator::finish() {
    finish_ = fault_.empty() && look_;
}

void Generator::cancel(App& app) {
    background_.cancel();
    finish_ = false;
    fault_.clear();
    known_ = "?";
    drop(app);
}

void Generator::drop(App& app) {
    look_.reset();
    fresh_ = false;
    changed_.reset();
    app.picture.end_preview(app.editor);
}

void Generator::settle(App& app) {
    background_.poll();
    // Somebody has given the material other scratches, or another normal map, meanwhile.
    if (look_ && known_ != "?" && scratches_now(app, look_->material) != known_) cancel(app);
    if (finish_ && !changed_ && !background_.running()) start(app);
    follow(app);
}

void Generator::start(App& app) {
    finish_ = false;
    background_.start<Full>(
        "scratches",
        [cache = cache_, recipe = scratch_recipe(choice_)](const Progress& progress) {
            const std::string folder = make_cached_scratches(cache, recipe, progress).string();
            return Full{folder, load_scratch(folder, true)};
        },
        [this, &app](Full full) { adopt(app, std::move(full)); },
        [this, &app](const std::string& line) {
            fault_ = line;
            drop(app);
            app.say(line, true);
        });
}

void Generator::adopt(App& app, Full full) {
    const std::string& name = full.folder;
    const std::optional<int> material = look_ ? look_->material : app.material;
    made_[name] = choice_;
    known_ = name;
    app.editor.put_scratch(name, std::move(full.maps));
    app.edit({}, "scratches",
             [&](Document& d) { viewer::set_parameter(d, "scratch", name, material); });
    drop(app);
}

// Undo, another material and another scene bring other scratches: the panel tells theirs.
void Generator::follow(const App& app) {
    if (look_ || working() || app.loading()) return;
    const std::string now = scratches_now(app, app.material);
    if (now == known_) return;
    known_ = now;
    fault_.clear();
    const auto made = made_.find(now);
    try {
        choice_ = made != made_.end() ? made->second
                                      : scratch_choice(now.empty() ? std::string("brushed") : now);
    } catch (const std::exception&) {
        // A folder of maps without their settings: the choice stays what it was.
    }
}

void Generator::show(App& app) {
    if (!look_ || (!fresh_ && app.picture.previewing())) return;
    fresh_ = false;
    try {
        app.picture.preview(scratch_previews(app.editor.stage(), look_->material, look_->tile_mm),
                            look_->maps);
    } catch (const std::exception& error) {
        fault_ = one_line(error.what());
        drop(app);
    }
}

void Generator::shown() {
    if (!changed_ || fresh_) return;
    preview_ms_ = 1000 * std::chrono::duration<double>(Clock::now() - *changed_).count();
    changed_.reset();
}

}  // namespace burnish::viewer

// burnish info: the contents of a file, or the available devices.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "burnish/error.hpp"
#include "cli/commands/commands.hpp"
#include "cli/session.hpp"
#include "jobs/info/info.hpp"

namespace burnish::cli {

void add_info_command(CLI::App& parent, Session&) {
    CLI::App* command = parent.add_subcommand(
        "info",
        "What a model, scene, picture, measured material, draft, rig or folder of maps holds");
    struct Flags {
        std::string input;
        bool devices = false;
    };
    const auto flags = std::make_shared<Flags>();
    command
        ->add_option(
            "input", flags->input,
            "a model, scene, picture, environment, measured material, weaving draft (.wif), rig "
            "(.json, .lp, .dome), folder of maps or builtin:")
        ->type_name("FILE|FOLDER");
    command->add_flag("--devices", flags->devices, "list the GL devices");
    command->callback([flags] {
        if (flags->input.empty() && !flags->devices)
            throw UsageError("info", "", "a file or a folder, or --devices", "neither");
        if (!flags->input.empty()) print(describe_file(flags->input));
        if (flags->devices) print(describe_devices());
    });
}

}  // namespace burnish::cli

// burnish gallery: reproduces the figures of the papers.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "burnish/error.hpp"
#include "cli/commands/commands.hpp"
#include "cli/integer_flag.hpp"
#include "cli/session.hpp"
#include "papers/gallery.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kGalleryFooter = R"(
Writes into DIR a picture for every figure (and an SVG, where it is a plot), gallery.json with all that
was measured, and index.html, which opens from disk.

Examples:
  burnish gallery --list
  burnish gallery -o gallery --quick
  burnish gallery k11-fig9 k12-fig10 -o gallery
  burnish gallery b12-measured --measured folder/of/bsdf -o gallery)";

struct GalleryFlags {
    GalleryRequest request;
    std::string output, measured;
    bool list = false;
};

void list_figures() {
    std::string text;
    for (const GalleryEntry& entry : gallery_entries())
        text += fmt::format("{:<13} {}\n", entry.id, entry.claim);
    print(text);
}

void run_gallery(GalleryFlags& flags, const Session& session) {
    if (flags.list) return list_figures();
    if (flags.output.empty()) throw UsageError("-o", "", "a folder to write into", "none");
    GalleryRequest& request = flags.request;
    request.output = flags.output;
    request.measured = flags.measured;
    request.command = session.command_line();
    const GalleryReport report = make_gallery(request, session.progress());
    print_report(report.warnings, report.written);
}

}  // namespace

void add_gallery_command(CLI::App& parent, Session& session) {
    CLI::App* command = parent.add_subcommand("gallery", "Make the figures of the papers again");
    const auto flags = std::make_shared<GalleryFlags>();
    command->add_option("ids", flags->request.ids, "figures, by the ids of --list; none: all")
        ->type_name("ID");
    command->add_option("-o,--output", flags->output, "folder to write into; made when needed")
        ->type_name("DIR");
    command->add_flag("--list", flags->list, "print the ids and what each figure claims");
    command->add_flag("--quick", flags->request.quick, "small pictures, few samples");
    command
        ->add_option("--measured", flags->measured,
                     "folder of RGL materials (.bsdf) for b12-measured")
        ->type_name("DIR");
    add_gl_device(*command, flags->request.gl_device);
    command->footer(kGalleryFooter);
    command->callback([flags, &session] { run_gallery(*flags, session); });
}

}  // namespace burnish::cli

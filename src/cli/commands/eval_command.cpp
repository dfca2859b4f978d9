#include "cli/commands/eval_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "cli/session.hpp"
#include "core/text.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kTableHelp = R"(
Columns may stand in any order. Further columns, lines that start with # and blank lines are kept
as they are; rows keep their order. Directions need not be unit, they are normalised first. Values
are written with the fewest digits that read back as the same number (at most 17 for f64, 9 for
f32). A row that cannot be evaluated is an error that names its line and column, and leaves an
older output file untouched.)";

struct EvalCommandFlags {
    EvalRequest request;
    std::string precision = "f64";
};

}  // namespace

void add_eval_command(CLI::App& parent, Session& session, const std::string& description,
                      const std::string& columns, bool colors,
                      std::function<void(const EvalRequest&, const Progress&)> evaluate) {
    CLI::App* command = parent.add_subcommand("eval", description);
    const auto flags = std::make_shared<EvalCommandFlags>();
    command->add_option("--in", flags->request.input, "table to read, CSV; - is standard input")
        ->required()
        ->type_name("FILE");
    command
        ->add_option("--out", flags->request.output,
                     "table to write, CSV; - is standard output; may be the table that is read, "
                     "which is then replaced once all of it is done")
        ->required()
        ->type_name("FILE");
    command->add_option("--precision", flags->precision, "f32 or f64: arithmetic and digits")
        ->capture_default_str()
        ->type_name("NAME");
    if (colors)
        command->add_flag("--rgb", flags->request.rgb, "add f_r, f_g and f_b too: f of each color");
    command->footer(columns + kTableHelp);
    command->callback([flags, &session, evaluate = std::move(evaluate)] {
        flags->request.precision = static_cast<Precision>(
            index_of_name(precision_names(), flags->precision, "precision", "--precision"));
        evaluate(flags->request, session.progress());
    });
}

}  // namespace burnish::cli

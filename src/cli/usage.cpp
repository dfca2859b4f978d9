#include "cli/usage.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.hpp"

namespace burnish::cli {
namespace {

using Apps = std::vector<const CLI::App*>;

// The program and the commands that CLI11 recognized, outermost first.
Apps recognized(const CLI::App& root) {
    Apps chain{&root};
    for (Apps::value_type app = &root; !app->get_subcommands().empty();) {
        app = app->get_subcommands().front();
        chain.push_back(app);
    }
    return chain;
}

// The full name of a command: "burnish mdf eval".
std::string path_of(const Apps& chain) {
    std::string path;
    for (const CLI::App* app : chain) path += (path.empty() ? "" : " ") + app->get_name();
    return path;
}

// The prefix of a message after the program's name: "mdf eval: ".
std::string prefix_of(const Apps& chain) {
    if (chain.size() < 2) return "";
    return path_of({chain.begin() + 1, chain.end()}) + ": ";
}

std::vector<std::string> commands_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return names;
}

std::vector<std::string> flags_of(const Apps& chain) {
    std::vector<std::string> names;
    for (const CLI::App* app : chain) {
        for (const CLI::Option* option : app->get_options()) {
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        }
    }
    return names;
}

// The flag of that name, of the command or of those it is under; nullptr: none.
const CLI::Option* flag_in(const Apps& chain, const std::string& name) {
    if (!name.starts_with('-')) return nullptr;
    for (const CLI::App* app : chain)
        if (const CLI::Option* option = app->get_option_no_throw(name)) return option;
    return nullptr;
}

class HelpFormatter : public CLI::Formatter {
  public:
    // CLI11 writes a new line only for names that fill the column: a shorter one by a letter would
    // run into its text.
    std::string make_option_opts(const CLI::Option* option) const override {
        std::string opts = CLI::Formatter::make_option_opts(option);
        constexpr std::size_t kIndent = 2;
        const std::size_t length =
            kIndent + make_option_name(option, option->get_positional()).size() + opts.size();
        return length + 1 == get_column_width() ? opts + " " : opts;
    }
};

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

std::string unknown_word(const Apps& chain, const std::string& word) {
    const bool flag = word.size() > 1 && word.front() == '-';
    const std::vector<std::string> known = flag ? flags_of(chain) : commands_of(*chain.back());
    if (known.empty()) return prefix_of(chain) + "unexpected argument " + shown(word);

    const std::string written = flag ? word.substr(0, word.find('=')) : word;
    const std::vector<std::string_view> views(known.begin(), known.end());
    const std::string nearest(nearest_name(views, written));
    std::string line =
        prefix_of(chain) + "unknown " + (flag ? "option " : "command ") + shown(written);
    if (!nearest.empty()) return line + "; did you mean '" + nearest + "'?";
    if (flag) return line + "; '" + path_of(chain) + " --help' lists them";
    return line + "; there are: " + listed(known);
}

// A missing value: what to give for it, as the help says.
std::string missing_value(const CLI::App& app, const std::string& name) {
    std::string line = name + ": expected a value, found none";
    const CLI::Option* option = app.get_option_no_throw(name);
    if (option == nullptr || option->get_description().empty()) return line;
    const bool flag = name.starts_with('-');
    return line + " (" + (flag ? name + " " : "") + option->get_type_name() + ": " +
           option->get_description() + ")";
}

// Rewords errors of CLI11, which start with the flag, in the form of our other errors.
std::string in_our_words(const CLI::App& app, const CLI::ParseError& error) {
    std::string text = one_line(error.what());
    const std::string flag = text.substr(0, text.find(": "));
    if (error.get_name() == "RequiredError")
        return missing_value(app, text.substr(0, text.find(' ')));
    if (error.get_name() == "ArgumentMismatch") return missing_value(app, flag);
    const std::size_t equals = text.find(" = ");
    if (error.get_name() == "ConversionError" && equals != std::string::npos)
        return text.substr(text.find(": ") + 2, equals - text.find(": ") - 2) +
               ": expected a switch without a value, found " + shown(text.substr(equals + 3));
    return text;
}

}  // namespace

UsageError usage_error(const CLI::App& root, const CLI::ParseError& error) {
    const Apps chain = recognized(root);
    const std::vector<std::string> unknown = root.remaining(true);
    if (!unknown.empty()) return UsageError(unknown_word(chain, unknown.front()));
    return UsageError(prefix_of(chain) + in_our_words(*chain.back(), error));
}

void require_values(const CLI::App& root, int argc, const char* const* argv) {
    Apps chain{&root};
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--") return;
        const CLI::App& app = *chain.back();
        const auto commands = app.get_subcommands(
            [&](const CLI::App* command) { return command->get_name() == word; });
        if (!commands.empty()) {
            chain.push_back(commands.front());
            continue;
        }
        const CLI::Option* option = flag_in(chain, word);
        if (option == nullptr || option->get_items_expected_min() == 0) continue;
        if (++i >= argc) return;
        const std::string next = argv[i];
        if (flag_in(chain, next.substr(0, next.find('='))) != nullptr)
            throw UsageError(prefix_of(chain) + missing_value(app, word));
    }
}

std::shared_ptr<CLI::FormatterBase> help_formatter() {
    return std::make_shared<HelpFormatter>();
}

std::vector<std::string> repeated_flags(const CLI::App& root) {
    std::vector<std::string> lines;
    for (const CLI::App* app : recognized(root)) {
        for (const CLI::Option* option : app->get_options()) {
            const bool last_wins =
                option->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeLast;
            if (!last_wins || option->get_lnames().empty() || option->count() < 2) continue;
            const bool takes_one = option->get_items_expected_max() == 1;
            if (option->get_type_size() == 0 || !takes_one) continue;  // a switch, a list
            lines.push_back("--" + option->get_lnames().front() + ": given " +
                            std::to_string(option->count()) + " times: the last one, " +
                            shown(option->results().back()) + ", holds");
        }
    }
    return lines;
}

void require_command(CLI::App& app) {
    // A missing command is reported by our code: CLI11 reports it too late.
    app.require_subcommand(0, 1);
    app.callback([&app] {
        if (!app.get_subcommands().empty()) return;
        Apps chain{&app};
        for (const CLI::App* parent = app.get_parent(); parent; parent = parent->get_parent()) {
            chain.insert(chain.begin(), parent);
        }
        throw UsageError(prefix_of(chain) +
                         "expected a command, one of: " + listed(commands_of(app)) + "; '" +
                         path_of(chain) + " --help' explains them");
    });
}

}  // namespace burnish::cli

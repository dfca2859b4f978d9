// burnish mdf: microfacet distributions with and without a perturbed normal.
#include <CLI/CLI.hpp>

#include "cli/commands/commands.hpp"
#include "cli/commands/eval_command.hpp"
#include "cli/plot_flags.hpp"
#include "cli/usage.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kMdfColumns = R"(
Reads the columns
  mdf           ashikhmin-shirley, ward, beckmann or ggx
  p0, p1        e_x, e_y (0 to 1000000) for ashikhmin-shirley;
                alpha_x, alpha_y (0.001 to 1.5) for the others
  method        what the perturbed normal does: none, normal-map, gram-schmidt, rotate-exact,
                rotate-approx, rotate-arc, follow-grain, deform-linear, deform-smooth,
                slope-shift or stretch
  nx, ny, nz    the perturbed normal, nz > 0
  hx, hy, hz    the half vector, anywhere
both in the unperturbed tangent space: x tangent, y bitangent, z normal. Adds
  D             as the papers normalise it: Int D dw = 1 for ashikhmin-shirley, peak 1 for ward,
                Int D (n.h) dw = 1 for beckmann and ggx
  D_proj        the unperturbed lobe normalised to Int D (n.h) dw = 1
  D_conserving  D_proj in the energy-conserving form of deform-smooth; D_proj for the others
)";

}  // namespace

void add_mdf_command(CLI::App& parent, Session& session) {
    CLI::App* mdf = parent.add_subcommand("mdf", "Microfacet distributions under a bent normal");
    require_command(*mdf);
    add_eval_command(*mdf, session, "Evaluate a distribution for every row of a table", kMdfColumns,
                     false, eval_mdf_table);
    add_mdf_plot_command(*mdf, session);
}

}  // namespace burnish::cli

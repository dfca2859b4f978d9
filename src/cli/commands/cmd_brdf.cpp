// burnish brdf: reflection models.
#include <CLI/CLI.hpp>

#include "cli/commands/commands.hpp"
#include "cli/commands/eval_command.hpp"
#include "cli/plot_flags.hpp"
#include "cli/usage.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kBrdfColumns = R"(
Reads the columns
  brdf          the model, one of            p0       p1       p2       p3    p4
                  ashikhmin-shirley (2000)   e_x      e_y      F0
                  ashikhmin-shirley-diffuse  Rd       Rs
                  ashikhmin-premoze-shirley  e_x      e_y      F0
                  ward (1992), ward-duer     ks       alpha_x  alpha_y
                  ward-gmd                   ks       alpha_x  alpha_y
                  cook-torrance              ks       m        F0
                  lafortune                  ks       Cx       Cy       Cz    n
                  phong                      ks       n
                  he (1991)                  sigma    tau      F0
                  ggx, ggx-separable         alpha_x  alpha_y  F0
                  beckmann                   alpha_x  alpha_y  F0
                  microfacet                 those of its mdf, F0
                or the path of a measured material of the RGL database, FILE.bsdf
  p0 .. p4      its parameters: e and n from 0 to 1000000, alphas and m from 0.001 to 1.5,
                F0, Rd, Rs and ks from 0 to 1 (ks of lafortune and phong to 1000000), C from
                -10 to 10, sigma from 0 to 5 and tau from 0.1 to 1000 wavelengths;
                what a model does not use may be empty, and a column that none uses absent
  ix, iy, iz    towards the light
  ox, oy, oz    towards the eye
  mdf           for microfacet only: ashikhmin-shirley, ward, beckmann or ggx
  smith         for microfacet only, may be absent: correlated (default) or separable
with directions in tangent space: x tangent, y bitangent, z normal. Adds
  f             specular reflectance per steradian, without the cosine; 0 below the horizon.
                Fresnel is Schlick's F0 + (1 - F0) (1 - i.h)^5 wherever F0 is a parameter.
                ashikhmin-shirley-diffuse is the diffuse term of that model. he is the
                directional-diffuse term, always computed in double precision. phong is not
                reciprocal; phong, ward-duer and, more slowly, ward grow without bound at
                grazing angles. Of a measured material f is all of the reflectance, its
                luminance, and i is the direction that the file calls incident
  f_r f_g f_b   with --rgb: f of each color, linear Rec. 709. A model has f three times
)";

}  // namespace

void add_brdf_command(CLI::App& parent, Session& session) {
    CLI::App* brdf = parent.add_subcommand("brdf", "Reflection models");
    require_command(*brdf);
    add_eval_command(*brdf, session, "Evaluate a model for every row of a table", kBrdfColumns,
                     true, eval_brdf_table);
    add_brdf_fit_command(*brdf, session);
    add_brdf_plot_command(*brdf, session);
}

}  // namespace burnish::cli

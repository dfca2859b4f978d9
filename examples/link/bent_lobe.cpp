// Links libburnish: evaluates a brushed lobe under a bent normal with the shared maths, then
// renders a picture when given a file name.
#include <burnish/f64.hpp>
#include <burnish/render.hpp>
#include <cmath>
#include <cstdio>

namespace maths = burnish::f64;

int main(int argc, char** argv) {
    // Brushed along the tangent, the normal bent 30 degrees towards it.
    const maths::Lobe lobe = maths::lobe_make(maths::kMdfGgx, 0.1, 0.5);
    const maths::vec3 bent(std::sin(0.5235988), 0.0, std::cos(0.5235988));
    for (const int method : {maths::kMethodNormalMap, maths::kMethodFollowGrain}) {
        const maths::Perturbation p = maths::perturb_make(method, bent, true, false);
        std::printf("%-12s D(n) = %8.4f   D(bent n) = %8.4f\n",
                    burnish::name_of(static_cast<burnish::Method>(method)).data(),
                    maths::lobe_D(lobe, p, maths::vec3(0, 0, 1)), maths::lobe_D(lobe, p, bent));
    }
    if (argc < 2) return 0;

    burnish::RenderRequest request;
    request.stage.input = "builtin:sphere";
    request.stage.values.set("metal", "copper", "example");
    request.stage.values.set("width", "256", "example");
    request.stage.values.set("height", "256", "example");
    request.output = argv[1];
    std::printf("rendered on %s\n", burnish::render(request).device.c_str());
}

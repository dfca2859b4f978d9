// Evaluates and samples a brushed metal under a bent normal, by the names of model and method.
#include <burnish/surface.hpp>
#include <cstdio>
#include <random>

int main() {
    burnish::Material brushed;
    brushed.base_color = {0.9f, 0.6f, 0.3f, 1.0f};
    brushed.brdf = burnish::brdf_named("microfacet");
    brushed.mdf = burnish::mdf_named("ggx");
    brushed.lobe = burnish::AlphaLobe{{0.1f, 0.5f}};

    const glm::dvec3 normal(0.5, 0.0, 0.8660254037844386);  // bent 30 degrees along the tangent
    const glm::dvec3 to_eye(0.0, 0.0, 1.0);
    const glm::dvec3 mirrored(0.8660254037844386, 0.0, 0.5);  // the eye's mirror direction about it
    for (const char* method : {"normal-map", "follow-grain"}) {
        brushed.method = burnish::method_named(method);
        const burnish::SurfacePoint point(brushed, normal);
        std::printf("%-12s f(mirror direction) = %8.4f per steradian\n", method,
                    point.eval(mirrored, to_eye).x);

        // The share of white light from everywhere that it reflects, by Monte Carlo.
        std::mt19937 random(1);
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        constexpr int kSamples = 20000;
        double sum = 0.0;
        for (int i = 0; i < kSamples; ++i)
            if (const auto sample =
                    point.sample(to_eye, {uniform(random), uniform(random), uniform(random)}))
                sum += sample->weight.x;
        std::printf("%-12s albedo = %.3f\n", method, sum / kSamples);
    }
}

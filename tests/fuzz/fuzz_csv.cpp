// The tables of `mdf eval`, `brdf eval` and `verify --csv`. The first byte says which, and in which precision.
#include <filesystem>

#include "harness.hpp"
#include "jobs/models/eval.hpp"
#include "jobs/models/verify_csv.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using burnish::Precision;
    if (size == 0) return -1;
    const unsigned kind = data[0];
    const auto path = burnish::fuzz::put("table.csv", burnish::fuzz::Bytes(data + 1, size - 1));
    const auto output = burnish::fuzz::folder() / "values.csv";
    const burnish::EvalRequest request{path.string(), output.string(),
                                       kind % 4 < 2 ? Precision::f64 : Precision::f32};
    burnish::fuzz::expect_answer([&] {
        if (kind >= 192) {
            burnish::VerifyCsvRequest compared;
            compared.input = path.string();
            compared.normal = {0.3, 0.2, 0.9};
            burnish::verify_csv(compared, {});
            return;
        }
        if (kind % 2 == 0)
            burnish::eval_mdf_table(request, {});
        else
            burnish::eval_brdf_table(request, {});
        // Nothing of the table is lost: names and values are only added.
        if (std::filesystem::file_size(output) < size - 1)
            burnish::fuzz::broken("a table that shrank");
    });
    return 0;
}

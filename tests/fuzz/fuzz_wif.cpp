// Weaving drafts: what is read must hold, and come back the same when it is written.
#include "burnish/wif.hpp"
#include "harness.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using burnish::fuzz::Bytes;
    const auto path = burnish::fuzz::put("cloth.wif", Bytes(data, size));
    burnish::fuzz::expect_answer([&] {
        burnish::is_wif_file(path);
        const burnish::WifFile file = burnish::read_wif(path);
        burnish::check_draft(file.draft, "draft");
        for (const std::string& warning : file.warnings)
            if (warning.empty() || warning.find_first_of("\r\n") != warning.npos)
                burnish::fuzz::broken("a warning of no or several lines");
        // Large ones take too long to write for a fuzzer.
        if (file.draft.warp_up.size() > 4096) return;
        const std::string text = burnish::wif_text(file.draft);
        const auto again = burnish::fuzz::put(
            "again.wif", Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
        if (burnish::read_wif(again).draft.warp_up != file.draft.warp_up)
            burnish::fuzz::broken("a draft that changed when it was written");
    });
    return 0;
}

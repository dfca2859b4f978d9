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
        // A long side may come back as one repeat: colors that differ little become one.
        const burnish::Draft &draft = file.draft, back = burnish::read_wif(again).draft;
        for (int pick = 0; pick < draft.picks; ++pick)
            for (int end = 0; end < draft.ends; ++end)
                if (draft.is_warp_up(end, pick) !=
                    back.is_warp_up(end % back.ends, pick % back.picks))
                    burnish::fuzz::broken("a draft that changed when it was written");
    });
    return 0;
}

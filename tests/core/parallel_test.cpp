#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "burnish/error.hpp"

namespace burnish {
namespace {

TEST(ParallelFor, CoversEveryIndexOnceInRangesFixedByTheGrain) {
    for (const std::size_t count : {0U, 1U, 2U, 7U, 64U, 1000U}) {
        for (const std::size_t grain : {0U, 1U, 3U, 64U, 5000U}) {
            std::vector<std::atomic<int>> visits(count);
            std::mutex mutex;
            std::set<std::pair<std::size_t, std::size_t>> ranges;
            parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) ++visits[i];
                const std::scoped_lock lock(mutex);
                ranges.emplace(begin, end);
            });
            for (const auto& visit : visits) EXPECT_EQ(visit.load(), 1);
            const std::size_t step = grain == 0 ? 1 : grain;
            for (const auto& [begin, end] : ranges) {
                EXPECT_EQ(begin % step, 0U);
                EXPECT_TRUE(end - begin == step || end == count);
            }
        }
    }
}

TEST(ParallelFor, HandsExceptionsToTheCaller) {
    const auto work = [] {
        parallel_for(1000, 1, [](std::size_t begin, std::size_t) {
            if (begin == 613) throw Error("range 613");
        });
    };
    EXPECT_THROW(work(), Error);
}

TEST(ParallelFor, MayBeNested) {
    std::atomic<std::size_t> sum{0};
    parallel_for(8, 1, [&](std::size_t, std::size_t) {
        parallel_for(8, 2, [&](std::size_t begin, std::size_t end) { sum += end - begin; });
    });
    EXPECT_EQ(sum.load(), 64U);
}

}  // namespace
}  // namespace burnish

// Working memory that pieces of a loop borrow: no two at a time the same.
#include "core/work_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "core/parallel.hpp"

namespace burnish {
namespace {

struct Buffer {
    std::vector<int> values;
    std::atomic<bool> lent{false};
};

TEST(WorkPool, WhatIsGivenBackIsLentAgain) {
    WorkPool<Buffer> pool;
    const Buffer* first = nullptr;
    {
        const WorkPool<Buffer>::Lease lease(pool);
        (*lease).values = {1, 2, 3};
        first = &*lease;
    }
    const WorkPool<Buffer>::Lease again(pool);
    EXPECT_EQ(&*again, first);
    EXPECT_EQ((*again).values.size(), 3u);
    const WorkPool<Buffer>::Lease other(pool);
    EXPECT_NE(&*other, first);
    EXPECT_TRUE((*other).values.empty());
}

TEST(WorkPool, NestedLoopsNeverShareOne) {
    WorkPool<Buffer> pool;
    std::atomic<int> shared{0};
    constexpr std::size_t kPieces = 64;
    parallel_for(kPieces, 1, [&](std::size_t, std::size_t) {
        const WorkPool<Buffer>::Lease lease(pool);
        if ((*lease).lent.exchange(true)) ++shared;
        // A thread that waits for these may begin another of the outer pieces.
        parallel_for(kPieces, 1, [&](std::size_t, std::size_t) {
            const WorkPool<Buffer>::Lease inner(pool);
            if ((*inner).lent.exchange(true)) ++shared;
            (*inner).lent = false;
        });
        (*lease).lent = false;
    });
    EXPECT_EQ(shared, 0);
}

}  // namespace
}  // namespace burnish

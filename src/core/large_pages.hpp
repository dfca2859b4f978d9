// Large arrays on large pages: a page of 2 MB is handed out, and cleared, 512 times less often than
// one of 4 kB, which a generated map of hundreds of megabytes is otherwise slowed down by.
#pragma once

#include <cstddef>
#include <vector>

namespace burnish {

// Asks the kernel for large pages under memory that is not in use yet. Changes no byte, and does
// nothing where there are none or the memory is smaller than one.
void ask_for_large_pages(void* data, std::size_t bytes);

// `count` zeros.
template <typename T>
std::vector<T> zeros_on_large_pages(std::size_t count) {
    std::vector<T> zeros;
    zeros.reserve(count);
    ask_for_large_pages(zeros.data(), count * sizeof(T));
    zeros.resize(count);
    return zeros;
}

}  // namespace burnish

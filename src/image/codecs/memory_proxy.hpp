// A file in memory for OpenImageIO's readers. Private to the image reader.
#pragma once

#include <OpenImageIO/filesystem.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace burnish {

// Some plug-ins cast a proxy that says "memreader" to IOMemReader, hence the base class; the
// functions are replaced because the base class does not check offsets beyond the end.
class MemoryReader final : public OIIO::Filesystem::IOMemReader {
  public:
    explicit MemoryReader(std::span<const std::byte> bytes)
        : IOMemReader(bytes.data(), bytes.size()), bytes_(bytes) {}

    bool seek(std::int64_t offset) override {
        if (offset < 0) return false;
        m_pos = offset;
        return true;
    }
    std::size_t read(void* to, std::size_t size) override {
        const std::size_t count = pread(to, size, m_pos);
        m_pos += static_cast<std::int64_t>(count);
        return count;
    }
    std::size_t pread(void* to, std::size_t size, std::int64_t offset) override {
        if (offset < 0 || static_cast<std::uint64_t>(offset) >= bytes_.size()) return 0;
        const auto from = bytes_.subspan(static_cast<std::size_t>(offset));
        const std::size_t count = std::min(size, from.size());
        std::memcpy(to, from.data(), count);
        return count;
    }

  private:
    std::span<const std::byte> bytes_;
};

}  // namespace burnish

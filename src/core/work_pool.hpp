// Working memory that outlives the ranges of a parallel loop. Each range borrows one object, so
// that the pool holds at most as many objects as ranges run at a time, nested loops included.
// Thread-safe.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace burnish {

template <typename T>
class WorkPool {
  public:
    // Holds one object of the pool until it goes out of scope. The object is as its last borrower
    // left it.
    class Lease {
      public:
        explicit Lease(WorkPool& pool) : pool_(pool), work_(pool.take()) {}
        Lease(const Lease&) = delete;
        Lease& operator=(const Lease&) = delete;
        ~Lease() { pool_.put(std::move(work_)); }
        T& operator*() const { return *work_; }

      private:
        WorkPool& pool_;
        std::unique_ptr<T> work_;
    };

  private:
    std::unique_ptr<T> take() {
        const std::lock_guard lock(mutex_);
        if (free_.empty()) return std::make_unique<T>();
        std::unique_ptr<T> work = std::move(free_.back());
        free_.pop_back();
        return work;
    }
    void put(std::unique_ptr<T> work) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(work));
    }

    std::mutex mutex_;
    std::vector<std::unique_ptr<T>> free_;
};

}  // namespace burnish

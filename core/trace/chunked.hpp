// A sequence that grows without moving what it holds: appending never copies, and memory follows
// the content.
#pragma once

#include "core/base/check.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace hs::trace {

/// Elements live in blocks of 2^16. T is plain data; elements are uninitialized until pushed.
template <typename T>
class Chunked {
public:
    static constexpr std::size_t block_bits = 16;
    static constexpr std::size_t block_size = std::size_t{1} << block_bits;

    void push_back(const T& value) { append() = value; }
    /// A new last element, uninitialized, to be written in place.
    [[nodiscard]] T& append() {
        if (cursor_ == block_end_) {
            add_block();
        }
        ++size_;
        return *cursor_++;
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] const T& operator[](std::size_t i) const {
        HS_DCHECK(i < size_, "an index below the size");
        return blocks_[i >> block_bits][i & (block_size - 1)];
    }
    /// The contiguous elements from i to the end of its block, at most `limit − i` of them.
    [[nodiscard]] std::size_t run_length(std::size_t i, std::size_t limit) const {
        const std::size_t to_block_end = block_size - (i & (block_size - 1));
        return to_block_end < limit - i ? to_block_end : limit - i;
    }
    [[nodiscard]] std::size_t bytes() const { return blocks_.size() * block_size * sizeof(T); }

private:
    void add_block() {
        blocks_.push_back(std::make_unique_for_overwrite<T[]>(block_size));
        cursor_ = blocks_.back().get();
        block_end_ = cursor_ + block_size;
    }

    std::vector<std::unique_ptr<T[]>> blocks_;
    T* cursor_ = nullptr;
    T* block_end_ = nullptr;
    std::size_t size_ = 0;
};

} // namespace hs::trace

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace rockfall {

/// A list of values that begin with all bytes zero, whose memory the system gives only where they are
/// written: for grids of which rocks reach few cells. Copies skip what is still zero, so that they take no
/// more.
///
/// Throws std::bad_alloc.
template <class Value>
requires(std::is_trivially_copyable_v<Value>) class ZeroedList {
public:
    ZeroedList() = default;
    explicit ZeroedList(std::size_t size) : values_{zeros(size)}, size_{size} {}
    ZeroedList(const ZeroedList& other) : ZeroedList{other.size_} { copy(other); }
    ZeroedList(ZeroedList&& other) noexcept
        : values_{std::move(other.values_)}, size_{std::exchange(other.size_, 0)} {}
    ZeroedList& operator=(ZeroedList other) noexcept {
        std::swap(values_, other.values_);
        std::swap(size_, other.size_);
        return *this;
    }
    ~ZeroedList() = default;

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    Value& operator[](std::size_t i) { return values_.get()[i]; }
    const Value& operator[](std::size_t i) const { return values_.get()[i]; }
    Value* begin() { return values_.get(); }
    Value* end() { return values_.get() + size_; }
    [[nodiscard]] const Value* begin() const { return values_.get(); }
    [[nodiscard]] const Value* end() const { return values_.get() + size_; }

    /// With so many values at least; further ones are zero.
    void grow_to(std::size_t size) {
        if (size > size_) {
            ZeroedList larger{size};
            larger.copy(*this);
            *this = std::move(larger);
        }
    }

    /// Calls visit(from, count) for each block of the list, of up to `block` values, that is not all zero.
    static constexpr std::size_t block = 64;
    template <class Visit>
    void for_each_block(Visit visit) const {
        static constexpr std::array<char, block * sizeof(Value)> nothing{};
        for (std::size_t from = 0; from < size_; from += block) {
            const std::size_t count = std::min(block, size_ - from);
            if (std::memcmp(begin() + from, nothing.data(), count * sizeof(Value)) != 0) {
                visit(from, count);
            }
        }
    }

private:
    struct Free {
        void operator()(Value* values) const { std::free(values); }
    };
    static std::unique_ptr<Value, Free> zeros(std::size_t size) {
        if (size == 0) {
            return nullptr;
        }
        void* const memory = std::calloc(size, sizeof(Value));
        if (memory == nullptr) {
            throw std::bad_alloc{};
        }
        return std::unique_ptr<Value, Free>{static_cast<Value*>(memory)};
    }
    void copy(const ZeroedList& other) {
        other.for_each_block([&](std::size_t from, std::size_t count) {
            std::copy_n(other.begin() + from, count, begin() + from);
        });
    }

    std::unique_ptr<Value, Free> values_;
    std::size_t size_ = 0;
};

}  // namespace rockfall

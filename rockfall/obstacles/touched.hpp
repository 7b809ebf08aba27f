#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace rockfall {

/// The stems, or logs, that a rock has hit and not yet left: it slides along them and cannot hit them anew.
///
/// Without this memory a rock within reach of two stems would hit one and the other in turn without moving.
class Touched {
public:
    [[nodiscard]] std::span<const std::uint32_t> numbers() const { return {numbers_.data(), count_}; }

    void remember(std::uint32_t number) {
        if (count_ == numbers_.size()) {  // wedged among many: the first one makes room
            std::move(numbers_.begin() + 1, numbers_.end(), numbers_.begin());
            --count_;
        }
        numbers_[count_++] = number;
    }

    /// `is_left(number)`: the rock is clear of it.
    template <class IsLeft>
    void forget_if(IsLeft is_left) {
        const auto end = numbers_.begin() + static_cast<std::ptrdiff_t>(count_);
        count_ = static_cast<std::size_t>(std::remove_if(numbers_.begin(), end, is_left) - numbers_.begin());
    }

private:
    std::array<std::uint32_t, 4> numbers_{};
    std::size_t count_ = 0;
};

}  // namespace rockfall

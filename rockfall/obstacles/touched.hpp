#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rockfall {

/// The stems, or logs, that a rock has hit and not yet left: it slides along them and cannot hit them again.
///
/// Without this memory a rock within reach of several stems would hit one and the other in turn without
/// moving: of scratches that take no energy there is no end. It holds as many as a rock can touch; in a
/// thicket a large one leans on dozens.
class Touched {
public:
    [[nodiscard]] std::span<const std::uint32_t> numbers() const { return numbers_; }

    void remember(std::uint32_t number) { numbers_.push_back(number); }

    /// `is_left(number)`: the rock is clear of it.
    template <class IsLeft>
    void forget_if(IsLeft is_left) {
        std::erase_if(numbers_, is_left);
    }

private:
    std::vector<std::uint32_t> numbers_;
};

}  // namespace rockfall

#include "coupling/assessments/decades/members/starts.hpp"

#include <algorithm>

namespace coupling::decades {

std::shared_ptr<Starts::Slot> Starts::slot_of(std::uint32_t replicate) {
    const std::lock_guard lock{mutex_};
    const auto known = std::find_if(slots_.begin(), slots_.end(),
                                    [&](const auto& slot) { return slot->replicate == replicate; });
    if (known != slots_.end()) {
        slots_.splice(slots_.begin(), slots_, known);
    } else {
        slots_.push_front(std::make_shared<Slot>(replicate));
        if (slots_.size() > most_) {
            slots_.pop_back();
        }
    }
    return slots_.front();
}

std::shared_ptr<const Start> Starts::of(std::uint32_t replicate, const std::function<Start()>& make) {
    const std::shared_ptr<Slot> slot = slot_of(replicate);
    const std::lock_guard lock{slot->making};
    if (!slot->start) {
        slot->start = std::make_shared<const Start>(make());
    }
    return slot->start;
}

std::vector<Member> in_order_of_starts(std::span<const Member> members, std::size_t at_a_time) {
    std::vector<Member> ordered{members.begin(), members.end()};
    std::stable_sort(ordered.begin(), ordered.end(), [&](const Member& a, const Member& b) {
        return a.replicate / at_a_time < b.replicate / at_a_time;
    });
    return ordered;
}

}  // namespace coupling::decades

#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/exchange/yearly_rockfall.hpp"
#include "forest/stand/stand.hpp"

namespace coupling::decades {

/// Year 0 of a replicate: its forest, grown in where the records leave out the young and the dead, and its
/// rocks. The same under all regimes and climates.
struct Start {
    forest::Stand stand;
    exchange::YearFalls falls;  ///< of a year with rocks
};

/// The starts of the replicates under way: each is made once, however many members begin with it.
class Starts {
public:
    /// Keeps the last `most` starts, beside those that members still hold.
    explicit Starts(std::size_t most) : most_{most} {}

    /// The start of a replicate, by `make` where nobody has made it. Who comes meanwhile waits.
    std::shared_ptr<const Start> of(std::uint32_t replicate, const std::function<Start()>& make);

private:
    struct Slot {
        explicit Slot(std::uint32_t of) : replicate{of} {}
        std::uint32_t replicate;
        std::mutex making;
        std::shared_ptr<const Start> start;
    };
    std::shared_ptr<Slot> slot_of(std::uint32_t replicate);

    std::size_t most_;
    std::mutex mutex_;
    std::list<std::shared_ptr<Slot>> slots_;  ///< the last used one first
};

/// The order in which members are lived through by so many at a time: those of a replicate follow each other,
/// and the first ones have different replicates, so that nobody waits for a start.
std::vector<Member> in_order_of_starts(std::span<const Member> members, std::size_t at_a_time);

}  // namespace coupling::decades

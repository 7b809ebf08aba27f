#include "rockfall/obstacles/plan_bins.hpp"

#include <algorithm>

namespace rockfall {
namespace {

bool is_nowhere(const PlanBox& box) {
    return box.west_m > box.east_m;
}

config::GridFrame frame_over(std::span<const PlanBox> boxes, double bin_size_m) {
    constexpr double far = std::numeric_limits<double>::max();
    PlanBox all{far, far, -far, -far};
    for (const PlanBox& box : boxes) {
        if (!is_nowhere(box)) {
            all = {std::min(all.west_m, box.west_m), std::min(all.south_m, box.south_m),
                   std::max(all.east_m, box.east_m), std::max(all.north_m, box.north_m)};
        }
    }
    if (is_nowhere(all)) {
        return {};
    }
    return {static_cast<int>((all.east_m - all.west_m) / bin_size_m) + 1,
            static_cast<int>((all.north_m - all.south_m) / bin_size_m) + 1,
            all.west_m,
            all.south_m,
            bin_size_m,
            bin_size_m};
}

template <class Visit>
void each_touched_bin(const config::GridFrame& frame, const PlanBox& box, Visit visit) {
    if (is_nowhere(box)) {
        return;
    }
    const config::Cell first = frame.cell_at(box.west_m, box.north_m);
    const config::Cell last = frame.cell_at(box.east_m, box.south_m);
    for (int row = std::max(0, first.row); row <= std::min(frame.rows - 1, last.row); ++row) {
        for (int column = std::max(0, first.column); column <= std::min(frame.columns - 1, last.column);
             ++column) {
            visit(frame.index({column, row}));
        }
    }
}

}  // namespace

PlanBins::PlanBins(std::span<const PlanBox> boxes)
    : frame_{frame_over(boxes, bin_size_m)}, bin_start_(frame_.size() + 1, 0) {
    for (const PlanBox& box : boxes) {
        each_touched_bin(frame_, box, [&](std::size_t bin) { ++bin_start_[bin + 1]; });
    }
    for (std::size_t bin = 0; bin < frame_.size(); ++bin) {
        bin_start_[bin + 1] += bin_start_[bin];
    }
    numbers_.resize(bin_start_.back());
    std::vector<std::uint32_t> next(bin_start_.begin(), bin_start_.end() - 1);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        each_touched_bin(frame_, boxes[i], [&](std::size_t bin) { numbers_[next[bin]++] = i; });
    }
}

}  // namespace rockfall

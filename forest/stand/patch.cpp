#include "forest/stand/patch.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace forest {

PatchGrid::PatchGrid(const config::GridFrame& frame, std::vector<Patch> patches)
    : frame_{frame}, patches_{std::move(patches)}, patch_of_cell_(frame.size(), none) {
    assert(frame.cell_width_m == patch_side_m && frame.cell_height_m == patch_side_m);
    std::sort(patches_.begin(), patches_.end(),
              [this](const Patch& a, const Patch& b) { return frame_.index(a.cell) < frame_.index(b.cell); });
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        std::uint32_t& entry = patch_of_cell_[frame_.index(patches_[i].cell)];
        assert(entry == none);
        entry = static_cast<std::uint32_t>(i);
    }
}

std::optional<PatchId> PatchGrid::at(config::Cell cell) const {
    if (!frame_.contains(cell)) {
        return std::nullopt;
    }
    const std::uint32_t patch = patch_of_cell_[frame_.index(cell)];
    return patch == none ? std::nullopt : std::optional{PatchId{patch}};
}

std::optional<PatchId> PatchGrid::at(double x_m, double y_m) const {
    return frame_.covers(x_m, y_m) ? at(frame_.cell_at(x_m, y_m)) : std::nullopt;
}

double PatchGrid::x_centre_m(PatchId id) const {
    return frame_.x_centre_m(patches_[index_of(id)].cell.column);
}

double PatchGrid::y_centre_m(PatchId id) const {
    return frame_.y_centre_m(patches_[index_of(id)].cell.row);
}

}  // namespace forest

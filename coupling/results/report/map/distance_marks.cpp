#include "coupling/results/report/map/distance_marks.hpp"

#include <algorithm>

#include "coupling/results/figures/line_places.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::report {
namespace {

LetteredBox box_of_mark(const DistanceMark& mark, double lettering) {
    return box_of(mark.text, mark.text_x(), mark.text_y(), mark_lettering * lettering);
}

bool is_within(const LetteredBox& box, const SheetSize& sheet) {
    return box.west >= 0.0 && box.east <= sheet.width && box.north >= 0.0 && box.south <= sheet.height;
}

}  // namespace

std::vector<DistanceMark> distance_marks_of(
    const Site& site, const SheetSize& sheet,
    const std::function<DrawnPoint(const Eigen::Vector2d&)>& on_sheet) {
    constexpr double least_step_m = 10.0;
    const std::vector<LetteredBox> furniture = furniture_boxes(sheet);
    std::vector<DistanceMark> marks;
    for (const rockfall::Target& target : site.targets) {
        const LinePlaces line{target};
        const double step_m = std::max(least_step_m, nice_step(line.length_m() / 8.0));
        if (target.is_area || line.length_m() < 2.0 * step_m ||
            sheet.units_per_m * step_m < 4.0 * sheet.lettering) {
            continue;
        }
        for (double at_m = 0.0; at_m <= line.length_m(); at_m += step_m) {
            DistanceMark mark{on_sheet(line.at(at_m) + site.origin_m()), tick_text(at_m)};
            const LetteredBox box = box_of_mark(mark, sheet.lettering);
            const bool is_free = std::none_of(furniture.begin(), furniture.end(),
                                              [&](const LetteredBox& other) { return overlap(box, other); });
            if (is_free && is_within(box, sheet)) {
                marks.push_back(std::move(mark));
            }
        }
    }
    return marks;
}

std::vector<LetteredBox> covered_by(const std::vector<DistanceMark>& marks, double lettering) {
    std::vector<LetteredBox> boxes;
    for (const DistanceMark& mark : marks) {
        boxes.push_back(box_of_mark(mark, lettering));
    }
    return boxes;
}

}  // namespace coupling::report

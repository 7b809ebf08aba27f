#include "coupling/assessments/collapse/side_views.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/block_series.hpp"
#include "coupling/results/report/map/labels.hpp"
#include "coupling/results/report/scene_mass.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::collapse {
namespace {

using config::joined;
using report::element;
using report::escaped;
using report::fixed;
using report::grouped;
using report::page_text;
using report::PageFields;
using report::place;
using report::svg_text;
using report::tick_text;

/// Displacements at which the colour of a block changes [m] [choice].
constexpr std::array displacement_bounds_m{1.0, 10.0, 50.0, 200.0};

/// The direction in which the mass went: of the mean way of all blocks.
Eigen::Vector2d main_direction(const CollapseResults& results) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < results.site.count.free; ++i) {
        sum += (results.seen(i).centre_m - results.site.blocks[i].centre_m).head<2>();
    }
    return sum.norm() > 0.0 ? Eigen::Vector2d{sum.normalized()} : Eigen::Vector2d{1.0, 0.0};
}

std::size_t displacement_class(double displacement_m) {
    return static_cast<std::size_t>(
        std::upper_bound(displacement_bounds_m.begin(), displacement_bounds_m.end(), displacement_m) -
        displacement_bounds_m.begin());
}

enum class Shown : std::uint8_t { speed, displacement };

/// Blocks seen across the direction in which they went, on one scale for all times. Units of the drawing.
class SideView {
public:
    explicit SideView(const CollapseResults& results) : results_{results}, along_{main_direction(results)} {
        for (std::size_t i = 0; i < results.site.count.free; ++i) {
            start_ +=
                results.site.blocks[i].centre_m.head<2>() / static_cast<double>(results.site.count.free);
        }
        for (const auto& frame : results.record.frames) {
            for (const BlockPlace& block : frame) {
                low_ = std::min(low_, way_of(block));
                high_ = std::max(high_, way_of(block));
                bottom_ = std::min(bottom_, block.centre().z());
                top_ = std::max(top_, block.centre().z());
            }
        }
        low_ -= margin_m;
        high_ += margin_m;
        bottom_ -= margin_m;
        top_ += margin_m;
        scale_ = (width - left - right) / (high_ - low_);
        floor_ = head + scale_ * (top_ - bottom_);
        heights_ = dug_out(results.site);
        furniture_ = joined(axes(), ground_line(), targets());
    }

    [[nodiscard]] std::string at(std::size_t frame, Shown shown) const {
        std::vector<std::string> by_class(displacement_bounds_m.size() + 1);
        const auto& blocks = results_.record.frames[frame];
        for (std::size_t i = 0; i < blocks.size(); i += every()) {
            const double size_m = std::cbrt(results_.site.blocks[i].solid.volume_m3);
            const std::size_t number =
                shown == Shown::speed
                    ? report::block_speed_class(static_cast<double>(blocks[i].speed_mps))
                    : displacement_class((blocks[i].centre() - results_.site.blocks[i].centre_m).norm());
            by_class[number] += element("circle", {{"cx", x_of(way_of(blocks[i]))},
                                                   {"cy", y_of(blocks[i].centre().z())},
                                                   {"r", std::max(0.7, 0.5 * scale_ * size_m)}});
        }
        std::string svg = furniture_;
        for (std::size_t k = 0; k < by_class.size(); ++k) {
            if (!by_class[k].empty()) {
                svg += element("g", {{"class", style_of(shown, k)}}, by_class[k]);
            }
        }
        return report::svg_drawing(width, height_,
                                   shown == Shown::speed
                                       ? page_text("The mass from the side, coloured by speed")
                                       : page_text("The mass from the side, coloured by displacement"),
                                   svg);
    }

    /// One block in so many is drawn.
    [[nodiscard]] std::size_t every() const { return results_.site.count.free / most_drawn + 1; }

    static std::string style_of(Shown shown, std::size_t number) {
        return joined(shown == Shown::speed ? "v" : "d", std::to_string(number));
    }

private:
    [[nodiscard]] double x_of(double way_m) const { return left + scale_ * (way_m - low_); }
    [[nodiscard]] double y_of(double height_m) const { return head + scale_ * (top_ - height_m); }
    [[nodiscard]] double way_of(const Eigen::Vector2d& at_m) const { return along_.dot(at_m - start_); }
    [[nodiscard]] double way_of(const BlockPlace& block) const {
        return way_of(Eigen::Vector2d{block.centre().head<2>()});
    }

    /// Ways from the middle of the start, heights above sea; lines at both.
    [[nodiscard]] std::string axes() const {
        std::string svg;
        const double step_m = report::nice_step((high_ - low_) / 7.0);
        for (double way_m = std::ceil(low_ / step_m) * step_m; way_m <= high_; way_m += step_m) {
            const double x = x_of(way_m);
            svg += report::svg_path("grid", joined("M", place(x), " ", place(head), "V", place(floor_)));
            svg += svg_text(x, floor_ + lettering, tick_text(way_m + 0.0), {{"text-anchor", "middle"}});
        }
        const double height_step_m = report::nice_step(std::max((top_ - bottom_) / 6.0, 16.0 / scale_));
        for (double at_m = std::ceil(bottom_ / height_step_m) * height_step_m; at_m <= top_;
             at_m += height_step_m) {
            const double y = y_of(at_m);
            svg += report::svg_path("grid", joined("M", place(left), " ", place(y), "H", place(width)));
            svg += svg_text(left - 4.0, y + 4.0, tick_text(at_m), {{"text-anchor", "end"}});
        }
        svg += svg_text(width, floor_ + 2.0 * lettering + 2.0, page_text("Way in plan, m"),
                        {{"text-anchor", "end"}});
        svg += svg_text(0.0, lettering, page_text("Height above sea, m"));
        return svg;
    }

    [[nodiscard]] std::optional<double> ground_at(double way_m) const {
        return height_between(start_ + way_m * along_ + results_.site.origin_m);
    }

    /// The ground along the mean direction of the blocks, below the middle of where they start.
    [[nodiscard]] std::string ground_line() const {
        const double step_m = 0.5 * std::min(heights_.frame.cell_width_m, heights_.frame.cell_height_m);
        std::string path;
        const char* step = "M";
        for (double way_m = low_; way_m <= high_; way_m += step_m) {
            const std::optional<double> height_m = ground_at(way_m);
            if (height_m) {
                path += joined(step, place(x_of(way_m)), " ", place(y_of(*height_m)));
            }
            step = height_m ? "L" : "M";
        }
        return report::svg_path("ground", path);
    }

    /// Between the middles of the four cells around a point; nothing where one of them has none.
    [[nodiscard]] std::optional<double> height_between(const Eigen::Vector2d& at_m) const {
        const config::GridFrame& frame = heights_.frame;
        const double column = (at_m.x() - frame.x_west_m) / frame.cell_width_m - 0.5;
        const double row = (frame.y_north_m() - at_m.y()) / frame.cell_height_m - 0.5;
        const config::Cell cell{static_cast<int>(std::floor(column)), static_cast<int>(std::floor(row))};
        const double east = column - cell.column;
        const double south = row - cell.row;
        double height_m = 0.0;
        for (const auto& [corner, share] :
             {std::pair{config::Cell{cell.column, cell.row}, (1.0 - east) * (1.0 - south)},
              std::pair{config::Cell{cell.column + 1, cell.row}, east * (1.0 - south)},
              std::pair{config::Cell{cell.column, cell.row + 1}, (1.0 - east) * south},
              std::pair{config::Cell{cell.column + 1, cell.row + 1}, east * south}}) {
            if (!frame.contains(corner) || std::isnan(heights_.at(corner))) {
                return std::nullopt;
            }
            height_m += share * heights_.at(corner);
        }
        return height_m;
    }

    /// Each target by a bar on the ground as long as it is along the view, and its name below the scale.
    [[nodiscard]] std::string targets() {
        std::string svg;
        std::vector<double> row_ends;
        height_ = floor_ + 2.0 * lettering + 6.0;
        struct Mark {
            double from, to;
            std::string name;
        };
        std::vector<Mark> marks;
        for (const rockfall::Target& target : results_.site.targets) {
            Mark mark{high_, low_, target.name.empty() ? target.id : target.name};
            for (const auto& part : target.parts) {
                for (const Eigen::Vector2d& vertex : part) {
                    mark.from = std::min(mark.from, way_of(vertex));
                    mark.to = std::max(mark.to, way_of(vertex));
                }
            }
            if (mark.to >= low_ && mark.from <= high_) {
                mark.from = std::max(mark.from, low_);
                mark.to = std::min(mark.to, high_);
                marks.push_back(std::move(mark));
            }
        }
        std::stable_sort(marks.begin(), marks.end(),
                         [](const Mark& a, const Mark& b) { return a.from + a.to < b.from + b.to; });
        for (const Mark& mark : marks) {
            const double middle_m = 0.5 * (mark.from + mark.to);
            const double x = x_of(middle_m);
            const double y = y_of(ground_at(middle_m).value_or(bottom_));
            const double wide = report::box_of(mark.name, 0.0, 0.0, lettering).east;
            const double begin = std::clamp(x - 0.5 * wide, 0.0, std::max(0.0, width - wide));
            std::size_t row = 0;
            while (row < row_ends.size() && row_ends[row] > begin) {
                ++row;
            }
            row_ends.resize(std::max(row_ends.size(), row + 1), 0.0);
            row_ends[row] = begin + wide + lettering;
            const double name_y = floor_ + (3.4 + 1.25 * static_cast<double>(row)) * lettering;
            height_ = std::max(height_, name_y + 4.0);
            svg += report::svg_path("target", joined("M", place(x_of(mark.from)), " ", place(y), "H",
                                                     place(std::max(x_of(mark.to), x_of(mark.from) + 2.0))));
            svg += report::svg_path("lead",
                                    joined("M", place(x), " ", place(y), "V", place(name_y - lettering)));
            // At the rim a name ends there, however wide the letters of a reader are.
            svg += begin + wide < width
                       ? svg_text(begin, name_y, mark.name, {{"class", "name"}})
                       : svg_text(width, name_y, mark.name, {{"class", "name"}, {"text-anchor", "end"}});
        }
        return svg;
    }

    static constexpr double width = 560.0;
    static constexpr double left = 40.0;
    static constexpr double right = 14.0;  ///< half of the last number below
    static constexpr double lettering = 12.0;
    static constexpr double head = 20.0;
    static constexpr double margin_m = 6.0;
    static constexpr std::size_t most_drawn = 2500;
    const CollapseResults& results_;
    Eigen::Vector2d along_;
    Eigen::Vector2d start_ = Eigen::Vector2d::Zero();  ///< middle of all blocks at the start
    double low_ = 1e300, high_ = -1e300, bottom_ = 1e300, top_ = -1e300, scale_ = 1.0;
    double floor_ = 0.0, height_ = 0.0;
    config::Raster<double> heights_;
    std::string furniture_;
};

template <std::size_t count>
std::string legend(Shown shown, const std::array<double, count>& bounds, const char* unit) {
    std::string items;
    for (std::size_t k = 0; k <= count; ++k) {
        const std::string low = k > 0 ? tick_text(bounds[k - 1]) : "",
                          high = k < count ? tick_text(bounds[k]) : "";
        const std::string name =
            k == 0 ? page_text("below {high} {unit}", {{"high", high}, {"unit", unit}})
            : k == count
                ? page_text("{low} {unit} and more", {{"low", low}, {"unit", unit}})
                : page_text("{low} to {high} {unit}", {{"low", low}, {"high", high}, {"unit", unit}});
        items += report::legend_item(
            element("rect", {{"class", SideView::style_of(shown, k)}, {"width", 30.0}, {"height", 14.0}}),
            name);
    }
    return element("ul", {{"class", "names"}}, items);
}

}  // namespace

PageFields side_views(const CollapseResults& results) {
    const SideView view{results};
    std::vector<PageFields> all;
    for (const std::size_t frame : picture_frames(results)) {
        all.push_back({{"speeds", view.at(frame, Shown::speed)},
                       {"displacements", view.at(frame, Shown::displacement)},
                       {"time", fixed(results.record.rows[frame].time_s, 1)}});
    }
    return {{"views", all},
            {"speed_legend", legend(Shown::speed, std::to_array(report::block_speed_bounds_mps), "m/s")},
            {"displacement_legend", legend(Shown::displacement, displacement_bounds_m, "m")},
            {"thinned",
             view.every() > 1 ? std::optional{PageFields{{"every", grouped(view.every())}}} : std::nullopt}};
}

}  // namespace coupling::collapse

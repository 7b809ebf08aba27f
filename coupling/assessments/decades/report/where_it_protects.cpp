#include "coupling/assessments/decades/report/where_it_protects.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/report/regime_chart.hpp"
#include "coupling/assessments/decades/tables/protection_places.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/map/map_colours.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::fixed;
using report::page_text;
using report::PageFields;

/// Bands in a row of the table, and in a point of the chart: 40 and 20 m [choice]. A gap of 40 m is what
/// guidelines allow at most.
constexpr std::size_t bands_in_row = 4;
constexpr std::size_t bands_in_point = 2;

/// A regime in the first climate at a target.
struct CourseAtTarget {
    std::size_t course;
    PooledBands bands;
};

std::vector<CourseAtTarget> courses_at(const Names& names, const std::vector<BandsOfCourse>& all_bands,
                                       std::uint32_t target) {
    std::vector<CourseAtTarget> courses;
    for (std::size_t course = 0; course < all_bands.size(); ++course) {
        const auto found = all_bands[course].find({target, std::nullopt});
        if (found != all_bands[course].end() && (!splits_charts(names) || names.climate_of(course) == 0)) {
            courses.push_back({course, found->second});
        }
    }
    return courses;
}

bool has_trees(const TargetBands& bands, std::size_t first) {
    for (std::size_t band = first; band < std::min(first + bands_in_row, bands.bands.size()); ++band) {
        if (bands.bands[band].met > 0) {
            return true;
        }
    }
    return false;
}

/// The first bands of the rows in which a rock of any regime meets a tree.
std::vector<std::size_t> rows_with_trees(const std::vector<CourseAtTarget>& courses) {
    std::vector<std::size_t> rows;
    std::size_t bands = 0;
    for (const CourseAtTarget& course : courses) {
        bands = std::max(bands, course.bands.pool().bands.size());
    }
    for (std::size_t first = 0; first < bands; first += bands_in_row) {
        if (std::any_of(courses.begin(), courses.end(),
                        [&](const CourseAtTarget& c) { return has_trees(c.bands.pool(), first); })) {
            rows.push_back(first);
        }
    }
    return rows;
}

std::string metres_of(std::size_t band) {
    return fixed(exchange::distance_band_m * static_cast<double>(band), 0);
}

std::string lost_html(const PooledFigure& lost) {
    if (std::isnan(lost.value)) {
        return "–";
    }
    return joined(
        report::element("b", {}, fixed(lost.value, 1)),
        lost.has_interval() ? joined(" (", fixed(lost.low, 1), " – ", fixed(lost.high, 1), ")") : "");
}

/// What the row nearest to the target protects, and whether another one does more, beyond chance.
std::optional<PageFields> answer_at(const Names& names, const CourseAtTarget& at, const std::string& target,
                                    const std::vector<std::size_t>& rows) {
    const auto nearest = std::find_if(rows.begin(), rows.end(),
                                      [&](std::size_t first) { return has_trees(at.bands.pool(), first); });
    if (nearest == rows.end()) {
        return std::nullopt;
    }
    const PooledFigure here = at.bands.lost_percent(*nearest, bands_in_row);
    if (std::isnan(here.value)) {
        return std::nullopt;
    }
    bool here_most = here.has_interval() && rows.size() > 1;
    std::optional<PageFields> most;
    double most_lost = here.high;
    for (const std::size_t first : rows) {
        if (first == *nearest) {
            continue;
        }
        const PooledFigure there = at.bands.lost_percent(first, bands_in_row);
        here_most = here_most && there.has_interval() && there.high < here.low;
        if (here.has_interval() && there.has_interval() && there.low > here.high && there.value > most_lost) {
            most_lost = there.value;
            most = PageFields{{"from", metres_of(first)},
                              {"to", metres_of(first + bands_in_row)},
                              {"lost_html", lost_html(there)}};
        }
    }
    return PageFields{{"course", look_of(names, at.course).title()},
                      {"from", metres_of(*nearest)},
                      {"to", metres_of(*nearest + bands_in_row)},
                      {"target", target},
                      {"lost_html", lost_html(here)},
                      {"share", fixed(at.bands.pool().spared_percent(*nearest, bands_in_row), 0)},
                      {"most", most},
                      {"here_most", here_most}};
}

std::string chart_of(const Names& names, const std::vector<CourseAtTarget>& courses,
                     const std::string& target, std::size_t last_band) {
    const bool with_ranges = courses.size() <= most_bands;
    struct Curve {
        std::string line;
        CourseLook look;
        std::vector<report::ChartPoint> means{};
        std::vector<report::ChartRange> ranges{};
    };
    std::vector<Curve> curves;
    double highest = 0.0;
    for (const CourseAtTarget& at : courses) {
        const CourseLook look = look_of(names, at.course);
        Curve& curve = curves.emplace_back(Curve{line_of_regime(look.line), look});
        for (std::size_t first = 0; first < last_band; first += bands_in_point) {
            const PooledFigure lost = at.bands.lost_percent(first, bands_in_point);
            if (!std::isnan(lost.value)) {
                const double x = exchange::distance_band_m *
                                 (static_cast<double>(first) + 0.5 * static_cast<double>(bands_in_point));
                curve.means.push_back({x, std::max(0.0, lost.value)});
                curve.ranges.push_back({x, std::max(0.0, lost.has_interval() ? lost.low : lost.value),
                                        std::max(0.0, lost.has_interval() ? lost.high : lost.value)});
                highest = std::max(highest, with_ranges ? curve.ranges.back().high : lost.value);
            }
        }
    }
    report::Chart chart{page_text("What cutting would cost: {target}", {{"target", target}}),
                        report::Axis::from_zero(page_text("Distance from the target on the map, m"),
                                                exchange::distance_band_m * static_cast<double>(last_band)),
                        report::Axis::from_zero(page_text("Points of protection lost"), highest)};
    for (const Curve& curve : curves) {
        if (with_ranges) {
            chart.add_band(curve.line, curve.ranges);
        }
    }
    for (const Curve& curve : curves) {
        chart.add_line(curve.line, curve.means);
        chart.add_name(curve.line, curve.look.title_in_chart());
        if (!curve.means.empty()) {
            chart.add_end_letter(curve.means.back().y, curve.look.letter);
        }
    }
    return chart.figure(page_text(
        "If no tree and no log stood in a band of 20 m, the rest of the forest as it is. Below 0 is drawn as "
        "0."));
}

std::optional<PageFields> target_fields_of(const Names& names, const std::vector<BandsOfCourse>& all_bands,
                                           const rockfall::Target& target, std::uint32_t place) {
    const std::vector<CourseAtTarget> courses = courses_at(names, all_bands, place);
    const std::vector<std::size_t> rows = rows_with_trees(courses);
    if (rows.empty()) {
        return std::nullopt;
    }
    const std::string name = target.name.empty() ? target.id : target.name;
    std::vector<PageFields> answers;
    std::vector<PageFields> heads;
    for (const CourseAtTarget& at : courses) {
        heads.push_back({{"head", look_of(names, at.course).title()}});
        if (auto answer = answer_at(names, at, name, rows)) {
            answers.push_back(std::move(*answer));
        }
    }
    std::vector<PageFields> table;
    for (const std::size_t first : rows) {
        std::vector<PageFields> cells;
        for (const CourseAtTarget& at : courses) {
            const double share = at.bands.pool().spared_percent(first, bands_in_row);
            cells.push_back({{"lost", lost_html(at.bands.lost_percent(first, bands_in_row))},
                             {"share", std::isnan(share) ? "–" : joined(fixed(share, 0), "\u00a0%")}});
        }
        table.push_back({{"distance", joined(metres_of(first), " – ", metres_of(first + bands_in_row))},
                         {"cells", cells}});
    }
    return PageFields{{"target", name},
                      {"answers", answers},
                      {"heads", heads},
                      {"rows", table},
                      {"chart", chart_of(names, courses, name, rows.back() + bands_in_row)}};
}

/// A grid of patches on the frame of the maps.
config::Raster<float> on_frame(const config::GridFrame& frame, const config::Raster<float>& patches) {
    config::Raster<float> raster{frame, std::numeric_limits<float>::quiet_NaN()};
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const config::Cell patch =
            patches.frame.cell_at(frame.x_centre_m(cell.column), frame.y_centre_m(cell.row));
        if (patches.frame.contains(patch)) {
            raster.values[i] = patches.at(patch);
        }
    }
    return raster;
}

/// The first regime in the first climate.
std::optional<PageFields> patch_map_fields(const Names& names, const Site& site,
                                           const forest::PatchGrid& grid,
                                           std::span<const MemberYears> members,
                                           const report::MapWindow& window) {
    const PatchProtection maps = patch_protection(names, members, 0, grid);
    const double reach = report::bulk_of(maps.lost);
    const double highest = report::bulk_of(maps.spared);
    if (!(reach > 0.0) && !(highest > 0.0)) {
        return std::nullopt;
    }
    const report::MapSheet sheet{site, window};
    std::string figures;
    const auto add = [&](const std::string& title, const config::Raster<float>& raster,
                         const report::ColourScale& scale, const char* id) {
        figures += sheet.figure(
            {title, title, sheet.picture(on_frame(site.map_frame, raster), scale), scale.legend(id), ""},
            report::MapSize::half);
    };
    if (reach > 0.0) {
        add(page_text("Points of protection lost if nothing stood on the patch"),
            report::without_zeros(maps.lost),
            report::ColourScale::linear(Palette::impacts, reach, page_text("points")), "patch-lost");
    }
    if (highest > 0.0) {
        add(page_text("Where stopped rocks have their last tree"), report::without_zeros(maps.spared),
            report::ColourScale::linear(Palette::impacts, highest, "%"), "patch-spared");
    }
    return PageFields{
        {"definitions", sheet.definitions()}, {"course", look_of(names, 0).title()}, {"figures", figures}};
}

}  // namespace

ProtectingPlaces where_it_protects(const Names& names, const Site& site, const forest::PatchGrid& grid,
                                   std::span<const MemberYears> members, const report::MapWindow& window) {
    std::vector<BandsOfCourse> all_bands;
    for (std::size_t course = 0; course < names.courses(); ++course) {
        all_bands.push_back(bands_of_course(names, members, course));
    }
    std::vector<PageFields> targets;
    for (std::uint32_t place = 0; place < site.targets.size(); ++place) {
        if (auto fields = target_fields_of(names, all_bands, site.targets[place], place)) {
            targets.push_back(std::move(*fields));
        }
    }
    if (targets.empty()) {
        return {};
    }
    const auto maps = patch_map_fields(names, site, grid, members, window);
    return {report::filled_template(
                "where_it_protects.html",
                {{"targets", targets}, {"splits_climates", splits_charts(names)}, {"maps", maps}}),
            maps.has_value()};
}

}  // namespace coupling::decades

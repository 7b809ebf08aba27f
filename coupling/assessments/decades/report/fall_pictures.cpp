#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/report/shown_ground.hpp"
#include "coupling/results/report/map/map_colours.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::ColourScale;

/// Years of a map that the page shows: pictures of more would make it heavy.
constexpr std::size_t most_years = 4;
/// Stands for the bare slope among the courses.
constexpr std::size_t no_regime = std::numeric_limits<std::size_t>::max();

using PictureCells = std::vector<rockfall::CellSums>;
using CellsOfYears = std::map<std::pair<std::size_t, std::int32_t>, PictureCells>;

/// Rocks of all replicates; of the bare slope those of the first course, for all have the same.
CellsOfYears summed(const Names& names, const RunView& run, std::span<const MemberYears> members) {
    CellsOfYears sums;
    for (const MemberYears& member : members) {
        for (const CellMap& map : member.maps) {
            const bool of_bare = map.cover == Cover::bare;
            const std::size_t course = names.course_of(member.member);
            if (of_bare && course != run.regimes.front().course) {
                continue;
            }
            PictureCells& sum = sums[{of_bare ? no_regime : course, map.year}];
            sum.resize(map.cells.size());
            for (std::size_t i = 0; i < sum.size(); ++i) {
                sum[i].add(map.cells[i]);
            }
        }
    }
    return sums;
}

/// The first and the last year and some between.
std::vector<std::int32_t> shown_years(const CellsOfYears& sums) {
    std::set<std::int32_t> known;
    for (const auto& [key, cells] : sums) {
        known.insert(key.second);
    }
    const std::vector<std::int32_t> years{known.begin(), known.end()};
    if (years.size() <= most_years) {
        return years;
    }
    std::vector<std::int32_t> shown;
    for (std::size_t i = 0; i < most_years; ++i) {
        shown.push_back(years[i * (years.size() - 1) / (most_years - 1)]);
    }
    return shown;
}

struct Quantity {
    const char* stem;
    const char* name;
    const char* meaning;
    const char* effect_unit;      ///< empty: no map of what the forest changes
    bool names_energies = false;  ///< the meaning says what energies count
};
constexpr std::array quantities{
    Quantity{"Reach_probability", "Reach probability",
             "Rocks that pass a cell, in percent of all rocks from the sources that feed it; colours by "
             "powers of ten.",
             ""},
    Quantity{"E_mean", "Energy, mean",
             "Of the largest kinetic energy ({energies}) of each rock in a cell. For the forest effect, "
             "cells that no rock reaches count as 0 kJ.",
             "kJ", true},
    Quantity{"E_max", "Energy, largest", "Of any rock in a cell.", ""},
    Quantity{"Nr_passages", "Rocks that pass", "Each rock counts once in a cell; colours by powers of ten.",
             "rocks"},
    Quantity{"Nr_tree_impacts", "Hits on trees", "Of the rocks of all replicates; colours by powers of ten.",
             ""},
};

std::string meaning_of(const Quantity& quantity) {
    return quantity.names_energies
               ? report::page_text(quantity.meaning,
                                   {{"energies", report::in_page_language(rockfall::what_energies_count())}})
               : report::page_text(quantity.meaning);
}

class FallPictures {
public:
    /// `defines`: the page has no other map of this site before.
    FallPictures(const Site& site, const Names& names, const RunView& run,
                 std::span<const MemberYears> members, const report::MapWindow& window, bool defines)
        : defines_{defines},
          site_{site},
          run_{run},
          sheet_{site, window},
          sums_{summed(names, run, members)},
          years_{shown_years(sums_)} {}

    [[nodiscard]] std::optional<report::PageFields> fields();

private:
    [[nodiscard]] config::Raster<float> values(const RasterKind& kind, std::size_t slope,
                                               std::int32_t year) const;
    [[nodiscard]] config::Raster<float> effect(const RasterKind& kind, std::size_t course,
                                               std::int32_t year) const;
    std::optional<report::PageFields> block(const Quantity& quantity);
    std::string figure(const Quantity& quantity, const std::string& title,
                       const config::Raster<float>& values, const ColourScale& scale);
    [[nodiscard]] std::string title(std::size_t slope, std::int32_t year) const;

    bool defines_;
    const Site& site_;
    const RunView& run_;
    report::MapSheet sheet_;
    CellsOfYears sums_;
    std::vector<std::int32_t> years_;
    int legends_ = 0;
};

config::Raster<float> FallPictures::values(const RasterKind& kind, std::size_t slope,
                                           std::int32_t year) const {
    config::Raster<float> raster{site_.map_frame, std::numeric_limits<float>::quiet_NaN()};
    if (const auto found = sums_.find({slope, year}); found != sums_.end()) {
        for (std::size_t cell = 0; cell < found->second.size(); ++cell) {
            if (found->second[cell].passages > 0) {
                raster.values[cell] = kind.value(found->second[cell], nullptr, cell);
            }
        }
    }
    return report::without_zeros(std::move(raster));
}

config::Raster<float> FallPictures::effect(const RasterKind& kind, std::size_t course,
                                           std::int32_t year) const {
    config::Raster<float> difference = values(kind, course, year);
    const config::Raster<float> without = values(kind, no_regime, year);
    for (std::size_t cell = 0; cell < difference.values.size(); ++cell) {
        float& value = difference.values[cell];
        const float other = without.values[cell];
        if (!std::isnan(value) || !std::isnan(other)) {
            value = (std::isnan(value) ? 0.0F : value) - (std::isnan(other) ? 0.0F : other);
        }
    }
    return difference;
}

std::string FallPictures::title(std::size_t slope, std::int32_t year) const {
    const auto regime = std::find_if(run_.regimes.begin(), run_.regimes.end(),
                                     [&](const RegimeView& view) { return view.course == slope; });
    const std::string name = regime == run_.regimes.end() ? report::page_text("bare slope")
                             : run_.regimes.size() > 1    ? regime->title()
                                                          : report::page_text("with forest");
    return report::join_with_commas({year == 0
                                         ? report::page_text("start")
                                         : report::page_text("year {year}", {{"year", std::to_string(year)}}),
                                     name});
}

std::string FallPictures::figure(const Quantity& quantity, const std::string& title,
                                 const config::Raster<float>& values, const ColourScale& scale) {
    return sheet_.figure(
        {title, report::join_with_commas({report::page_text(quantity.name), title}),
         sheet_.picture(values, scale), scale.legend(joined("fall-ramp", std::to_string(++legends_))), "",
         report::page_text(quantity.name)},
        report::MapSize::third);
}

std::optional<report::PageFields> FallPictures::block(const Quantity& quantity) {
    const RasterKind& kind = raster_kind(quantity.stem);
    ValueRange range{std::numeric_limits<float>::infinity(), 0.0F};
    double reach = 0.0;
    std::vector<std::size_t> slopes;
    for (const RegimeView& regime : run_.regimes) {
        slopes.push_back(regime.course);
    }
    if (std::string_view{quantity.stem} != "Nr_tree_impacts") {
        slopes.push_back(no_regime);
    }
    for (const std::int32_t year : years_) {
        for (const std::size_t slope : slopes) {
            const ValueRange here = range_of(values(kind, slope, year));
            range = {here.high > 0.0F ? std::min(range.low, here.low) : range.low,
                     std::max(range.high, here.high)};
            if (*quantity.effect_unit != '\0' && slope != no_regime) {
                reach = std::max(reach, report::bulk_of(effect(kind, slope, year)));
            }
        }
    }
    if (!(range.high > 0.0F)) {
        return std::nullopt;
    }
    const ColourScale scale = report::scale_for(kind, range);
    const ColourScale effects = ColourScale::difference(reach, quantity.effect_unit);
    std::string figures;
    for (const std::int32_t year : years_) {
        for (const std::size_t slope : slopes) {
            figures += figure(quantity, title(slope, year), values(kind, slope, year), scale);
        }
        for (const std::size_t slope : slopes) {
            if (*quantity.effect_unit != '\0' && slope != no_regime) {
                figures += figure(
                    quantity,
                    report::page_text("forest effect, {slope_year}", {{"slope_year", title(slope, year)}}),
                    effect(kind, slope, year), effects);
            }
        }
    }
    return report::PageFields{
        {"quantity", report::page_text(quantity.name)}, {"meaning", meaning_of(quantity)}, {"maps", figures}};
}

std::optional<report::PageFields> FallPictures::fields() {
    if (years_.empty()) {
        return std::nullopt;
    }
    std::vector<report::PageFields> blocks;
    for (const Quantity& quantity : quantities) {
        if (auto maps = block(quantity)) {
            blocks.push_back(std::move(*maps));
        }
    }
    return report::PageFields{{"definitions", defines_ ? sheet_.definitions() : ""}, {"quantities", blocks}};
}

}  // namespace

std::optional<report::PageFields> maps_of_falls(const PageContent& content, const RunView& run) {
    const bool known = content.site != nullptr && !run.regimes.empty() &&
                       std::any_of(content.members.begin(), content.members.end(),
                                   [](const MemberYears& member) { return !member.maps.empty(); });
    return known ? FallPictures{*content.site,
                                content.names,
                                run,
                                content.members,
                                shown_ground(*content.site, content.grid, content.members),
                                !content.has_maps}
                       .fields()
                 : std::nullopt;
}

}  // namespace coupling::decades

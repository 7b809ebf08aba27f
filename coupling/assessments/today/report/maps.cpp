#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/assessments/today/report/shown_window.hpp"
#include "coupling/results/figures/most_reached.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/report/map/energy_classes.hpp"
#include "coupling/results/report/map/map_colours.hpp"
#include "coupling/results/report/map/map_key.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

constexpr std::size_t most_drawn_paths = 500;

/// All maps of the page; gives each legend a name of its own.
class MapPage {
public:
    explicit MapPage(const RunResults& results)
        : results_{results}, sheet_{results.site, shown_window(results)}, covers_{covers_of(results)} {
        sheet_.name_only(most_reached(results.tally.targets, most_targets_shown));
    }

    PageFields fields();

private:
    /// The energies on each slope in common classes.
    std::string first_maps();
    std::string path_maps();
    /// A quantity on each slope in common colours, and what the forest changes.
    std::string row(const char* stem, const std::string& name, const std::string& difference_unit);
    std::string rests_and_hits();
    [[nodiscard]] std::string next_legend() { return joined("ramp", std::to_string(++legends_)); }
    [[nodiscard]] bool has_percentiles() const {
        return results_.histograms[index_of(Cover::bare)] != nullptr;
    }
    [[nodiscard]] ValueRange common_range(const RasterKind& kind) const;
    std::string value_map(const RasterKind& kind, Cover cover, const ColourScale& scale,
                          const std::string& title, const std::string& group);
    std::string difference_map(const RasterKind& kind, const std::string& unit, const std::string& group);

    const RunResults& results_;
    MapSheet sheet_;
    std::vector<Cover> covers_;
    int legends_ = 0;
};

std::string path_legend() {
    return class_legend_of(energy_class_colours.size(), 2, " paths", [](std::size_t i) {
        return LegendEntry{svg_path(joined("class", std::to_string(i)), "M0 -3l9 -5l9 6l9 -4"),
                           energy_class_name(i)};
    });
}

/// At most `most_drawn_paths` of the paths on one slope, evenly chosen.
std::vector<const rockfall::PathRecord*> drawn_paths(const RunResults& results, Cover cover) {
    std::vector<const rockfall::PathRecord*> kept;
    for (const rockfall::PathRecord& path : results.paths) {
        if (path.cover == cover && !path.points.empty()) {
            kept.push_back(&path);
        }
    }
    if (kept.size() <= most_drawn_paths) {
        return kept;
    }
    std::vector<const rockfall::PathRecord*> chosen;
    for (std::size_t i = 0; i < most_drawn_paths; ++i) {
        chosen.push_back(kept[i * kept.size() / most_drawn_paths]);
    }
    return chosen;
}

std::string MapPage::first_maps() {
    const RasterKind& kind = raster_kind(has_percentiles() ? "E_95" : "E_max");
    const ColourScale scale = scale_for(kind, common_range(kind));
    const std::string& name =
        has_percentiles() ? page_text("Energy, 95th percentile") : page_text("Energy, largest of a cell");
    std::string html;
    for (const Cover cover : covers_) {
        const config::Raster<float> shown = without_zeros(raster_of(kind, results_, cover));
        const std::string title = join_with_commas({name, title_of(cover)});
        html +=
            sheet_.figure({title, title, sheet_.picture(shown, scale), scale.legend(next_legend()), "", {}},
                          covers_.size() > 1 ? MapSize::third : MapSize::half);
    }
    return html;
}

std::string MapPage::path_maps() {
    std::string html;
    for (const Cover cover : covers_) {
        const std::vector<const rockfall::PathRecord*> drawn = drawn_paths(results_, cover);
        const std::string caption = page_text(
            covers_.size() > 1 ? "{drawn} of {rocks} rocks, the same ones on both slopes; colour and "
                                 "width by kinetic energy."
                               : "{drawn} of {rocks} rocks; colour and width by kinetic energy.",
            {{"drawn", grouped(drawn.size())}, {"rocks", grouped(results_.rocks)}});
        html += sheet_.figure(
            {title_of(cover), page_text("Sampled paths, {title_of}", {{"title_of", title_of(cover)}}),
             sheet_.paths(drawn), path_legend(), caption},
            MapSize::half);
    }
    return html;
}

ValueRange MapPage::common_range(const RasterKind& kind) const {
    ValueRange common{std::numeric_limits<float>::infinity(), 0.0F};
    for (const Cover cover : covers_) {
        const ValueRange range = range_of(without_zeros(raster_of(kind, results_, cover)));
        common = {std::min(common.low, range.low), std::max(common.high, range.high)};
    }
    return common;
}

std::string MapPage::value_map(const RasterKind& kind, Cover cover, const ColourScale& scale,
                               const std::string& title, const std::string& group) {
    const config::Raster<float> shown = without_zeros(raster_of(kind, results_, cover));
    return sheet_.figure({title, join_with_commas({std::string{kind.meaning}, title_of(cover)}),
                          sheet_.picture(shown, scale), scale.legend(next_legend()), "", group},
                         MapSize::third);
}

std::string MapPage::difference_map(const RasterKind& kind, const std::string& unit,
                                    const std::string& group) {
    const config::Raster<float> difference = difference_of(kind, results_);
    const auto share_where = [&](auto condition) {
        const auto cells = std::count_if(difference.values.begin(), difference.values.end(),
                                         [](float v) { return !std::isnan(v); });
        const auto those = std::count_if(difference.values.begin(), difference.values.end(), condition);
        return percent(cells == 0 ? 0.0 : static_cast<double>(those) / static_cast<double>(cells));
    };
    const std::string caption =
        page_text("Blue: less with forest, in {less} of the cells that rocks pass; red: more, in {more}.",
                  {{"less", share_where([](float v) { return v < 0.0F; })},
                   {"more", share_where([](float v) { return v > 0.0F; })}});
    const ColourScale scale = ColourScale::difference(bulk_of(difference), unit);
    return sheet_.figure({page_text("Forest effect (forest − bare)"),
                          page_text("{kind_meaning}, with forest minus bare slope",
                                    {{"kind_meaning", std::string{kind.meaning}}}),
                          sheet_.picture(difference, scale), scale.legend(next_legend()), caption, group},
                         MapSize::third);
}

std::string MapPage::row(const char* stem, const std::string& name, const std::string& difference_unit) {
    const RasterKind& kind = raster_kind(stem);
    const ColourScale scale = scale_for(kind, common_range(kind));
    std::string html;
    for (const Cover cover : covers_) {
        html += value_map(kind, cover, scale, title_of(cover), name);
    }
    return results_.with_forest ? joined(html, difference_map(kind, difference_unit, name)) : html;
}

std::string MapPage::rests_and_hits() {
    const RasterKind& rests = raster_kind("Nr_deposited");
    const ColourScale scale = scale_for(rests, common_range(rests));
    std::string html;
    for (const Cover cover : covers_) {
        html += value_map(rests, cover, scale,
                          page_text("Come to rest, {title_of}", {{"title_of", title_of(cover)}}),
                          page_text("Rocks at rest"));
    }
    if (results_.with_forest) {
        const RasterKind& hits = raster_kind("Nr_tree_impacts");
        html += value_map(hits, Cover::forest,
                          scale_for(hits, range_of(raster_of(hits, results_, Cover::forest))),
                          page_text("Hits on trees"), page_text("Hits on trees"));
    }
    return html;
}

PageFields MapPage::fields() {
    const Site& site = results_.site;
    const std::uint64_t stems_a_dot = sheet_.stems_a_dot();
    const bool with_trees = !site.trees.empty();
    const auto part = [](bool is_shown, const char* name, const std::string& text) {
        return is_shown ? std::optional{PageFields{{name, text}}} : std::nullopt;
    };
    return {{"map_definitions", sheet_.definitions()},
            {"first_maps", first_maps()},
            {"step_m", tick_text(sheet_.contour_step_m())},
            {"with_trees", with_trees},
            {"with_picture", site.picture != nullptr},
            {"all_stems", with_trees && stems_a_dot <= 1},
            {"some_stems", part(with_trees && stems_a_dot > 1, "stems", grouped(stems_a_dot))},
            {"lines", lines_in_words(drawn_of(site), {.distances_along_lines = true})},
            {"map_key", map_key(drawn_of(site))},
            {"cell_width_m", three_digits(site.map_frame.cell_width_m)},
            {"in_blocks", part(sheet_.block() > 1, "side", std::to_string(sheet_.block()))},
            {"paths", !results_.paths.empty()},
            {"path_maps", results_.paths.empty() ? "" : path_maps()},
            {"reach_maps", row("Reach_probability", page_text("Reach probability"), page_text("points"))},
            {"percentiles", has_percentiles()},
            {"least_rocks", grouped(rocks_to_tell(0.95))},
            {"energy_maps", has_percentiles() ? row("E_95", page_text("Energy, 95th percentile"), "kJ") : ""},
            {"passage_maps", row("Nr_passages", page_text("Rocks that pass"), page_text("rocks"))},
            {"rest_maps", rests_and_hits()}};
}

}  // namespace

PageFields maps(const RunResults& results) {
    return MapPage{results}.fields();
}

}  // namespace coupling::report

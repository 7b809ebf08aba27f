#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/assessments/today/report/shown_window.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/report/map/energy_classes.hpp"
#include "coupling/results/report/map/map_colours.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::report {
namespace {

using config::joined;

constexpr std::size_t most_drawn_paths = 500;

/// Puts maps into rows and gives each legend a name of its own.
class MapPage {
public:
    explicit MapPage(const RunResults& results)
        : results_{results}, sheet_{results.site, shown_window(results)}, covers_{covers_of(results)} {}

    /// What maps refer to, and the energies on each slope in common classes.
    void first_maps();

    void paths();
    /// A quantity on each slope in common colours, and what the forest changes.
    void row(const char* stem, const std::string& name, const std::string& difference_unit,
             const std::string& meaning, const std::string& about_effect);
    void rests_and_hits();
    [[nodiscard]] std::string about() const;
    [[nodiscard]] std::string lines_in_words() const;
    [[nodiscard]] std::string html() const { return html_; }

private:
    [[nodiscard]] std::string next_legend() { return joined("ramp", std::to_string(++legends_)); }
    [[nodiscard]] ValueRange common_range(const RasterKind& kind) const;
    std::string value_map(const RasterKind& kind, Cover cover, const ColourScale& scale,
                          const std::string& title, const std::string& group);
    std::string difference_map(const RasterKind& kind, const std::string& unit, const std::string& group);

    const RunResults& results_;
    MapSheet sheet_;
    std::vector<Cover> covers_;
    std::string html_;
    int legends_ = 0;
};

std::string path_legend() {
    return class_legend_of(energy_class_colours.size(), 2, " paths", [](std::size_t i) {
        return LegendEntry{joined("<path class=\"class", std::to_string(i), "\" d=\"M0 -3l9 -5l9 6l9 -4\"/>"),
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

void MapPage::first_maps() {
    const bool has_percentiles = results_.histograms[index_of(Cover::bare)] != nullptr;
    const RasterKind& kind = raster_kind(has_percentiles ? "E_95" : "E_max");
    const ColourScale scale = scale_for(kind, common_range(kind));
    const std::string& name =
        has_percentiles ? page_text("Energy, 95th percentile") : page_text("Energy, largest of a cell");
    html_ = joined(sheet_.definitions(), "<div class=\"maps\">");
    for (const Cover cover : covers_) {
        const config::Raster<float> shown = without_zeros(raster_of(kind, results_, cover));
        html_ += sheet_.figure({joined(name, ", ", title_of(cover)),
                                joined(name, ", ", title_of(cover)),
                                sheet_.picture(shown, scale),
                                scale.legend(next_legend()),
                                "",
                                {}},
                               covers_.size() > 1 ? MapSize::third : MapSize::half);
    }
    html_ += joined("<p class=\"soft\">", lines_in_words(), "</p></div>\n");
}

std::string MapPage::lines_in_words() const {
    const std::uint64_t stems_a_dot = sheet_.stems_a_dot();
    return join_sentences(
        {page_text(
             "Contours every {contour_step_m} m. Thin outlines: release sources. Thick lines: targets, with "
             "distances in m along lines.",
             {{"contour_step_m", tick_text(sheet_.contour_step_m())}}),
         results_.site.trees.empty() ? ""
         : stems_a_dot > 1 ? page_text("Green dots: one stem in {stems}.", {{"stems", grouped(stems_a_dot)}})
                           : page_text("Green dots: stems."),
         results_.site.nets.empty() ? "" : page_text("Blue broken lines: nets.")});
}

void MapPage::paths() {
    if (results_.paths.empty()) {
        return;
    }
    html_ += joined("<h3>", page_text("Sampled paths"), "</h3>\n<div class=\"halves\">");
    for (const Cover cover : covers_) {
        const std::vector<const rockfall::PathRecord*> drawn = drawn_paths(results_, cover);
        const std::string caption = page_text(
            covers_.size() > 1 ? "{drawn} of {rocks} rocks, the same ones on both slopes; colour and "
                                 "width by kinetic energy."
                               : "{drawn} of {rocks} rocks; colour and width by kinetic energy.",
            {{"drawn", grouped(drawn.size())}, {"rocks", grouped(results_.rocks)}});
        html_ += sheet_.figure(
            {title_of(cover), page_text("Sampled paths, {title_of}", {{"title_of", title_of(cover)}}),
             sheet_.paths(drawn), path_legend(), caption},
            MapSize::half);
    }
    html_ += "</div>\n";
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
    return sheet_.figure({title, joined(std::string{kind.meaning}, ", ", title_of(cover)),
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

void MapPage::row(const char* stem, const std::string& name, const std::string& difference_unit,
                  const std::string& meaning, const std::string& about_effect) {
    const RasterKind& kind = raster_kind(stem);
    if (kind.percentile && results_.histograms[index_of(Cover::bare)] == nullptr) {
        return;
    }
    const ColourScale scale = scale_for(kind, common_range(kind));
    html_ += joined("<h3>", name, "</h3>\n<p class=\"soft\">",
                    join_sentences({meaning, results_.with_forest ? about_effect : ""}),
                    "</p>\n<div class=\"thirds\">");
    for (const Cover cover : covers_) {
        html_ += value_map(kind, cover, scale, title_of(cover), name);
    }
    if (results_.with_forest) {
        html_ += difference_map(kind, difference_unit, name);
    }
    html_ += "</div>\n";
}

void MapPage::rests_and_hits() {
    const RasterKind& rests = raster_kind("Nr_deposited");
    const ColourScale scale = scale_for(rests, common_range(rests));
    html_ += joined("<h3>",
                    page_text(results_.with_forest ? "Where rocks come to rest, and where they hit trees"
                                                   : "Where rocks come to rest"),
                    "</h3>\n<p class=\"soft\">",
                    page_text("Rocks that stop, and hits on trees, in each cell; colours by powers of ten."),
                    "</p>\n<div class=\"thirds\">");
    for (const Cover cover : covers_) {
        html_ += value_map(rests, cover, scale,
                           page_text("Come to rest, {title_of}", {{"title_of", title_of(cover)}}),
                           page_text("Rocks at rest"));
    }
    if (results_.with_forest) {
        const RasterKind& hits = raster_kind("Nr_tree_impacts");
        html_ += value_map(hits, Cover::forest,
                           scale_for(hits, range_of(raster_of(hits, results_, Cover::forest))),
                           page_text("Hits on trees"), page_text("Hits on trees"));
    }
    html_ += "</div>\n";
}

std::string MapPage::about() const {
    const std::string side = std::to_string(sheet_.block());
    return join_sentences(
        {page_text(
             "North is up; coordinates and scale in metres; cells of {cell_width_m} m. Maps show the part "
             "where rocks go. Light of the hillshade from the north-west, 45° high.",
             {{"cell_width_m", three_digits(results_.site.map_frame.cell_width_m)}}),
         lines_in_words(),
         results_.with_forest ? page_text("Colours of a forest effect end at its 99th percentile.") : "",
         sheet_.block() > 1 ? page_text("The pictures show blocks of {side} × {side} cells, of each the "
                                        "value farthest from 0; the "
                                        "grids in rasters/ hold every cell.",
                                        {{"side", side}})
                            : ""});
}

std::string switch_for(const char* what, const std::string& label) {
    return joined("<label><input type=\"checkbox\" id=\"show-", what, "\" checked=\"checked\"/> ", label,
                  "</label>");
}

}  // namespace

std::string first_maps(const RunResults& results) {
    MapPage page{results};
    page.first_maps();
    return page.html();
}

std::string maps(const RunResults& results) {
    MapPage page{results};
    page.paths();
    page.row("Reach_probability", page_text("Reach probability"), page_text("points"),
             page_text("Rocks that pass a cell, in percent of all rocks from the sources that feed it; "
                       "colours by powers of ten."),
             page_text("For the forest effect both are shares of the same rocks."));
    page.row(
        "E_95", page_text("Energy, 95th percentile"), "kJ",
        page_text(
            "Of the largest kinetic energy ({energies}) of each rock in a cell: one rock in twenty has more.",
            {{"energies", in_page_language(rockfall::what_energies_count())}}),
        page_text("For the forest effect, cells that no rock reaches count as 0 kJ."));
    page.row("Nr_passages", page_text("Rocks that pass"), page_text("rocks"),
             page_text("Each rock counts once in a cell; colours by powers of ten."), "");
    page.rests_and_hits();
    return joined("<h2>", page_text("Maps"), "</h2>\n<p class=\"soft\">", page.about(),
                  "</p>\n<figure class=\"map map-choice only-live\" hidden=\"hidden\"></figure>\n<fieldset "
                  "class=\"switches\">",
                  switch_for("hillshade", page_text("hillshade")),
                  switch_for("contours", page_text("contours")),
                  results.site.trees.empty() ? "" : switch_for("stems", page_text("stems")),
                  switch_for("sources", page_text("sources")), switch_for("targets", page_text("targets")),
                  "</fieldset>\n", page.html());
}

}  // namespace coupling::report

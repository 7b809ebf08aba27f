#include <algorithm>
#include <cmath>

#include "coupling/results/rasters.hpp"
#include "coupling/results/report/map_sheet.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/results/report/sections.hpp"

namespace coupling::report {
namespace {

constexpr std::size_t most_drawn_paths = 250;

config::Raster<float> without_zeros(config::Raster<float> raster) {
    std::replace(raster.values.begin(), raster.values.end(), 0.0F, std::numeric_limits<float>::quiet_NaN());
    return raster;
}

/// A value that all but the largest hundredth (of what is not 0) stay below, so that single cells do not rule
/// the colours.
double bulk_of(const config::Raster<float>& raster) {
    std::vector<float> sizes;
    for (const float value : raster.values) {
        if (!std::isnan(value) && value != 0.0F) {
            sizes.push_back(std::abs(value));
        }
    }
    if (sizes.empty()) {
        return 0.0;
    }
    const auto place =
        sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), place, sizes.end());
    return static_cast<double>(*place);
}

const char* title_of(Cover cover) {
    return cover == Cover::forest ? "with forest" : "bare slope";
}

/// Puts maps into rows and gives each legend a name of its own.
class MapPage {
public:
    explicit MapPage(const RunResults& results)
        : results_{results}, sheet_{results}, covers_{covers_of(results)} {
        html_ = sheet_.definitions();
    }

    void paths();
    void pair_with_difference(const char* stem, const std::string& name, const char* difference_unit,
                              const std::string& caption);
    void single_row();
    [[nodiscard]] std::string html() const { return html_; }

private:
    [[nodiscard]] std::string next_legend() { return joined("ramp", std::to_string(++legends_)); }
    [[nodiscard]] config::Raster<float> raster(const char* stem, Cover cover) const {
        return raster_of(raster_kind(stem), results_, cover);
    }
    [[nodiscard]] ColourScale scale_for(const RasterKind& kind, double high) const;
    std::string value_map(const RasterKind& kind, Cover cover, const ColourScale& scale,
                          const std::string& title, const std::string& caption);
    std::string difference_map(const RasterKind& kind, const std::string& name, const char* unit);

    const RunResults& results_;
    MapSheet sheet_;
    std::vector<Cover> covers_;
    std::string html_;
    int legends_ = 0;
};

std::string path_legend() {
    std::string svg =
        "<svg class=\"legend paths\" viewBox=\"0 0 400 44\" role=\"img\" aria-label=\"legend\">";
    for (std::size_t i = 0; i < energy_class_names.size(); ++i) {
        const double x = 4.0 + 132.0 * static_cast<double>(i);
        svg += joined("<path class=\"class", std::to_string(i), "\" d=\"M", place(x),
                      " 15l9 -5l9 6l9 -4\"/><text x=\"", place(x + 32.0), "\" y=\"18\">",
                      escaped(energy_class_names[i]), "</text>");
    }
    return joined(svg, "</svg>");
}

void MapPage::paths() {
    if (results_.paths.empty()) {
        return;
    }
    html_ += "<div class=\"halves\">";
    for (const Cover cover : covers_) {
        const auto kept =
            std::count_if(results_.paths.begin(), results_.paths.end(),
                          [&](const rockfall::PathRecord& path) { return path.cover == cover; });
        const auto every = (static_cast<std::size_t>(kept) + most_drawn_paths - 1) / most_drawn_paths;
        const std::size_t drawn = every > 0 ? (static_cast<std::size_t>(kept) + every - 1) / every : 0;
        html_ +=
            sheet_.figure({std::string{"Sampled paths, "} + title_of(cover),
                           sheet_.paths(cover, most_drawn_paths), path_legend(),
                           grouped(drawn) + " of " + grouped(results_.rocks) +
                               " rocks, the same ones on each slope; colour and width by kinetic energy."},
                          MapSize::half);
    }
    html_ += "</div>\n";
}

ColourScale MapPage::scale_for(const RasterKind& kind, double high) const {
    switch (kind.style) {
        case RasterStyle::energy_classes:
            return ColourScale::energy_classes();
        case RasterStyle::logarithmic:
            return ColourScale::logarithmic(kind.palette, 1.0, high, std::string{kind.unit});
        case RasterStyle::linear:
            break;
    }
    const bool is_share = kind.stem == "Reach_probability";
    return is_share
               ? ColourScale::logarithmic(kind.palette, 0.1, std::min(high, 100.0), std::string{kind.unit})
               : ColourScale::linear(kind.palette, high, std::string{kind.unit});
}

std::string MapPage::value_map(const RasterKind& kind, Cover cover, const ColourScale& scale,
                               const std::string& title, const std::string& caption) {
    const config::Raster<float> shown = without_zeros(raster_of(kind, results_, cover));
    return sheet_.figure({title, sheet_.picture(shown, scale), scale.legend(next_legend()), caption},
                         MapSize::third);
}

std::string MapPage::difference_map(const RasterKind& kind, const std::string& name, const char* unit) {
    const config::Raster<float> difference =
        difference_of(raster_of(kind, results_, Cover::forest), raster_of(kind, results_, Cover::bare));
    const auto present = [](float value) { return !std::isnan(value); };
    const auto cells = std::count_if(difference.values.begin(), difference.values.end(), present);
    const auto more =
        std::count_if(difference.values.begin(), difference.values.end(), [](float v) { return v > 0.0F; });
    const ColourScale scale = ColourScale::difference(bulk_of(difference), unit);
    const std::string caption =
        cells == 0 ? ""
                   : "Blue: less with forest. It rises in " +
                         percent(static_cast<double>(more) / static_cast<double>(cells)) + " of the cells.";
    return sheet_.figure({joined("Forest effect: ", name, ", with forest minus bare slope"),
                          sheet_.picture(difference, scale), scale.legend(next_legend()), caption},
                         MapSize::third);
}

void MapPage::pair_with_difference(const char* stem, const std::string& name, const char* difference_unit,
                                   const std::string& caption) {
    const RasterKind& kind = raster_kind(stem);
    if (kind.percentile && results_.histograms[index_of(Cover::bare)] == nullptr) {
        return;
    }
    double high = 0.0;
    for (const Cover cover : covers_) {
        high = std::max(high, static_cast<double>(range_of(raster_of(kind, results_, cover)).high));
    }
    const ColourScale scale = scale_for(kind, high);
    html_ += "<div class=\"thirds\">";
    for (const Cover cover : covers_) {
        html_ += value_map(kind, cover, scale, name + ", " + title_of(cover), caption);
    }
    if (results_.with_forest) {
        html_ += difference_map(kind, name, difference_unit);
    }
    html_ += "</div>\n";
}

void MapPage::single_row() {
    html_ += "<div class=\"thirds\">";
    const auto add = [&](const char* stem, Cover cover, const std::string& title,
                         const std::string& caption) {
        const RasterKind& kind = raster_kind(stem);
        const double high = static_cast<double>(range_of(raster_of(kind, results_, cover)).high);
        html_ += value_map(kind, cover, scale_for(kind, high), title, caption);
    };
    if (results_.with_forest) {
        add("Nr_tree_impacts", Cover::forest, "Hits on trees", "Where on the slope the forest works.");
        add("Nr_deposited", Cover::forest, "Rocks come to rest, with forest", "");
    }
    add("Nr_deposited", Cover::bare, "Rocks come to rest, bare slope", "");
    html_ += "</div>\n";
}

}  // namespace

std::string maps(const RunResults& results) {
    MapPage page{results};
    page.paths();
    page.pair_with_difference("Reach_probability", "Reach probability", "% points",
                              "Rocks that pass a cell, of all from the sources that feed it.");
    page.pair_with_difference("E_95", "Energy, 95th percentile", "kJ", "");
    page.pair_with_difference("Nr_passages", "Rocks that pass", "rocks", "");
    page.single_row();
    const MapSheet sheet{results};
    const double cell_m = results.site.map_frame.cell_width_m;
    std::string about = joined(
        "<p class=\"soft\">North is up; coordinates and scale in metres; cells of ", three_digits(cell_m),
        " m. Hillshade: light from the north-west, 45° high. Thin black outlines: release sources. Thick "
        "black lines: targets. Colours end at the 99th percentile in the difference maps.");
    if (sheet.block() > 1) {
        about += joined(" The pictures show blocks of ", std::to_string(sheet.block()), " x ",
                        std::to_string(sheet.block()),
                        " cells, of each the largest value; the grids in rasters/ hold every cell.");
    }
    return joined(
        "<h2>Maps</h2>\n", about,
        "</p>\n<fieldset class=\"switches\"><label><input type=\"checkbox\" id=\"show-shade\" "
        "checked=\"checked\"/> "
        "hillshade</label><label><input type=\"checkbox\" id=\"show-sources\" checked=\"checked\"/> "
        "sources</label><label><input type=\"checkbox\" id=\"show-targets\" checked=\"checked\"/> "
        "targets</label></fieldset>\n",
        page.html());
}

}  // namespace coupling::report

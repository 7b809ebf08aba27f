#include "coupling/program/actions/drawing_project.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "config/grid/ascii_grid.hpp"
#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/formats/layer_name.hpp"
#include "coupling/program/actions/drawing_layers.hpp"
#include "coupling/program/actions/given_files.hpp"
#include "coupling/program/actions/steep_cells.hpp"
#include "coupling/results/qgis/editing.hpp"
#include "coupling/results/qgis/layer_tree.hpp"
#include "coupling/results/qgis/vector_style.hpp"
#include "coupling/results/text/element.hpp"

namespace coupling {
namespace {

using config::joined;
using geopackage::Form;
using qgis::Mark;
using Layers = std::vector<const DrawingLayer*>;

constexpr const char* hillshade_file = "hillshade.asc";
constexpr const char* hillshade_system_file = "hillshade.prj";

/// The layers that a file of the user does not stand for. Cable corridors are named by tables of regimes.
Layers layers_to_draw(const GivenFiles& given) {
    Layers layers;
    for (const DrawingLayer& layer : drawing_layers()) {
        const bool is_given = layer.name.starts_with("source_")                 ? !given.sources.empty()
                              : layer.name == "roads" || layer.name == "houses" ? !given.targets.empty()
                              : layer.name == "nets"                            ? !given.nets.empty()
                              : layer.name == "grounds"
                                  ? !given.grounds.empty()
                                  : layer.name == "stands" && !(given.trees.empty() && given.stands.empty());
        if (!is_given) {
            layers.push_back(&layer);
        }
    }
    return layers;
}

bool has_layer(const Layers& layers, std::string_view name) {
    return std::any_of(layers.begin(), layers.end(),
                       [&](const DrawingLayer* layer) { return layer->name == name; });
}

/// The shipped ground types by a code each, as the layer `grounds` names them.
std::string types_by_code() {
    const config::Table surfaces = config::read_shipped_table("surfaces.csv");
    std::string table =
        "# The codes of the layer grounds: the shipped ground types (bannwald info surfaces). Add rows of "
        "your "
        "own.\ncode,label,like\n";
    for (std::size_t row = 0; row < surfaces.rows(); ++row) {
        table += joined(std::to_string(row + 1), ",", config::csv_field(surfaces.text(row, "label")), ",",
                        surfaces.text(row, "name"), "\n");
    }
    return table;
}

std::vector<qgis::Choice> ground_choices() {
    const config::Table surfaces = config::read_shipped_table("surfaces.csv");
    std::vector<qgis::Choice> choices;
    for (std::size_t row = 0; row < surfaces.rows(); ++row) {
        choices.push_back({std::to_string(row + 1), surfaces.text(row, "label")});
    }
    return choices;
}

std::vector<qgis::Choice> choices_of(const DrawingLayer& layer, const config::ColumnRules& column) {
    std::vector<qgis::Choice> choices;
    if (layer.name == "grounds" && column.name == "code") {
        return ground_choices();
    }
    if (layer.name == "stands" && column.name == "species") {
        const config::Table species = config::read_shipped_table("species.csv");
        for (std::size_t row = 0; row < species.rows(); ++row) {
            choices.push_back({species.text(row, "species_code"), species.text(row, "latin_name")});
        }
        return choices;
    }
    for (const std::string& word : column.rules.words) {
        choices.push_back({word, word});
    }
    return choices;
}

/// Ids and names that are left empty become the numbers of the features.
bool is_filled_by_reader(const DrawingLayer& layer, const std::string& column) {
    return column == "target_id" || (layer.name == "nets" && column == "name");
}

std::string form_of(const DrawingLayer& layer) {
    std::vector<qgis::FormField> fields;
    for (const config::ColumnRules& column : drawing_columns(layer)) {
        const std::string unit{column.rules.unit};  // else the name of the column ends in it
        const bool is_species = layer.name == "stands" && column.name == "species";
        fields.push_back(
            {column.name,
             joined(column.name, unit.empty() || unit == "-" ? "" : joined(" [", unit, "]"), ": ",
                    column.meaning),
             choices_of(layer, column),
             is_species || (!column.may_be_empty() && !is_filled_by_reader(layer, column.name))});
    }
    return qgis::form_of(fields);
}

std::string symbols_of(const DrawingLayer& layer, Mark mark) {
    if (layer.name != "grounds") {
        return qgis::single(mark, {"", layer.colour, mark == Mark::line ? 0.9 : 0.5});
    }
    std::vector<qgis::Category> categories;
    const std::vector<qgis::Choice> grounds = ground_choices();
    for (std::size_t i = 0; i < grounds.size(); ++i) {
        const double place = static_cast<double>(i) / static_cast<double>(grounds.size() - 1);
        categories.push_back({grounds[i].value, {grounds[i].label, colour_at(Palette::reach, place), 0.3}});
    }
    categories.push_back({"", {"other", layer.colour, 0.3}});
    return qgis::categorised(mark, "code", categories);
}

/// Files of heights that QGIS opens as they are: not folders, texts that may list files, or what is packed.
bool is_raster_for_gis(const std::string& name) {
    return !is_folder(formats::split_layer_name(name).file) && !name.ends_with(".gz") &&
           !name.ends_with(".txt");
}

/// Cells of a coarser frame over the same place, each with the mean of what is known in it. What is left of a
/// block in the east and the south is cut off.
config::Raster<double> coarser(const config::Raster<double>& heights, int cells) {
    config::GridFrame frame = heights.frame;
    frame.columns /= cells;
    frame.rows /= cells;
    frame.cell_width_m *= cells;
    frame.cell_height_m *= cells;
    frame.y_south_m = heights.frame.y_north_m() - frame.rows * frame.cell_height_m;
    config::Raster<double> thin{frame, std::numeric_limits<double>::quiet_NaN()};
    for (int row = 0; row < frame.rows; ++row) {
        for (int column = 0; column < frame.columns; ++column) {
            double sum = 0.0;
            int known = 0;
            for (int inside = 0; inside < cells * cells; ++inside) {
                const double height_m =
                    heights.at({column * cells + inside % cells, row * cells + inside / cells});
                sum += std::isnan(height_m) ? 0.0 : height_m;
                known += std::isnan(height_m) ? 0 : 1;
            }
            if (known > 0) {
                thin.values[frame.index({column, row})] = sum / known;
            }
        }
    }
    return thin;
}

/// Heights that QGIS cannot open as they are: a copy to draw on, of a million cells at most [choice].
std::vector<GivenProject::File> copy_to_draw_on(const GivenFiles& given, const DrawingGround& ground) {
    const bool opens =
        !ground.is_sample && std::all_of(given.dem.begin(), given.dem.end(), is_raster_for_gis);
    if (ground.heights == nullptr || opens) {
        return {};
    }
    constexpr double most_cells = 1e6;
    const auto cells = static_cast<int>(
        std::ceil(std::sqrt(static_cast<double>(ground.heights->frame.size()) / most_cells)));
    std::ostringstream text;
    config::write_ascii_grid(text, cells > 1 ? coarser(*ground.heights, cells) : *ground.heights);
    std::vector<GivenProject::File> files{{hillshade_file, text.str()}};
    if (!ground.system.empty()) {
        files.push_back({hillshade_system_file, ground.system + "\n"});
    }
    return files;
}

std::string from_project(const std::filesystem::path& folder, const std::string& name) {
    const std::string from = name_from(folder, name);
    return std::filesystem::path{from}.is_absolute() || from.starts_with("..") ? from : joined("./", from);
}

std::string map_of(const Layers& layers, const GivenFiles& given, const std::filesystem::path& folder,
                   const DrawingGround& ground, bool has_copy) {
    qgis::TreeGroup root{"Bannwald: draw", {}, {}, true};
    for (const DrawingLayer* layer : layers) {
        const bool is_line = layer->form == Form::line || layer->form == Form::multi_line;
        const Mark mark = is_line ? Mark::line : Mark::area;
        root.layers.push_back(
            {is_line ? qgis::TreeLayer::Kind::line : qgis::TreeLayer::Kind::area, std::string{layer->title},
             joined("./", drawing_file, "|layername=", layer->name),
             joined(symbols_of(*layer, mark), form_of(*layer)), std::string{layer->label}, true});
    }
    const std::string hillshade = report::element("pipe", {},
                                                  report::element("rasterrenderer", {{"type", "hillshade"},
                                                                                     {"band", "1"},
                                                                                     {"azimuth", "315"},
                                                                                     {"angle", "45"},
                                                                                     {"zfactor", "1"},
                                                                                     {"multidirection", "1"},
                                                                                     {"opacity", "1"},
                                                                                     {"alphaBand", "-1"}}));
    const auto add_hillshade = [&](std::string file) {
        root.layers.push_back({qgis::TreeLayer::Kind::raster, "Hillshade of the heights", std::move(file),
                               hillshade, "", true});
    };
    if (has_copy) {
        add_hillshade(joined("./", hillshade_file));
    } else if (ground.heights != nullptr) {
        for (const std::string& name : given.dem) {
            add_hillshade(from_project(folder, name));
        }
    }
    geopackage::Extent extent;
    if (ground.heights != nullptr) {
        const config::GridFrame& frame = ground.heights->frame;
        extent = {frame.x_west_m, frame.x_east_m(), frame.y_south_m, frame.y_north_m(), false};
    }
    std::ostringstream text;
    qgis::write_project(text, root, ground.system, extent);
    return text.str();
}

/// What stands in for sources that are not drawn yet: steep cells, and of a slope without cliffs the
/// steepest.
double limit_of_sources_deg(const DrawingGround& ground) {
    constexpr std::size_t least_cells = 10;  // [choice]
    constexpr double least_deg = 1.0;
    double limit_deg = source_slope_deg(ground.spacing_m);
    while (ground.heights != nullptr && limit_deg > least_deg &&
           cells_steeper_than(limit_deg, *ground.heights).count < least_cells) {
        limit_deg *= 0.9;
    }
    return std::round(10.0 * limit_deg) / 10.0;
}

std::string sources_to_draw(const std::string& limit_deg) {
    return joined("source_shapes = ", drawing_source("source_lines"), ", ", drawing_source("source_areas"),
                  "    ; where rocks break off\nundrawn_steeper_than_deg = ", limit_deg,
                  "    ; GUESS: all cells steeper than this, as long as no sources are drawn\n",
                  "rocks = 10000               ; in all\n");
}

std::string listed_names(const Layers& layers) {
    std::string names;
    for (const DrawingLayer* layer : layers) {
        names += joined(names.empty() ? "" : ", ", layer->name);
    }
    return names;
}

}  // namespace

DrawnProject drawn_project(const GivenFiles& given, const std::filesystem::path& folder,
                           const DrawingGround& ground) {
    DrawnProject drawn;
    if (!given.draw) {
        return drawn;
    }
    const Layers layers = layers_to_draw(given);
    drawn.run = joined("drawing = ", drawing_file,
                       "       ; drawn in QGIS: layers that are still empty count as not given\n");
    if (has_layer(layers, "grounds")) {
        drawn.terrain = joined("surface_polygons = ", drawing_source("grounds"),
                               "    ; ground elsewhere than `ground` says\n",
                               "surface_types = surface_types.csv    ; its codes\n");
        drawn.files.push_back({"surface_types.csv", types_by_code()});
    }
    if (has_layer(layers, "source_lines")) {
        const std::string limit_deg = config::to_text(limit_of_sources_deg(ground));
        drawn.release = sources_to_draw(limit_deg);
        drawn.printed.push_back(joined("no sources given: all cells steeper than ", limit_deg,
                                       " degrees are a guess that counts until some are drawn"));
    }
    if (has_layer(layers, "roads")) {
        drawn.targets = joined("file = ", drawing_source("roads"), ", ", drawing_source("houses"),
                               "    ; what is to be protected\n");
    }
    if (has_layer(layers, "stands")) {
        drawn.stands = joined("\n[stands]\npolygons = ", drawing_source("stands"),
                              "    ; which stand grows where\nrecords = ", drawing_source("stands"),
                              "     ; stems, basal area, diameter of its species\n");
    }
    if (has_layer(layers, "nets")) {
        drawn.nets = joined("file = ", drawing_source("nets"), "    ; nets that stand already\n");
    }
    drawn.files.push_back({drawing_file, empty_drawing(layers, ground.system)});
    std::vector<GivenProject::File> copy = copy_to_draw_on(given, ground);
    drawn.files.push_back({drawing_map_file, map_of(layers, given, folder, ground, !copy.empty())});
    std::move(copy.begin(), copy.end(), std::back_inserter(drawn.files));
    drawn.printed.push_back(joined(drawing_file, ": empty layers to draw in: ", listed_names(layers)));
    drawn.printed.push_back(joined("open ", drawing_map_file,
                                   " in QGIS, draw, save the layers, and run: layers that are still empty "
                                   "count as not given"));
    return drawn;
}

}  // namespace coupling

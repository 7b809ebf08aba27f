#include "coupling/results/qgis/results_tree.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/geopackage/layer_look.hpp"
#include "coupling/results/qgis/vector_style.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::qgis {
namespace {

using config::joined;

namespace fs = std::filesystem;
using geopackage::Form;
using geopackage::LayerLook;
using geopackage::Written;
using Kind = TreeLayer::Kind;
using report::page_text;

constexpr std::string_view hazard_zones = "hazard_zones";

std::string source_of(const std::string& layer, const std::string& subset = "") {
    return subset.empty() ? joined("./results.gpkg|layername=", layer)
                          : joined("./results.gpkg|layername=", layer, "|subset=", subset);
}

/// A value in SQL.
std::string literal(const std::string& text) {
    std::string quoted{"'"};
    for (const char c : text) {
        quoted += c;
        if (c == '\'') {
            quoted += '\'';
        }
    }
    return quoted += "'";
}

Mark mark_of(Form form) {
    return form == Form::point                              ? Mark::point
           : form == Form::line || form == Form::multi_line ? Mark::line
                                                            : Mark::area;
}

Kind kind_of(Mark mark) {
    return mark == Mark::point ? Kind::point : mark == Mark::line ? Kind::line : Kind::area;
}

void add_targets(TreeGroup& group, Colour ink) {
    const std::string source = source_of("targets");
    group.layers.push_back({Kind::line, page_text("Targets: lines"),
                            joined(source, "|geometrytype=MultiLineString"),
                            single(Mark::line, {"", ink, 1.0}), "name", true});
    group.layers.push_back({Kind::area, page_text("Targets: areas"),
                            joined(source, "|geometrytype=MultiPolygon"), single(Mark::area, {"", ink, 0.6}),
                            "name", true});
}

std::string on_slope(const std::string& title, std::string_view cover) {
    return joined(title, ", ", page_text(cover == "forest" ? "with forest" : "bare slope"));
}

void add_by_cover(TreeGroup& group, const std::string& layer, const std::string& title, Mark mark,
                  const std::string& style, bool shown) {
    for (const std::string cover : {"forest", "bare"}) {
        group.layers.push_back({kind_of(mark), on_slope(title, cover),
                                source_of(layer, joined("\"cover\" = '", cover, "'")), style, "",
                                shown && cover == "forest"});
    }
}

std::string tree_style(const LayerLook& look) {
    const Symbol unhit{report::message_text("no energy taken"), look.colour, 0.5};
    return by_energy(Mark::point, look.energy_column, 0.8, &unhit);
}

/// One layer for each regime, climate and year, from the first replicate; the last of them is shown.
void add_trees_by_year(TreeGroup& group, const fs::path& folder, const LayerLook& look) {
    geopackage::Database database{folder / "results.gpkg", geopackage::Database::Open::to_read};
    geopackage::Statement years = database.prepare(
        "SELECT regime, climate, year, (SELECT count(DISTINCT climate) FROM trees) FROM trees "
        "GROUP BY regime, climate, year ORDER BY min(fid)");
    TreeGroup trees{page_text("Trees, first replicate"), {}, {}, true};
    while (years.step()) {
        const std::string regime = years.text(0);
        const std::string climate = years.text(1);
        const std::string year = years.text(2);
        const bool several = years.text(3) != "1";
        trees.layers.push_back(
            {Kind::point,
             joined(regime, several ? joined(", ", climate) : "", ", ",
                    page_text("year {year}", {{"year", year}})),
             source_of("trees", joined("\"regime\" = ", literal(regime),
                                       several ? joined(" AND \"climate\" = ", literal(climate)) : "",
                                       " AND \"year\" = ", year, " AND \"replicate\" = 1")),
             tree_style(look), "", false});
    }
    if (!trees.layers.empty()) {
        trees.layers.back().shown = true;
        group.groups.push_back(std::move(trees));
    }
}

/// A layer whose classes have a colour each, and the first of them a mark so large.
std::string by_classes(Mark mark, const LayerLook& look, double size_mm, double larger_by_mm) {
    std::vector<Category> categories;
    for (const geopackage::DrawnClass& drawn : look.classes) {
        categories.push_back({drawn.value, {report::message_text(drawn.label), drawn.colour, size_mm}});
        size_mm += larger_by_mm;
    }
    return categorised(mark, look.class_column, categories);
}

/// One layer for each slope and rule; of hazard.rule that with forest is shown, or the bare slope alone.
void add_hazard_zones(TreeGroup& group, const fs::path& folder, const std::string& layer,
                      const std::string& style) {
    geopackage::Database database{folder / "results.gpkg", geopackage::Database::Open::to_read};
    const bool is_ruling = layer == hazard_zones;
    geopackage::Statement slopes = database.prepare(
        joined("SELECT cover, rule FROM ", layer, " GROUP BY cover, rule ORDER BY cover = 'bare'"));
    bool shown = is_ruling;
    while (slopes.step()) {
        const std::string cover = slopes.text(0);
        group.layers.push_back({Kind::area,
                                on_slope(page_text(is_ruling ? "Hazard zones by rule {rule}"
                                                             : "Hazard zones by rule {rule}, for comparison",
                                                   {{"rule", slopes.text(1)}}),
                                         cover),
                                source_of(layer, joined("\"cover\" = ", literal(cover))), style, "", shown});
        shown = false;
    }
}

/// Lines and areas of each slope.
void add_target_levels(TreeGroup& group, const std::string& layer, const LayerLook& look) {
    for (const std::string cover : {"forest", "bare"}) {
        for (const Mark mark : {Mark::line, Mark::area}) {
            const bool is_line = mark == Mark::line;
            group.layers.push_back({kind_of(mark),
                                    on_slope(page_text(is_line ? "Targets by hazard level: lines"
                                                               : "Targets by hazard level: areas"),
                                             cover),
                                    joined("./results.gpkg|layername=", layer,
                                           "|geometrytype=", is_line ? "MultiLineString" : "MultiPolygon",
                                           "|subset=\"cover\" = ", literal(cover)),
                                    by_classes(mark, look, is_line ? 1.4 : 0.4, 0.0), "name", false});
        }
    }
}

/// How a layer of the package is drawn.
void add_layer(TreeGroup& group, const fs::path& folder, const Written& layer) {
    const std::string& name = layer.plan.name;
    const Mark mark = mark_of(layer.plan.form);
    const LayerLook look = geopackage::look_of(layer.plan);
    const std::string title = geopackage::layer_title(layer.plan);
    const auto add = [&](const std::string& style) {
        group.layers.push_back({kind_of(mark), title, source_of(name), style, "", look.shown});
    };
    const auto by_cover = [&](double least_size_mm) {
        add_by_cover(group, name, title, mark, by_energy(mark, look.energy_column, least_size_mm),
                     look.shown);
    };
    if (name == "targets") {
        add_targets(group, look.colour);
    } else if (name == "sources") {
        add(single(mark, {"", look.colour, mark == Mark::point ? 2.0 : mark == Mark::line ? 0.6 : 0.0}));
    } else if (name == "trajectories") {
        by_cover(0.2);
    } else if (name == "deposits") {
        by_cover(0.9);
    } else if (name == "arrivals" || name == "net_crossings") {
        by_cover(1.2);
    } else if (name == "trees" && look.energy_column == "rock_energy_kj") {
        add_trees_by_year(group, folder, look);
    } else if (name == "trees") {
        add(tree_style(look));
    } else if (name == "tree_hits") {
        add(by_classes(mark, look, 1.0, 0.6));
    } else if (name == "log_hits" || name == "removed_trees") {
        add(single(mark, {"", look.colour, 1.2}));
    } else if (name == "nets" || name == "works") {
        add(single(mark, {"", look.colour, 1.0}));
    } else if (name == "target_levels") {
        add_target_levels(group, name, look);
    } else if (name.starts_with(hazard_zones)) {
        add_hazard_zones(group, folder, name, by_classes(mark, look, 0.3, 0.0));
    } else if (!look.class_column.empty()) {
        add_by_cover(group, name, title, mark, by_classes(mark, look, 0.3, 0.0), false);
    } else {
        add(single(mark, {"", look.colour, 0.8}));
    }
}

/// The <pipe> of the style beside a raster; empty where there is none.
std::string pipe_of(const fs::path& raster) {
    fs::path style = raster;
    style.replace_extension(".qml");
    if (!path_exists(style)) {
        return {};
    }
    const FileBytes bytes = open_file(style, {.file = style.string()}, "the style of a raster");
    const std::string_view text = bytes.text();
    const std::size_t first = text.find("<pipe>");
    const std::size_t last = text.find("</pipe>");
    return first == std::string_view::npos || last == std::string_view::npos
               ? std::string{}
               : joined(text.substr(first, last + 7 - first), "\n");
}

/// What the folders of rasters are called in the tree: names of regimes and climates as they are.
std::string group_title(const std::string& folder) {
    if (folder.starts_with("year_")) {
        return page_text("year {year}", {{"year", folder.substr(5)}});
    }
    return folder == "rasters"      ? page_text("Rasters")
           : folder == "forest"     ? page_text("with forest")
           : folder == "bare"       ? page_text("bare slope")
           : folder == "difference" ? page_text("with forest minus bare slope")
           : folder == "all_years"  ? page_text("all years")
           : folder == "rockfall"   ? page_text("Rockfall")
           : folder == "collapse"   ? page_text("Collapse of the rock mass")
                                    : folder;
}

TreeGroup& group_at(TreeGroup& root, const fs::path& folders) {
    TreeGroup* group = &root;
    for (const fs::path& folder : folders) {
        const std::string title = group_title(folder.string());
        auto found = std::find_if(group->groups.begin(), group->groups.end(),
                                  [&](const TreeGroup& below) { return below.title == title; });
        if (found == group->groups.end()) {
            found = group->groups.insert(group->groups.end(), {title, {}, {}, folder == "rasters"});
        }
        group = &*found;
    }
    return *group;
}

/// The map that a project opens with: the hazard level, else how likely rocks come; with forest where there
/// is one. Empty where there is none of them.
std::string first_map(std::span<const WrittenFile> files) {
    for (const char* map : {"rasters/forest/Hazard_level.asc", "rasters/bare/Hazard_level.asc",
                            "rasters/forest/Reach_probability.asc", "rasters/bare/Reach_probability.asc"}) {
        if (std::any_of(files.begin(), files.end(), [&](const WrittenFile& f) { return f.path == map; })) {
            return map;
        }
    }
    return "";
}

void add_rasters(TreeGroup& root, const fs::path& folder, std::span<const WrittenFile> files) {
    const std::string first = first_map(files);
    for (const WrittenFile& file : files) {
        const fs::path path{file.path};
        if (path.extension() != ".asc") {
            continue;
        }
        const bool show = file.path == first;
        group_at(root, path.parent_path())
            .layers.push_back({Kind::raster,
                               joined(geopackage::words_of(file.sentence), " (", path.stem().string(), ")"),
                               joined("./", file.path), pipe_of(folder / path), "", show});
    }
}

}  // namespace

TreeGroup results_tree(const fs::path& folder, std::span<const WrittenFile> files,
                       std::span<const Written> layers) {
    TreeGroup root{"Bannwald", {}, {}, true};
    TreeGroup tables{page_text("Tables"), {}, {}, false};
    for (const Written& layer : layers) {
        if (layer.plan.form == Form::none) {
            tables.layers.push_back(
                {Kind::table, layer.plan.name, source_of(layer.plan.name), "", "", false});
        } else {
            add_layer(root, folder, layer);
        }
    }
    add_rasters(root, folder, files);
    root.groups.push_back(std::move(tables));
    return root;
}

WrittenFile write_results_tree(const fs::path& folder, const std::string& projection,
                               std::span<const WrittenFile> files, std::span<const Written> layers) {
    OutFile file{folder / "results.qlr"};
    write_layer_tree(file.stream(), results_tree(folder, files, layers), projection);
    file.close();
    return {"results.qlr", "All layers and maps, styled and grouped: drag it into QGIS."};
}

}  // namespace coupling::qgis

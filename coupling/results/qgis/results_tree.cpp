#include "coupling/results/qgis/results_tree.hpp"

#include <algorithm>
#include <cctype>

#include "config/text/joined.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/qgis/vector_style.hpp"

namespace coupling::qgis {
namespace {

using config::joined;

namespace fs = std::filesystem;
using geopackage::Form;
using geopackage::Written;
using Kind = TreeLayer::Kind;

constexpr Colour brown{0x8c, 0x51, 0x0a};
constexpr Colour dark_green{0x00, 0x44, 0x1b};
constexpr Colour pale_green{0xa1, 0xd9, 0x9b};
constexpr Colour blue{0x05, 0x30, 0x61};
constexpr Colour ink{0x20, 0x20, 0x20};
constexpr Colour grey{0x96, 0x96, 0x96};

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

bool has_column(const Written& layer, std::string_view column) {
    const auto& columns = layer.plan.columns;
    return std::any_of(columns.begin(), columns.end(), [&](const auto& c) { return c.name == column; });
}

Mark mark_of(Form form) {
    return form == Form::point                              ? Mark::point
           : form == Form::line || form == Form::multi_line ? Mark::line
                                                            : Mark::area;
}

Kind kind_of(Mark mark) {
    return mark == Mark::point ? Kind::point : mark == Mark::line ? Kind::line : Kind::area;
}

void add_targets(TreeGroup& group) {
    const std::string source = source_of("targets");
    group.layers.push_back({Kind::line, "Targets: lines", joined(source, "|geometrytype=MultiLineString"),
                            single(Mark::line, {"", ink, 1.0}), "name", true});
    group.layers.push_back({Kind::area, "Targets: areas", joined(source, "|geometrytype=MultiPolygon"),
                            single(Mark::area, {"", ink, 0.6}), "name", true});
}

void add_by_cover(TreeGroup& group, const std::string& layer, const std::string& title, Mark mark,
                  const std::string& style, bool shown) {
    for (const std::string cover : {"forest", "bare"}) {
        group.layers.push_back(
            {kind_of(mark), joined(title, cover == "forest" ? ", with forest" : ", bare slope"),
             source_of(layer, joined("\"cover\" = '", cover, "'")), style, "", shown && cover == "forest"});
    }
}

std::string tree_style(const std::string& energy_column) {
    const Symbol unhit{"no energy taken", pale_green, 0.5};
    return by_energy(Mark::point, energy_column, 0.8, &unhit);
}

/// One layer for each regime, climate and year, from the first replicate; the last of them is shown.
void add_trees_by_year(TreeGroup& group, const fs::path& folder) {
    geopackage::Database database{folder / "results.gpkg", geopackage::Database::Open::to_read};
    geopackage::Statement years = database.prepare(
        "SELECT regime, climate, year, (SELECT count(DISTINCT climate) FROM trees) FROM trees "
        "GROUP BY regime, climate, year ORDER BY min(fid)");
    TreeGroup trees{"Trees, first replicate", {}, {}, true};
    while (years.step()) {
        const std::string regime = years.text(0);
        const std::string climate = years.text(1);
        const std::string year = years.text(2);
        const bool several = years.text(3) != "1";
        trees.layers.push_back(
            {Kind::point, joined(regime, several ? joined(", ", climate) : "", ", year ", year),
             source_of("trees", joined("\"regime\" = ", literal(regime),
                                       several ? joined(" AND \"climate\" = ", literal(climate)) : "",
                                       " AND \"year\" = ", year, " AND \"replicate\" = 1")),
             tree_style("rock_energy_kj"), "", false});
    }
    if (!trees.layers.empty()) {
        trees.layers.back().shown = true;
        group.groups.push_back(std::move(trees));
    }
}

/// "hazard_zones" as "Hazard zones".
std::string title_of(const std::string& layer) {
    std::string title = layer;
    std::replace(title.begin(), title.end(), '_', ' ');
    title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
    return title;
}

/// A layer that says itself in which colours it is drawn.
std::string by_classes(Mark mark, const geopackage::Plan& plan) {
    constexpr double outline_mm = 0.3;
    std::vector<Category> categories;
    for (const geopackage::DrawnClass& drawn : plan.classes) {
        categories.push_back({drawn.value, {drawn.label, drawn.colour, outline_mm}});
    }
    return categorised(mark, plan.drawn_by, categories);
}

/// How a layer of the package is drawn.
void add_layer(TreeGroup& group, const fs::path& folder, const Written& layer) {
    const std::string& name = layer.plan.name;
    const Mark mark = mark_of(layer.plan.form);
    const auto add = [&](const std::string& title, const std::string& style, bool shown) {
        group.layers.push_back({kind_of(mark), title, source_of(name), style, "", shown});
    };
    if (name == "targets") {
        add_targets(group);
    } else if (name == "sources") {
        add("Sources",
            single(mark, {"", brown,
                          mark == Mark::point  ? 2.0
                          : mark == Mark::line ? 0.6
                                               : 0.0}),
            true);
    } else if (name == "trajectories") {
        add_by_cover(group, name, "Trajectories", mark, by_energy(mark, "energy_max_kj", 0.2), true);
    } else if (name == "deposits") {
        add_by_cover(group, name, "Deposits", mark, by_energy(mark, "max_energy_kj", 0.9), false);
    } else if (name == "arrivals") {
        add_by_cover(group, name, "Arrivals at targets", mark, by_energy(mark, "energy_kj", 1.2), false);
    } else if (name == "trees" && has_column(layer, "regime")) {
        add_trees_by_year(group, folder);
    } else if (name == "trees") {
        add("Trees by energy taken", tree_style("energy_kj"), true);
    } else if (name == "tree_hits") {
        add("Tree hits",
            categorised(mark, "broken",
                        {{"no", {"tree held", dark_green, 1.0}}, {"yes", {"tree broken", ink, 1.6}}}),
            false);
    } else if (name == "logs") {
        add("Logs", single(mark, {"", brown, 0.8}), true);
    } else if (name == "log_hits") {
        add("Log hits", single(mark, {"", brown, 1.2}), false);
    } else if (name == "nets") {
        add("Nets", single(mark, {"", blue, 1.0}), true);
    } else if (name == "net_crossings") {
        add_by_cover(group, name, "Rocks at nets", mark, by_energy(mark, "energy_kj", 1.2), false);
    } else if (!layer.plan.drawn_by.empty()) {
        add_by_cover(group, name, title_of(name), mark, by_classes(mark, layer.plan), false);
    } else if (name == "removed_trees") {
        add("Trees that rocks removed", single(mark, {"", blue, 1.2}), false);
    } else {
        add(name, single(mark, {"", grey, 0.8}), false);
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

/// What the folders of rasters are called in the tree.
std::string group_title(const std::string& folder) {
    if (folder == "rasters") {
        return "Rasters";
    }
    if (folder.starts_with("year_")) {
        return joined("year ", folder.substr(5));
    }
    return folder == "bare" ? "bare slope" : folder == "difference" ? "with forest minus bare slope" : folder;
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
            .layers.push_back({Kind::raster, path.stem().string(), joined("./", file.path),
                               pipe_of(folder / path), "", show});
    }
}

}  // namespace

TreeGroup results_tree(const fs::path& folder, std::span<const WrittenFile> files,
                       std::span<const Written> layers) {
    TreeGroup root{"Bannwald", {}, {}, true};
    TreeGroup tables{"Tables", {}, {}, false};
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

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/siting_layouts.hpp"
#include "coupling/assessments/nets/siting/siting.hpp"
#include "coupling/assessments/nets/siting/siting_page.hpp"
#include "coupling/assessments/nets/siting/siting_words.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/geopackage/column_types.hpp"
#include "coupling/results/geopackage/package.hpp"
#include "coupling/results/report/head_of_run.hpp"

namespace coupling::siting {
namespace {

using config::joined;
using config::percent;
using geopackage::Geometry;

namespace fs = std::filesystem;

/// Lines of the layer that a table becomes, row by row.
using Lines = std::vector<std::vector<Eigen::Vector2d>>;

/// A table and the lines of its rows.
struct TableWithLines {
    std::string csv;
    Lines lines;
};

ReportSettings head_of(const fs::path& run) {
    const fs::path file = run / "summary.json";
    const FileBytes bytes = open_file(file, {file.string()}, "the summary of a finished run");
    return report::head_of_run(read_summary(bytes.text(), file.string()));
}

std::vector<Cover> covers_in(const SitingResults& results) {
    return results.with_forest ? std::vector{Cover::forest, Cover::bare} : std::vector{Cover::bare};
}

void add_net(CsvRow& row, const std::optional<NetDesign>& net) {
    if (!net) {
        row.empty().empty().empty().empty();
        return;
    }
    row.text(net->energy_class)
        .number<0>(net->capacity_kj)
        .number<1>(net->height_m)
        .number<1>(net->length_m());
}

void add_kept(CsvRow& row, const Share& kept) {
    row.whole(kept.part).number<4>(percent * kept.value).number<4>(percent * kept.interval.low);
    row.number<4>(percent * kept.interval.high).whole(kept.whole - kept.part);
}

/// Number of each stretch along its line, from 1.
std::vector<std::size_t> numbers_along(const SitingResults& results) {
    std::vector<std::size_t> of_line(results.lines.size(), 0);
    std::vector<std::size_t> numbers;
    for (const StretchResult& stretch : results.stretches) {
        numbers.push_back(++of_line[stretch.sited.line]);
    }
    return numbers;
}

TableWithLines stretches_table(const SitingResults& results) {
    std::ostringstream out;
    TableRows row{out, siting_layouts(), "net_stretches.csv"};
    Lines lines;
    const std::vector<std::size_t> numbers = numbers_along(results);
    const auto judged = index_of(results.judged);
    for (std::size_t i = 0; i < results.stretches.size(); ++i) {
        const StretchResult& stretch = results.stretches[i];
        const Stretch& place = stretch.sited.stretch;
        const ProtectedLine& line = results.lines[stretch.sited.line];
        const LineSums all = sums_of(results.by_line[stretch.sited.line].bins[judged]);
        row.text(line.name).whole(numbers[i]).number<1>(place.from_m).number<1>(place.to_m);
        row.text(name_of(results.judged)).whole(stretch.rocks);
        row.number<4>(percent * static_cast<double>(stretch.rocks) / static_cast<double>(all.rocks));
        row.number<4>(percent * stretch.energy_sum_kj / all.energy_kj);
        row.number<3>(stretch.energy_95_kj).number<3>(stretch.energy_max_kj);
        if (stretch.sited.uphill) {
            row.number<1>(stretch.sited.uphill->azimuth_deg())
                .text(coupling::name_of(stretch.sited.uphill->from));
        } else {
            row.empty().empty();
        }
        if (stretch.ranking.best) {
            const std::size_t best = stretch.candidates[*stretch.ranking.best];
            const Judged& found = results.figures[best][judged].judged;
            row.number<1>(found.distance_m);
            add_net(row, found.net);
            add_kept(row, found.left.kept);
            row.number<4>(found.left.energy_percent).number<3>(found.left.largest_kj);
        } else {
            for (int k = 0; k < 12; ++k) {
                row.empty();
            }
        }
        row.text(ties_of(results, stretch)).end();
        lines.push_back(piece_of(line.line_m, place.from_m, place.to_m));
    }
    return {out.str(), lines};
}

TableWithLines candidates_table(const SitingResults& results) {
    std::ostringstream out;
    TableRows row{out, siting_layouts(), "net_candidates.csv"};
    Lines lines;
    const std::vector<std::size_t> numbers = numbers_along(results);
    for (std::size_t i = 0; i < results.stretches.size(); ++i) {
        const StretchResult& stretch = results.stretches[i];
        for (std::size_t k = 0; k < stretch.candidates.size(); ++k) {
            const Candidate& candidate = results.candidates[stretch.candidates[k]];
            for (const Cover cover : covers_in(results)) {
                const CandidateFigures& found = results.figures[stretch.candidates[k]][index_of(cover)];
                const Left& left = found.judged.left;
                row.text(results.lines[stretch.sited.line].name).whole(numbers[i]);
                row.number<1>(candidate.distance_m).text(name_of(cover));
                add_net(row, found.judged.net);
                row.whole(left.kept.whole).whole(found.crossing);
                add_kept(row, left.kept);
                row.number<4>(left.energy_kj / static_cast<double>(results.rocks[index_of(cover)]));
                row.number<4>(left.energy_percent).number<3>(left.largest_kj).whole(found.reached);
                row.number<3>(found.energy_95_kj).number<3>(found.energy_max_kj);
                row.text(found.judged.net && keeps_wanted(found.judged, results.wanted_share) ? "yes" : "no");
                row.text(stretch.ranking.best == k ? "yes" : "no")
                    .text(stretch.ranking.ties[k] ? "yes" : "no");
                row.end();
                lines.push_back(found.judged.net ? piece_of(candidate.line_m, found.judged.net->from_m,
                                                            found.judged.net->to_m)
                                                 : candidate.line_m);
            }
        }
    }
    return {out.str(), lines};
}

TableWithLines along_table(const SitingResults& results) {
    constexpr double per_1000 = 1000.0;
    std::ostringstream out;
    TableRows row{out, siting_layouts(), "net_along.csv"};
    Lines lines;
    for (std::size_t line = 0; line < results.lines.size(); ++line) {
        for (const Cover cover : covers_in(results)) {
            const auto c = index_of(cover);
            const auto rocks = static_cast<double>(results.rocks[c]);
            const std::vector<LineBin>& bins = results.by_line[line].bins[c];
            for (std::size_t i = 0; i < bins.size(); ++i) {
                const LineBin& bin = bins[i];
                const LineBin& left = results.by_line[line].left[c][i];
                row.text(results.lines[line].name).number<1>(bin.from_m).number<1>(bin.to_m);
                row.text(name_of(cover)).whole(bin.rocks).number<3>(per_1000 * bin.energy_sum_kj / rocks);
                row.number<3>(bin.energy_sum_kj / static_cast<double>(bin.rocks));
                row.number<3>(percentile_is_known(bin.rocks, 95) ? quantile_of(bin.energies_kj, 0.95).value
                                                                 : std::numeric_limits<double>::quiet_NaN());
                row.number<3>(bin.rocks > 0 ? bin.energies_kj.back()
                                            : std::numeric_limits<double>::quiet_NaN());
                row.whole(left.rocks).number<3>(per_1000 * left.energy_sum_kj / rocks);
                const bool needed = std::any_of(
                    results.stretches.begin(), results.stretches.end(), [&](const StretchResult& stretch) {
                        return stretch.sited.line == line && bin.from_m < stretch.sited.stretch.to_m &&
                               bin.to_m > stretch.sited.stretch.from_m;
                    });
                row.text(needed ? "yes" : "no").end();
                lines.push_back(piece_of(results.lines[line].line_m, bin.from_m, bin.to_m));
            }
        }
    }
    return {out.str(), lines};
}

bool has_level(const std::string& energy_class) {
    return std::any_of(net_classes().begin(), net_classes().end(), [&](const NetClass& known) {
        return known.name == energy_class && std::isfinite(known.mel_kj);
    });
}

/// The projection of the rasters of a run; empty where they have none.
std::string projection_of(const fs::path& run) {
    const fs::path file = run / "rasters" / "bare" / "Nr_passages.prj";
    return path_exists(file) ? std::string{open_file(file, {file.string()}, "a projection file").text()} : "";
}

void add_layer(geopackage::GeoPackage& package, const std::string& name, const std::string& sentence,
               const TableWithLines& table, const Eigen::Vector2d& origin_m) {
    OwnRows seen{table.csv, name};
    geopackage::ColumnTypes types{seen.columns()};
    while (seen.next()) {
        types.see(seen.fields());
    }
    geopackage::Layer layer{package, {name, sentence, types.columns(), geopackage::Form::line, {}}};
    std::size_t number = 0;
    for (OwnRows rows{table.csv, name}; rows.next();) {
        std::vector<geopackage::Vertex> corners;
        for (const Eigen::Vector2d& corner : table.lines[number]) {
            corners.push_back({corner.x() + origin_m.x(), corner.y() + origin_m.y(), 0.0, 0.0});
        }
        const Geometry geometry = geopackage::line(corners, {}, package.srs_id());
        layer.add(rows.fields(), &geometry);
        ++number;
    }
    layer.finish();
}

/// The chosen nets as nets.file takes them.
TableWithLines nets_table(const SitingResults& results, const Eigen::Vector2d& origin_m) {
    std::ostringstream out;
    out << "name,height_m,capacity_kj,class,gap_m,wkt\n";
    CsvRow row{out};
    Lines lines;
    const auto to_millimetres = [](double length_m) {
        constexpr double mm_per_m = 1000.0;
        return config::to_text(std::round(mm_per_m * length_m) / mm_per_m);
    };
    for (const NetRecord& record : results.nets) {
        std::string wkt = "LINESTRING (";
        for (const Eigen::Vector2d& corner : record.net.line_m) {
            wkt += joined(wkt.ends_with('(') ? "" : ", ", to_millimetres(corner.x() + origin_m.x()), " ",
                          to_millimetres(corner.y() + origin_m.y()));
        }
        // The open class has no level of its own: nets.file asks for the capacity instead.
        const bool by_class = has_level(record.energy_class);
        row.text(record.name).number<1>(record.net.height_m);
        row.text(by_class ? "" : config::to_text(record.net.capacity_j / config::j_per_kj));
        row.text(by_class ? record.energy_class : "").number<0>(record.net.gap_m).text(wkt + ')');
        row.end();
        lines.push_back(record.net.line_m);
    }
    return {out.str(), lines};
}

}  // namespace

void write_siting(const SitingResults& results, const rockfall::Terrain& terrain, ShortRun& folder,
                  bool with_nets) {
    const Eigen::Vector2d origin_m = terrain.origin_m();
    const TableWithLines stretches = stretches_table(results);
    const TableWithLines candidates = candidates_table(results);
    const TableWithLines along = along_table(results);
    const TableWithLines nets = nets_table(results, origin_m);
    const auto write_file = [&](const char* name, const char* sentence, const std::string& text) {
        folder.add(name, sentence, [&](std::ostream& out) { out << text; });
    };
    write_file("net_stretches.csv", "Where works are needed.", stretches.csv);
    write_file("net_candidates.csv", "All candidates with their figures, with forest and on the bare slope.",
               candidates.csv);
    write_file("net_along.csv", "What comes to each piece of 10 m, and what the nets leave.", along.csv);
    if (with_nets) {
        write_file("nets.csv", "The best net of each stretch, ready for nets.file of a scenario.", nets.csv);
    }
    geopackage::GeoPackage package{folder.path() / "net_place.gpkg",
                                   geopackage::spatial_reference(projection_of(results.run))};
    add_layer(package, "net_along", "Pieces of the lines, what comes to them and what nets leave.", along,
              origin_m);
    add_layer(package, "net_stretches", "Where works are needed.", stretches, origin_m);
    add_layer(package, "net_candidates", "Nets that were compared.", candidates, origin_m);
    add_layer(package, "nets", "The best net of each stretch.", nets, origin_m);
    package.close();
    folder.add_written({"net_place.gpkg", "All of it as layers for QGIS."});
    folder.add("report.html", "Map, curve and designs as a page.",
               [&](std::ostream& page) { write_siting_page(page, results, terrain, head_of(results.run)); });
}

}  // namespace coupling::siting

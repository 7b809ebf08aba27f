#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/design_columns.hpp"
#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/net_layers.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/assessments/nets/figures/net_summary.hpp"
#include "coupling/assessments/nets/siting/siting.hpp"
#include "coupling/assessments/nets/siting/siting_page.hpp"
#include "coupling/assessments/nets/siting/siting_words.hpp"
#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/inputs/scenario/report_settings.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::siting {
namespace {

using config::joined;
using config::percent;

std::vector<Cover> covers_in(const SitingResults& results) {
    return results.with_forest ? std::vector{Cover::forest, Cover::bare} : std::vector{Cover::bare};
}

constexpr const char* rules = "coupling/assessments/nets/README.md";
constexpr const char* along_line = "along the line from its first corner";

Column line_column() {
    return {"line", "text", "name of the line to protect", "input --nets"};
}

ColumnsOf<NetDesign> chosen_net_columns() {
    constexpr const char* classes = "net_classes.csv (ETAG 027, EAD 340059-00-0106)";
    return {{"class", "energy class of the net; empty: too few rocks for an estimate", classes,
             &NetDesign::energy_class},
            {"capacity_kj", 0,
             "maximum energy level of the class; of the open class the design energy rounded up to 100 kJ",
             classes, &NetDesign::capacity_kj},
            {"height_m", 2,
             "height of the net: the next one on offer; where none is that high, the design height rounded "
             "up to 10 cm",
             rules, &NetDesign::height_m},
            {"net_length_m", 1, "length of the net in plan", rules, &NetDesign::length_m}};
}

/// Rocks that a net holds and leaves.
ColumnsOf<Share> kept_columns(const char* kept, const char* share) {
    return {{"kept", kept, from_counting, &Share::part},
            share_columns("kept", share),
            {"left_rocks", "rocks that it leaves", from_counting,
             [](const Share& of) { return of.whole - of.part; }}};
}

/// How rocks come past a net.
ColumnsOf<Left> past_columns() {
    return {{"left_over", "those of them that pass over it", from_counting, &Left::over},
            {"left_through", "that break through it", from_counting, &Left::through},
            {"left_beside", "that come past its ends, or start below it", from_counting, &Left::beside}};
}

constexpr auto kept_by = [](const Left& left) -> const Share& { return left.kept; };

/// Number of each stretch along its line, from 1.
std::vector<std::size_t> numbers_along(const SitingResults& results) {
    std::vector<std::size_t> of_line(results.lines.size(), 0);
    std::vector<std::size_t> numbers;
    for (const StretchResult& stretch : results.stretches) {
        numbers.push_back(++of_line[stretch.sited.line]);
    }
    return numbers;
}

/// A stretch, with what its best net leaves.
struct StretchRow {
    const SitingResults& results;
    const StretchResult& stretch;
    std::size_t number;
    LineSums all;
    const CandidateFigures* best;
    std::string ties;
};

ColumnsOf<StretchResult> stretch_columns() {
    return {{"energy_95_kj", 3, "95th percentile of their energies (empty: fewer than 20 rocks)",
             &StretchResult::energy_95_kj},
            {"energy_max_kj", 3, "largest of their energies", &StretchResult::energy_max_kj},
            {ColumnsOf<Uphill>{{"azimuth_deg", 1, "direction upslope, clockwise from north; empty: none",
                                rules, &Uphill::azimuth_deg},
                               {"azimuth_from", "where it comes from: rocks, gradient or given (--azimuth)",
                                rules, [](const Uphill& uphill) { return coupling::name_of(uphill.from); }}},
             [](const auto& of) { return of.sited.uphill; }}};
}

ColumnsOf<Judged> judged_columns() {
    return {{"distance_m", 1, "of the best candidate, in plan upslope of the stretch; empty: none is best",
             rules, &Judged::distance_m},
            {chosen_net_columns(), &Judged::net},
            {ColumnsOf<Left>{{kept_columns("rocks that the best net holds, of those that come to the stretch",
                                           "share of them"),
                              kept_by},
                             past_columns(),
                             {"left_energy_percent", 4, "share of the energy that it leaves", from_counting,
                              &Left::energy_percent},
                             {"left_max_kj", 3, "largest energy that it leaves", &Left::largest_kj}},
             &Judged::left}};
}

ColumnsOf<CandidateFigures> best_columns() {
    return {{judged_columns(), &CandidateFigures::judged}, {design_columns(), &CandidateFigures::needed}};
}

TableOf<StretchRow> stretch_table() {
    return {
        "net_stretches.csv",
        "Where works are needed.",
        "a stretch of a line where works are needed",
        {{line_column(), [](const auto& row) { return row.results.lines[row.stretch.sited.line].name; }},
         {"stretch", "number of the stretch along the line", rules, &StretchRow::number},
         {"from_m", 1, joined("where it begins, ", along_line), rules,
          [](const auto& row) { return row.stretch.sited.stretch.from_m; }},
         {"to_m", 1, "where it ends", rules, [](const auto& row) { return row.stretch.sited.stretch.to_m; }},
         {cover_column(), [](const auto& row) { return name_of(row.results.judged); }},
         {"rocks", "rocks that come to the stretch where no net stands", from_counting,
          [](const auto& row) { return row.stretch.rocks; }},
         {"rocks_percent", 4, "share of the rocks that come to the line", from_counting,
          [](const auto& row) {
              return percent * static_cast<double>(row.stretch.rocks) / static_cast<double>(row.all.rocks);
          }},
         {"energy_percent", 4, "share of the energy that comes to the line", from_counting,
          [](const auto& row) { return percent * row.stretch.energy_sum_kj / row.all.energy_kj; }},
         {stretch_columns(), [](const auto& row) { return &row.stretch; }},
         {best_columns(), &StretchRow::best},
         {"ties", "distances [m] of the candidates that are as good", rules, &StretchRow::ties}}};
}

TableWithLines stretches_table(const SitingResults& results) {
    std::ostringstream out;
    Lines lines;
    const std::vector<std::size_t> numbers = numbers_along(results);
    const auto judged = index_of(results.judged);
    stretch_table().write_to(out, [&](auto& rows) {
        for (std::size_t i = 0; i < results.stretches.size(); ++i) {
            const StretchResult& stretch = results.stretches[i];
            const std::optional<std::size_t> best = stretch.ranking.best;
            rows.add({results, stretch, numbers[i], sums_of(results.by_line[stretch.sited.line].bins[judged]),
                      best ? &results.figures[stretch.candidates[*best]][judged] : nullptr,
                      ties_of(results, stretch)});
            lines.push_back(piece_of(results.lines[stretch.sited.line].line_m, stretch.sited.stretch.from_m,
                                     stretch.sited.stretch.to_m));
        }
    });
    return {stretch_table(), out.str(), lines};
}

/// A candidate on one slope.
struct CandidateRow {
    const SitingResults& results;
    const StretchResult& stretch;
    std::size_t number;
    std::size_t place;  ///< among the candidates of the stretch
    Cover cover;

    [[nodiscard]] const CandidateFigures& figures() const {
        return results.figures[stretch.candidates[place]][index_of(cover)];
    }
    [[nodiscard]] double residual_kj() const {
        return figures().judged.left.energy_kj / static_cast<double>(results.rocks[index_of(cover)]);
    }
};

TableOf<CandidateRow> candidate_table() {
    constexpr auto left = [](const CandidateRow& row) -> const Left& { return row.figures().judged.left; };
    return {
        "net_candidates.csv",
        "All candidates with their figures, with forest and on the bare slope.",
        "a candidate upslope of a stretch on one slope; the design rests on the slope with forest where "
        "there "
        "is one",
        {{line_column(), [](const auto& row) { return row.results.lines[row.stretch.sited.line].name; }},
         {"stretch", "number of the stretch along the line", rules, &CandidateRow::number},
         {"distance_m", 1, "in plan, upslope of the stretch", rules,
          [](const auto& row) {
              return row.results.candidates[row.stretch.candidates[row.place]].distance_m;
          }},
         {cover_column(), [](const auto& row) { return name_of(row.cover); }},
         {chosen_net_columns(), [](const auto& row) { return row.figures().judged.net; }},
         {"rocks", "rocks that come to the stretch where no net stands", from_counting,
          [](const auto& row) { return row.figures().judged.left.kept.whole; }},
         {"crossing", "those of them that cross the line of the candidate before", from_counting,
          [](const auto& row) { return row.figures().crossing; }},
         {ColumnsOf<Left>{
              kept_columns("those that the net holds", "share of the rocks that come to the stretch"),
              kept_by},
          left},
         {past_columns(), left},
         {"residual_kj", 4, "energy that it leaves to the stretch, per rock that fell", from_counting,
          &CandidateRow::residual_kj},
         {ColumnsOf<Left>{{"left_energy_percent", 4, "share of the energy that comes to the stretch",
                           from_counting, &Left::energy_percent},
                          {"left_max_kj", 3, "largest energy that it leaves", &Left::largest_kj}},
          left},
         {ColumnsOf<CandidateFigures>{
              {"reached",
               "all rocks that cross the line between the ends of the net, also those that would stop before "
               "the line to protect",
               from_counting, &CandidateFigures::reached},
              {"energy_95_kj", 3, "95th percentile of their energies (empty: fewer than 20 rocks)",
               &CandidateFigures::energy_95_kj},
              {"energy_max_kj", 3, "largest of their energies", &CandidateFigures::energy_max_kj},
              {design_columns(), &CandidateFigures::needed}},
          &CandidateRow::figures},
         {"keeps_wanted", "yes: it keeps the wanted share of the rocks (nets.wanted_share)", rules,
          [](const auto& row) {
              const Judged& judged = row.figures().judged;
              return judged.net && keeps_wanted(judged, row.results.wish.share);
          }},
         {"best", "yes: the best candidate of the stretch", rules,
          [](const auto& row) { return row.stretch.ranking.best == row.place; }},
         {"tie", "yes: as good as the best", rules,
          [](const auto& row) -> bool { return row.stretch.ranking.ties[row.place]; }}}};
}

TableWithLines candidates_table(const SitingResults& results) {
    std::ostringstream out;
    Lines lines;
    const std::vector<std::size_t> numbers = numbers_along(results);
    candidate_table().write_to(out, [&](auto& rows) {
        for (std::size_t i = 0; i < results.stretches.size(); ++i) {
            const StretchResult& stretch = results.stretches[i];
            for (std::size_t k = 0; k < stretch.candidates.size(); ++k) {
                const Candidate& candidate = results.candidates[stretch.candidates[k]];
                for (const Cover cover : covers_in(results)) {
                    const CandidateRow row{results, stretch, numbers[i], k, cover};
                    rows.add(row);
                    const auto& net = row.figures().judged.net;
                    lines.push_back(net ? piece_of(candidate.line_m, net->from_m, net->to_m)
                                        : candidate.line_m);
                }
            }
        }
    });
    return {candidate_table(), out.str(), lines};
}

/// A piece of a line on one slope, without nets and with those of all stretches.
struct PieceRow : LineBin {
    const std::string& line;
    Cover cover;
    const LineBin& left;
    double fallen;  ///< rocks, anywhere
    bool needed;
};

TableOf<PieceRow> piece_table() {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {"net_along.csv",
            "What comes to each piece of 10 m, and what the nets leave.",
            "a piece of a line, 10 m long, on one slope",
            {{line_column(), [](const auto& row) { return &row.line; }},
             {"from_m", 1, joined("where it begins, ", along_line), "definition", &LineBin::from_m},
             {"to_m", 1, "where it ends", "definition", &LineBin::to_m},
             {cover_column(), [](const auto& row) { return name_of(row.cover); }},
             {"rocks", "rocks that come to it where no net stands", from_counting, &LineBin::rocks},
             {"energy_per_1000_kj", 3, "sum of their energies per 1000 rocks that fell", from_counting,
              [](const auto& row) { return 1000.0 * row.energy_sum_kj / row.fallen; }},
             {"energy_mean_kj", 3, "mean of their energies",
              [](const auto& row) { return row.energy_sum_kj / static_cast<double>(row.rocks); }},
             {"energy_95_kj", 3, "95th percentile of their energies (empty: fewer than 20 rocks)",
              [](const auto& row) {
                  return percentile_is_known(row.rocks, 95) ? quantile_of(row.energies_kj, 0.95).value
                                                            : unknown;
              }},
             {"energy_max_kj", 3, "largest of their energies",
              [](const auto& row) { return row.rocks > 0 ? row.energies_kj.back() : unknown; }},
             {"left_rocks", "rocks that come to it past the nets of nets.csv together", from_counting,
              [](const auto& row) { return row.left.rocks; }},
             {"left_energy_per_1000_kj", 3, "sum of their energies per 1000 rocks that fell", from_counting,
              [](const auto& row) { return 1000.0 * row.left.energy_sum_kj / row.fallen; }},
             {"needed", "yes: it belongs to a stretch where works are needed", rules, &PieceRow::needed}}};
}

TableWithLines along_table(const SitingResults& results) {
    std::ostringstream out;
    Lines lines;
    const auto add = [&](auto& rows, std::size_t line, Cover cover) {
        const std::vector<LineBin>& bins = results.by_line[line].bins[index_of(cover)];
        for (std::size_t i = 0; i < bins.size(); ++i) {
            const LineBin& bin = bins[i];
            const bool needed = std::any_of(
                results.stretches.begin(), results.stretches.end(), [&](const StretchResult& stretch) {
                    return stretch.sited.line == line && bin.from_m < stretch.sited.stretch.to_m &&
                           bin.to_m > stretch.sited.stretch.from_m;
                });
            rows.add({bin, results.lines[line].name, cover, results.by_line[line].left[index_of(cover)][i],
                      static_cast<double>(results.rocks[index_of(cover)]), needed});
            lines.push_back(piece_of(results.lines[line].line_m, bin.from_m, bin.to_m));
        }
    };
    piece_table().write_to(out, [&](auto& rows) {
        for (std::size_t line = 0; line < results.lines.size(); ++line) {
            for (const Cover cover : covers_in(results)) {
                add(rows, line, cover);
            }
        }
    });
    return {piece_table(), out.str(), lines};
}

bool has_level(const std::string& energy_class) {
    return std::any_of(net_classes().begin(), net_classes().end(), [&](const NetClass& known) {
        return known.name == energy_class && std::isfinite(known.mel_kj);
    });
}

/// A chosen net, its line as well-known text.
struct PlacedNet {
    const NetRecord& record;
    std::string wkt;

    /// The open class has no level of its own: nets.file asks for the capacity instead.
    [[nodiscard]] bool by_class() const { return has_level(record.energy_class); }
};

/// As nets.file takes them.
TableOf<PlacedNet> placed_net_table() {
    return {
        "nets.csv",
        "The best net of each stretch, ready for nets.file of a scenario.",
        "a net",
        {{"name", "of the net", rules, [](const auto& row) { return row.record.name; }},
         {"height_m", 2, "height of the net", rules, [](const auto& row) { return row.record.net.height_m; }},
         {"capacity_kj", as_given, "of a net of the open class", rules,
          [](const auto& row) {
              return row.by_class() ? std::nullopt
                                    : std::optional{row.record.net.capacity_j / config::j_per_kj};
          }},
         {"class", "energy class", rules,
          [](const auto& row) { return row.by_class() ? row.record.energy_class : std::string{}; }},
         {"gap_m", 0, "below the net", rules, [](const auto& row) { return row.record.net.gap_m; }},
         {"wkt", "its line", rules, &PlacedNet::wkt}}};
}

TableWithLines nets_table(const SitingResults& results, const Eigen::Vector2d& origin_m) {
    std::ostringstream out;
    Lines lines;
    const auto to_millimetres = [](double length_m) {
        constexpr double mm_per_m = 1000.0;
        return config::to_text(std::round(mm_per_m * length_m) / mm_per_m);
    };
    placed_net_table().write_to(out, [&](auto& rows) {
        for (const NetRecord& record : results.nets) {
            std::string wkt = "LINESTRING (";
            for (const Eigen::Vector2d& corner : record.net.line_m) {
                wkt += joined(wkt.ends_with('(') ? "" : ", ", to_millimetres(corner.x() + origin_m.x()), " ",
                              to_millimetres(corner.y() + origin_m.y()));
            }
            rows.add({record, wkt + ')'});
            lines.push_back(record.net.line_m);
        }
    });
    return {placed_net_table(), out.str(), lines};
}

}  // namespace

std::vector<TableLayout> siting_layouts() {
    return {stretch_table(), candidate_table(), piece_table()};
}

void write_siting(const SitingResults& results, const rockfall::Terrain& terrain, ShortRun& folder,
                  bool with_nets) {
    const Eigen::Vector2d origin_m = terrain.origin_m();
    const TableWithLines stretches = stretches_table(results);
    const TableWithLines candidates = candidates_table(results);
    const TableWithLines along = along_table(results);
    const TableWithLines nets = nets_table(results, origin_m);
    const auto write_file = [&](const std::string& name, const std::string& sentence,
                                const std::string& text) {
        folder.add(name, sentence, [&](std::ostream& out) { out << text; });
    };
    write_file(stretch_table().file, stretch_table().sentence, stretches.csv);
    write_file(candidate_table().file, candidate_table().sentence, candidates.csv);
    write_file(piece_table().file, piece_table().sentence, along.csv);
    if (with_nets) {
        write_file(placed_net_table().file, placed_net_table().sentence, nets.csv);
    }
    geopackage::GeoPackage package{folder.path() / "net_place.gpkg",
                                   geopackage::spatial_reference(projection_of_run(results.run))};
    add_lines(package, "net_along", "Pieces of the lines, what comes to them and what nets leave.", along,
              origin_m);
    add_lines(package, "net_stretches", stretch_table().sentence, stretches, origin_m);
    add_lines(package, "net_candidates", "Nets that were compared.", candidates, origin_m);
    add_lines(package, "nets", "The best net of each stretch.", nets, origin_m);
    package.close();
    folder.add_written({"net_place.gpkg", "All of it as layers for QGIS."});
    folder.add("report.html", "Map, curve and designs as a page.", [&](std::ostream& page) {
        write_siting_page(page, results, terrain, head_of(results.run), folder.files_with_those_to_come());
    });
}

}  // namespace coupling::siting

#include "coupling/assessments/nets/net_place.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/design_columns.hpp"
#include "coupling/assessments/nets/figures/net_layers.hpp"
#include "coupling/assessments/nets/figures/net_summary.hpp"
#include "coupling/assessments/nets/figures/net_try.hpp"
#include "coupling/assessments/nets/figures/net_words.hpp"
#include "coupling/assessments/nets/net_trial.hpp"
#include "coupling/assessments/nets/siting/protected_line.hpp"
#include "coupling/assessments/nets/siting/siting.hpp"
#include "coupling/inputs/nets/net_input.hpp"
#include "coupling/inputs/places/line_through.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "coupling/results/tables/text_layout.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/short_run.hpp"

namespace coupling {
namespace {

using config::j_per_kj;
using config::joined;
using config::percent;

constexpr const char* how_judged = "coupling/assessments/nets/README.md";

/// A coordinate to the millimetre.
std::string to_millimetres(double length_m) {
    constexpr double mm_per_m = 1000.0;
    return config::to_text(std::round(mm_per_m * length_m) / mm_per_m);
}

/// "270 deg, where 310 rocks that reach it come from".
std::string in_words(const Uphill& uphill) {
    const std::string azimuth =
        joined("towards ", report::fixed(uphill.azimuth_deg(), 0), " deg (90: east), ");
    switch (uphill.from) {
        case Uphill::From::rocks:
            return joined(azimuth, "where the ", std::to_string(uphill.rocks),
                          " rocks that reach it come from");
        case Uphill::From::gradient:
            return joined(azimuth, "along the gradient of the ground: no rock reaches it, or from all sides");
        case Uphill::From::given:
            break;
    }
    return joined(azimuth, "as given");
}

/// The places of all lines that lie wholly on the terrain; what is left out becomes a remark.
std::vector<NetPlace> places_of(std::span<const NetRecord> lines,
                                std::span<const std::optional<Uphill>> uphills,
                                std::span<const double> distances_m, const rockfall::Terrain& terrain,
                                std::span<const rockfall::Target> houses, std::vector<std::string>& remarks) {
    std::vector<NetPlace> places;
    for (std::uint32_t line = 0; line < lines.size(); ++line) {
        const std::optional<Uphill>& uphill = uphills[line];
        if (!uphill) {
            remarks.push_back(joined(lines[line].name,
                                     ": no way is upslope, as no rock reaches it, or from all sides, and the "
                                     "ground is level; --azimuth gives one"));
            continue;
        }
        remarks.push_back(joined(lines[line].name, ": the net is moved ", in_words(*uphill)));
        for (const double distance_m : distances_m) {
            NetPlace place{line, distance_m, *uphill, lines[line].net};
            for (Eigen::Vector2d& corner : place.net.line_m) {
                corner += distance_m * uphill->direction;
            }
            if (first_place_off_ground(place.net, terrain)) {
                remarks.push_back(joined(lines[line].name, ": ", config::to_text(distance_m),
                                         " m upslope it leaves the terrain, left out"));
            } else if (const auto met = targets_under(place.net.line_m, houses, runs_over); !met.empty()) {
                remarks.push_back(joined(lines[line].name, ": ", config::to_text(distance_m),
                                         " m upslope it runs through the house ",
                                         config::in_quotes(met.front()->id), ", left out"));
            } else {
                places.push_back(std::move(place));
            }
        }
    }
    return places;
}

/// How a place compares with the others of its line.
enum class Rank : std::uint8_t { best, tie, other };

/// The places of given nets and what they are worth.
struct GivenNetPlaces {
    std::vector<NetPlace> places;
    std::unique_ptr<PlaceTrial> trial;  ///< refers to the places
    std::vector<Rank> ranks;            ///< by place
};

/// A place on one slope.
struct PlaceRow : PlaceFigures {
    const std::string& line;
    const NetPlace& place;
    Cover cover;
    Rank rank;
};

const std::optional<BarrierDesign>& design_at(const PlaceFigures& of) {
    return of.at_net.design;
}

ColumnsOf<PlaceFigures> place_figure_columns() {
    return {
        {"rocks", "rocks that fell", from_counting, [](const auto& of) { return of.arrive.whole; }},
        {"arrive", "rocks that reach the line where no net stands", from_counting,
         [](const auto& of) { return of.arrive.part; }},
        {"kept", "those of them that a net at this place holds", from_counting,
         [](const auto& of) { return of.kept.part; }},
        {"kept_percent", 4, "share of them", from_counting,
         [](const auto& of) { return percent * of.kept.value; }},
        {"residual_kj", 4,
         "energy on the line of the rocks that the net does not hold, per rock that fell; of rocks that "
         "break through as without the net",
         how_judged, &PlaceFigures::residual_kj},
        {"reached", "rocks that reach the net at this place", from_counting,
         [](const auto& of) { return of.at_net.reached.part; }},
        {"held_percent", 4, "share of them that it holds", from_counting,
         [](const auto& of) { return percent * of.at_net.outcome[0].value; }},
        {"energy_95_kj", 3, "95th percentile of the energy in front of the net (empty: fewer than 20 rocks)",
         [](const auto& of) { return of.at_net.energy_kj.p95.value; }},
        {"energy_99_kj", 3, "99th percentile of it (empty: fewer than 100 rocks)",
         [](const auto& of) { return of.at_net.energy_kj.p99.value; }},
        {"height_95_m", 3,
         "95th percentile of the height of passage, of the rock's upper edge above the ground (empty: fewer "
         "than "
         "20 rocks)",
         [](const auto& of) { return of.at_net.height_m.p95.value; }},
        {"height_99_m", 3, "99th percentile of it (empty: fewer than 100 rocks)",
         [](const auto& of) { return of.at_net.height_m.p99.value; }},
        {design_columns(), design_at}};
}

TableOf<PlaceRow> place_table() {
    return {
        "net_places.csv",
        "",
        "a place of a net on one slope",
        {{"net", "name of the line to protect", "input --nets", [](const auto& row) { return &row.line; }},
         {"distance_m", 1, "in plan, upslope of the line", "definition",
          [](const auto& row) { return row.place.distance_m; }},
         {"azimuth_deg", 1, "direction upslope in which the net is moved, clockwise from north", how_judged,
          [](const auto& row) { return row.place.uphill.azimuth_deg(); }},
         {"azimuth_from",
          "where it comes from: rocks that reach the line, gradient of the ground or given (--azimuth)",
          how_judged, [](const auto& row) { return name_of(row.place.uphill.from); }},
         {cover_column(), [](const auto& row) { return name_of(row.cover); }},
         place_figure_columns(),
         {"best",
          "yes: least residual energy of all places of the line, with forest if there is one; none where no "
          "place keeps a rock from it",
          how_judged, [](const auto& row) { return row.rank == Rank::best; }},
         {"tie", "yes: leaves at most a tenth more energy than the best", how_judged,
          [](const auto& row) { return row.rank == Rank::tie; }}}};
}

void write_places(std::ostream& out, std::span<const NetRecord> lines, const GivenNetPlaces& given,
                  const PathsHead& head) {
    place_table().write_to(out, [&](auto& rows) {
        for (std::size_t i = 0; i < given.places.size(); ++i) {
            for (const Cover cover : all_covers) {
                if (cover == Cover::bare || head.with_forest) {
                    rows.add({given.trial->figures(i, cover, head), lines[given.places[i].line].name,
                              given.places[i], cover, given.ranks[i]});
                }
            }
        }
    });
}

/// A table of nets as nets.file takes it.
void write_best(std::ostream& out, std::span<const NetRecord> lines, const GivenNetPlaces& given,
                const Eigen::Vector2d& origin_m) {
    const std::vector<NetPlace>& places = given.places;
    out << "name,height_m,capacity_kj,class,gap_m,wkt\n";
    CsvRow row{out};
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (given.ranks[i] != Rank::best) {
            continue;
        }
        const rockfall::Net& net = places[i].net;
        std::string wkt = "LINESTRING (";
        for (const Eigen::Vector2d& corner : net.line_m) {
            wkt += joined(wkt.ends_with('(') ? "" : ", ", to_millimetres(corner.x() + origin_m.x()), " ",
                          to_millimetres(corner.y() + origin_m.y()));
        }
        const NetRecord& record = lines[places[i].line];
        row.text(record.name).text(config::to_text(net.height_m));
        row.text(record.energy_class.empty() ? config::to_text(net.capacity_j / j_per_kj) : "");
        row.text(record.energy_class).text(config::to_text(net.gap_m)).text(wkt + ')');
        row.end();
    }
}

/// A way upslope for each line: the given one, or that of the rocks, for which all paths are read.
std::vector<std::optional<Uphill>> uphills_of(const NetPlaceRequest& request,
                                              std::span<const NetRecord> lines) {
    if (request.azimuth_deg) {
        return {lines.size(), uphill_along(*request.azimuth_deg)};
    }
    NetPathsReader paths = paths_of_run(request.run);
    Arrivals arrivals{lines, paths.terrain()};
    paths.each([&](const StoredPath& path) { arrivals.look(path); });
    std::vector<std::optional<Uphill>> uphills;
    for (std::uint32_t line = 0; line < lines.size(); ++line) {
        uphills.push_back(arrivals.uphill(line));
    }
    return uphills;
}

/// The best place of a line and those that tie with it, as a remark.
void rank_places(std::uint32_t line, const std::string& name, const PathsHead& head, GivenNetPlaces& given,
                 std::vector<std::string>& remarks) {
    constexpr double tied_by = 1.1;  // a tenth more energy is left below [choice]
    const Cover judged = head.with_forest ? Cover::forest : Cover::bare;
    std::optional<std::size_t> best;
    std::optional<std::uint64_t> arrive;
    double least_kj = 0.0;
    for (std::size_t i = 0; i < given.places.size(); ++i) {
        if (given.places[i].line != line) {
            continue;
        }
        const PlaceFigures of = given.trial->figures(i, judged, head);
        arrive = of.arrive.part;
        if (of.kept.part > 0 && (!best || of.residual_kj < least_kj)) {
            best = i;
            least_kj = of.residual_kj;
        }
    }
    if (!best) {
        if (arrive) {
            remarks.push_back(joined(
                name, *arrive == 0 ? ": no rock reaches the line" : ": no place keeps a rock from the line",
                head.with_forest ? " with forest" : "", ", so none is best and none stands in nets.csv"));
        }
        return;
    }
    std::string ties;
    for (std::size_t i = 0; i < given.places.size(); ++i) {
        if (i != *best && given.places[i].line == line &&
            given.trial->figures(i, judged, head).kept.part > 0 &&
            given.trial->figures(i, judged, head).residual_kj <= tied_by * least_kj) {
            given.ranks[i] = Rank::tie;
            ties += joined(ties.empty() ? "" : ", ", config::to_text(given.places[i].distance_m));
        }
    }
    given.ranks[*best] = Rank::best;
    const PlaceFigures of = given.trial->figures(*best, judged, head);
    remarks.push_back(joined(name, ": best ", config::to_text(given.places[*best].distance_m),
                             " m upslope, keeps ", std::to_string(of.kept.part), " of ",
                             std::to_string(of.kept.whole), " rocks from the line, leaves ",
                             report::three_digits(of.residual_kj), " kJ a rock",
                             ties.empty() ? "" : joined("; as good: ", ties, " m upslope")));
}

GivenNetPlaces place_given(const NetPlaceRequest& request, std::span<const NetRecord> nets,
                           std::span<const double> distances_m, std::span<const rockfall::Target> houses,
                           NetPathsReader& paths, std::vector<std::string>& remarks) {
    const std::vector<std::optional<Uphill>> uphills = uphills_of(request, nets);
    GivenNetPlaces given;
    given.places = places_of(nets, uphills, distances_m, paths.terrain(), houses, remarks);
    given.trial = std::make_unique<PlaceTrial>(nets, given.places, paths.terrain());
    given.ranks.assign(given.places.size(), Rank::other);
    paths.each([&](const StoredPath& path) { given.trial->look(path); });
    for (std::uint32_t line = 0; line < nets.size(); ++line) {
        rank_places(line, nets[line].name, paths.head(), given, remarks);
    }
    return given;
}

}  // namespace

std::vector<double> usual_net_distances_m() {
    std::vector<double> distances_m;
    for (int i = 1; i <= 15; ++i) {
        distances_m.push_back(10.0 * i);
    }
    return distances_m;
}

PlaceTrial::PlaceTrial(std::span<const NetRecord> lines, std::span<const NetPlace> places,
                       const rockfall::Terrain& terrain)
    : places_{places}, terrain_{terrain}, lines_{lines_alone(lines)}, arrive_(lines.size()) {
    for (const NetPlace& place : places) {
        at_.push_back({rockfall::NetIndex{std::span{&place.net, 1}}, {}, {}, {}});
    }
}

void PlaceTrial::look(const StoredPath& path) {
    const auto cover = static_cast<std::size_t>(path.cover);
    TriedNets on_lines;
    try_nets(lines_, terrain_, path, on_lines);
    std::vector<std::optional<std::size_t>> arrival(arrive_.size());  // rows
    for (std::size_t i = 0; i < on_lines.rows.size(); ++i) {
        const NetRow& row = on_lines.rows[i];
        if (row.crossing.first) {
            arrival[row.crossing.net] = i;
            ++arrive_[row.crossing.net][cover];
        }
    }
    for (std::size_t i = 0; i < places_.size(); ++i) {
        TriedNets tried;
        try_nets(at_[i].net, terrain_, path, tried);
        at_[i].rows.insert(at_[i].rows.end(), tried.rows.begin(), tried.rows.end());
        const std::optional<std::size_t> arrives = arrival[places_[i].line];
        if (!arrives) {
            continue;
        }
        // Held before it comes to the line, not behind it (a road that rocks of both sides of a valley
        // reach).
        const bool held = !tried.rows.empty() &&
                          tried.rows.back().crossing.outcome == rockfall::NetOutcome::held &&
                          tried.when.back() <= on_lines.when[*arrives];
        if (held) {
            ++at_[i].kept[cover];
        } else {
            at_[i].residual_j[cover] += static_cast<double>(on_lines.rows[*arrives].crossing.energy_j);
        }
    }
}

PlaceFigures PlaceTrial::figures(std::size_t place, rockfall::Cover cover, const PathsHead& head) const {
    const auto c = static_cast<std::size_t>(cover);
    const std::vector<NetRecord> one{{"", "", places_[place].net}};
    PlaceFigures figures;
    figures.at_net =
        net_figures(one, at_[place].rows, cover, head.rocks[c], head.design, head.strata).front();
    const std::uint64_t arrive = arrive_[places_[place].line][c];
    figures.arrive = share_of(arrive, head.rocks[c]);
    figures.kept = share_of(at_[place].kept[c], arrive);
    figures.residual_kj =
        head.rocks[c] == 0 ? 0.0 : at_[place].residual_j[c] / j_per_kj / static_cast<double>(head.rocks[c]);
    return figures;
}

std::vector<TableLayout> net_place_layouts() {
    return together(siting::siting_layouts(), std::vector<TableLayout>{place_table()});
}

const std::vector<TableLayout>& net_command_layouts() {
    static const std::vector<TableLayout> layouts =
        together(net_place_layouts(), std::vector{net_inexact_layout()});
    return layouts;
}

void place_nets(const NetPlaceRequest& request, std::ostream& out) {
    NetPathsReader paths = paths_of_run(request.run);
    std::vector<std::string> remarks;
    siting::GivenLines given =
        siting::read_lines(request.nets, {paths.terrain(), projection_of_run(request.run)}, remarks);
    const std::vector<double> distances_m =
        request.distances_m.empty() ? usual_net_distances_m() : request.distances_m;
    const std::filesystem::path folder = request.out.empty() ? request.run / "net_place" : request.out;
    ShortRun::look_at(folder, "net place",
                      {"report.html", "nets.csv", "net_places.csv", "net_stretches.csv", "net_candidates.csv",
                       "net_along.csv", "net_place.gpkg"},
                      request.overwrite);
    const std::vector<rockfall::Target> houses = houses_of_run(request.run, paths.terrain(), remarks);
    std::optional<GivenNetPlaces> of_given;
    if (!given.nets.empty()) {
        of_given = place_given(request, given.nets, distances_m, houses, paths, remarks);
    }
    siting::SitingResults sited =
        siting::site_nets(paths, std::move(given.lines), {distances_m, request.azimuth_deg, houses});
    sited.run = request.run;
    sited.remarks.insert(sited.remarks.begin(), remarks.begin(), remarks.end());

    const InterruptGuard until_written;
    ShortRun results{folder};
    if (of_given) {
        results.add("net_places.csv", "Each place of each net: what it keeps from the line.",
                    [&](std::ostream& table) { write_places(table, given.nets, *of_given, paths.head()); });
        results.add("nets.csv", "The best place of each net, ready for nets.file.", [&](std::ostream& table) {
            write_best(table, given.nets, *of_given, paths.terrain().origin_m());
        });
    }
    siting::write_siting(sited, paths.terrain(), results, !of_given);
    results.publish({.kind = "net place",
                     .run = run_of_paths(request.run, request.nets, paths.head()),
                     .figures = {{"stretches", sited.stretches.size()}, {"nets", sited.nets.size()}},
                     .inputs = paths.head().inputs,
                     .warnings = sited.remarks,
                     .excel_decimal = excel_decimal_of(paths.head())},
                    net_place_layouts());
    if (!request.quiet) {
        for (const std::string& remark : sited.remarks) {
            out << remark << '\n';
        }
        for (const std::string& line : siting::in_words(sited)) {
            print_wrapped(out, line.starts_with("  ") ? "    " : "", line);
        }
        print_wrapped(out, "", design_rule_in_words(paths.head().design));
        out << (folder / "report.html").string() << '\n' << folder.string() << '\n';
    }
}

}  // namespace coupling

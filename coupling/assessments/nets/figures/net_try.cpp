#include "coupling/assessments/nets/figures/net_try.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/version.hpp"
#include "coupling/assessments/nets/figures/net_tables.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/nets/net_input.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/inputs/tables/prepare.hpp"
#include "coupling/results/figures/finished_runs.hpp"
#include "coupling/results/figures/read_summary.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "rockfall/obstacles/nets/net_passage.hpp"

namespace coupling {
namespace {

using config::joined;

namespace fs = std::filesystem;

rockfall::NetCrossingRecord record_of(const rockfall::NetPassage& passage, bool first) {
    const rockfall::NetCrossing& crossing = passage.crossing;
    return {crossing.net,
            static_cast<float>(passage.position_m.x()),
            static_cast<float>(passage.position_m.y()),
            static_cast<float>(crossing.along_m),
            static_cast<float>(crossing.height_m),
            static_cast<float>(crossing.radius_m),
            static_cast<float>(crossing.energy_j),
            static_cast<float>(crossing.translational_j),
            static_cast<float>(crossing.speed_mps),
            crossing.outcome,
            first};
}

/// Adds a crossing as the footprint of a fall would keep it. Whether the rock goes on unchanged.
bool keep(const rockfall::NetPassage& passage, const StoredPath& path, std::size_t piece,
          std::size_t first_row, TriedNets& tried) {
    const rockfall::NetCrossing& crossing = passage.crossing;
    const bool first =
        std::none_of(tried.rows.begin() + static_cast<std::ptrdiff_t>(first_row), tried.rows.end(),
                     [&](const NetRow& row) { return row.crossing.net == crossing.net; });
    tried.rows.push_back({path.rock, path.cover, record_of(passage, first)});
    tried.when.emplace_back(piece, passage.time_s);
    if (crossing.outcome == rockfall::NetOutcome::broke) {
        tried.broken.push_back({path.rock, path.cover, crossing.net});
    }
    return !rockfall::acts(crossing.outcome);
}

/// Adds a net that the rock would cross if none stood, behind one that it broke. Each net once; not one that
/// it has met already.
void keep_unknown(std::uint32_t net, const StoredPath& path, std::size_t first_row, std::size_t first_unknown,
                  TriedNets& tried) {
    const auto is_met = [&](const NetRow& row) { return row.crossing.net == net; };
    const auto is_kept = [&](const NetOfRock& one) { return one.net == net; };
    if (std::none_of(tried.rows.begin() + static_cast<std::ptrdiff_t>(first_row), tried.rows.end(), is_met) &&
        std::none_of(tried.unknown.begin() + static_cast<std::ptrdiff_t>(first_unknown), tried.unknown.end(),
                     is_kept)) {
        tried.unknown.push_back({path.rock, path.cover, net});
    }
}

/// Values as settings write them and as a summary does.
bool is_same(const std::string& setting, const std::string& in_summary) {
    if (setting == in_summary || (setting == "yes" && in_summary == "true") ||
        (setting == "no" && in_summary == "false")) {
        return true;
    }
    const auto number = config::parse_number(setting);
    return number && number == config::parse_number(in_summary);
}

/// A setting in which stored paths are of another run than the summary; nothing where they agree.
std::optional<std::string> other_setting(const PathsHead& head, const SummaryOfRun& summary) {
    for (const auto& [key, value] : head.settings) {
        const auto found = std::find_if(summary.settings.begin(), summary.settings.end(),
                                        [&](const auto& setting) { return setting.key == key; });
        if (found == summary.settings.end() || !is_same(value, found->value)) {
            return joined(key, " = ", value, ", where summary.json beside it has ",
                          found == summary.settings.end() ? "none" : found->value);
        }
    }
    return std::nullopt;
}

/// Paths, summary and program must be of one kind, or figures of two runs would be mixed.
void check_same_run(const NetPathsReader& paths, const fs::path& folder, const fs::path& file) {
    const fs::path summary_file = folder / "summary.json";
    const FileBytes bytes = open_file(summary_file, {summary_file.string()}, "the summary of a finished run");
    const SummaryOfRun summary = read_summary(bytes.text(), summary_file.string());
    const PathsHead& head = paths.head();
    const bool same_inputs =
        summary.inputs.size() == head.inputs.size() &&
        std::equal(head.inputs.begin(), head.inputs.end(), summary.inputs.begin(),
                   [](const InputFile& a, const auto& b) { return a.role == b.role && a.hash == b.hash; });
    if (head.seed != summary.seed || head.version != summary.version || !same_inputs) {
        config::fail(config::ExitCode::data, {file.string()},
                     "paths of another run than summary.json beside it", "both of one run");
    }
    if (const auto other = other_setting(head, summary)) {
        config::fail(config::ExitCode::data, {file.string()}, joined("paths of another run: of ", *other),
                     "both of one run");
    }
    if (head.version != config::version()) {
        config::fail(config::ExitCode::data, {file.string()},
                     joined("paths of version ", head.version, " of the program"),
                     joined("version ", config::version(), ": run the scenario again"));
    }
}

}  // namespace

void try_nets(const rockfall::NetIndex& nets, const rockfall::Terrain& terrain, const StoredPath& path,
              TriedNets& tried) {
    const std::size_t first_row = tried.rows.size();
    const std::size_t first_unknown = tried.unknown.size();
    std::vector<rockfall::NetLineCrossing> lines;
    bool goes_on = true;
    bool is_known = true;    // not behind a net that the rock broke
    std::size_t number = 0;  // of the piece
    const auto take = [&](const rockfall::NetPassage& passage) {
        if (!is_known) {
            keep_unknown(passage.crossing.net, path, first_row, first_unknown, tried);
        } else if (!keep(passage, path, number, first_row, tried)) {
            is_known = false;
            goes_on = passage.crossing.outcome == rockfall::NetOutcome::broke;
        }
        return goes_on;
    };
    for (const StoredPiece& piece : path.pieces) {
        if (!goes_on) {
            return;
        }
        if (piece.flies) {
            const auto ground_m = [&](double, const Eigen::Vector3d& place_m) {
                const auto triangle = terrain.locate(place_m.x(), place_m.y(), piece.triangle);
                return terrain.plane_of(triangle.value_or(piece.triangle)).height_m(place_m.x(), place_m.y());
            };
            rockfall::each_passage(nets, path.body, {piece.start_m, piece.other}, piece.first, piece.second,
                                   lines, ground_m, take);
        } else {
            rockfall::each_passage(
                nets, path.body,
                rockfall::StraightWay{piece.start_m, piece.other, piece.first, piece.second, piece.slides,
                                      piece.rotation_start_j, piece.rotation_end_j},
                lines, take);
        }
        ++number;
    }
}

std::vector<NetFigures> figures_of_tried(std::span<const NetRecord> nets, const TriedNets& tried,
                                         const std::array<std::uint64_t, rockfall::covers>& rocks,
                                         const PathsHead& head) {
    std::vector<NetFigures> figures;
    for (const Cover cover : all_covers) {
        if (cover == Cover::forest && !head.with_forest) {
            continue;
        }
        auto of_slope =
            net_figures(nets, tried.rows, cover, rocks[index_of(cover)], head.design, head.strata);
        figures.insert(figures.end(), of_slope.begin(), of_slope.end());
    }
    for (NetFigures& of : figures) {
        of.inexact = static_cast<std::uint64_t>(
            std::count_if(tried.unknown.begin(), tried.unknown.end(),
                          [&](const NetOfRock& one) { return one.net == of.net && one.cover == of.cover; }));
    }
    return figures;
}

NetPathsReader paths_of_run(const fs::path& folder) {
    const fs::path file = folder / "net_paths.bin";
    if (!path_exists(file)) {
        config::fail(config::ExitCode::file, {file.string()}, "no stored paths",
                     "the folder of a run with nets.keep_paths = yes", name_a_finished_run(folder));
    }
    NetPathsReader paths{file};
    check_same_run(paths, folder, file);
    return paths;
}

std::vector<NetRecord> nets_on(const fs::path& file, const RunTerrain& run, Standing standing,
                               std::vector<std::string>& remarks) {
    TableOnRun given_table = table_on(run, file, "a table or layer of nets", remarks);
    config::Table& table = given_table.table;
    tables::add_remarks(tables::prepare(table, "nets", given_table.has_own_shapes), remarks);
    GivenNets given = nets_of(table, standing);
    for (const config::Problem& warning : net_warnings(table, given.nets)) {
        remarks.push_back(joined("warning: ", config::to_string(warning)));
    }
    tables::add_remarks(tables::findings_of_use(*table.use()), remarks);
    config::Problems problems;
    std::vector<NetRecord> nets = on_terrain(std::move(given), run.terrain, problems);
    problems.throw_if_any();
    return nets;
}

}  // namespace coupling

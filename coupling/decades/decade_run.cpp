#include "coupling/decades/decade_run.hpp"

#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <optional>

#include "coupling/decades/decade_results.hpp"
#include "coupling/decades/member_part.hpp"
#include "coupling/decades/simulate.hpp"
#include "coupling/inputs/reading.hpp"
#include "coupling/results/joined.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/run/checkpoint.hpp"
#include "coupling/run/first_error.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/output_folder.hpp"
#include "coupling/run/progress.hpp"
#include "coupling/run/settings_hash.hpp"
#include "coupling/version.hpp"

namespace coupling::decades {
namespace {

namespace fs = std::filesystem;

std::vector<Member> members_of(const Scenario& scenario, std::size_t regimes) {
    std::vector<Member> members;
    for (std::uint32_t regime = 0; regime < regimes; ++regime) {
        for (std::uint32_t replicate = 0; replicate < scenario.forest.replicates; ++replicate) {
            members.push_back({regime, replicate});
        }
    }
    return members;
}

fs::path part_of(const OutputFolder& folder, const Member& member) {
    return folder.parts() / joined("member_", std::to_string(member.regime + 1), "_",
                                   std::to_string(member.replicate + 1), ".part");
}

/// Stems that rocks meet but no forest grows.
std::vector<rockfall::Stem> standing_stems(const ForestSite& forest) {
    std::vector<rockfall::Stem> stems;
    for (const TreeRecord& tree : forest.obstacles) {
        if (tree.stem.dbh_cm >= least_obstacle_cm) {
            stems.push_back(tree.stem);
        }
    }
    return stems;
}

/// Lives through the members that have no part yet: several at a time, or the rocks of one on several threads
/// where there are fewer members than threads. Throws Interrupted.
void live_missing(const Decades& decades, std::span<const Member> missing, const OutputFolder& folder,
                  const std::string& hash, const RunRequest& request) {
    Progress progress{"simulating years", decades.scenario.years * missing.size(), 0, request.quiet};
    std::mutex progress_mutex;
    const auto year_done = [&] {
        if (InterruptGuard::requested()) {
            throw Interrupted{};
        }
        const std::lock_guard lock{progress_mutex};
        progress.add(1);
    };
    const int threads = request.threads > 0 ? request.threads : omp_get_max_threads();
    const int at_once = std::min(threads, static_cast<int>(missing.size()));
    const int threads_each = at_once > 1 ? 1 : threads;
    const auto count = static_cast<std::int64_t>(missing.size());
    std::mutex parts_mutex;
    FirstError error;
#pragma omp parallel for schedule(dynamic, 1) num_threads(std::max(1, at_once))
    for (std::int64_t i = 0; i < count; ++i) {
        error.guard([&] {
            const Member& member = missing[static_cast<std::size_t>(i)];
            const MemberYears years = simulate(decades, member, threads_each, year_done);
            // Until the first member is through there is nothing to keep, and an interrupted run leaves
            // nothing behind.
            const std::lock_guard lock{parts_mutex};
            write_marker(folder.checkpoint(), hash);
            write_part(part_of(folder, member), hash, years);
        });
    }
    progress.finish();
    error.rethrow();
}

void say_target(const DecadeResults& results, std::uint32_t target) {
    for (std::uint32_t regime = 0; regime < results.names.regimes.size(); ++regime) {
        PairedCounts first;
        PairedCounts last;
        std::int32_t last_year = 0;
        const auto add = [](PairedCounts& sum, const PairedCounts& counts) {
            sum.both += counts.both;
            sum.only_forest += counts.only_forest;
            sum.only_bare += counts.only_bare;
        };
        for (const MemberYears& member : results.members) {
            for (const TargetRow& row : member.targets) {
                if (member.member.regime != regime || row.target != target) {
                    continue;
                }
                if (row.year == member.targets.front().year) {
                    add(first, row.paired);
                }
                if (row.year == member.targets.back().year) {
                    add(last, row.paired);
                    last_year = row.year;
                }
            }
        }
        const auto percent = [](const PairedCounts& counts) {
            const auto effect = protection_effect(counts);
            return effect ? joined(report::fixed(100.0 * effect->value, 1), " %")
                          : std::string{"– (no rock arrives)"};
        };
        std::printf("  %s, %s: kept away by the forest: %s in year 0, %s in year %d\n",
                    results.site.targets[target].name.c_str(), results.names.regimes[regime].c_str(),
                    percent(first).c_str(), percent(last).c_str(), last_year);
    }
}

void print_summary(const DecadeResults& results, const fs::path& folder,
                   const std::vector<WrittenFile>& files) {
    const forest::PatchGrid& grid = results.site.forest->grid;
    std::printf("%s of %.2f ha forest (%zu patches), %s, %s", counted(results.scenario.years, "year").c_str(),
                grid.area_ha(), grid.size(), counted(results.names.regimes.size(), "regime").c_str(),
                counted(results.scenario.forest.replicates, "replicate").c_str());
    results.rocks > 0 ? std::printf(", %llu rocks a year\n", static_cast<unsigned long long>(results.rocks))
                      : std::printf(", no rockfall\n");
    const MemberYears& member = results.members.front();
    for (const StandRow& row : member.stands) {
        if (row.unit == all && row.species == all &&
            (row.year == 0 || row.year == static_cast<std::int32_t>(results.scenario.years))) {
            std::printf(
                "  year %d (%s, replicate 1): %.0f stems/ha, %.1f m2/ha, %.0f m3/ha, dominant height %.1f "
                "m\n",
                row.year, results.names.regimes[member.member.regime].c_str(), row.figures.stems_pha,
                row.figures.basal_area_m2pha, row.figures.volume_m3pha, row.figures.dominant_height_m);
        }
    }
    for (std::uint32_t target = 0; results.rocks > 0 && target < results.site.targets.size(); ++target) {
        say_target(results, target);
    }
    std::printf("Results in %s\n", folder.string().c_str());
    for (const WrittenFile& file : files) {
        if (file.path == "report.html" || file.path == "summary.json" || file.path == "tables/stands.csv" ||
            file.path == "tables/protection.csv") {
            std::printf("  %-28s %s\n", file.path.c_str(), file.sentence.c_str());
        }
    }
}

/// Copies the parts of shards into the folder. A part that is cut off or of other settings is refused.
void gather(std::span<const fs::path> shards, std::span<const Member> members, const OutputFolder& folder,
            const std::string& hash) {
    for (const fs::path& shard : shards) {
        if (!fs::is_directory(shard / "parts")) {
            config::fail(config::ExitCode::file, {shard.string()}, "no parts in this folder",
                         "the --out folder of a shard");
        }
        for (const Member& member : members) {
            const fs::path part = shard / "parts" / part_of(folder, member).filename();
            if (const auto years = read_part(part, hash)) {
                write_marker(folder.checkpoint(), hash);
                write_part(part_of(folder, member), hash, *years);
            }
        }
    }
}

void refuse_gaps(std::span<const Member> missing, const Names& names) {
    if (!missing.empty()) {
        config::fail(config::ExitCode::file, {},
                     joined(std::to_string(missing.size()), " members without a part, such as ",
                            names.regimes[missing.front().regime], ", replicate ",
                            std::to_string(missing.front().replicate + 1)),
                     "the folders of all shards; `bannwald run` simulates what is missing");
    }
}

/// The rocks that really fall are drawn from the simulated ones.
void refuse_too_many_rocks(const Scenario& scenario, const std::optional<RockSeason>& rocks) {
    if (rocks && scenario.forest.feedback &&
        scenario.forest.rocks_per_year > static_cast<double>(rocks->rocks())) {
        config::fail(config::ExitCode::settings, scenario.options->place_of("feedback.rocks_per_year"),
                     joined("feedback.rocks_per_year ", report::fixed(scenario.forest.rocks_per_year, 0)),
                     joined("at most the ", std::to_string(rocks->rocks()), " rocks simulated in a year"));
    }
}

Names names_of(const Management& management, const forest::SpeciesTable& species) {
    Names names{{}, {}, species};
    for (const Regime& regime : management.regimes) {
        names.regimes.push_back(regime.name());
        names.interventions.emplace_back();
        for (const Intervention& row : regime.interventions()) {
            names.interventions.back().emplace_back(row.name, name_of(row.treatment));
        }
    }
    return names;
}

/// All members, from their parts, in order.
std::vector<MemberYears> read_all(std::span<const Member> members, const OutputFolder& folder,
                                  const std::string& hash) {
    std::vector<MemberYears> years;
    for (const Member& member : members) {
        years.push_back(read_part(part_of(folder, member), hash).value());
    }
    return years;
}

/// As the static assessment does.
void tell_rocks_not_started(std::span<const MemberYears> members, std::uint64_t rocks,
                            config::Warnings& warnings) {
    std::uint64_t missing = 0;
    for (const MemberYears& member : members) {
        for (const SlopeRow& slope : member.slopes) {
            missing += slope.cover == Cover::bare ? rocks - slope.figures.rocks : 0;
        }
    }
    if (missing > 0) {
        warnings.add(joined(std::to_string(missing),
                            " rocks of all years and members were not released: their place in "
                            "the source lies outside the terrain"));
    }
}

}  // namespace

int run_decades(const RunRequest& request, const Scenario& scenario, Site& site, config::Warnings& warnings) {
    const Management management = read_management(scenario, *site.forest, warnings);
    site.inputs.insert(site.inputs.end(), management.inputs.begin(), management.inputs.end());
    const fs::path out = request.out.empty() ? scenario.file.parent_path() / "out" : request.out;
    const std::string hash =
        settings_hash(scenario, site.inputs);  // the inputs of the regimes are among them
    OutputFolder folder{out, hash, request.overwrite};
    const InterruptGuard guard;
    std::optional<RockSeason> rocks;
    if (scenario.forest.rockfall_every > 0) {
        rocks.emplace(scenario, site, site.forest->species.fracture_energy, standing_stems(*site.forest));
    }
    refuse_too_many_rocks(scenario, rocks);
    const Decades decades{scenario, *site.forest, management, rocks ? &*rocks : nullptr};
    const Names names = names_of(management, site.forest->species.table);
    const std::vector<Member> members = members_of(scenario, names.regimes.size());
    gather(request.shards, members, folder, hash);
    std::vector<Member> missing;
    for (std::size_t i = request.shard.number - 1; i < members.size(); i += request.shard.count) {
        if (!has_part(part_of(folder, members[i]), hash)) {
            missing.push_back(members[i]);
        }
    }
    if (!request.shards.empty()) {
        refuse_gaps(missing, names);
    }
    try {
        live_missing(decades, missing, folder, hash, request);
    } catch (const Interrupted&) {
        std::fprintf(stderr, fs::exists(folder.checkpoint())
                                 ? "bannwald: interrupted; the finished members are kept, run the same "
                                   "command again to go on\n"
                                 : "bannwald: interrupted; no member was finished, nothing is kept\n");
        return static_cast<int>(config::ExitCode::interrupted);
    }
    if (request.shard.count > 1) {
        std::printf("Shard %u of %u is done; its parts lie in %s\n", request.shard.number,
                    request.shard.count, folder.parts().string().c_str());
        return static_cast<int>(config::ExitCode::done);
    }
    const std::vector<MemberYears> years = read_all(members, folder, hash);
    const DecadeResults results{scenario, site,     names, years, rocks ? rocks->rocks() : 0,
                                warnings, version()};
    tell_rocks_not_started(years, results.rocks, warnings);
    make_folder(folder.staging());
    const std::vector<WrittenFile> files = write_results(results, folder.staging());
    folder.publish();
    if (!request.quiet) {
        print_summary(results, folder.path(), files);
    }
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace coupling::decades

#include "coupling/assessments/decades/decade_run.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/decades/closing_summary.hpp"
#include "coupling/assessments/decades/decade_results.hpp"
#include "coupling/assessments/decades/idle_interventions.hpp"
#include "coupling/assessments/decades/members/parts.hpp"
#include "coupling/assessments/decades/members/share_out.hpp"
#include "coupling/assessments/decades/members/simulate.hpp"
#include "coupling/assessments/decades/risk/read_risk.hpp"
#include "coupling/assessments/decades/risk/risk_over_years.hpp"
#include "coupling/assessments/decades/start_artefact.hpp"
#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/assessments/decades/tables/departures_over_years.hpp"
#include "coupling/assessments/decades/whole_run.hpp"
#include "coupling/exchange/stems_and_logs.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/run/assessment.hpp"
#include "coupling/run/settings_hash.hpp"

namespace coupling::decades {
namespace {

using config::joined;

namespace fs = std::filesystem;

/// Replicates of members, rising.
std::vector<std::uint32_t> replicates_of(std::span<const Member> members) {
    std::set<std::uint32_t> replicates;
    for (const Member& member : members) {
        replicates.insert(member.replicate);
    }
    return {replicates.begin(), replicates.end()};
}

/// A member without a part of this run.
struct MissingMember {
    std::uint64_t place = 0;  ///< in the list of all
    Member member{};
    std::int32_t begun = 0;  ///< years that an earlier, shorter run has left
};

/// The years that each replicate is still to simulate.
std::vector<YearsToCome> years_to_come(std::span<const MissingMember> members) {
    std::map<std::uint32_t, std::int32_t> first;
    for (const MissingMember& missing : members) {
        const std::int32_t next = missing.begun > 0 ? missing.begun + 1 : 0;
        const auto known = first.emplace(missing.member.replicate, next).first;
        known->second = std::min(known->second, next);
    }
    std::vector<YearsToCome> years;
    for (const auto& [replicate, year] : first) {
        years.push_back({replicate, year});
    }
    return years;
}

/// What a shorter run has left of a member.
std::optional<KeptMember> begun_part(const MissingMember& missing, const Parts& parts) {
    if (missing.begun == 0) {
        return std::nullopt;
    }
    std::optional<KeptMember> begun = parts.begun(missing.member);
    if (!begun || begun->kept.last != missing.begun) {
        config::fail(config::ExitCode::file, {parts.folder().string()},
                     "a kept part of an earlier run that has changed since this run began",
                     "the folder as it was; run the same command again");
    }
    return begun;
}

/// Simulates members, together with the other ranks.
void simulate_members(Decades decades, std::span<const MissingMember> missing, const Parts& parts,
                      const Shard& shard, const Crew& crew) {
    const auto at_a_time = static_cast<std::size_t>(crew.threads);
    Starts starts{2 * at_a_time};  // those of the members before may still be at work
    decades.starts = &starts;
    std::vector<Member> members;
    std::uint64_t years = 0;
    for (const MissingMember& one : missing) {
        members.push_back(one.member);
        years += decades.scenario.run.years - static_cast<std::uint64_t>(one.begun);
    }
    if (decades.rocks != nullptr) {
        make_bare_falls(*decades.rocks, *decades.blocks, years_to_come(missing), parts, shard, crew);
    }
    const std::vector<Member> ordered = in_order_of_starts(members, at_a_time);
    share_out(crew, {RankGroup::Work::members, "simulating years", ordered.size(), years},
              [&](std::size_t i, int threads, const std::function<void()>& year_done) {
                  const auto& one = *std::find_if(missing.begin(), missing.end(), [&](const auto& other) {
                      return other.member == ordered[i];
                  });
                  parts.keep(simulate_on(decades, one.member, begun_part(one, parts), threads, year_done));
              });
}

/// With --overwrite the parts of a shard would be deleted before they are read.
void refuse_to_overwrite_shards(const RunRequest& request, const fs::path& out) {
    for (const fs::path& shard : request.shards) {
        std::error_code ignored;
        if (request.overwrite && fs::equivalent(shard, out, ignored)) {
            config::fail(config::ExitCode::settings, {out.string()},
                         "the output folder is that of a shard; --overwrite would delete its parts",
                         "another folder by --out, or no --overwrite");
        }
    }
}

/// Copies the parts of shards into the folder. A part that is cut off or of other settings is refused.
void gather(std::span<const fs::path> shards, std::span<const Member> members, const Parts& parts,
            const std::string& hash, const MemberKeys* keys, std::size_t blocks) {
    for (const fs::path& shard : shards) {
        if (!is_folder(shard / "parts")) {
            config::fail(config::ExitCode::file, {shard.string()}, "no parts in this folder",
                         "the --out folder of a shard");
        }
        // Nothing in the folder of a shard is ours to delete.
        const Parts others{shard / "parts", hash, keys,
                           "the folder of a shard with the same settings and inputs; run that shard again in "
                           "a folder of its own, or copy its folder once more"};
        for (const Member& member : members) {
            static_cast<void>(others.read(member));  // all are sound, or nothing is copied
        }
        for (const Member& member : members) {
            if (const auto kept = others.read(member)) {
                parts.keep(*kept);
            }
        }
        for (const std::uint32_t replicate : replicates_of(members)) {
            for (std::size_t block = 0; block < blocks; ++block) {
                if (others.has_bare(replicate, block)) {
                    parts.keep_bare(replicate, block, others.read_bare(replicate, block));
                }
            }
        }
    }
}

/// Members of the shard that have no part yet, and what earlier runs have left of them.
std::vector<MissingMember> missing_of(std::span<const Member> members, const Shard& shard,
                                      const Parts& parts) {
    std::vector<MissingMember> missing;
    for (std::uint64_t i = shard.number - 1; i < members.size(); i += shard.count) {
        if (!parts.read(members[i])) {
            const std::optional<KeptMember> begun = parts.begun(members[i]);
            missing.push_back({i, members[i], begun ? begun->kept.last : 0});
        }
    }
    return missing;
}

/// Those of the first rank, on all of them.
std::vector<MissingMember> from_first(RankGroup& ranks, std::span<const MissingMember> missing,
                                      std::span<const Member> members) {
    std::vector<std::uint64_t> numbers;
    for (const MissingMember& one : missing) {
        numbers.push_back(one.place);
        numbers.push_back(static_cast<std::uint64_t>(one.begun));
    }
    numbers = ranks.from_first(std::move(numbers));
    std::vector<MissingMember> all;
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
        all.push_back({numbers[i], members[numbers[i]], static_cast<std::int32_t>(numbers[i + 1])});
    }
    return all;
}

/// `out`: the folder that has the parts of all shards by now.
void refuse_gaps(std::span<const MissingMember> missing, const Names& names, const fs::path& out) {
    if (!missing.empty()) {
        config::fail(
            config::ExitCode::file, {},
            joined(std::to_string(missing.size()), " members without a part, such as ",
                   names.course_name(names.course_of(missing.front().member)), ", replicate ",
                   std::to_string(missing.front().member.replicate + 1)),
            "the folders of all shards",
            joined("name the missing folder, too; or `bannwald run SCENARIO --out ", out.string(),
                   "` with the same settings simulates only these: the parts of the others lie there"));
    }
}

/// The rocks that really fall are drawn from the simulated ones.
void refuse_too_many_rocks(const Scenario& scenario, const std::optional<exchange::YearlyRockfall>& rocks) {
    if (rocks && scenario.forest.feedback &&
        scenario.forest.rocks_per_year > static_cast<double>(rocks->rocks())) {
        config::fail(config::ExitCode::settings, scenario.options->place_of("feedback.rocks_per_year"),
                     joined("feedback.rocks_per_year ", report::fixed(scenario.forest.rocks_per_year, 0)),
                     joined("at most the ", std::to_string(rocks->rocks()), " rocks simulated in a year"));
    }
}

/// All members, from their parts, in order.
std::vector<MemberYears> read_all(std::span<const Member> members, const Parts& parts) {
    std::vector<MemberYears> years;
    for (const Member& member : members) {
        years.push_back(std::move(parts.read(member).value().years));
    }
    return years;
}

/// As the static assessment does.
void warn_of_rocks_not_started(std::span<const MemberYears> members, std::uint64_t rocks,
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

/// Ranks that read other settings or files, or another folder, would spoil each other's work.
void refuse_other_parts(RankGroup& ranks, const std::string& hash, const Shard& shard,
                        const fs::path& parts) {
    const std::vector<std::uint64_t> own{std::stoull(hash, nullptr, 16), shard.number, shard.count};
    if (ranks.from_first(own) != own) {
        config::fail(config::ExitCode::settings, {},
                     "processes of one run with different settings, files or shards", "the same for all");
    }
    if (!is_folder(parts)) {
        config::fail(config::ExitCode::file, {parts.string()},
                     "a process does not see the output folder of the first one",
                     "a folder that all machines share");
    }
}

/// A run over years, whose inputs are read. Other ranks and shards do their part of it.
class DecadeRun : public RunSteps {
public:
    DecadeRun(const RunRequest& request, const Scenario& scenario, const Site& site,
              const Management& management, const MemberKeys& keys,
              std::optional<consequences::RiskPlan> risk_plan, config::Warnings& warnings, RankGroup& ranks)
        : request_{request},
          scenario_{scenario},
          site_{site},
          warnings_{warnings},
          ranks_{ranks},
          hash_{settings_hash(scenario, site.inputs)},
          keys_{keys},
          risk_plan_{std::move(risk_plan)},
          parts_{OutputFolder::parts_of(output_folder_of(request, scenario)), hash_, &keys},
          names_{names_of(management, *site.forest)},
          members_{members_of(scenario, names_)},
          blocks_{scenario},
          decades_{scenario, *site.forest, management, nullptr, &blocks_, &parts_} {
        if (scenario.forest.rockfall_every > 0) {
            rocks_.emplace(scenario, site, site.forest->species.fracture_energy,
                           standing_stems(*site.forest));
            decades_.rocks = &*rocks_;
        }
        refuse_too_many_rocks(scenario, rocks_);
    }

    [[nodiscard]] const std::string& hash() const { return hash_; }

    void simulate(const OutputFolder*) override {
        refuse_other_parts(ranks_, hash_, request_.shard, parts_.folder());
        gather(request_.shards, members_, parts_, hash_, &keys_, blocks_.count());
        std::vector<MissingMember> missing;
        if (ranks_.first()) {
            missing = missing_of(members_, request_.shard, parts_);
        }
        missing = from_first(ranks_, missing, members_);
        say_what_is_there(missing);
        if (!request_.shards.empty()) {
            refuse_gaps(missing, names_, parts_.folder().parent_path());
        }
        const int threads = request_.threads > 0 ? request_.threads : ranks_.usual_threads();
        simulate_members(decades_, missing, parts_, request_.shard, {ranks_, threads, request_.quiet});
        if (request_.shard.count > 1 && ranks_.first()) {
            std::printf("Shard %u of %u is done; its parts lie in %s\n", request_.shard.number,
                        request_.shard.count, parts_.folder().string().c_str());
        }
    }

    std::vector<WrittenFile> write(const fs::path& folder, const WriteWatch& watch) override {
        years_ = read_all(members_, parts_);
        if (risk_plan_) {
            risk_ =
                risk_over_years(names_, site_.targets, years_, *risk_plan_, real_rocks_per_year(scenario_));
        }
        simulated_years_ = parts_.own_years(members_);
        parts_.keep_for_others(members_, blocks_.count());
        add_warnings();
        decision_ =
            decide(names_, series_of(names_, site_, years_, std::nullopt), years_, scenario_.forest.decision);
        return write_results(results(), folder, watch);
    }

    void print_figures() const override { print_summary(results()); }

    [[nodiscard]] std::string after_interruption(const fs::path&) const override {
        return parts_.any() ? "the finished parts are kept, run the same command again to go on"
                            : "no part was finished, nothing is kept";
    }

private:
    [[nodiscard]] DecadeResults results() const {
        return {scenario_,
                site_,
                names_,
                years_,
                simulated_years_,
                rocks_ ? rocks_->rocks() : 0,
                warnings_,
                config::version(),
                &decades_.management,
                risk_ ? &*risk_ : nullptr,
                decision_ ? &*decision_ : nullptr};
    }

    /// Before a long run, so that the user sees what an extension costs.
    void say_what_is_there(std::span<const MissingMember> missing) const {
        if (!ranks_.first() || request_.quiet) {
            return;
        }
        const auto whole = std::count_if(members_.begin(), members_.end(), [&](const Member& member) {
            return parts_.kept_years(member) == static_cast<std::int32_t>(scenario_.run.years);
        });
        const std::string of_all = joined(" of ", counted(members_.size(), "member"));
        if (whole > 0) {
            std::printf("%s of an earlier run in this folder serve this one, too\n",
                        joined(std::to_string(whole), of_all).c_str());
        }
        const auto begun = std::count_if(missing.begin(), missing.end(),
                                         [](const MissingMember& one) { return one.begun > 0; });
        if (begun > 0) {
            std::printf("%s of an earlier, shorter run in this folder go on from its last year\n",
                        joined(std::to_string(begun), of_all).c_str());
        }
    }

    void add_warnings() {
        warn_of_rocks_not_started(years_, rocks_ ? rocks_->rocks() : 0, warnings_);
        const auto departures = [&](Cover cover) {
            return departures_over_years(years_, cover, site_.slope.terrain);
        };
        warn_of_departures(departures(Cover::bare), departures(Cover::forest), warnings_);
        warn_of_falls(scenario_.rockfall.fall.motion, fall_figures_over_years(years_, site_.slope.terrain),
                      warnings_);
        warn_of_unreached_targets(site_, years_, departures(Cover::bare), warnings_);
        if (auto sentence =
                missing_dead_wood(names_, series_of(names_, site_, years_, std::nullopt), years_)) {
            warnings_.add(std::move(*sentence));
        }
        for (std::string& sentence : idle_interventions(names_, years_)) {
            warnings_.add(std::move(sentence));
        }
        for (std::string& sentence : unfelled_trees(names_, decades_.management, years_,
                                                    static_cast<std::int32_t>(scenario_.run.years))) {
            warnings_.add(std::move(sentence));
        }
    }

    const RunRequest& request_;
    const Scenario& scenario_;
    const Site& site_;
    config::Warnings& warnings_;
    RankGroup& ranks_;
    std::string hash_;
    const MemberKeys& keys_;
    std::optional<consequences::RiskPlan> risk_plan_;
    Parts parts_;
    Names names_;
    std::vector<Member> members_;
    std::optional<exchange::YearlyRockfall> rocks_;
    YearBlocks blocks_;
    Decades decades_;
    std::vector<MemberYears> years_;
    std::optional<RiskOverYears> risk_;
    std::optional<Decision> decision_;
    std::uint64_t simulated_years_ = 0;  ///< years of members that this run has simulated
};

}  // namespace

int run_decades(const RunRequest& request, const Scenario& scenario, Site& site, config::Warnings& warnings,
                RankGroup& ranks) {
    const Management management =
        read_management(scenario, *site.forest, warnings, mean_block_m(scenario, site));
    const MemberKeys keys{scenario, site, management};
    // The hash of a run is also that of what its regimes read, and of what its rocks cost.
    site.inputs.insert(site.inputs.end(), management.inputs.begin(), management.inputs.end());
    std::optional<consequences::RiskPlan> risk = read_risk(scenario, site, warnings);
    DecadeRun run{request, scenario, site, management, keys, std::move(risk), warnings, ranks};
    const fs::path out = output_folder_of(request, scenario);
    if (ranks.first()) {
        refuse_to_overwrite_shards(request, out);
    }
    return complete_run(run, {request, scenario, out, run.hash()}, ranks);
}

}  // namespace coupling::decades

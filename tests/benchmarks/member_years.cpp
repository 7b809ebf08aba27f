#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/simulate.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/program/actions/init.hpp"
#include "coupling/program/actions/run_assessment.hpp"
#include "coupling/run/output_folder.hpp"

namespace benchmarks {
namespace {

namespace decades = coupling::decades;
namespace exchange = coupling::exchange;
namespace fs = std::filesystem;
using benchmark::DoNotOptimize;
using benchmark::State;

/// The shipped example of 9 ha and 1000 rocks a year, opened for a few years in a folder of its own.
class SmallRegimes {
public:
    static constexpr int years = 3;

    SmallRegimes() {
        coupling::write_example(folder_, "regimes-small");
        scenario_ = coupling::read_scenario(folder_ / "scenario.ini", overrides());
        site_ = std::make_unique<coupling::Site>(coupling::open_site(*scenario_, warnings_));
        management_ = decades::read_management(*scenario_, *site_->forest, warnings_);
        rocks_ = std::make_unique<exchange::YearlyRockfall>(
            *scenario_, *site_, site_->forest->species.fracture_energy, std::vector<rockfall::Stem>{});
        blocks_ = std::make_unique<decades::YearBlocks>(*scenario_);
        fs::create_directories(folder_ / "parts");
        parts_ = std::make_unique<decades::Parts>(folder_ / "parts", "benchmark");
        std::vector<exchange::BareYear> bare;
        for (const std::int32_t year : blocks_->years(0)) {
            bare.push_back(rocks_->simulate_bare(0, year, blocks_->with_cells(year), 1));
        }
        parts_->keep_bare(0, 0, bare);
    }
    ~SmallRegimes() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    SmallRegimes(const SmallRegimes&) = delete;
    SmallRegimes& operator=(const SmallRegimes&) = delete;

    static std::vector<std::string> overrides() {
        return {"run.years=" + std::to_string(years), "output.map_years=0, " + std::to_string(years),
                "release.rocks=1000"};
    }
    [[nodiscard]] decades::Decades decades() const {
        return {*scenario_, *site_->forest, management_, rocks_.get(), blocks_.get(), parts_.get()};
    }
    [[nodiscard]] const exchange::YearlyRockfall& rocks() const { return *rocks_; }
    [[nodiscard]] forest::Stand stand() const { return site_->forest->start(1, 0); }
    [[nodiscard]] const fs::path& folder() const { return folder_; }

private:
    fs::path folder_ = fs::temp_directory_path() / ("bannwald-benchmark-" + std::to_string(getpid()));
    config::Warnings warnings_;
    std::unique_ptr<coupling::Scenario> scenario_;
    std::unique_ptr<coupling::Site> site_;
    decades::Management management_;
    std::unique_ptr<exchange::YearlyRockfall> rocks_;
    std::unique_ptr<decades::YearBlocks> blocks_;
    std::unique_ptr<decades::Parts> parts_;
};

const SmallRegimes& small() {
    static const SmallRegimes it;
    return it;
}

void count_rocks(State& state) {
    state.counters["rocks/s"] = benchmark::Counter(static_cast<double>(small().rocks().rocks()),
                                                   benchmark::Counter::kIsIterationInvariantRate);
}

void rock_year_bare(State& state) {
    for (auto _ : state) {
        DoNotOptimize(small().rocks().simulate_bare(0, 1, false, 1));
    }
    count_rocks(state);
}

void rock_year_forest(State& state) {
    const forest::Stand stand = small().stand();
    const exchange::BareYear bare = small().rocks().simulate_bare(0, 1, false, 1);
    for (auto _ : state) {
        DoNotOptimize(small().rocks().simulate(stand, bare, 0, false, 1));
    }
    count_rocks(state);
}

/// One iteration is a year of a member: the start and the years after it are shared out evenly.
void member_year(State& state) {
    const decades::Decades decades = small().decades();
    while (state.KeepRunningBatch(SmallRegimes::years + 1)) {
        DoNotOptimize(decades::simulate(decades, {1, 0}, 1, [] {}));
    }
}

/// `bannwald merge` of eight members: reads the scenario, the site and the parts, writes all results.
void merge(State& state) {
    coupling::RunRequest request{.scenario = small().folder() / "scenario.ini",
                                 .overrides = SmallRegimes::overrides(),
                                 .out = small().folder() / "shard",
                                 .threads = 1,
                                 .overwrite = true,
                                 .quiet = true,
                                 .shard = {1, 2}};
    const auto run = [&] {
        coupling::RankGroup alone{coupling::RankGroup::Alone{}};
        static_cast<void>(coupling::run_assessment(request, alone));
    };
    run();
    request.out = small().folder() / "other_shard";
    request.shard = {2, 2};
    run();
    request.shards = {small().folder() / "shard", small().folder() / "other_shard"};
    request.shard = {};
    request.out = small().folder() / "out";
    for (auto _ : state) {
        run();
    }
    state.counters["members"] = 8.0;
}

}  // namespace

void register_member_years() {
    const auto add = [](const char* name, void (*function)(State&)) {
        return benchmark::RegisterBenchmark(name, function)->Unit(benchmark::kMillisecond);
    };
    add("Years/Rocks/Bare", rock_year_bare);
    add("Years/Rocks/Forest", rock_year_forest);
    add("Years/Member", member_year);
    add("Years/Merge", merge);
}

}  // namespace benchmarks

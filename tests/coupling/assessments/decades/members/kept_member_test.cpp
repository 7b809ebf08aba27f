#include "coupling/assessments/decades/members/kept_member.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "coupling/assessments/decades/members/member_keys.hpp"
#include "coupling/assessments/decades/members/member_part.hpp"
#include "coupling/assessments/decades/members/simulate.hpp"
#include "coupling/assessments/decades/whole_run.hpp"
#include "tests/coupling/assessments/decades/members/random_study.hpp"

namespace coupling::decades::kept_member_test {
namespace {

/// A scenario with all that its members need, kept in memory.
class StudyInMemory {
public:
    StudyInMemory(const ForestProject& project, std::vector<std::string> settings)
        : opened_{open(project, std::move(settings))} {
        if (!opened_.site) {
            ADD_FAILURE() << opened_.errors;
            return;
        }
        config::Warnings ignored;
        management_ = read_management(*opened_.scenario, *opened_.site->forest, ignored, 0.5);
        keys_.emplace(*opened_.scenario, *opened_.site, management_);
        if (opened_.scenario->forest.rockfall_every > 0) {
            rocks_.emplace(*opened_.scenario, *opened_.site, opened_.site->forest->species.fracture_energy,
                           std::vector<rockfall::Stem>{});
        }
    }

    [[nodiscard]] const Scenario& scenario() const { return *opened_.scenario; }
    [[nodiscard]] const MemberKeys& keys() const { return *keys_; }
    [[nodiscard]] std::vector<Member> members() const {
        return members_of(scenario(), names_of(management_, *opened_.site->forest));
    }
    [[nodiscard]] KeptMember simulated(const Member& member, std::optional<KeptMember> begun = {}) const {
        const Decades decades{scenario(), *opened_.site->forest, management_, rocks_ ? &*rocks_ : nullptr};
        return simulate_on(decades, member, std::move(begun), 1, [] {});
    }

private:
    Opened opened_;
    Management management_;
    std::optional<MemberKeys> keys_;
    std::optional<exchange::YearlyRockfall> rocks_;
};

/// All bytes of a member: rows, stand and what the regime remembers.
std::string bytes_of(const SampleProject& project, KeptMember member) {
    member.taken_over = 0;
    write_part(project.file("bytes.part"), {"run"}, member);
    return project.read("bytes.part");
}

KeptMember read_back(const SampleProject& project, const KeptMember& member) {
    write_part(project.file("member.part"), {"run"}, member);
    return read_part(project.file("member.part"), {"run"}, member.years.member).value();
}

TEST(KeptMembers, ComeBackWithAllTheirBytes) {
    const ForestProject project;
    write_random_study_files(project);
    const StudyInMemory study{
        project,
        {"trees.file=", "stands.records=records.csv", "climate.sequence=repeat", "release.rocks=1500",
         "run.years=6", "feedback.on=yes", "feedback.rocks_per_year=1500", "stands.spin_up_years=5",
         "disturbance.wind=yes", "disturbance.storm_interval=2", "regimes.list=gaps.csv, strips.csv"}};
    const KeptMember gaps = study.simulated({0, 0});
    const KeptMember strips = study.simulated({1, 0});
    // Each list has something to lose.
    for (const KeptMember* one : {&gaps, &strips}) {
        const forest::StandImage& stand = one->end.stand;
        EXPECT_EQ(stand.year, 2006);
        EXPECT_FALSE(stand.trees.empty() || stand.wounds.empty() || stand.cohorts.empty() ||
                     stand.patch_states.empty() || stand.dead_wood.snags.empty() ||
                     stand.dead_wood.logs.empty() || stand.deaths.empty());
        EXPECT_GT(stand.next_id, stand.trees.size());
        EXPECT_GT(stand.stems_at_start, 0U);
        const KeptMember back = read_back(project, *one);
        EXPECT_EQ(back.kept, one->kept);
        EXPECT_EQ(back.end.regime, one->end.regime);
        EXPECT_EQ(bytes_of(project, back), bytes_of(project, *one));
    }
    EXPECT_FALSE(gaps.end.regime.cuts.empty());
    EXPECT_FALSE(strips.end.regime.visits.empty() || strips.end.regime.clearings.empty());
}

/// A part holds every field of a stand, each put to the test here. A part that leaves one out does not
/// compile: end_archive.cpp names all fields.
TEST(KeptMembers, HoldEachFieldOfAStand) {
    const auto fields = [](const forest::StandImage& stand) {
        const auto& [year, trees, wounds, cohorts, patch_states, dead_wood, deaths, balance, earlier, next_id,
                     stems_at_start, mass_at_start_kg, dead_wood_at_start_kg] = stand;
        return std::tuple_size_v<decltype(std::tie(year, trees, wounds, cohorts, patch_states, dead_wood,
                                                   deaths, balance, earlier, next_id, stems_at_start,
                                                   mass_at_start_kg, dead_wood_at_start_kg))>;
    };
    const ForestProject project;
    KeptMember empty;
    const std::string before = bytes_of(project, empty);
    // Each scalar alone changes the file; each list makes it longer.
    const auto changes = [&](const auto& change) {
        KeptMember changed;
        change(changed.end.stand);
        return bytes_of(project, changed) != before ? 1U : 0U;
    };
    const std::size_t written = changes([](auto& stand) { stand.year = 1; }) +
                                changes([](auto& stand) { stand.trees.resize(1); }) +
                                changes([](auto& stand) { stand.wounds.resize(1); }) +
                                changes([](auto& stand) { stand.cohorts.resize(1); }) +
                                changes([](auto& stand) { stand.patch_states.resize(1); }) +
                                changes([](auto& stand) { stand.dead_wood.logs.resize(1); }) +
                                changes([](auto& stand) { stand.deaths.resize(1); }) +
                                changes([](auto& stand) { stand.balance.grown_kg = 1.0; }) +
                                changes([](auto& stand) { stand.earlier.grown_kg = 1.0; }) +
                                changes([](auto& stand) { stand.next_id = 1; }) +
                                changes([](auto& stand) { stand.stems_at_start = 1; }) +
                                changes([](auto& stand) { stand.mass_at_start_kg = 1.0; }) +
                                changes([](auto& stand) { stand.dead_wood_at_start_kg = 1.0; });
    EXPECT_EQ(written, fields(empty.end.stand));
}

/// What one draw of settings has shown.
struct Seen {
    int went_on = 0;
    int began_anew = 0;
};

void grow(std::uint32_t seed, Seen& seen) {
    const RandomStudy random = random_study(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + random.in_words());
    const ForestProject project;
    write_random_study_files(project);
    const StudyInMemory shorter{project, random.shorter()};
    const StudyInMemory longer{project, random.longer()};
    const std::vector<Member> members = longer.members();
    ASSERT_EQ(members.size(), random.members);
    for (const Member& member : {members.front(), members.back()}) {
        KeptMember begun = read_back(project, shorter.simulated(member));
        const bool goes_on = shorter.keys().of(member) == longer.keys().of(member, random.first) &&
                             can_go_on(begun.kept, longer.scenario());
        ASSERT_EQ(goes_on, random.goes_on);
        if (!goes_on) {
            ++seen.began_anew;
            continue;
        }
        ++seen.went_on;
        leave_what_is_wanted(begun, longer.scenario());
        const KeptMember grown = longer.simulated(member, std::move(begun));
        EXPECT_EQ(grown.taken_over, random.first);
        EXPECT_TRUE(bytes_of(project, grown) == bytes_of(project, longer.simulated(member)));
    }
}

TEST(KeptMembers, GoOnAsIfTheyHadNeverStopped) {
    Seen seen;
    for (std::uint32_t seed = 1; seed <= 24; ++seed) {
        grow(seed, seen);
    }
    EXPECT_GE(seen.went_on, 8);
    EXPECT_GE(seen.began_anew, 5);
}

Opened eight_years(const std::vector<std::string>& more) {
    const ForestProject project;
    std::vector<std::string> settings{"trees.file=", "stands.records=records.csv", "climate.sequence=repeat",
                                      "run.years=8"};
    settings.insert(settings.end(), more.begin(), more.end());
    return open(project, settings);
}

TEST(CanGoOn, WantsAllListsAndMapsOfTheKeptYears) {
    const auto serves = [](const KeptYears& kept, const std::vector<std::string>& more) {
        return can_go_on(kept, *eight_years(more).scenario);
    };
    const KeptYears kept{5, {0, 5}, {0, 2, 5}};
    EXPECT_TRUE(serves(kept, {}));
    EXPECT_TRUE(serves(kept, {"run.rockfall_every=5"}));
    EXPECT_FALSE(serves(kept, {"run.rockfall_every=3"})) << "rocks fell in year 5 as it was the last";
    EXPECT_TRUE(serves(kept, {"output.map_years=2, 8"}));
    EXPECT_FALSE(serves(kept, {"output.map_years=3, 8"}));
    EXPECT_FALSE(serves(kept, {"output.tree_list_years=2"}));
    EXPECT_FALSE(serves({9, {0, 8}, {0, 8}}, {})) << "a longer run serves no shorter one";
}

TEST(LeaveWhatIsWanted, TakesOutListsAndMapsOfYearsThatHaveNoneNow) {
    KeptMember member;
    member.kept = {5, {0, 3, 5}, {0, 3, 5}};
    for (const std::int32_t year : {0, 3, 5}) {
        member.years.trees.push_back({.year = year});
        member.years.paths.push_back({.year = year});
        member.years.slopes.push_back({.year = year, .figures = {}});
        member.years.maps.push_back({.year = year, .cells = {}});
        member.years.patches.push_back({.year = year});
    }
    const Opened eight = eight_years({"output.tree_list_years=0, 3", "output.map_years=3"});
    leave_what_is_wanted(member, *eight.scenario);
    const auto years_of = [](const auto& rows) {
        std::vector<std::int32_t> years;
        for (const auto& row : rows) {
            years.push_back(row.year);
        }
        return years;
    };
    using Years = std::vector<std::int32_t>;
    EXPECT_EQ(years_of(member.years.trees), (Years{0, 3}));
    EXPECT_EQ(years_of(member.years.paths), (Years{0, 3}));
    EXPECT_EQ(years_of(member.years.slopes), (Years{0, 3, 5})) << "of all years";
    EXPECT_EQ(years_of(member.years.maps), Years{3});
    EXPECT_EQ(years_of(member.years.patches), Years{3});
}

}  // namespace
}  // namespace coupling::decades::kept_member_test

#include "coupling/assessments/hazard/risk/avoided_risk.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/version.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/read_summary.hpp"

namespace coupling::hazard::risk {
namespace {

using config::joined;

namespace fs = std::filesystem;

/// Sections whose settings change no fall but by nets and works.
constexpr std::array sections_beside_the_rocks{"works.",  "nets.",   "risk.",   "report.",
                                               "design.", "hazard.", "output.", "run."};
/// Files that change no fall but by nets and works.
constexpr std::array roles_beside_the_rocks{"works", "nets", "picture", "logo", "risk_curves", "matrix"};

template <class Openings>
bool begins_with_one(std::string_view text, const Openings& openings) {
    return std::any_of(openings.begin(), openings.end(),
                       [&](const char* opening) { return text.starts_with(opening); });
}

[[noreturn]] void refuse_without(const fs::path& period, std::string found, std::string expected) {
    config::fail(config::ExitCode::settings, {joined("risk.without: ", period.string())}, std::move(found),
                 std::move(expected),
                 "run the scenario of this run without nets.file and works.file into that folder");
}

/// Whether a value of a summary, where flags are true or false and numbers shortened, is that of a setting.
bool is_same_value(const std::string& of_summary, const std::string& ours) {
    if (of_summary == ours || (of_summary == "true" && ours == "yes") ||
        (of_summary == "false" && ours == "no")) {
        return true;
    }
    const auto theirs = config::parse_number(of_summary);
    const auto number = config::parse_number(ours);
    return theirs && number && *theirs == *number;
}

/// Hashes of the inputs that decide how rocks fall, by their roles.
std::multimap<std::string, std::string> hashes_of(const auto& inputs) {
    std::multimap<std::string, std::string> hashes;
    for (const auto& input : inputs) {
        if (!begins_with_one(input.role, roles_beside_the_rocks)) {
            hashes.emplace(input.role, input.hash);
        }
    }
    return hashes;
}

/// The names in a column of a table of a run; none without the table.
std::set<std::string> names_in(const fs::path& file, const std::string& column) {
    std::set<std::string> names;
    if (!path_exists(file)) {
        return names;
    }
    OwnRows rows{file};
    const std::size_t place = rows.column(column);
    while (rows.next()) {
        names.insert(std::string{rows.fields()[place]});
    }
    return names;
}

}  // namespace

std::optional<double> AvoidedRisk::cost_per_year() const {
    double sum = 0.0;
    for (const NewBarrier& barrier : barriers) {
        if (!barrier.cost_per_year) {
            return std::nullopt;
        }
        sum += *barrier.cost_per_year;
    }
    return barriers.empty() ? std::nullopt : std::optional{sum};
}

Ratio benefit_by_cost(const Estimate& money, double cost_per_year) {
    return {money.value / cost_per_year, money.low / cost_per_year, money.high / cost_per_year};
}

Ratio cost_of_each(const Estimate& spared, double cost_per_year) {
    const auto each = [&](double of) {
        return of > 0.0 ? cost_per_year / of : std::numeric_limits<double>::infinity();
    };
    return {each(spared.value), each(spared.high), each(spared.low)};
}

std::vector<NewBarrier> new_barriers(const Site& site, const fs::path& period, double interest_percent) {
    std::vector<NewBarrier> barriers;
    const auto add = [&](const std::string& name, const char* kind, const BarrierCost& cost) {
        barriers.push_back({name, kind, cost, annual_cost(cost, interest_percent)});
    };
    const std::set<std::string> nets = names_in(period / "tables" / "nets.csv", "net");
    for (const NetRecord& net : site.nets) {
        if (!nets.contains(net.name)) {
            add(net.name, "net", net.cost);
        }
    }
    const std::set<std::string> works = names_in(period / "tables" / "works.csv", "work");
    for (const WorkRecord& work : site.works) {
        if (!works.contains(work.name)) {
            add(work.name, name_of(work.kind), work.cost);
        }
    }
    return barriers;
}

void check_same_rocks(const fs::path& period, const Scenario& scenario, const Site& site) {
    const fs::path file = period / "summary.json";
    if (!path_exists(file)) {
        refuse_without(period, "no finished return period", "the folder of a finished hazard run, its --out");
    }
    const SummaryOfRun summary = read_summary(open_file(file, {}, "a summary").text(), file.string());
    if (summary.version != config::version()) {
        refuse_without(period, joined("results of version ", summary.version),
                       joined("those of this version, ", config::version()));
    }
    if (summary.seed != scenario.run.seed || summary.rocks != site.rocks()) {
        refuse_without(
            period, joined(std::to_string(summary.rocks), " rocks, run.seed ", std::to_string(summary.seed)),
            joined("the same rocks: ", std::to_string(site.rocks()), ", run.seed ",
                   std::to_string(scenario.run.seed)));
    }
    for (const config::ParameterRow& row : scenario.shown_settings()) {
        if (row.files != config::NamesFiles::none || begins_with_one(row.key, sections_beside_the_rocks)) {
            continue;  // files by their hashes, below
        }
        const auto found =
            std::find_if(summary.settings.begin(), summary.settings.end(),
                         [&](const SummaryOfRun::Setting& setting) { return setting.key == row.key; });
        if (found != summary.settings.end() && !is_same_value(found->value, row.value_text)) {
            refuse_without(period, joined(row.key, " = ", found->value),
                           joined(row.key, " = ", row.value_text));
        }
    }
    const auto theirs = hashes_of(summary.inputs);
    const auto ours = hashes_of(site.inputs);
    for (const auto& [role, hash] : ours) {
        const auto [first, last] = theirs.equal_range(role);
        if (std::none_of(first, last, [&](const auto& entry) { return entry.second == hash; })) {
            refuse_without(period, joined("other ", role, " than this run"), "the same inputs");
        }
    }
    if (theirs.size() != ours.size()) {
        refuse_without(period, "other inputs than this run", "the same inputs");
    }
}

}  // namespace coupling::hazard::risk

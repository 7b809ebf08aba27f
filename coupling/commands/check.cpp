#include "coupling/commands/check.hpp"

#include <omp.h>

#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>
#include <string>

#include "config/text/numbers.hpp"
#include "coupling/commands/estimate.hpp"
#include "coupling/inputs/reading.hpp"
#include "coupling/inputs/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/profile/profile_run.hpp"

namespace coupling {

namespace {

std::string size_in_words(std::uint64_t bytes) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1);
    if (bytes < 100'000) {
        text << static_cast<double>(bytes) / 1e3 << " kB";
    } else {
        text << static_cast<double>(bytes) / 1e6 << " MB";
    }
    return text.str();
}

std::string duration(double seconds) {
    if (seconds < 1.0) {
        return "a second";
    }
    if (seconds < 100.0) {
        return std::to_string(std::lround(seconds)) + " s";
    }
    return seconds < 6000.0 ? std::to_string(std::lround(seconds / 60.0)) + " min"
                            : std::to_string(std::lround(seconds / 3600.0)) + " h";
}

/// A line of the listing: a name, padded, and what there is to say.
void say(std::ostream& out, const std::string& name, const std::string& text) {
    out << std::left << std::setw(14) << name << text << '\n';
}

std::size_t zones_of(const Site& site) {
    std::set<std::uint32_t> zones;
    for (const rockfall::ReleaseSource& source : site.sources) {
        zones.insert(source.zone);
    }
    return zones.size();
}

std::string trees_in_words(const Site& site) {
    if (site.trees.empty()) {
        return "none: only the bare slope is assessed";
    }
    std::set<std::string> species;
    double basal_area_m2 = 0.0;
    for (const TreeRecord& tree : site.trees) {
        species.insert(tree.species);
        basal_area_m2 += 0.25 * M_PI * tree.stem.dbh_cm * tree.stem.dbh_cm * 1e-4;
    }
    std::ostringstream text;
    text << site.trees.size() << " of " << species.size() << " species, basal area " << std::fixed
         << std::setprecision(0) << basal_area_m2 << " m2";
    return text.str();
}

std::string ground_in_words(const Site& site) {
    std::string text;
    for (const rockfall::SurfaceType& type : site.slope.types) {
        text += (text.empty() ? "" : "; ") + type.label;
    }
    return text;
}

void describe_site(const Scenario& scenario, const Site& site, std::ostream& out) {
    say(out, "scenario", scenario.file.string());
    for (const InputFile& input : site.inputs) {
        say(out, input.role, input.name + ", " + size_in_words(input.bytes) + ", hash " + input.hash);
    }
    out << '\n';
    say(out, "terrain",
        std::to_string(site.slope.terrain.vertices().size()) + " points, " +
            std::to_string(site.slope.terrain.triangles().size()) + " triangles");
    say(out, "ground", ground_in_words(site));
    say(out, "maps", to_string(site.map_frame));
    say(out, "projection",
        site.projection.empty() ? "none"
                                : site.projection.substr(0, site.projection.find('"', 8) + 1) + ", ...");
    say(out, "trees", trees_in_words(site));
    say(out, "sources", std::to_string(site.sources.size()) + " in " + counted(zones_of(site), "zone"));
    std::string targets;
    for (const rockfall::Target& target : site.targets) {
        targets += (targets.empty() ? "" : ", ") + target.id;
    }
    say(out, "targets", targets.empty() ? "none" : targets);
}

void describe_run(const Scenario& scenario, const Site& site, int threads, std::ostream& out) {
    const Estimate estimate = estimate_of(scenario, site, threads);
    say(out, "rocks",
        std::to_string(estimate.rocks) +
            (estimate.covers == 2 ? ", each with forest and on the bare slope" : ""));
    say(out, "memory",
        "up to " + size_in_words(estimate.bytes()) + ": terrain " + size_in_words(estimate.terrain_bytes) +
            ", maps " + size_in_words(estimate.map_bytes) + ", percentiles at most " +
            size_in_words(estimate.percentile_bytes));
    say(out, "time",
        "about " + duration(estimate.seconds) + " on " +
            counted(static_cast<std::size_t>(threads), "thread") + ", within a factor of three");
}

void print_settings(const config::Options& options, std::ostream& out) {
    out << "\nSettings (* differs from the default)\n";
    for (const config::ParameterRow& row : options.rows()) {
        out << (row.changed ? "* " : "  ") << std::left << std::setw(38) << row.key << ' '
            << (row.value_text.empty() ? "(none)" : row.value_text);
        if (row.unit != "-" && !row.unit.empty()) {
            out << ' ' << row.unit;
        }
        out << "    default " << (row.default_text.empty() ? "(none)" : row.default_text);
        if (!row.source.empty()) {
            out << "; " << row.source;
        }
        out << '\n';
    }
}

}  // namespace

void check_scenario(const CommandLine& line, config::Warnings& warnings, std::ostream& out) {
    const auto scenario = read_scenario(line.argument, line.overrides);
    if (scenario->profile.empty()) {
        const Site site = open_site(*scenario, warnings);
        describe_site(*scenario, site, out);
        describe_run(*scenario, site, line.threads > 0 ? line.threads : omp_get_max_threads(), out);
    } else {
        profile::describe(*scenario, profile::open_profile(*scenario, warnings), out);
    }
    if (line.print_settings) {
        print_settings(*scenario->options, out);
    }
}

}  // namespace coupling

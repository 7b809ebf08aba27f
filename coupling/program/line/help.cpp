#include "coupling/program/line/help.hpp"

#include <omp.h>

#include <Eigen/Core>
#include <algorithm>
#include <boost/version.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/version.hpp"
#include "coupling/inputs/collapse_settings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/run/ranks.hpp"

namespace coupling {
namespace {

constexpr std::string_view opening_of_help = R"(bannwald - how well a forest protects from rockfall

)";

constexpr std::string_view closing = R"(
Everywhere
  --help                               help of a command: bannwald run --help
  --help-all [SECTION]                 every setting of a scenario, or those of a section: --help-all regimes
  --version                            version, and what it was built with
  -q, --quiet                          only errors, and the warnings once at the end of a run
  -v, --verbose                        every warning and problem one by one, every file of the results

A first run
  bannwald init example
  bannwald run example/scenario.ini

)";

constexpr std::string_view exit_codes = R"(Exit codes
  0   done
  1   a fault of the program
  2   usage or settings
  3   a file is missing, unreadable or cannot be written
  4   the data are not plausible
  5   a validation case lies outside its bounds
  75  interrupted: run again to continue
)";

void write_overview(const std::vector<Command>& commands, std::ostream& out) {
    out << opening_of_help;
    for (const Command& command : commands) {
        out << command.overview;
    }
    out << closing;
}

/// Calls `use` with every setting that a scenario may have: those of all kinds of run.
template <class Use>
void with_settings_of_scenarios(const Use& use) {
    Scenario scenario;
    collapse::CollapseSettings of_collapse;
    config::Options options;
    declare(options, scenario);
    collapse::declare(options, of_collapse);
    use(options);
}

[[noreturn]] void refuse_section(const std::string& section, std::vector<std::string> sections) {
    std::set<std::string> named;
    std::erase_if(sections, [&](const std::string& name) { return !named.insert(name).second; });
    const std::string nearest = config::nearest_word(section, sections);
    std::string all;
    for (const std::string& name : sections) {
        all += (all.empty() ? "" : ", ") + name;
    }
    config::fail(config::ExitCode::settings, {}, "section " + config::in_quotes(section),
                 nearest.empty() ? "one of " + all : config::in_quotes(nearest));
}

/// Settings of a section, which may stand in brackets.
void write_help_of_section(const std::vector<Command>& commands, std::string section, std::ostream& out) {
    if (section.starts_with('[') && section.ends_with(']')) {
        section = section.substr(1, section.size() - 2);
    }
    std::vector<std::string> sections;
    bool is_found = false;
    const auto write = [&](const config::Options& options, const std::string& name) {
        sections.push_back(name);
        if (name == section && !is_found) {
            options.write_help(out, section);
            is_found = true;
        }
    };
    for (const Command& command : commands) {
        if (command.own_settings) {
            command.own_settings(write);
        }
    }
    const std::vector<std::string> of_commands = std::exchange(sections, {});
    with_settings_of_scenarios([&](const config::Options& options) {
        for (const config::ParameterRow& row : options.rows()) {
            write(options, row.key.substr(0, row.key.rfind('.')));
        }
    });
    if (!is_found) {
        sections.insert(sections.end(), of_commands.begin(), of_commands.end());
        refuse_section(section, std::move(sections));
    }
}

}  // namespace

void write_short_help(const std::vector<Command>& commands, std::ostream& out) {
    write_overview(commands, out);
    out << exit_codes;
}

void write_help(const Command& command, std::ostream& out) {
    out << command.help;
    if (command.more_help) {
        command.more_help(out);
    }
}

void write_help_all(const std::vector<Command>& commands, std::string section, std::ostream& out) {
    if (!section.empty()) {
        write_help_of_section(commands, std::move(section), out);
        return;
    }
    write_overview(commands, out);
    for (const Command& command : commands) {
        out << command.help << '\n';
    }
    out << exit_codes << "\nSettings of a scenario file\n\n";
    with_settings_of_scenarios([&](const config::Options& options) { options.write_help(out); });
    for (const Command& command : commands) {
        if (command.own_settings) {
            out << '\n' << command.own_settings_title << "\n\n";
            command.own_settings([&](const config::Options& options, const std::string& name) {
                options.write_help(out, name);
            });
        }
    }
}

void write_version(std::ostream& out) {
    out << "bannwald " << config::version();
    if (!config::commit().empty()) {
        out << " (" << config::commit() << ')';
    }
    out << "\nbuilt with " << BANNWALD_COMPILER << "; CGAL " << BANNWALD_CGAL << ", Eigen "
        << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION << ", Boost "
        << BOOST_VERSION / 100000 << '.' << BOOST_VERSION / 100 % 1000 << ", OpenMP " << _OPENMP << ", "
        << mpi_in_words() << "\nlicence GPL-3.0-or-later; no warranty, to the extent permitted by law\n";
}

}  // namespace coupling

#include "coupling/commands/command_line.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <map>
#include <set>
#include <sstream>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "coupling/commands/command_words.hpp"

namespace coupling {

namespace {

namespace po = boost::program_options;

[[noreturn]] void refuse(std::string found, std::string expected) {
    config::fail(config::ExitCode::settings, {}, std::move(found), std::move(expected));
}

bool may_come_again(const std::string& option) {
    return option == "set" || option == "surface" || option == "creator";
}

po::options_description described(const std::string& command) {
    const auto text = [] { return po::value<std::string>(); };
    po::options_description options;
    auto add = options.add_options();
    add("help,h", "")("quiet,q", "")("verbose,v", "");
    add("argument", po::value<std::vector<std::string>>());
    for (const std::string& name : options_of_commands().at(command)) {
        if (may_come_again(name)) {
            add(name.c_str(), po::value<std::vector<std::string>>());
        } else if (name == "overwrite" || name == "print-settings" || name == "list" || name == "pictures" ||
                   name == "rerun") {
            add(name.c_str(), "");
        } else {
            add(name.c_str(), text());
        }
    }
    return options;
}

po::variables_map parse(const std::string& command, const std::vector<std::string>& arguments) {
    try {
        const po::options_description options = described(command);
        po::positional_options_description places;
        places.add("argument", -1);
        po::variables_map values;
        po::store(po::command_line_parser(arguments)
                      .options(options)
                      .positional(places)
                      .style(po::command_line_style::unix_style & ~po::command_line_style::allow_guessing)
                      .run(),
                  values);
        return values;
    } catch (const po::unknown_option& error) {
        const std::string nearest = config::nearest_word(error.get_option_name(), option_words(command));
        refuse("option " + config::in_quotes(error.get_option_name()) + " of " + command,
               nearest.empty() ? "one of `bannwald " + command + " --help`" : config::in_quotes(nearest));
    } catch (const po::error& error) {
        refuse(error.what(), "the form of `bannwald " + command + " --help`");
    }
}

/// The whole number that an option is given.
template <class Whole>
Whole whole_of(const std::string& option, const std::string& text, long long low, long long high) {
    const auto number = config::parse_whole(text);
    if (!number || *number < low || *number > high) {
        refuse("--" + option + ' ' + config::in_quotes(text),
               "a whole number in [" + std::to_string(low) + ", " + std::to_string(high) + "]");
    }
    return static_cast<Whole>(*number);
}

/// Numbers of metres separated by commas, in rising order, each once.
std::vector<double> rising_numbers(const std::string& option, const std::string& text,
                                   const config::NumberRange& range) {
    std::vector<double> numbers;
    std::istringstream words{text};
    for (std::string word; std::getline(words, word, ',');) {
        const auto number = config::parse_number(word);
        if (!number || !range.contains(*number)) {
            refuse("--" + option + ' ' + config::in_quotes(text),
                   config::describe("numbers", range) + " m, separated by commas");
        }
        numbers.push_back(*number);
    }
    std::sort(numbers.begin(), numbers.end());
    if (numbers.empty() || std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end()) {
        refuse("--" + option + ' ' + config::in_quotes(text), "different numbers, separated by commas");
    }
    return numbers;
}

/// The folder of the results is where many look for it, but it is none of the scenario.
void refuse_folder_as_setting(const std::vector<std::string>& overrides) {
    const std::set<std::string> looked_for{"run.out",    "run.dir",    "run.folder",
                                           "output.out", "output.dir", "output.folder"};
    for (const std::string& override : overrides) {
        if (looked_for.contains(override.substr(0, override.find('=')))) {
            refuse("--set " + override, "--out DIR: the folder of the results is no setting");
        }
    }
}

std::vector<double> diameters_of(const std::string& text) {
    constexpr config::NumberRange range{.low = 0.0, .high = 10.0, .low_excluded = true};
    return rising_numbers("diameters", text, range);
}

std::string argument_of(const std::string& command, const po::variables_map& values) {
    const std::string& expected = arguments_of_commands().at(command);
    if (values.count("argument") == 0) {
        refuse("`bannwald " + command + "` alone", expected + " after it");
    }
    const auto& words = values["argument"].as<std::vector<std::string>>();
    if (words.size() != 1) {
        refuse(config::in_quotes(words[1]) + " after " + config::in_quotes(words[0]), "only " + expected);
    }
    return words.front();
}

/// The texts of an option that may be given several times, or a list of one or none.
std::vector<std::string> texts(const po::variables_map& values, const std::string& name) {
    if (values.count(name) == 0) {
        return {};
    }
    return may_come_again(name) ? values[name].as<std::vector<std::string>>()
                                : std::vector<std::string>{values[name].as<std::string>()};
}

/// Files of the user to make a project from.
void add_given_files(CommandLine& line, const po::variables_map& values) {
    const auto take = [&](const char* option, std::string& file) {
        for (const std::string& given : texts(values, option)) {
            file = given;
        }
    };
    take("dem", line.given.dem);
    take("sources", line.given.sources);
    take("targets", line.given.targets);
    take("trees", line.given.trees);
    take("grounds", line.given.grounds);
    const GivenFiles& given = line.given;
    if (given.dem.empty() && !(given.sources + given.targets + given.trees + given.grounds).empty()) {
        refuse("files for a project without --dem", "--dem with the ground heights as well");
    }
    if (values.count("example") + values.count("from-rockyfor3d") + values.count("dem") > 1) {
        refuse("several of --example, --from-rockyfor3d and --dem", "only one of them");
    }
}

/// Words and options of validate alone.
void add_validate(CommandLine& line, const po::variables_map& values) {
    if (values.count("argument") > 0) {
        line.cases = values["argument"].as<std::vector<std::string>>();
    }
    for (const std::string& folder : texts(values, "cases")) {
        line.cases_folder = folder;
    }
    for (const std::string& profile : texts(values, "profile")) {
        line.profile = profile;
    }
    for (const std::string& rocks : texts(values, "rocks")) {
        line.rocks = whole_of<std::uint64_t>("rocks", rocks, 2, 10'000'000);
    }
    line.list = values.count("list") > 0;
}

/// Words and options of stopping-table alone.
void add_stopping_table(CommandLine& line, const po::variables_map& values) {
    if (values.count("argument") > 0) {
        line.argument = argument_of("stopping-table", values);
    }
    if (values.count("out") == 0) {
        refuse("`bannwald stopping-table` without a folder for the table", "--out DIR");
    }
    line.surface_names = texts(values, "surface");
    for (const std::string& diameters : texts(values, "diameters")) {
        line.diameters_m = diameters_of(diameters);
    }
    for (const std::string& throws : texts(values, "throws")) {
        line.throws = whole_of<std::uint32_t>("throws", throws, 10, 10'000'000);
    }
    for (const std::string& surfaces : texts(values, "surfaces")) {
        line.surfaces = whole_of<std::uint32_t>("surfaces", surfaces, 4, 10'000);
    }
    for (const std::string& seed : texts(values, "seed")) {
        line.seed = whole_of<std::uint64_t>("seed", seed, 0, 9'007'199'254'740'992);
    }
    line.pictures = values.count("pictures") > 0;
}

/// What only people know of an archive, and whether its run is repeated.
void add_pack(CommandLine& line, const po::variables_map& values) {
    const auto take = [&](const char* option, std::string& text) {
        for (const std::string& given : texts(values, option)) {
            text = given;
        }
    };
    take("title", line.title);
    take("licence", line.licence);
    take("date", line.date);
    line.creators = texts(values, "creator");
    for (const std::string& scenario : texts(values, "scenario")) {
        line.scenario = scenario;
    }
    line.rerun = values.count("rerun") > 0;
    const bool is_date = line.date.size() == 10 && line.date[4] == '-' && line.date[7] == '-' &&
                         config::parse_whole(line.date.substr(0, 4)) &&
                         config::parse_whole(line.date.substr(5, 2)) &&
                         config::parse_whole(line.date.substr(8, 2));
    if (!line.date.empty() && !is_date) {
        refuse("--date " + config::in_quotes(line.date), "a day such as 2026-05-31");
    }
}

/// A scenario and a table of settings.
void add_vary(CommandLine& line, const po::variables_map& values) {
    const std::vector<std::string> words = values.count("argument") == 0
                                               ? std::vector<std::string>{}
                                               : values["argument"].as<std::vector<std::string>>();
    if (words.size() != 2) {
        refuse("`bannwald vary` with " + std::to_string(words.size()) + " files",
               "a scenario and a table of settings: bannwald vary SCENARIO FACTORS.csv --out DIR");
    }
    if (values.count("out") == 0) {
        refuse("`bannwald vary` without a folder for the results", "--out DIR");
    }
    line.argument = words[0];
    line.factors = words[1];
}

/// "2/5": the second of five.
Shard shard_of(const std::string& text) {
    const auto slash = text.find('/');
    const auto number = config::parse_whole(text.substr(0, slash));
    const auto count = config::parse_whole(slash == std::string::npos ? "" : text.substr(slash + 1));
    if (!number || !count || *number < 1 || *count < *number || *count > 100'000) {
        refuse("--shard " + config::in_quotes(text), "i/n with 1 <= i <= n, such as 2/5");
    }
    return {static_cast<std::uint32_t>(*number), static_cast<std::uint32_t>(*count)};
}

/// A file, or `tables` and perhaps the name of one.
void add_info(CommandLine& line, const po::variables_map& values) {
    const std::string first = values.count("argument") == 0
                                  ? std::string{}
                                  : values["argument"].as<std::vector<std::string>>().front();
    if (first != "tables" || values["argument"].as<std::vector<std::string>>().size() != 2) {
        line.argument = argument_of("info", values);
        return;
    }
    line.argument = first;
    line.table = values["argument"].as<std::vector<std::string>>().back();
}

/// Folders of finished runs.
void add_compare(CommandLine& line, const po::variables_map& values) {
    if (values.count("argument") == 0 || values["argument"].as<std::vector<std::string>>().size() < 2) {
        refuse("`bannwald compare` without two folders", "the folders of two finished runs or more");
    }
    const auto& words = values["argument"].as<std::vector<std::string>>();
    line.folders.assign(words.begin(), words.end());
    if (values.count("page") > 0) {
        line.page = values["page"].as<std::string>();
    }
    for (const std::string& tag : texts(values, "language")) {
        line.language = config::language_of(tag);
        if (!line.language) {
            refuse("--language " + config::in_quotes(tag), "en, de, fr or it");
        }
    }
    if (line.language && line.page.empty()) {
        refuse("--language without --page", "--page FILE, the page to write in that language");
    }
}

/// The scenario and the folders after it.
void add_merge(CommandLine& line, const po::variables_map& values) {
    if (values.count("argument") == 0 || values["argument"].as<std::vector<std::string>>().size() < 2) {
        refuse("`bannwald merge` without folders", "a scenario file and the folders of its shards");
    }
    const auto& words = values["argument"].as<std::vector<std::string>>();
    line.argument = words.front();
    line.folders.assign(words.begin() + 1, words.end());
}

/// `net try DIR --nets FILE` and `net place DIR --nets FILE`.
void add_net(CommandLine& line, const po::variables_map& values) {
    const std::vector<std::string> words = values.count("argument") == 0
                                               ? std::vector<std::string>{}
                                               : values["argument"].as<std::vector<std::string>>();
    constexpr const char* form = "`bannwald net try DIR --nets FILE`, or place instead of try";
    if (words.empty() || (words.front() != "try" && words.front() != "place")) {
        refuse(words.empty() ? "`bannwald net` alone" : "`bannwald net " + words.front() + '`', form);
    }
    line.action = words.front();
    if (words.size() != 2 || values.count("nets") == 0) {
        refuse("`bannwald net " + line.action + "` without " + (words.size() != 2 ? "one folder" : "--nets"),
               form);
    }
    line.argument = words[1];
    line.nets = values["nets"].as<std::string>();
    for (const std::string& distances : texts(values, "distances")) {
        if (line.action == "try") {
            refuse("--distances of `bannwald net try`", "it with `bannwald net place`");
        }
        constexpr config::NumberRange range{.low = 0.0, .high = 5000.0};
        line.distances_m = rising_numbers("distances", distances, range);
    }
    for (const std::string& azimuth : texts(values, "azimuth")) {
        if (line.action == "try") {
            refuse("--azimuth of `bannwald net try`", "it with `bannwald net place`");
        }
        constexpr config::NumberRange range{.low = 0.0, .high = 360.0};
        line.azimuth_deg = config::parse_number(azimuth);
        if (!line.azimuth_deg || !range.contains(*line.azimuth_deg)) {
            refuse("--azimuth " + config::in_quotes(azimuth),
                   config::describe("a number", range) + " deg, clockwise from north");
        }
    }
}

CommandLine parse_command(const std::string& command, const std::vector<std::string>& arguments) {
    const po::variables_map values = parse(command, arguments);
    CommandLine line;
    if (values.count("help") > 0) {
        line.command = "help";
        line.help_for = command;
        return line;
    }
    line.command = command;
    const bool validates = command == "validate";
    if (validates) {
        add_validate(line, values);
    } else if (command == "stopping-table") {
        add_stopping_table(line, values);
    } else if (command == "merge") {
        add_merge(line, values);
    } else if (command == "info") {
        add_info(line, values);
    } else if (command == "net") {
        add_net(line, values);
    } else if (command == "vary") {
        add_vary(line, values);
    } else if (command == "compare") {
        add_compare(line, values);
    } else {
        line.argument = argument_of(command, values);
    }
    line.overrides = texts(values, "set");
    refuse_folder_as_setting(line.overrides);
    const std::vector<std::string> seeds =
        command == "stopping-table" ? std::vector<std::string>{} : texts(values, "seed");
    for (const std::string& seed : seeds) {
        line.overrides.push_back((validates ? "series.seed=" : "run.seed=") + seed);
    }
    for (const std::string& example : texts(values, "example")) {
        line.example = example;
    }
    for (const std::string& folder : texts(values, "from-rockyfor3d")) {
        line.rockyfor3d = folder;
    }
    add_given_files(line, values);
    add_pack(line, values);
    if (command == "check" && values.count("page") > 0) {
        line.page = values["page"].as<std::string>();
    }
    for (const std::string& out : texts(values, "out")) {
        line.out = out;
    }
    for (const std::string& threads : texts(values, "threads")) {
        line.threads = whole_of<int>("threads", threads, 1, 4096);
    }
    for (const std::string& shard : texts(values, "shard")) {
        line.shard = shard_of(shard);
    }
    line.overwrite = values.count("overwrite") > 0;
    line.print_settings = values.count("print-settings") > 0;
    line.quiet = values.count("quiet") > 0;
    line.verbose = values.count("verbose") > 0;
    return line;
}

/// What the program is asked before any command: --help and its like.
CommandLine parse_general(const std::string& word) {
    static const std::map<std::string, std::string> general{{"--help", "help"},
                                                            {"-h", "help"},
                                                            {"help", "help"},
                                                            {"--help-all", "help-all"},
                                                            {"--version", "version"}};
    const auto found = general.find(word);
    if (found != general.end()) {
        CommandLine line;
        line.command = found->second;
        return line;
    }
    std::vector<std::string> words = command_names();
    words.insert(words.end(), {"--help", "--help-all", "--version"});
    const std::string nearest = config::nearest_word(word, words);
    refuse("command " + config::in_quotes(word),
           nearest.empty() ? "init, check, run, merge, compare, vary, collapse, pack, verify, net, validate, "
                             "stopping-table, info or completion; see `bannwald --help`"
                           : config::in_quotes(nearest));
}

}  // namespace

CommandLine parse_command_line(const std::vector<std::string>& arguments) {
    if (arguments.empty()) {
        return parse_general("--help");
    }
    // What every command takes may stand before it too.
    const std::set<std::string> everywhere{"-q", "--quiet", "-v", "--verbose"};
    const auto word = std::find_if_not(arguments.begin(), arguments.end(),
                                       [&](const std::string& each) { return everywhere.contains(each); });
    if (word == arguments.end()) {
        refuse(config::in_quotes(arguments.front()) + " alone", "a command; see `bannwald --help`");
    }
    const auto& names = command_names();
    std::vector<std::string> rest{word + 1, arguments.end()};
    rest.insert(rest.end(), arguments.begin(), word);
    if (std::find(names.begin(), names.end(), *word) == names.end()) {
        CommandLine line = parse_general(*word);
        if (line.command == "help-all" && !rest.empty()) {
            line.section = rest.front();
        }
        return line;
    }
    return parse_command(*word, rest);
}

}  // namespace coupling

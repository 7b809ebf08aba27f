#include "coupling/program/line/arguments.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <set>
#include <sstream>
#include <utility>

#include "config/text/numbers.hpp"

namespace coupling {
namespace {

namespace po = boost::program_options;

constexpr const char* word_key = "argument";

po::options_description described(const Command& command) {
    po::options_description options;
    auto add = options.add_options();
    add("help,h", "")("quiet,q", "")("verbose,v", "");
    add(word_key, po::value<std::vector<std::string>>());
    for (const CommandOption& option : command.options) {
        if (option.is_switch) {
            add(option.name.c_str(), "");
        } else if (option.may_come_again) {
            add(option.name.c_str(), po::value<std::vector<std::string>>());
        } else {
            add(option.name.c_str(), po::value<std::string>());
        }
    }
    return options;
}

/// The options of a command as they are written.
std::vector<std::string> written_options(const Command& command) {
    std::vector<std::string> words{"--help", "--quiet", "--verbose"};
    for (const CommandOption& option : command.options) {
        words.push_back("--" + option.name);
    }
    return words;
}

/// Takes a number below 0, such as a coordinate, for a word and not for options.
std::vector<po::option> numbers_as_words(std::vector<std::string>& words) {
    std::vector<po::option> found;
    if (!words.empty() && words.front().starts_with('-') && config::parse_number(words.front())) {
        po::option& number = found.emplace_back();
        number.value = {words.front()};
        number.original_tokens = {words.front()};
        number.position_key = 0;
        words.erase(words.begin());
    }
    return found;
}

po::variables_map parsed(const Command& command, const std::vector<std::string>& words) {
    try {
        const po::options_description options = described(command);
        po::positional_options_description places;
        places.add(word_key, -1);
        po::variables_map values;
        po::store(po::command_line_parser(words)
                      .options(options)
                      .positional(places)
                      .extra_style_parser(numbers_as_words)
                      .style(po::command_line_style::unix_style & ~po::command_line_style::allow_guessing)
                      .run(),
                  values);
        return values;
    } catch (const po::unknown_option& error) {
        const std::string nearest = config::nearest_word(error.get_option_name(), written_options(command));
        refuse_usage(
            "option " + config::in_quotes(error.get_option_name()) + " of " + command.name,
            nearest.empty() ? "one of `bannwald " + command.name + " --help`" : config::in_quotes(nearest));
    } catch (const po::error& error) {
        refuse_usage(error.what(), "the form of `bannwald " + command.name + " --help`");
    }
}

std::vector<std::string> values_of(const po::variable_value& value) {
    if (const auto* many = boost::any_cast<std::vector<std::string>>(&value.value())) {
        return *many;
    }
    const auto* one = boost::any_cast<std::string>(&value.value());
    return one == nullptr ? std::vector<std::string>{} : std::vector<std::string>{*one};
}

/// The folder of the results is where many look for it, but it is none of the scenario.
void refuse_folder_as_setting(const std::vector<std::string>& overrides) {
    const std::set<std::string> looked_for{"run.out",    "run.dir",    "run.folder",
                                           "output.out", "output.dir", "output.folder"};
    for (const std::string& override : overrides) {
        if (looked_for.contains(override.substr(0, override.find('=')))) {
            refuse_usage("--set " + override, "--out DIR: the folder of the results is no setting");
        }
    }
}

}  // namespace

void refuse_usage(std::string found, std::string expected) {
    config::fail(config::ExitCode::settings, {}, std::move(found), std::move(expected));
}

Arguments::Arguments(const Command& command, const std::vector<std::string>& words)
    : command_{command.name}, argument_{command.argument} {
    for (const auto& [name, value] : parsed(command, words)) {
        if (name == word_key) {
            words_ = values_of(value);
        } else {
            options_[name] = values_of(value);
        }
    }
}

std::vector<std::string> Arguments::texts(const std::string& option) const {
    const auto found = options_.find(option);
    return found == options_.end() ? std::vector<std::string>{} : found->second;
}

std::string Arguments::text(const std::string& option) const {
    const std::vector<std::string> all = texts(option);
    return all.empty() ? std::string{} : all.back();
}

std::optional<long long> Arguments::whole(const std::string& option, long long low, long long high) const {
    if (!has(option)) {
        return std::nullopt;
    }
    const auto number = config::parse_whole(text(option));
    if (!number || *number < low || *number > high) {
        refuse_usage("--" + option + ' ' + config::in_quotes(text(option)),
                     "a whole number in [" + std::to_string(low) + ", " + std::to_string(high) + "]");
    }
    return *number;
}

std::vector<double> Arguments::rising_metres(const std::string& option,
                                             const config::NumberRange& range) const {
    if (!has(option)) {
        return {};
    }
    const std::string written = "--" + option + ' ' + config::in_quotes(text(option));
    std::vector<double> numbers;
    std::istringstream parts{text(option)};
    for (std::string part; std::getline(parts, part, ',');) {
        const auto number = config::parse_number(part);
        if (!number || !range.contains(*number)) {
            refuse_usage(written, config::describe("numbers", range) + " m, separated by commas");
        }
        numbers.push_back(*number);
    }
    std::sort(numbers.begin(), numbers.end());
    if (numbers.empty() || std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end()) {
        refuse_usage(written, "different numbers, separated by commas");
    }
    return numbers;
}

std::string Arguments::only_word() const {
    if (words_.empty()) {
        refuse_usage("`bannwald " + command_ + "` alone", argument_ + " after it");
    }
    if (words_.size() != 1) {
        refuse_usage(config::in_quotes(words_[1]) + " after " + config::in_quotes(words_[0]),
                     "only " + argument_);
    }
    return words_.front();
}

int Arguments::threads() const {
    return static_cast<int>(whole("threads", 1, 4096).value_or(0));
}

std::vector<std::string> Arguments::overrides(const std::string& seed_section) const {
    std::vector<std::string> all = texts("set");
    refuse_folder_as_setting(all);
    if (has("seed")) {
        all.push_back(seed_section + ".seed=" + text("seed"));
    }
    return all;
}

}  // namespace coupling

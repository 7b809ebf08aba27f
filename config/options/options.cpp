#include "config/options/options.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

#include "config/options/ini.hpp"
#include "config/options/parameter.hpp"
#include "config/options/values.hpp"
#include "config/text/numbers.hpp"

namespace config {

namespace {

/// More keys of free names than any file of ours holds [choice]; they are compared with each other.
constexpr std::size_t most_free_entries = 10'000;

std::string with_unit(std::string words, const ParameterInfo& info) {
    if (!info.unit.empty() && info.unit != "-") {
        words.append(" ").append(info.unit);
    }
    return words;
}

/// What a number is to be written like that is not accepted as it stands; empty where that is not clear.
std::string advice_for(const std::string& value, const std::function<bool(std::string_view)>& accepts) {
    if (const auto plain = without_separators(value); plain && accepts(*plain)) {
        return "write " + *plain + " without separators of thousands";
    }
    std::string with_point = value;
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    if (std::count(value.begin(), value.end(), ',') == 1 && parse_number(with_point) && accepts(with_point)) {
        return "write " + with_point + ", with a decimal point";
    }
    const std::size_t end = value.find(' ');
    if (end != std::string::npos && parse_number(value.substr(0, end)) && accepts(value.substr(0, end))) {
        return "write " + value.substr(0, end) + " without a unit";
    }
    return {};
}

std::string list_of_words(const std::vector<std::string>& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words) {
        text.append(text.empty() ? "" : between).append(word);
    }
    return text;
}

bool is_met(const Need& need, const std::string& value) {
    const auto& wanted = need.values;
    return wanted.empty() ? !value.empty() && value != "0" && value != "no"
                          : std::find(wanted.begin(), wanted.end(), value) != wanted.end();
}

}  // namespace

std::string to_string(const Renaming& renaming) {
    return to_string(
        Problem{.place = renaming.place,
                .found = std::string{renaming.formerly}.append(" is renamed to ").append(renaming.key),
                .advice = "it works as before, but write the new name"});
}

Options::Options() = default;
Options::~Options() = default;
Options::Options(Options&&) noexcept = default;
Options& Options::operator=(Options&&) noexcept = default;

void Options::declare(Parameter parameter) {
    assert(find(parameter.key) == nullptr && present_name(parameter.key) == parameter.key);
    parameter.default_text = parameter.get();
    assert(parameter.accepts(parameter.default_text));
    for ([[maybe_unused]] const Preset& preset : parameter.info.presets) {
        assert(parameter.accepts(preset.value));
    }
    parameters_.push_back(std::move(parameter));
}

void Options::number(std::string key, double& target, ParameterInfo info) {
    const NumberRange range{info.low, info.high};
    Parameter parameter{.key = std::move(key), .info = info, .kind = "number"};
    parameter.expected = with_unit(describe("a number", range), info);
    parameter.accepts = [range](std::string_view text) { return number_in(text, range).has_value(); };
    parameter.set = [range, &target](std::string_view text) { target = number_in(text, range).value(); };
    parameter.get = [&target] { return to_text(target); };
    declare(std::move(parameter));
}

void Options::count(std::string key, std::uint64_t& target, ParameterInfo info) {
    info.low = std::max(info.low, 0.0);
    const NumberRange range{info.low, info.high};
    Parameter parameter{.key = std::move(key), .info = info, .kind = "whole number"};
    parameter.expected = with_unit(describe("a whole number", range), info);
    parameter.accepts = [range](std::string_view text) { return count_in(text, range).has_value(); };
    parameter.set = [range, &target](std::string_view text) { target = count_in(text, range).value(); };
    parameter.get = [&target] { return std::to_string(target); };
    declare(std::move(parameter));
}

void Options::flag(std::string key, bool& target, ParameterInfo info) {
    Parameter parameter{.key = std::move(key), .info = std::move(info), .kind = "yes/no"};
    parameter.expected = "yes or no";
    parameter.words = {"yes", "no", "true", "false"};
    parameter.accepts = [](std::string_view text) { return flag_in(text).has_value(); };
    parameter.set = [&target](std::string_view text) { target = flag_in(text).value(); };
    parameter.get = [&target] { return std::string{target ? "yes" : "no"}; };
    declare(std::move(parameter));
}

void Options::text(std::string key, std::string& target, ParameterInfo info) {
    Parameter parameter{.key = std::move(key), .info = std::move(info), .kind = "text"};
    parameter.expected = "one line of text";
    parameter.accepts = is_one_line;
    parameter.set = [&target](std::string_view text) { target = text; };
    parameter.get = [&target] { return target; };
    declare(std::move(parameter));
}

void Options::file(std::string key, std::string& target, ParameterInfo info) {
    info.files = NamesFiles::one;
    text(std::move(key), target, std::move(info));
}

void Options::numbers(std::string key, std::vector<double>& target, ParameterInfo info) {
    const NumberRange range{info.low, info.high};
    Parameter parameter{.key = std::move(key), .info = info, .kind = "list of numbers"};
    parameter.expected = with_unit(describe("numbers", range), info)
                             .append(", with decimal points and a blank after each comma");
    parameter.accepts = [range](std::string_view text) { return numbers_in(text, range).has_value(); };
    parameter.set = [range, &target](std::string_view text) { target = numbers_in(text, range).value(); };
    parameter.get = [&target] { return list_text(target); };
    declare(std::move(parameter));
}

void Options::whole_numbers(std::string key, std::vector<double>& target, ParameterInfo info) {
    const NumberRange range{info.low, info.high};
    Parameter parameter{.key = std::move(key), .info = info, .kind = "list of whole numbers"};
    parameter.expected = with_unit(describe("whole numbers", range), info);
    parameter.accepts = [range](std::string_view text) { return whole_numbers_in(text, range).has_value(); };
    parameter.set = [range, &target](std::string_view text) {
        target = whole_numbers_in(text, range).value();
    };
    parameter.get = [&target] { return list_text(target); };
    declare(std::move(parameter));
}

void Options::declare_choice(std::string key, std::vector<std::string> words,
                             std::function<void(std::size_t)> set, std::function<std::string()> get,
                             ParameterInfo info) {
    Parameter parameter{.key = std::move(key), .info = std::move(info)};
    parameter.kind = std::string{"one of "}.append(list_of_words(words, "|"));
    parameter.expected = std::string{"one of "}.append(list_of_words(words, ", "));
    parameter.words = words;
    parameter.accepts = [words](std::string_view text) {
        return std::find(words.begin(), words.end(), text) != words.end();
    };
    parameter.set = [words, set = std::move(set)](std::string_view text) {
        set(static_cast<std::size_t>(std::find(words.begin(), words.end(), text) - words.begin()));
    };
    parameter.get = std::move(get);
    declare(std::move(parameter));
}

void Options::need(const std::string& key, Need need) {
    const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                    [&](const Parameter& parameter) { return parameter.key == key; });
    assert(found != parameters_.end());
    found->info.needs.push_back(std::move(need));
}

void Options::free_section(std::string name) {
    free_sections_.push_back(std::move(name));
}

bool Options::is_free(const std::string& section) const {
    return std::any_of(free_sections_.begin(), free_sections_.end(), [&](const std::string& name) {
        return name == section || ((name.ends_with(':') || name.ends_with('.')) && section.starts_with(name));
    });
}

const Options::Parameter* Options::find(const std::string& key) const {
    const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                    [&](const Parameter& parameter) { return parameter.key == key; });
    return found == parameters_.end() ? nullptr : &*found;
}

std::string Options::present_name(const std::string& key) const {
    const auto found = std::find_if(parameters_.begin(), parameters_.end(), [&](const Parameter& parameter) {
        return !parameter.info.formerly.empty() && parameter.info.formerly == key;
    });
    return found == parameters_.end() ? key : found->key;
}

void Options::rename(IniEntry& entry) {
    const std::string formerly = entry.key();
    const std::string key = present_name(formerly);
    if (key != formerly) {
        renamings_.push_back({entry.key_place, formerly, key});
        const std::size_t dot = key.rfind('.');
        entry.section = key.substr(0, dot);
        entry.name = key.substr(dot + 1);
    }
}

std::vector<std::string> Options::section_names() const {
    std::vector<std::string> sections;
    for (const Parameter& parameter : parameters_) {
        if (std::find(sections.begin(), sections.end(), parameter.section()) == sections.end()) {
            sections.push_back(parameter.section());
        }
    }
    return sections;
}

std::string Options::legal_keys_near(const IniEntry& entry) const {
    std::vector<std::string> keys;
    std::vector<std::string> names_of_section;
    std::vector<std::string> sections_with_name;
    for (const Parameter& parameter : parameters_) {
        if (parameter.name() == entry.name) {
            sections_with_name.emplace_back(parameter.section());
        }
        keys.push_back(parameter.key);
        keys.push_back(parameter.info.formerly.empty() ? parameter.key : parameter.info.formerly);
        if (parameter.section() == entry.section) {
            names_of_section.push_back(parameter.name());
        }
    }
    // The right name in another section: in the one that is written nearly like it, if there is one.
    if (!sections_with_name.empty()) {
        const std::string nearest = nearest_word(entry.section, sections_with_name);
        return in_quotes((nearest.empty() ? sections_with_name.front() : nearest) + '.' + entry.name);
    }
    if (const std::string nearest = nearest_word(entry.key(), keys); !nearest.empty()) {
        return in_quotes(present_name(nearest));
    }
    if (!names_of_section.empty()) {
        return std::string{"a key of ["}
            .append(entry.section)
            .append("]: ")
            .append(list_of_words(names_of_section, ", "));
    }
    return std::string{"a key of one of the sections "}.append(list_of_words(section_names(), ", "));
}

void Options::check(const IniEntry& entry, Problems& problems) const {
    const Parameter* const parameter = find(entry.key());
    if (parameter == nullptr) {
        problems.add(ExitCode::settings, entry.key_place, std::string{"key "}.append(in_quotes(entry.key())),
                     legal_keys_near(entry));
    } else if (!parameter->accepts(entry.value)) {
        std::string expected = parameter->expected;
        if (const std::string nearest = nearest_word(entry.value, parameter->words); !nearest.empty()) {
            expected.append(" (is ").append(in_quotes(nearest)).append(" meant?)");
        }
        const std::string advice = advice_for(entry.value, parameter->accepts);
        problems.add(ExitCode::settings, entry.value_place,
                     std::string{entry.key()}.append(" = ").append(
                         entry.value.empty() ? "nothing" : in_quotes(entry.value)),
                     expected, advice);
    }
}

std::string Options::preset_asked_for(const std::string& preset_key, const std::vector<IniEntry>& entries,
                                      Problems& problems) const {
    const Parameter* const parameter = find(preset_key);
    if (parameter == nullptr) {
        assert(preset_key.empty());
        return "";
    }
    std::string name = parameter->default_text;
    Place place;
    for (const IniEntry& entry : entries) {
        if (entry.key() == preset_key) {
            name = entry.value;
            place = entry.value_place;
        }
    }
    std::vector<std::string> legal = preset_names();
    if (std::find(legal.begin(), legal.end(), parameter->default_text) == legal.end()) {
        legal.insert(legal.begin(), parameter->default_text);
    }
    if (std::find(legal.begin(), legal.end(), name) == legal.end()) {
        problems.add(ExitCode::settings, place, std::string{preset_key}.append(" = ").append(in_quotes(name)),
                     std::string{"one of "}.append(list_of_words(legal, ", ")));
    }
    return name;
}

void Options::read(std::istream& in, const std::string& file, const std::vector<std::string>& overrides,
                   const std::string& preset_key) {
    Problems problems;
    std::vector<IniEntry> entries = read_ini(in, file, problems);
    renamings_.clear();
    for (IniEntry& entry : entries) {
        rename(entry);
    }
    std::map<std::string, std::size_t> lines;
    for (const IniEntry& entry : entries) {
        const auto [first, is_new] = lines.emplace(entry.key(), entry.key_place.line);
        if (!is_new && problems.list().size() < most_ini_problems) {
            problems.add(ExitCode::settings, entry.key_place,
                         in_quotes(entry.key())
                             .append(" a second time (first on line ")
                             .append(std::to_string(first->second))
                             .append(")"),
                         "each key once");
        }
    }
    for (const std::string& text : overrides) {
        std::vector<IniEntry> entry = read_override(text, problems);
        for (IniEntry& assignment : entry) {
            rename(assignment);
        }
        entries.insert(entries.end(), entry.begin(), entry.end());
    }
    const auto declared_end = std::stable_partition(
        entries.begin(), entries.end(), [&](const IniEntry& entry) { return !is_free(entry.section); });
    const std::vector<IniEntry> free_part(declared_end, entries.end());
    if (free_part.size() > most_free_entries) {
        fail(ExitCode::settings, free_part[most_free_entries].key_place,
             "more than " + std::to_string(most_free_entries) + " keys in sections of free names",
             "a file of settings: is this the file that was meant?");
    }
    entries.erase(declared_end, entries.end());
    for (const IniEntry& entry : entries) {
        if (problems.list().size() >= most_ini_problems) {
            break;
        }
        check(entry, problems);
    }
    const std::string preset = preset_asked_for(preset_key, entries, problems);
    problems.throw_if_any();

    apply(file, preset, entries);
    free_entries_.clear();
    for (const IniEntry& entry : free_part) {
        const auto same = std::find_if(
            free_entries_.begin(), free_entries_.end(),
            [&](const FreeEntry& free) { return free.section == entry.section && free.key == entry.name; });
        FreeEntry& target = same == free_entries_.end() ? free_entries_.emplace_back() : *same;
        target = {entry.section, entry.name, entry.value, entry.value_place};
    }
}

void Options::apply(const std::string& file, const std::string& preset,
                    const std::vector<IniEntry>& entries) {
    file_ = file;
    for (Parameter& parameter : parameters_) {
        std::string value = parameter.default_text;
        for (const Preset& alternative : parameter.info.presets) {
            if (alternative.name == preset) {
                value = alternative.value;
            }
        }
        parameter.place = {.file = file};
        parameter.was_set = false;
        parameter.comment.clear();
        for (const IniEntry& entry : entries) {
            if (entry.key() == parameter.key) {
                value = entry.value;
                parameter.place = entry.value_place;
                parameter.was_set = true;
                parameter.comment = entry.comment;
            }
        }
        parameter.set(value);
    }
}

Place Options::place_of(const std::string& key) const {
    const Parameter* const parameter = find(key);
    return parameter == nullptr ? Place{.file = file_} : parameter->place;
}

bool Options::was_set(const std::string& key) const {
    const Parameter* const parameter = find(key);
    return parameter != nullptr && parameter->was_set;
}

std::vector<IdleSettings> Options::idle() const {
    std::vector<IdleSettings> idle;
    for (const Parameter& parameter : parameters_) {
        const auto& needs = parameter.info.needs;
        const auto missed = std::find_if(needs.begin(), needs.end(), [&](const Need& need) {
            return !is_met(need, find(need.key)->get());
        });
        if (!parameter.was_set || missed == needs.end()) {
            continue;
        }
        const auto same = std::find_if(idle.begin(), idle.end(), [&](const IdleSettings& settings) {
            return settings.other == missed->key;
        });
        IdleSettings& settings =
            same != idle.end() ? *same
                               : idle.emplace_back(IdleSettings{{}, missed->key, find(missed->key)->get()});
        settings.keys.push_back(parameter.key);
    }
    return idle;
}

std::string Options::remark_of(const std::string& key) const {
    const Parameter* const parameter = find(key);
    return parameter == nullptr ? "" : parameter->comment;
}

std::vector<std::string> Options::preset_names() const {
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters_) {
        for (const Preset& preset : parameter.info.presets) {
            if (std::find(names.begin(), names.end(), preset.name) == names.end()) {
                names.push_back(preset.name);
            }
        }
    }
    return names;
}

}  // namespace config

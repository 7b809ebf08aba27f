#pragma once

#include <cstdint>
#include <functional>
#include <istream>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/errors/input_error.hpp"

namespace config {

/// The value that a named set of settings gives to a parameter: {"strict", "0"}.
struct Preset {
    std::string name;
    std::string value;
};

/// What a setting of text names.
enum class NamesFiles : std::uint8_t {
    none,     ///< no file
    one,      ///< a file, from the folder of the settings; perhaps `|` and a layer
    several,  ///< a list split at commas, of which the entries with a dot are files
};

/// What a parameter needs to have an effect: that another has one of these values; without any, that it is
/// given (not empty, 0 or no).
struct Need {
    std::string key;
    std::vector<std::string> values{};
};

/// All that is said about a parameter, once: it feeds reader, check, help, example file and manual.
struct ParameterInfo {
    std::string unit = "-";
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    std::string meaning{};
    std::string source{};           ///< paper and equation, or "choice"
    std::vector<Preset> presets{};  ///< values in named sets other than the default one
    std::string formerly{};         ///< earlier name of the key, still read; empty: none
    NamesFiles files = NamesFiles::none;
    std::vector<Need> needs{};  ///< all of them
};

/// A declared parameter as text, for listings.
struct ParameterRow {
    std::string key;   ///< section.name
    std::string kind;  ///< number, whole number, yes/no, text, list of numbers, one of a|b|c
    std::string unit;
    std::string range;  ///< "[0, 2]", empty if free
    std::string default_text;
    std::string value_text;
    std::string meaning;
    std::string source;
    std::vector<Preset> presets;
    bool changed = false;  ///< value differs from the default
    NamesFiles files = NamesFiles::none;
    std::vector<Need> needs{};
};

/// An assignment in a section that is left free.
struct FreeEntry {
    std::string section;
    std::string key;
    std::string value;
    Place place;
};

/// An assignment by the earlier name of a key.
struct Renaming {
    Place place;
    std::string formerly;
    std::string key;
};

/// "scenario.ini:12:1: rockfall.rt_noise is renamed to picus.rt_noise; ...": what was found and what to do.
std::string to_string(const Renaming& renaming);

/// Settings that were set and have no effect, since another one that they need has this value.
struct IdleSettings {
    std::vector<std::string> keys;
    std::string other;
    std::string value;  ///< empty: the other is not set
};

struct IniEntry;

/// The settings of a run: INI files and `section.key=value` pairs through Boost.Program_options, behind a
/// front that names file and line, finds all problems at once, suggests the nearest key and reads numbers
/// strictly (no nan, no -1 for a count, no 1,5, no 3abc).
///
/// Holds references to the targets: they must outlive it. Moved, never copied.
class Options {
public:
    Options();
    ~Options();
    Options(Options&& other) noexcept;
    Options& operator=(Options&& other) noexcept;
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    /// Each declares a key once, with what its target holds as default.
    void number(std::string key, double& target, ParameterInfo info);
    void count(std::string key, std::uint64_t& target, ParameterInfo info);
    void flag(std::string key, bool& target, ParameterInfo info);  ///< yes/no, true/false, on/off, 1/0
    void text(std::string key, std::string& target, ParameterInfo info);
    void file(std::string key, std::string& target, ParameterInfo info);  ///< a text that names a file
    void numbers(std::string key, std::vector<double>& target, ParameterInfo info);        ///< "0.5, 1.0 1.5"
    void whole_numbers(std::string key, std::vector<double>& target, ParameterInfo info);  ///< "0,5 10"

    template <class Enum>
    void choice(std::string key, Enum& target, std::vector<std::pair<std::string, Enum>> names,
                ParameterInfo info) {
        std::vector<std::string> words;
        for (const auto& [word, value] : names) {
            words.push_back(word);
        }
        declare_choice(
            std::move(key), std::move(words),
            [&target, names](std::size_t index) { target = names[index].second; },
            [&target, names] {
                for (const auto& [word, value] : names) {
                    if (value == target) {
                        return word;
                    }
                }
                return std::string{};
            },
            std::move(info));
    }

    /// Adds a need to a declared key.
    void need(const std::string& key, Need need);

    /// Leaves a section unread for free_entries(). A name that ends in ':' or '.' stands for all sections
    /// that begin with it: "regime:" for [regime:no_management].
    void free_section(std::string name);

    /// Reads an INI file, then the overrides ("section.key=value", later ones win), then sets the targets.
    ///
    /// The key `preset_key` (such as "rockfall.preset", a declared text) is looked at first: the values of
    /// the preset it names replace the defaults before anything else is set; its own default names no preset.
    /// Every problem of the file and of the overrides is thrown at once as InputError (settings), and then no
    /// target is changed. A second read begins with the defaults again.
    void read(std::istream& in, const std::string& file, const std::vector<std::string>& overrides,
              const std::string& preset_key = "");

    /// What stood in the sections left free, in the order of the file.
    [[nodiscard]] const std::vector<FreeEntry>& free_entries() const { return free_entries_; }

    /// What was set by an earlier name of its key. All else, messages too, knows the present names only.
    [[nodiscard]] const std::vector<Renaming>& renamings() const { return renamings_; }
    /// The present name of a key that may be an earlier one.
    [[nodiscard]] std::string present_name(const std::string& key) const;

    /// Where a key was set (file and line, or the override), the file alone if it was left at its default.
    [[nodiscard]] Place place_of(const std::string& key) const;
    [[nodiscard]] bool was_set(const std::string& key) const;
    /// What was set without effect, by the need that is not met.
    [[nodiscard]] std::vector<IdleSettings> idle() const;
    /// The comment behind the value that counts, without its sign; "" for defaults and overrides.
    [[nodiscard]] std::string remark_of(const std::string& key) const;

    [[nodiscard]] std::vector<ParameterRow> rows() const;
    /// Names of all presets that any parameter knows, in the order of declaration.
    [[nodiscard]] std::vector<std::string> preset_names() const;

    /// The present values, those of free sections too, as a commented INI file that `read` takes back.
    void write_ini(std::ostream& out, bool with_comments) const;
    /// A table for people: key, default, unit, range, meaning, grouped by section; 100 columns wide.
    void write_help(std::ostream& out, const std::string& section_filter = "") const;

private:
    struct Parameter;
    void declare_choice(std::string key, std::vector<std::string> words, std::function<void(std::size_t)> set,
                        std::function<std::string()> get, ParameterInfo info);
    void declare(Parameter parameter);
    [[nodiscard]] const Parameter* find(const std::string& key) const;
    [[nodiscard]] bool is_free(const std::string& section) const;
    void rename(IniEntry& entry);
    [[nodiscard]] std::vector<std::string> section_names() const;
    [[nodiscard]] std::string legal_keys_near(const IniEntry& entry) const;
    void check(const IniEntry& entry, Problems& problems) const;
    [[nodiscard]] std::string preset_asked_for(const std::string& preset_key,
                                               const std::vector<IniEntry>& entries,
                                               Problems& problems) const;
    void apply(const std::string& file, const std::string& preset, const std::vector<IniEntry>& entries);

    std::vector<Parameter> parameters_;
    std::vector<std::string> free_sections_;
    std::vector<FreeEntry> free_entries_;
    std::vector<Renaming> renamings_;
    std::string file_;
};

}  // namespace config

#include "config/table/column_form.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include "config/text/plain_letters.hpp"
#include "config/text/reading.hpp"

namespace config {
namespace {

/// A unit with other spellings of it (letters and digits only), what it measures, and its size in the first
/// unit of that kind. Size 0: cannot be converted by a factor.
struct Unit {
    std::string_view name;
    std::string_view spellings;
    std::string_view kind;
    double size;
};

constexpr std::array units{
    Unit{"m", "m meter metre meters metres metri masl mamsl muem mslm", "length", 1.0},
    Unit{"dm", "dm", "length", 0.1},
    Unit{"cm", "cm", "length", 0.01},
    Unit{"mm", "mm mmpmonth mmmonth mmpmonat mmmonat mmpmois mmpmese", "length", 0.001},
    Unit{"km", "km", "length", 1000.0},
    Unit{"pm", "pm 1pm m1", "perlength", 1.0},
    Unit{"kgphayear", "kgphayear kgphapyear kgphaa kgphapa kghayear kgha1a1", "massperarea", 1.0},
    Unit{"ft", "ft feet foot", "length", 0.3048},
    Unit{"in", "in inch inches zoll", "length", 0.0254},
    Unit{"mmpd", "mmpd mmd mmd1 mmpday mmday mmptag mmpjour", "flux", 1.0},
    Unit{"kgpm2s", "kgpm2s kgm2s1 kgm2s kgpm2ps", "flux", 86400.0},
    Unit{"kg", "kg", "mass", 1.0},
    Unit{"g", "g", "mass", 0.001},
    Unit{"t", "t to ton tons tonne tonnes", "mass", 1000.0},
    Unit{"j", "j joule", "energy", 1.0},
    Unit{"kj", "kj", "energy", 1000.0},
    Unit{"mps", "mps ms ms1", "speed", 1.0},
    Unit{"kmph", "kmph kmh kph kmh1", "speed", 1.0 / 3.6},
    Unit{"deg", "deg degree degrees grad degre degres gradi", "angle", 1.0},
    Unit{"rad", "rad", "angle", 57.29577951308232},
    Unit{"gon", "gon", "angle", 0.9},
    Unit{"percent", "percent pct prozent", "share", 0.01},
    Unit{"c", "c degc celsius degreesc degreescelsius gradcelsius degrescelsius gradicelsius", "temperature",
         0.0},
    Unit{"k", "k kelvin", "temperature", 0.0},
    Unit{"f", "f degf fahrenheit degreesf degreesfahrenheit", "temperature", 0.0},
    Unit{"kgpm3", "kgpm3 kgm3", "density", 1.0},
    Unit{"tpm3", "tpm3 tm3", "density", 1000.0},
    Unit{"gpcm3", "gpcm3 gcm3", "density", 1000.0},
    Unit{"m3", "m3", "volume", 1.0},
    Unit{"l", "l dm3 liter litre", "volume", 0.001},
    Unit{"hours", "hours stunden heures ore", "duration", 1.0},
    Unit{"minutes", "minutes minuten minuti", "duration", 1.0 / 60.0},
    Unit{"years", "years year yr a jahre jahr ans anni", "time", 1.0},
    Unit{"m2", "m2", "area", 1.0},
    Unit{"m2pha", "m2pha m2ha m2ha1", "perarea", 1.0},
    Unit{"m3pha", "m3pha m3ha m3ha1", "volumeperarea", 1.0},
    Unit{"pha", "pha 1pha ha1 npha nha stpha stha", "density2", 1.0},
    Unit{"pa", "pa", "pressure", 1.0},
    Unit{"hpa", "hpa mbar", "pressure", 100.0},
    Unit{"kpa", "kpa", "pressure", 1000.0},
    Unit{"mjm2d", "mjm2d mjpm2 mjm2 mjpm2pd mjpm2d mjm2d1 mjm2pd mjm2day mjpm2day mjpm2pday", "radiation",
         1.0},
    Unit{"wpm2", "wpm2 wm2", "radiation", 0.0864},
    Unit{"jpcm2", "jpcm2 jcm2 jpcm2d jcm2d jpcm2pd jpcm2pday", "radiation", 0.01},
    Unit{"kjpm2", "kjpm2 kjm2 kjpm2d kjm2d kjpm2pd kjpm2pday", "radiation", 0.001},
    Unit{"jpm2", "jpm2 jm2 jpm2d jm2d", "radiation", 1e-6},
    Unit{"kwhm2d", "kwhm2d kwhpm2pd kwhpm2d kwhm2d1 kwhm2day kwhpm2day kwhpm2pday kwhrpm2pday", "radiation",
         3.6}};

const Unit* unit_called(std::string_view letters) {
    for (const Unit& unit : units) {
        std::string_view rest = unit.spellings;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            if (rest.substr(0, end) == letters) {
                return &unit;
            }
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    return nullptr;
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
        text.replace(at, what.size(), with);
    }
    return text;
}

std::string letters_and_digits(std::string_view text) {
    std::string kept;
    for (const char c : replaced(replaced(std::string{text}, "°", ""), "º", "")) {  // "N° arbre"
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 || std::isalnum(byte) != 0) {
            kept += c;
        }
    }
    return kept;
}

/// "m³/ha" and "m3 per ha" as "m3pha"; "°" is a degree.
std::string unit_letters(std::string text) {
    for (const auto& [sign, plain] :
         {std::pair{"²", "2"}, std::pair{"³", "3"}, std::pair{"°", "deg"}, std::pair{"%", "percent"},
          std::pair{"/", "p"}, std::pair{" per ", "p"}, std::pair{"_per_", "p"}, std::pair{"·", ""}}) {
        text = replaced(std::move(text), sign, plain);
    }
    return letters_and_digits(text);
}

/// The words between blanks, dots, dashes and underscores.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words(1);
    for (const char c : text) {
        if (c == ' ' || c == '.' || c == '_' || c == '-' || c == '\t') {
            words.emplace_back();
        } else {
            words.back() += c;
        }
    }
    std::erase_if(words, [](const std::string& word) { return word.empty(); });
    return words;
}

/// Cuts a unit in brackets off the end. True where brackets were there that say a unit, or nothing.
bool take_bracketed_unit(std::string& name, ColumnForm& form) {
    const bool is_closed = name.ends_with(']') || name.ends_with(')');
    const std::size_t open = is_closed ? name.rfind(name.back() == ']' ? '[' : '(') : std::string::npos;
    if (open == std::string::npos || open == 0) {
        return false;
    }
    const std::string inside = unit_letters(name.substr(open + 1, name.size() - open - 2));
    const Unit* unit = unit_called(inside);
    if (unit == nullptr && !inside.empty()) {
        return false;
    }
    name.erase(open);
    form.unit = unit == nullptr ? "" : std::string{unit->name};
    return true;
}

/// Takes the longest unit that the last words of a name are; one word at least stays for the quantity.
void take_last_words(std::vector<std::string>& words, ColumnForm& form) {
    constexpr std::size_t most_words = 4;  // kg per ha year
    for (std::size_t count = std::min(most_words, words.size() - 1); count > 0; --count) {
        std::string last;
        for (std::size_t i = words.size() - count; i < words.size(); ++i) {
            last += words[i] == "per" ? "p" : unit_letters(words[i]);
        }
        constexpr std::size_t shortest_of_words = 3;  // "side_c_m" is in m, not in cm
        const bool may_be =
            count == 1 || words[words.size() - count] == "per" || last.size() >= shortest_of_words;
        if (const Unit* unit = may_be ? unit_called(last) : nullptr) {
            words.resize(words.size() - count);
            form.unit = unit->name;
            return;
        }
    }
}

}  // namespace

ColumnForm form_of(std::string_view name) {
    ColumnForm form;
    if (name.size() > longest_column_bytes) {
        form.letters = name;  // a column of its own, which nobody knows
        return form;
    }
    std::string plain{trimmed(plain_letters(name))};
    form.letters = letters_and_digits(replaced(replaced(plain, "²", "2"), "³", "3"));
    if (take_bracketed_unit(plain, form)) {
        form.letters = letters_and_digits(plain);
        form.quantity = form.letters;
        form.letters += form.unit;
        return form;
    }
    std::vector<std::string> words = words_of(plain);
    if (words.size() > 1) {
        take_last_words(words, form);
    }
    if (!form.unit.empty() && words.size() > 1 && words.back() == "in" &&
        plain.find(" in ") != std::string::npos) {
        words.pop_back();  // "BHD in cm", but not speed_in_mps
    }
    for (const std::string& word : words) {
        form.quantity += letters_and_digits(word);
    }
    return form;
}

bool is_same_column(const ColumnForm& a, const ColumnForm& b) {
    const bool same_unit = !a.unit.empty() && a.unit == b.unit;
    return !a.letters.empty() && (a.letters == b.letters || (same_unit && a.quantity == b.quantity));
}

bool is_other_unit(const ColumnForm& a, const ColumnForm& b) {
    return !a.quantity.empty() && a.quantity == b.quantity && !a.unit.empty() && !b.unit.empty() &&
           a.unit != b.unit;
}

double unit_factor(std::string_view from, std::string_view to) {
    const Unit* a = unit_called(from);
    const Unit* b = unit_called(to);
    return a != nullptr && b != nullptr && a->kind == b->kind && b->size > 0.0 ? a->size / b->size : 0.0;
}

}  // namespace config

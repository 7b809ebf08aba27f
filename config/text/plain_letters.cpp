#include "config/text/plain_letters.hpp"

#include <algorithm>
#include <array>

namespace config {

std::string plain_letters(std::string_view text) {
    struct Letter {
        std::string_view written;
        std::string_view plain;
    };
    static constexpr std::array letters{
        Letter{"ä", "ae"}, Letter{"Ä", "ae"}, Letter{"ö", "oe"}, Letter{"Ö", "oe"}, Letter{"ü", "ue"},
        Letter{"Ü", "ue"}, Letter{"ß", "ss"}, Letter{"é", "e"},  Letter{"É", "e"},  Letter{"è", "e"},
        Letter{"È", "e"},  Letter{"ê", "e"},  Letter{"Ê", "e"},  Letter{"ë", "e"},  Letter{"à", "a"},
        Letter{"À", "a"},  Letter{"â", "a"},  Letter{"Â", "a"},  Letter{"ç", "c"},  Letter{"Ç", "c"},
        Letter{"î", "i"},  Letter{"Î", "i"},  Letter{"ï", "i"},  Letter{"ì", "i"},  Letter{"ô", "o"},
        Letter{"ò", "o"},  Letter{"ù", "u"},  Letter{"û", "u"},  Letter{"œ", "oe"}, Letter{"’", "'"}};
    std::string result;
    while (!text.empty()) {
        const auto found = std::find_if(letters.begin(), letters.end(), [&](const Letter& letter) {
            return text.starts_with(letter.written);
        });
        if (found != letters.end()) {
            result += found->plain;
            text.remove_prefix(found->written.size());
            continue;
        }
        const char c = text.front();
        result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        text.remove_prefix(1);
    }
    return result;
}

}  // namespace config

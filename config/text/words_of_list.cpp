#include "config/text/words_of_list.hpp"

#include <iterator>
#include <sstream>
#include <utility>

namespace config {

std::vector<std::string> words_of_list(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : text) {
        if (c == ',') {
            words.push_back(std::exchange(word, ""));
        } else if (c != ' ' && c != '\t') {
            word += c;
        }
    }
    words.push_back(std::move(word));
    return words;
}

std::vector<std::string> words_between_blanks(std::string_view text) {
    std::istringstream in{std::string{text}};
    return {std::istream_iterator<std::string>{in}, {}};
}

}  // namespace config

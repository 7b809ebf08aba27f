#include "coupling/results/text/join_texts.hpp"

#include "config/text/joined.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

template <class Texts, class Joint>
std::string join(const Texts& texts, const Joint& joint) {
    std::string all;
    for (const auto& text : texts) {
        if (!text.empty()) {
            all = all.empty() ? std::string{text} : joint(all, text);
        }
    }
    return all;
}

std::string with_comma(const std::string& first, const std::string& next) {
    return config::joined(first, ", ", next);
}

}  // namespace

std::string join_sentences(std::initializer_list<std::string_view> sentences) {
    return join(sentences, [](const std::string& first, std::string_view next) {
        return config::joined(first, " ", next);
    });
}

std::string join_with_commas(const std::vector<std::string>& texts) {
    return join(texts, with_comma);
}

std::string join_with_semicolons(const std::vector<std::string>& texts) {
    return join(texts, [](const std::string& first, const std::string& next) {
        return page_text("{first}; {next}", {{"first", first}, {"next", next}});
    });
}

std::string join_with_and(const std::vector<std::string>& texts) {
    if (texts.size() < 2) {
        return join(texts, with_comma);
    }
    const std::string before = join_with_commas({texts.begin(), texts.end() - 1});
    return page_text("{first} and {last}", {{"first", before}, {"last", texts.back()}});
}

std::string with_label(const std::string& label, const std::string& text) {
    return page_text("{quantity}: {figure}", {{"quantity", label}, {"figure", text}});
}

}  // namespace coupling::report

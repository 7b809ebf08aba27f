#include "coupling/results/text/writing_language.hpp"

namespace coupling::report {
namespace {

config::Language& language_of_thread() {
    thread_local config::Language language = config::Language::en;
    return language;
}

}  // namespace

WritingLanguage::WritingLanguage(config::Language language) : before_{language_of_thread()} {
    language_of_thread() = language;
}

WritingLanguage::~WritingLanguage() {
    language_of_thread() = before_;
}

config::Language language_in_use() {
    return language_of_thread();
}

}  // namespace coupling::report

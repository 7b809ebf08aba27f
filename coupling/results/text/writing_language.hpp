#pragma once

#include "config/text/language.hpp"

namespace coupling::report {

/// While such an object lives, `page_text` and the numbers of `markup` are those of a language; English where
/// none lives: on the screen and in files for machines. A page makes one before its first text. It holds for
/// the thread that made it, as a page is written by one thread; they may be nested.
class WritingLanguage {
public:
    explicit WritingLanguage(config::Language language);
    ~WritingLanguage();
    WritingLanguage(const WritingLanguage&) = delete;
    WritingLanguage& operator=(const WritingLanguage&) = delete;

private:
    config::Language before_;
};

/// The language in which this thread writes now.
config::Language language_in_use();

}  // namespace coupling::report

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// What inventories write around a botanical name is left out: authors ("Picea abies (L.) H.Karst."),
/// cultivars
/// ("Fagus sylvatica 'Atropunicea'"), ranks below the species ("Pinus mugo subsp. mugo"), what leaves a name
/// open ("Quercus sp.", "cf."), blanks and underscores. Gives the names to look for, the narrower first: of
/// "Pinus mugo subsp. uncinata" those are "Pinus uncinata" and "Pinus mugo". A genus alone comes only where
/// nothing but an author or an open word stands behind it: "Quercus L.", but not of "Quercus frainetto". A
/// hybrid ("Tilia x europaea") is a species of its own. Nothing comes for texts that are no such name.
std::vector<std::string> botanical_readings(std::string_view name);

/// A name of any language without the words that leave it open: "Lärche sp." is "Lärche".
std::string without_open_words(std::string_view name);

}  // namespace coupling

#include "rocking/input/excitation_words.hpp"

#include <variant>

#include "rocking/scene/excitation.hpp"

namespace rocking {
namespace {

template <class... Kinds>
std::string_view words_of(std::string_view name, std::variant<Kinds...>*) {
  std::string_view words;
  static_cast<void>(((Kinds::name == name && (words = Kinds::in_words, true)) || ...));
  return words;
}

}  // namespace

std::string_view excitation_in_words(std::string_view kind) {
  return words_of(kind, static_cast<Excitation*>(nullptr));
}

}  // namespace rocking

// The C++ names of the glossary exist in the headers.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool is_of_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The next place from `start` on at which the word stands alone; npos if there is none.
std::size_t find_word(std::string_view text, std::string_view word, std::size_t start = 0) {
  for (std::size_t at = text.find(word, start); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_of_a_name(text[at - 1])) && (end == text.size() || !is_of_a_name(text[end]))) return at;
  }
  return std::string_view::npos;
}

/// What stands in the braces of each definition of a class, struct, enumeration or concept.
std::vector<std::string_view> definitions(std::string_view text, std::string_view type) {
  std::vector<std::string_view> found;
  for (std::size_t at = find_word(text, type); at != std::string_view::npos; at = find_word(text, type, at + 1)) {
    const std::size_t line = text.rfind('\n', at) + 1;
    const std::string_view before = text.substr(line, at - line);
    const bool is_definition = before.starts_with("struct ") || before.starts_with("class ") ||
                               before.starts_with("enum class ") || before.starts_with("concept ");
    const std::size_t open = text.find_first_of("{;", at);
    if (!is_definition || open == std::string_view::npos || text[open] == ';') continue;
    int depth = 0;
    std::size_t end = open;
    do {
      depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
    } while (++end < text.size() && depth > 0);
    found.push_back(text.substr(open, end - open));
  }
  return found;
}

bool exists(const std::vector<std::string>& headers, std::string_view type, std::string_view member) {
  for (const std::string& header : headers) {
    for (const std::string_view body : definitions(header, type)) {
      if (find_word(body, member) != std::string_view::npos) return true;
    }
  }
  return false;
}

/// The names in the last column of the tables that name no member of their type, or nothing at all.
Names dead_names(std::string_view glossary, const std::vector<std::string>& headers) {
  Names dead;
  while (!glossary.empty()) {
    std::string_view line = glossary.substr(0, glossary.find('\n'));
    glossary.remove_prefix(std::min(glossary.size(), line.size() + 1));
    if (!line.starts_with('|')) continue;
    line.remove_suffix(std::min<std::size_t>(line.size(), 2));
    line.remove_prefix(std::min(line.size(), line.rfind(" | ")));
    for (std::size_t open = line.find('`'); open != std::string_view::npos; open = line.find('`')) {
      line.remove_prefix(open + 1);
      const std::string name(line.substr(0, line.find('`')));
      line.remove_prefix(std::min(line.size(), name.size() + 1));
      const std::size_t last = name.rfind("::");
      const std::string member = last == std::string::npos ? name : name.substr(last + 2);
      std::string type = last == std::string::npos ? "" : name.substr(0, last);
      type.erase(0, type.rfind(':') + 1);
      const bool has_type = !type.empty() && std::isupper(static_cast<unsigned char>(type.front())) != 0;
      const bool is_there =
          has_type ? exists(headers, type, member) : std::ranges::any_of(headers, [&member](const std::string& header) {
            return find_word(header, member) != std::string_view::npos;
          });
      if (!is_there) dead.push_back(name);
    }
  }
  return dead;
}

TEST(Glossary, NamesWhatIsInTheHeaders) {
  const fs::path source(ROCKING_SOURCE_DIR);
  std::vector<std::string> headers;
  for (const char* folder : {"lib/rocking", "analysis", "tests/support"}) {
    for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
      if (entry.path().extension() == ".hpp") headers.push_back(text_of(entry.path()));
    }
  }
  ASSERT_GT(headers.size(), 100U);
  EXPECT_THAT(dead_names(text_of(source / "lib/docs/glossary.md"), headers), ::testing::IsEmpty());
}

TEST(GlossaryRule, FindsANameThatIsNoMember) {
  const std::vector<std::string> headers{"struct Wave {\n  double phase = 0.0;\n};\nstruct Other { int size; };\n"};
  EXPECT_THAT(dead_names("| phase | Phi | `Wave::phase`, `a::Wave`, `phase` |\n", headers), ::testing::IsEmpty());
  EXPECT_THAT(dead_names("| phase | `none` | `Wave::size`, `Wav::phase`, `pha` |\n", headers),
              ::testing::ElementsAre("Wave::size", "Wav::phase", "pha"));
}

}  // namespace

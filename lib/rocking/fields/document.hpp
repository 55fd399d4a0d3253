#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rocking/fields/struct_type.hpp"

namespace rocking {

/// A kind of file that rocking writes: its `format`, what it is, and the list of its keys.
class Document {
 public:
  Document(std::string_view format, std::string_view sentence, const StructType& fields)
      : format_(format), sentence_(sentence), fields_(&fields) {}

  [[nodiscard]] std::string_view format() const { return format_; }
  /// Name of its struct.
  [[nodiscard]] std::string_view title() const { return fields_->name(); }
  /// JSON Schema, draft 7, as `rocking schema` prints it.
  [[nodiscard]] std::string schema_text() const;
  /// The keys after `format` as a table in Markdown. Several keys in a row that mean what they mean elsewhere are one row.
  [[nodiscard]] std::string table() const;

 protected:
  void write_to(const TextSink& sink, const void* value) const;
  void read_into(void* value, const Json& json, const ReadingPlace& place) const;

 private:
  std::string_view format_;
  std::string_view sentence_;
  const StructType* fields_;
};

/// The same of files whose content is a T.
template <HasFields T>
class DocumentOf : public Document {
 public:
  /// Reports what in a value contradicts itself.
  using Check = void (*)(const T& value, const ReadingPlace& place);

  DocumentOf(std::string_view format, std::string_view sentence, Check check = nullptr)
      : Document(format, sentence, fields_of(static_cast<const T*>(nullptr))), check_(check) {}

  /// Writes the file's content piece by piece: equal values give equal bytes. A name of a file may be no UTF-8: its
  /// other bytes become U+FFFD.
  void write(const TextSink& sink, const T& value) const { write_to(sink, &value); }
  [[nodiscard]] std::string text(const T& value) const {
    std::string text;
    write([&text](std::string_view piece) { text += piece; }, value);
    return text;
  }

  /// Throws base::InputError with every fault: its place, the value, and what would do.
  [[nodiscard]] T read(const Json& json) const { return read(json, true); }
  /// The same, but a digest, or another value that follows from others, may be any: for checks that tell what is wrong.
  [[nodiscard]] T read_unchecked(const Json& json) const { return read(json, false); }

 private:
  [[nodiscard]] T read(const Json& json, bool is_fit_checked) const {
    T value{};
    std::vector<base::Problem> problems;
    const ReadingPlace place{.pointer = "", .problems = &problems, .is_fit_checked = is_fit_checked};
    read_into(&value, json, place);
    if (problems.empty() && check_ != nullptr) check_(value, place);
    if (!problems.empty()) throw base::InputError(std::move(problems));
    return value;
  }

  Check check_;
};

}  // namespace rocking

#include "rocking/input/other_files.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <string>
#include <system_error>
#include <vector>

#include "rocking/input/line_problems.hpp"

namespace rocking {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view write_columns =
    "write times and accelerations as text, a line for each sample, and give \"units\"";
constexpr std::string_view unpack = "unpack it, and give the files of accelerations in it";

/// What stands at a place of a file of a kind.
struct Signature {
  std::size_t place;
  std::string_view bytes;
  std::string_view kind;
  std::string_view remedy;
};

constexpr std::array signatures{
    Signature{0, "\x1F\x8B"sv, "a file packed by gzip", unpack},
    Signature{0, "BZh"sv, "a file packed by bzip2", unpack},
    Signature{0, "\xFD\x37zXZ\0"sv, "a file packed by xz", unpack},
    Signature{0, "7z\xBC\xAF"sv, "a 7-Zip archive", unpack},
    Signature{257, "ustar"sv, "a tar archive", unpack},
    Signature{0, "\xD0\xCF\x11\xE0"sv, "a spreadsheet of Excel (.xls)", "save its sheet as CSV, and give \"columns\""},
    Signature{0, "MATLAB 5.0 MAT-file"sv, "a file of MATLAB (.mat)", write_columns},
    Signature{0, "MATLAB 7.3 MAT-file"sv, "a file of MATLAB (.mat)", write_columns},
    Signature{0, "\x89HDF"sv, "an HDF5 file (MATLAB 7.3, ASDF)", write_columns},
    Signature{0, "\x93NUMPY"sv, "an array of NumPy (.npy)", write_columns},
    Signature{0, "MS\x03"sv, "miniSEED", "correct it for the instrument with ObsPy, and write accelerations as text"},
    Signature{0, "WID2 "sv, "GSE2", "correct it for the instrument with ObsPy, and write accelerations as text"},
    Signature{0, "%PDF"sv, "a PDF document", "give the file of the record itself"},
    Signature{0, "{\\rtf"sv, "a text of a word processor (RTF)", "save it as plain text"},
    Signature{0, "<!DOCTYPE"sv, "a web page", "download the record itself: this may be a page that asks to log in"},
    Signature{0, "<html"sv, "a web page", "download the record itself: this may be a page that asks to log in"},
    Signature{0, "<?xml"sv, "XML", write_columns}};

std::string looks_like(std::string_view kind) { return "looks like " + std::string(kind) + ", which is not read"; }

bool stands(std::string_view bytes, std::size_t place, std::string_view wanted) {
  return bytes.size() >= place && bytes.substr(place).starts_with(wanted);
}

Refusal refuse_zip(std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, 4096);
  const bool is_excel =
      begin.find("[Content_Types].xml") != std::string_view::npos || begin.find("xl/") != std::string_view::npos;
  const bool is_ods = begin.find("opendocument.spreadsheet") != std::string_view::npos;
  if (!is_excel && !is_ods) return {looks_like("a zip archive"), std::string(unpack)};
  return {looks_like(is_ods ? "a spreadsheet (.ods)" : "a spreadsheet of Excel (.xlsx)"),
          "save its sheet as CSV, and give \"columns\""};
}

/// Whether every second one of the first bytes is 0, as in Latin letters of UTF-16 without its mark.
bool is_utf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  constexpr std::size_t looked_at = 32;
  if (bytes.size() < looked_at) return false;
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < looked_at; ++i) zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
  return std::max(zeros[0], zeros[1]) == looked_at / 2 && std::min(zeros[0], zeros[1]) == 0;
}

/// A fixed header of a record: a number of six digits and the quality of the data.
bool is_miniseed(std::string_view bytes) {
  constexpr std::size_t header = 48;
  if (bytes.size() < header || std::string_view("DRQM").find(bytes[6]) == std::string_view::npos) return false;
  const auto is_of_number = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == ' '; };
  return (bytes[7] == ' ' || bytes[7] == '\0') && std::ranges::all_of(bytes.substr(0, 6), is_of_number);
}

/// The version of the header stands in word 76: 6, or 7.
bool is_sac(std::string_view bytes) {
  constexpr std::size_t header = 632, place = 304;
  if (bytes.size() < header) return false;
  const std::string_view word = bytes.substr(place, 4);
  return word == "\x06\0\0\0"sv || word == "\0\0\0\x06"sv || word == "\x07\0\0\0"sv || word == "\0\0\0\x07"sv;
}

/// How many numbers a text consists of; counts no further than one that is none, or than beyond `most`.
std::size_t numbers_in(std::string_view text, std::size_t most) {
  std::size_t count = 0;
  std::vector<std::string_view> fields;
  while (!text.empty() && count <= most) {
    split_fields(take_line(text), fields);
    if (!std::ranges::all_of(fields, is_number_field)) break;
    count += fields.size();
  }
  return count;
}

/// A title, then the number of samples and the time step, and as many numbers.
std::optional<Refusal> refuse_counts_without_words(const std::vector<std::string_view>& lines, std::string_view text) {
  if (lines.size() < 3) return std::nullopt;
  std::vector<std::string_view> title, counts;
  split_fields(lines[0], title);
  split_fields(lines[1], counts);
  const bool is_title = !title.empty() && !is_number_field(title.front());
  const bool are_counts = counts.size() >= 2 && counts.size() <= 4 && std::ranges::all_of(counts, is_number_field) &&
                          counts[1].find('.') != std::string_view::npos;
  if (!is_title || !are_counts) return std::nullopt;
  std::size_t declared = 0;
  const auto [end, error] = std::from_chars(counts[0].data(), counts[0].data() + counts[0].size(), declared);
  const bool is_whole = error == std::errc() && end == counts[0].data() + counts[0].size();
  constexpr std::size_t fewest = 2, slack = 1;
  if (!is_whole || declared < fewest || declared > text.size()) return std::nullopt;
  const std::size_t found = numbers_in(text.substr(lines[0].size() + lines[1].size() + 2), declared + slack);
  if (found + slack < declared || found > declared + slack) return std::nullopt;
  const std::string count(counts[0]), step(counts[1]);
  return Refusal{"looks like a file of RSPMatch or eqsig: a title, and then " + count + " samples at a step of " +
                     step + "; it does not state the unit of its accelerations",
                 "write NPTS= " + count + ", DT= " + step + " SEC in place of its second line, and give \"units\""};
}

struct TextFormat {
  std::string_view words;  ///< in one of the first lines, in letters of any case
  std::string_view kind;
  std::string_view remedy;
};

constexpr std::array text_formats{
    TextFormat{"response and fourier amplitude spectra", "response spectra of CSMIP (V3)", "give the file of V2"},
    TextFormat{"5 response spectra", "response spectra of the USGS", "give the file of accelerations"},
    TextFormat{"accelerogram data of volume i", "a file of the University of Southern California (Volume 1 or 2)",
               "take the record from the COSMOS data center or from PEER"},
    TextFormat{"vol1ds", "a file of Iran's BHRC (Volume 1)", write_columns},
    TextFormat{"archivo estandar de aceleracion", "a file of Mexico's database", write_columns}};

}  // namespace

std::optional<Refusal> refuse_binary_file(std::string_view bytes) {
  if (is_utf16(bytes)) {
    return Refusal{looks_like("a text in UTF-16"), "save it as UTF-8: `iconv -f UTF-16 -t UTF-8 FILE`"};
  }
  if (bytes.starts_with("PK\x03\x04")) return refuse_zip(bytes);
  for (const Signature& known : signatures) {
    if (stands(bytes, known.place, known.bytes)) return Refusal{looks_like(known.kind), std::string(known.remedy)};
  }
  const std::string_view obspy = "correct it for the instrument with ObsPy, and write accelerations as text";
  if (is_miniseed(bytes)) return Refusal{looks_like("miniSEED"), std::string(obspy)};
  if (is_sac(bytes)) return Refusal{looks_like("SAC"), std::string(obspy)};
  return std::nullopt;
}

std::optional<Refusal> refuse_text_format(std::string_view text) {
  constexpr std::size_t looked_at = 8;
  const std::string_view whole = text;
  std::vector<std::string_view> lines;
  while (lines.size() < looked_at && !text.empty()) lines.push_back(take_line(text));
  for (const std::string_view line : lines) {
    const std::string words = in_small_letters(std::string(line));
    for (const TextFormat& known : text_formats) {
      if (words.find(known.words) == std::string::npos) continue;
      return Refusal{looks_like(known.kind), std::string(known.remedy)};
    }
  }
  return refuse_counts_without_words(lines, whole);
}

}  // namespace rocking

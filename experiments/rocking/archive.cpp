#include "archive.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <zip.h>

#include "exit_code.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/base/digest.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/output/report.hpp"
#include "rocking/store/store_identity.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"

namespace rocking::program {
namespace {

namespace fs = std::filesystem;

constexpr const char* metadata_name = "ro-crate-metadata.json";
constexpr const char* experiment_name = "experiment.json";

/// The bytes of the files of an archive by their names.
using Files = std::map<std::string, std::string>;

/// `report.json` and so on: all but what a run in progress keeps.
Files files_in(const fs::path& folder) {
  Files files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    const bool is_kept = entry.is_regular_file() && !name.starts_with('.') && entry.path().extension() != ".zip" &&
                         entry.path() != RunFolder(folder).progress_path();
    if (is_kept) files[name] = read_file(entry.path());
  }
  return files;
}

bool stays_inside(const std::string& name) {
  const fs::path path = fs::path(name).lexically_normal();
  return path.is_relative() && !path.empty() && *path.begin() != "..";
}

/// The records that an experiment reads, by the names that it gives them.
Files records_of(const std::string& experiment, const fs::path& beside) {
  Files records;
  const FileSource read = files_seen_from(beside);
  const FileSource noted = [&](const std::string& name, std::size_t most) {
    std::string text = read(name, most);
    records[name] = text;
    return text;
  };
  input_of([&] {
    static_cast<void>(experiment_in(experiment, {}, {.files = noted}));
    return 0;
  });
  for (const auto& [name, text] : records) {
    if (stays_inside(name)) continue;
    throw UsageError("--with-records: " + name +
                     " lies outside of the folder of the experiment; copy the records below it");
  }
  return records;
}

std::string media_type_of(const std::string& name) {
  static const std::map<std::string, std::string> types{{".json", "application/json"},
                                                        {".html", "text/html"},
                                                        {".sqlite", "application/vnd.sqlite3"},
                                                        {".svg", "image/svg+xml"},
                                                        {".png", "image/png"},
                                                        {".pdf", "application/pdf"},
                                                        {".csv", "text/csv"},
                                                        {".tsv", "text/tab-separated-values"},
                                                        {".tex", "application/x-tex"}};
  const auto found = types.find(fs::path(name).extension().string());
  return found == types.end() ? "text/plain" : found->second;
}

Json reference(const std::string& id) { return {{"@id", id}}; }

Json file_entity(const std::string& name, const std::string& bytes) {
  return {{"@id", name},
          {"@type", "File"},
          {"name", name},
          {"encodingFormat", media_type_of(name)},
          {"contentSize", std::to_string(bytes.size())},
          {"sha256", base::to_hex(base::sha256(bytes))}};
}

/// RO-Crate 1.1: the root, the program, the run as an action, and the files. Who ran it and under which licence it may be
/// used are left to the user.
std::string metadata_of(const Report& report, const Files& files) {
  const SystemFacts& system = report.system;
  const std::string title = report.title().empty() ? "A run of rocking" : report.title();
  Json parts = Json::array(), inputs = Json::array(), results = Json::array(), entities = Json::array();
  for (const auto& [name, bytes] : files) {
    const bool is_input = name == experiment_name || name.starts_with(std::string(archived_records) + '/');
    parts.push_back(reference(name));
    (is_input ? inputs : results).push_back(reference(name));
    entities.push_back(file_entity(name, bytes));
  }
  Json graph = Json::array(
      {{{"@id", metadata_name},
        {"@type", "CreativeWork"},
        {"conformsTo", reference("https://w3id.org/ro/crate/1.1")},
        {"about", reference("./")}},
       {{"@id", "./"},
        {"@type", "Dataset"},
        {"name", title},
        {"description",
         "Realisations of a rocking block, the probabilities of its responses, and all that gives the same bits again: "
         "rocking verify FILE computes them."},
        {"datePublished", system.start.substr(0, 10)},
        {"license", "not stated: to be chosen by who publishes this"},
        {"hasPart", std::move(parts)},
        {"mentions", reference("#run")}},
       {{"@id", "#run"},
        {"@type", "CreateAction"},
        {"name", "rocking run"},
        {"description", fmt::format("on {}, {} threads, {:.3g} s", system.machine, system.threads, system.duration_s)},
        {"startTime", system.start},
        {"instrument", reference("#rocking")},
        {"object", std::move(inputs)},
        {"result", std::move(results)}},
       {{"@id", "#rocking"},
        {"@type", "SoftwareApplication"},
        {"name", "rocking"},
        {"softwareVersion", system.build.version + ' ' + system.build.revision},
        {"softwareRequirements",
         fmt::format("{} {}; {}; archived with libzip {}", system.build.compiler, system.build.flags,
                     system.build.libraries.value_or("libraries not stated"), zip_libzip_version())}}});
  for (Json& entity : entities) graph.push_back(std::move(entity));
  const Json context =
      Json::array({"https://w3id.org/ro/crate/1.1/context", {{"sha256", "https://schema.org/sha256"}}});
  return Json({{"@context", context}, {"@graph", std::move(graph)}}).dump(2) + '\n';
}

struct Closer {
  void operator()(zip_t* zip) const { zip_discard(zip); }
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using Zip = std::unique_ptr<zip_t, Closer>;

std::string reason_of(int code) {
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

Zip opened(const fs::path& path, int flags) {
  int code = 0;
  Zip zip(zip_open(path.c_str(), flags, &code));
  if (zip) return zip;
  throw base::InputError(
      {path.string(), "", "is no zip that can be read: " + reason_of(code), "give an archive of `rocking archive`"});
}

/// With a fixed date, owner and order, so that the same files give the same bytes.
void add(zip_t* zip, const std::string& name, const std::string& bytes) {
  constexpr zip_uint16_t new_year_of_1980 = 33;
  constexpr zip_uint32_t readable = 0100644U << 16U;
  zip_source_t* source = zip_source_buffer(zip, bytes.data(), bytes.size(), 0);
  const zip_int64_t place = zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (place < 0) {
    zip_source_free(source);
    throw std::runtime_error(name + ": " + zip_strerror(zip));
  }
  const auto index = static_cast<zip_uint64_t>(place);
  zip_file_set_dostime(zip, index, 0, new_year_of_1980, 0);
  zip_file_set_external_attributes(zip, index, 0, ZIP_OPSYS_UNIX, readable);
  zip_set_file_compression(zip, index, ZIP_CM_DEFLATE, 6);
}

/// The bytes of an entry; the reason why they cannot be read is added to the faults.
std::optional<std::string> entry_of(zip_t* zip, zip_uint64_t index, const std::string& name,
                                    std::vector<std::string>& faults) {
  zip_stat_t facts;
  const bool is_known = zip_stat_index(zip, index, 0, &facts) == 0 && (facts.valid & ZIP_STAT_SIZE) != 0;
  const std::unique_ptr<zip_file_t, Closer> file(is_known ? zip_fopen_index(zip, index, 0) : nullptr);
  std::string bytes(is_known ? facts.size : 0, '\0');
  const bool is_read =
      file && zip_fread(file.get(), bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size());
  char past = 0;
  if (is_read && zip_fread(file.get(), &past, 1) == 0) return bytes;  // at the end the checksum is compared
  const bool has_no_error = file && zip_error_code_zip(zip_file_get_error(file.get())) == ZIP_ER_OK;  // other lengths
  faults.push_back(name + ": cannot be read: " +
                   (has_no_error ? "its bytes are damaged"
                    : file       ? zip_file_strerror(file.get())
                                 : zip_strerror(zip)));
  return std::nullopt;
}

/// Compares the files with the metadata.
void compare(const Files& files, std::vector<std::string>& faults) {
  const Json metadata = Json::parse(files.at(metadata_name), nullptr, false);
  std::map<std::string, std::string> stated;
  if (metadata.is_object() && metadata.contains("@graph")) {
    for (const Json& entity : metadata["@graph"]) {
      const auto has_text = [&entity](const char* key) { return entity.contains(key) && entity[key].is_string(); };
      if (has_text("@id") && has_text("sha256")) stated[entity["@id"]] = entity["sha256"];
    }
  }
  for (const auto& [name, bytes] : files) {
    if (name == metadata_name) continue;
    const auto found = stated.find(name);
    const std::string own = base::to_hex(base::sha256(bytes));
    if (found == stated.end()) {
      faults.push_back(name + ": is not in " + metadata_name);
    } else if (found->second != own) {
      faults.push_back(fmt::format("{}: has the SHA-256 {}, {} states {}", name, own, metadata_name, found->second));
    }
  }
  for (const auto& [name, digest] : stated) {
    if (!files.contains(name)) faults.push_back(name + ": is missing");
  }
}

void expect_no_other_file(const fs::path& archive) {
  if (archive.extension() != ".zip") {
    throw UsageError("--output " + shell_word(archive.string()) + ": must end with .zip; give a name such as run.zip");
  }
  if (!fs::exists(archive)) return;
  if (fs::is_regular_file(archive) && read_file(archive, 4).starts_with("PK\x03\x04")) return;
  throw InTheWay(archive.string() +
                 ": already exists and is no archive, so it is not replaced; choose another name, or remove it");
}

/// The store reads its records from the archive.
void read_records_from(const fs::path& store, const fs::path& folder) {
  sqlite::Database database(store, sqlite::Access::write);
  Identity identity = read_identity(database);
  identity.files = folder.string();
  database.execute("DELETE FROM identity");
  write_identity(database, identity);
}

}  // namespace

std::vector<std::string> write_archive(const fs::path& folder, const fs::path& archive, bool with_records) {
  expect_no_other_file(archive);
  const RunFolder run(folder);
  run.expect_installed();
  if (!run.has_report() || !run.has_store()) {
    throw MissingInput(folder.string() +
                       ": has no finished run, whose report.json and realisations.sqlite are archived");
  }
  Files files = files_in(folder);
  const Report report = parse_report(files.at("report.json"));
  const Identity identity = run.open_valid_store().identity();
  files[experiment_name] = Json::parse(identity.experiment).dump(2) + '\n';
  if (with_records) {
    for (auto& [name, text] : records_of(identity.experiment, identity.files)) {
      files[std::string(archived_records) + '/' + fs::path(name).lexically_normal().generic_string()] = std::move(text);
    }
  }
  files[metadata_name] = metadata_of(report, files);
  const fs::path unfinished = archive.string() + ".unfinished";
  Zip zip = opened(unfinished, ZIP_CREATE | ZIP_TRUNCATE);
  std::vector<std::string> names;
  for (const auto& [name, bytes] : files) {
    add(zip.get(), name, bytes);
    names.push_back(name);
  }
  if (zip_close(zip.get()) != 0) {
    throw std::system_error(zip_error_code_system(zip_get_error(zip.get())), std::generic_category(), archive.string());
  }
  static_cast<void>(zip.release());
  fs::rename(unfinished, archive);
  return names;
}

UnpackedArchive::UnpackedArchive(const fs::path& archive) {
  if (!fs::is_regular_file(archive)) throw MissingInput(archive.string() + ": there is no such archive");
  const Zip zip = opened(archive, ZIP_RDONLY | ZIP_CHECKCONS);
  Files files;
  const auto entries = static_cast<zip_uint64_t>(zip_get_num_entries(zip.get(), 0));
  for (zip_uint64_t i = 0; i < entries; ++i) {
    const std::string name = zip_get_name(zip.get(), i, 0);
    if (!stays_inside(name)) {
      throw base::InputError(
          {archive.string(), name, "would be written outside of its folder", "give an archive of `rocking archive`"});
    }
    if (auto bytes = entry_of(zip.get(), i, name, faults_)) files[name] = *std::move(bytes);
  }
  for (const char* needed : {metadata_name, "report.json", "realisations.sqlite"}) {
    if (!faults_.empty() || files.contains(needed)) continue;
    throw base::InputError(
        {archive.string(), "", std::string("has no ") + needed, "give an archive of `rocking archive`"});
  }
  if (faults_.empty()) compare(files, faults_);
  if (!faults_.empty()) return;
  std::string made = (fs::temp_directory_path() / "rocking-archive-XXXXXX").string();
  if (::mkdtemp(made.data()) == nullptr) throw std::system_error(errno, std::generic_category(), made);
  folder_ = made;
  for (const auto& [name, bytes] : files) {
    fs::create_directories((folder_ / name).parent_path());
    write_atomically(folder_ / name, bytes);
  }
  if (fs::is_directory(folder_ / archived_records))
    read_records_from(RunFolder(folder_).store_path(), folder_ / archived_records);
}

UnpackedArchive::~UnpackedArchive() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

}  // namespace rocking::program

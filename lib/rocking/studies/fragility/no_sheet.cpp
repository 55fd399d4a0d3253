#include "rocking/studies/fragility/sheet.hpp"
#include "rocking/study/study.hpp"

// Of a library that was built without pages.
namespace rocking {

Sheet write_fragility_sheet(const StoredRun&, const RunFragility&, const HazardCurve&, const std::filesystem::path&,
                            const std::string&, base::StopRequest) {
  throw UnfitQuestion("--sheet: this library was built without pages");
}

}  // namespace rocking

#include "rocking/studies/fragility/question.hpp"
#include "rocking/study/study.hpp"

// Of a library that was built without pages.
namespace rocking {

Written write_sheet(const StoredRun&, const RunFragility&, const HazardCurve&, const std::filesystem::path&,
                    const SheetNotes&, const Execution&) {
  throw UnfitQuestion("sheet", "", "this library was built without pages");
}

}  // namespace rocking

#include "rocking/output/condition_table.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "rocking/input/quantities_in_text.hpp"
#include "rocking/look/markup.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

using look::Media;

/// For readers, with the name of the quantity where there is room for it.
look::Column column_of(const std::string& pointer, Media media) {
  const QuantityName name = quantity_name(pointer);
  const bool has_symbol = !name.symbol.empty();
  const std::string symbol = has_symbol ? " <i>" + look::lowered(name.symbol) + "</i>" : "";
  const std::string unit = name.unit.empty() ? "" : " [" + name.unit + ']';
  return {.title = last_key(pointer),
          .latex =
              (has_symbol ? look::latex_symbol(name.symbol) : look::latex_text(name.quantity)) + look::latex_text(unit),
          .html = look::escaped(name.quantity) + symbol + look::escaped(unit),
          .media = media};
}

void add_swept(const Report& report, ConditionColumns& columns) {
  for (std::size_t i = 0; i < report.swept.size(); ++i) {
    columns.push_back({column_of(report.swept[i], Media::readers),
                       [i](const ReportedCondition& each) { return short_value(each.asked.parameters[i]); }});
  }
  for (std::size_t i = 0; i < report.swept.size(); ++i) {
    columns.push_back({{.title = report.swept[i], .media = Media::csv}, [i](const ReportedCondition& each) {
                         const Json value = json_of(each.asked.parameters[i].value);
                         return value.is_string() ? value.get<std::string>() : value.dump();
                       }});
  }
  if (!report.swept.empty()) return;
  columns.push_back({{.title = "condition", .media = Media::page}, [](const auto&) { return "the only one"; }});
}

void add_other_forms(const Report& report, Media media, ConditionColumns& columns) {
  const auto shakings = shakings_of(report);
  const auto is_swept = [&report](std::string_view key) {
    return std::ranges::find(report.swept, "/excitation/" + std::string(key)) != report.swept.end();
  };
  for (const std::string_view key : shaking_columns(report.swept, shakings)) {
    columns.push_back({column_of("/excitation/" + std::string(key), media),
                       [key](const ReportedCondition& each) { return column_cell(each.shaking, key); }});
  }
  for (const std::string_view key : shown_forms(shakings)) {
    if (is_swept(key)) continue;
    columns.push_back(
        {{.title = std::string(key), .media = Media::csv}, [key](const ReportedCondition& each) -> look::Cell {
           if (!each.shaking) return {};
           return look::number(number_of(*each.shaking, key), 17);
         }});
  }
  const auto differs = [&](const ReportedCondition& each) { return each.scale != report.conditions.front().scale; };
  if (is_swept("scale") || std::ranges::none_of(report.conditions, differs)) return;
  columns.push_back({column_of("/excitation/scale", media),
                     [](const ReportedCondition& each) { return look::number(each.scale, 4); }});
}

}  // namespace

ConditionColumns condition_columns(const Report& report, Media other_forms, Media n) {
  ConditionColumns columns;
  add_swept(report, columns);
  add_other_forms(report, other_forms, columns);
  columns.push_back({{.title = "n", .latex = "$n$", .html = "<i>n</i>", .media = n},
                     [](const ReportedCondition& each) { return look::whole(each.result.realisations); }});
  return columns;
}

look::Table table_of(const Report& report, const ConditionColumns& columns,
                     const std::function<bool(const ReportedCondition&)>& is_shown) {
  look::Table table;
  for (const ConditionColumn& each : columns) table.columns.push_back(each.column);
  for (const ReportedCondition& condition : report.conditions) {
    if (is_shown && !is_shown(condition)) continue;
    look::Row& row = table.rows.emplace_back();
    for (const ConditionColumn& each : columns) row.push_back(each.cell(condition));
  }
  return table;
}

ConditionTable::ConditionTable(const Report& report, const std::vector<look::Column>& further)
    : start_(condition_columns(report)) {
  for (const ConditionColumn& each : start_) table_.columns.push_back(each.column);
  table_.columns.insert(table_.columns.end(), further.begin(), further.end());
}

look::Row ConditionTable::row(const ReportedCondition& condition, const look::Row& further) const {
  look::Row row;
  for (const ConditionColumn& each : start_) row.push_back(each.cell(condition));
  append(row, further);
  return row;
}

void ConditionTable::add(const ReportedCondition& condition, const look::Row& further) {
  table_.rows.push_back(row(condition, further));
}

}  // namespace rocking

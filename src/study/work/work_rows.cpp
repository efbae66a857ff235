// Rows as lines of CSV, and such lines read back with a message for every field that cannot be read.
#include "study/work/work_rows.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "util/csv.h"

namespace tyg {
namespace {

constexpr std::string_view kDevice = ",device";
constexpr std::string_view kHeader =
    "scene,columns,rows,integrator,precision,dt,tolerance,steps,force_evaluations,seconds,"
    "rms_error_m,max_error_m,energy_drift,floor_m,horizon_s,status,device";
/// Of files from before there was a device.
constexpr std::string_view kOldHeader = kHeader.substr(0, kHeader.size() - kDevice.size());
constexpr std::size_t kFields = 17;
constexpr std::array kPrecisions{Precision::Double, Precision::Float};
constexpr std::array kDevices{RowDevice::Cpu, RowDevice::Gpu};
constexpr std::array kStatuses{RowStatus::Ok, RowStatus::Unstable, RowStatus::NotFinite, RowStatus::TooSlow};

/// One line of a file, as fields, and where it is: what the readers below need.
struct Line {
  std::vector<std::string> fields;
  std::string where;  ///< FILE:LINE
};

[[noreturn]] void refuse(const Line& line, const std::string& found, std::string_view allowed) {
  throw InputError(fmt::format("{}: found {}, allowed {}", line.where, found, allowed));
}

template <class Number>
Number numberIn(const Line& line, std::size_t k) {
  Number value{};
  const std::string& text = line.fields[k];
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) refuse(line, "'" + text + "'", "a number");
  return value;
}

/// The value of `all` that a field names.
template <class Values>
auto valueIn(const Line& line, std::size_t k, const Values& all, std::string_view allowed) {
  const std::string& text = line.fields[k];
  const auto found = std::ranges::find_if(all, [&](auto value) { return nameOf(value) == text; });
  if (found == all.end()) refuse(line, "'" + text + "'", allowed);
  return *found;
}

/// What a run that held cannot have: later these numbers are divided by, and drawn.
void checkNumbers(const Line& line, const WorkRow& row) {
  const auto check = [&](std::size_t k, bool good, std::string_view allowed) {
    if (!good) refuse(line, "'" + line.fields[k] + "'", allowed);
  };
  const auto isFinite = [](double number) { return std::isfinite(number) && number >= 0; };
  check(5, isFinite(row.dt) && row.dt > 0, "a finite step above 0");
  check(6, isFinite(row.tolerance), "a finite tolerance of at least 0");
  check(7, row.steps > 0, "a number of steps above 0");
  check(8, row.forceEvaluations >= 0, "a number of force evaluations of at least 0");
  check(9, isFinite(row.seconds), "finite seconds of at least 0");
  check(10, isFinite(row.rmsError), "a finite error of at least 0");
  check(11, isFinite(row.maxError), "a finite error of at least 0");
}

WorkRow rowIn(const Line& line, std::string_view header) {
  const std::size_t fields = header == kHeader ? kFields : kFields - 1;
  if (line.fields.size() != fields) {
    refuse(line, std::to_string(line.fields.size()) + " fields",
           fmt::format("{}, as in the header {}", fields, header));
  }
  WorkRow row;
  row.scene = line.fields[0];
  row.columns = numberIn<int>(line, 1);
  row.rows = numberIn<int>(line, 2);
  row.integrator = line.fields[3];
  row.precision = valueIn(line, 4, kPrecisions, "float or double");
  row.dt = numberIn<double>(line, 5);
  row.tolerance = numberIn<double>(line, 6);
  row.steps = numberIn<std::int64_t>(line, 7);
  row.forceEvaluations = numberIn<std::int64_t>(line, 8);
  row.seconds = numberIn<double>(line, 9);
  row.rmsError = numberIn<double>(line, 10);
  row.maxError = numberIn<double>(line, 11);
  row.energyDrift = numberIn<double>(line, 12);
  row.floor = numberIn<double>(line, 13);
  row.horizon = numberIn<double>(line, 14);
  row.status = valueIn(line, 15, kStatuses, "ok, unstable, not-finite or too-slow");
  if (fields == kFields) row.device = valueIn(line, 16, kDevices, "cpu or gpu");
  if (row.status == RowStatus::Ok) checkNumbers(line, row);
  return row;
}

}  // namespace

std::string_view nameOf(RowStatus status) {
  switch (status) {
    case RowStatus::Ok:
      return "ok";
    case RowStatus::Unstable:
      return "unstable";
    case RowStatus::NotFinite:
      return "not-finite";
    default:
      return "too-slow";
  }
}

std::string_view nameOf(RowDevice device) { return device == RowDevice::Cpu ? "cpu" : "gpu"; }

std::string workCsv(const std::vector<WorkRow>& rows) {
  std::string csv = std::string(kHeader) + "\n";
  for (const WorkRow& row : rows) {
    csv += csvLine(row.scene, row.columns, row.rows, row.integrator, nameOf(row.precision), row.dt, row.tolerance,
                   row.steps, row.forceEvaluations, row.seconds, row.rmsError, row.maxError, row.energyDrift, row.floor,
                   row.horizon, nameOf(row.status), nameOf(row.device));
  }
  return csv;
}

std::vector<WorkRow> parseWorkCsv(std::string_view text, const std::string& fileName) {
  std::vector<WorkRow> rows;
  int number = 0;
  std::string_view header;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (++number == 1) header = line;
    if (header != kHeader && header != kOldHeader) {
      throw InputError(
          fmt::format("{}:1: found '{}', allowed is the header of a rows.csv: {}", fileName, line, kHeader));
    }
    if (number > 1 && !line.empty())
      rows.push_back(rowIn({csvFields(line), fmt::format("{}:{}", fileName, number)}, header));
  }
  if (number == 0) throw InputError(fileName + ": found an empty file, allowed is a rows.csv of tyg chart");
  return rows;
}

}  // namespace tyg

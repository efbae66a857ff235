// Rows as CSV and back.
#include "study/work/work_rows.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "util/text.h"

namespace tyg {
namespace {

constexpr std::string_view kHeader =
    "scene,columns,rows,integrator,precision,dt,tolerance,steps,force_evaluations,seconds,"
    "rms_error_m,max_error_m,energy_drift,floor_m,horizon_s,status";
constexpr std::size_t kFields = 16;
constexpr std::array kStatuses{RowStatus::Ok, RowStatus::Unstable, RowStatus::NotFinite, RowStatus::TooSlow};

class LineReader {
 public:
  LineReader(std::string_view line, const std::string& fileName, int number)
      : where_(fileName + ":" + std::to_string(number)) {
    split(line);
    if (fields_.size() != kFields) {
      refuse(std::to_string(fields_.size()) + " fields",
             std::to_string(kFields) + ", as in the header " + std::string(kHeader));
    }
  }

  WorkRow row() {
    WorkRow row;
    row.scene = fields_[0];
    row.columns = number<int>(1);
    row.rows = number<int>(2);
    row.integrator = fields_[3];
    row.precision = precision();
    row.dt = number<double>(5);
    row.tolerance = number<double>(6);
    row.steps = number<std::int64_t>(7);
    row.forceEvaluations = number<std::int64_t>(8);
    row.seconds = number<double>(9);
    row.rmsError = number<double>(10);
    row.maxError = number<double>(11);
    row.energyDrift = number<double>(12);
    row.floor = number<double>(13);
    row.horizon = number<double>(14);
    row.status = status();
    return row;
  }

 private:
  void split(std::string_view line) {
    bool quoted = false;
    fields_.emplace_back();
    for (std::size_t i = 0; i < line.size(); ++i) {
      const char c = line[i];
      if (c == '"') {
        if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
          fields_.back() += line[++i];
        } else {
          quoted = !quoted;
        }
      } else if (c == ',' && !quoted) {
        fields_.emplace_back();
      } else {
        fields_.back() += c;
      }
    }
  }

  [[noreturn]] void refuse(const std::string& found, const std::string& allowed) const {
    throw InputError(where_ + ": found " + found + ", allowed " + allowed);
  }

  template <class Number>
  [[nodiscard]] Number number(std::size_t k) const {
    Number value{};
    const std::string& text = fields_[k];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) refuse("'" + text + "'", "a number");
    return value;
  }

  [[nodiscard]] Precision precision() const {
    if (fields_[4] != "float" && fields_[4] != "double") refuse("'" + fields_[4] + "'", "float or double");
    return fields_[4] == "float" ? Precision::Float : Precision::Double;
  }

  [[nodiscard]] RowStatus status() const {
    const auto* found = std::ranges::find_if(kStatuses, [&](RowStatus s) { return nameOf(s) == fields_[15]; });
    if (found == kStatuses.end()) refuse("'" + fields_[15] + "'", "ok, unstable, not-finite or too-slow");
    return *found;
  }

  std::string where_;
  std::vector<std::string> fields_;
};

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

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string workCsv(const std::vector<WorkRow>& rows) {
  std::string csv(kHeader);
  csv += "\n";
  for (const WorkRow& row : rows) {
    csv += csvField(row.scene);
    csv += "," + std::to_string(row.columns) + "," + std::to_string(row.rows) + "," + row.integrator;
    csv += row.precision == Precision::Float ? ",float," : ",double,";
    csv += shortNumber(row.dt) + "," + shortNumber(row.tolerance) + "," + std::to_string(row.steps) + "," +
           std::to_string(row.forceEvaluations);
    for (const double number : {row.seconds, row.rmsError, row.maxError, row.energyDrift, row.floor, row.horizon}) {
      csv += "," + shortNumber(number);
    }
    csv.append(",").append(nameOf(row.status)).append("\n");
  }
  return csv;
}

std::vector<WorkRow> parseWorkCsv(std::string_view text, const std::string& fileName) {
  std::vector<WorkRow> rows;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (++number == 1 && line != kHeader) {
      throw InputError(fileName + ":1: found '" + std::string(line) +
                       "', allowed is the header of a rows.csv: " + std::string(kHeader));
    }
    if (number > 1 && !line.empty()) rows.push_back(LineReader(line, fileName, number).row());
  }
  if (number == 0) throw InputError(fileName + ": found an empty file, allowed is a rows.csv of tyg chart");
  return rows;
}

}  // namespace tyg

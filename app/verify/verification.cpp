#include "app/verify/verification.h"

#include <algorithm>
#include <cmath>

#include "app/bench/table.h"
#include "app/check/xml_text.h"
#include "base/byte_text.h"
#include "base/file.h"
#include "base/text.h"

namespace fascia {
namespace {

constexpr const char* kStyle =
    "body{font:15px/1.5 sans-serif;margin:2em auto;max-width:1200px;color:#222}table{border-collapse:collapse}"
    "th,td{padding:.2em .7em;border-bottom:1px solid #ccc;text-align:left;vertical-align:top}"
    ".number{text-align:right;white-space:nowrap}.failed{color:#b00020;font-weight:bold}.passed{color:#1b7a2f}"
    ".noted{color:#666}img{max-width:48%}";

const char* result_of(const VerifiedNumber& finding) {
  if (!finding.judged) return "noted";
  return finding.passed() ? "passed" : "failed";
}

std::string range_of(const VerifiedNumber& finding) {
  if (!finding.judged) return "";
  if (!std::isfinite(finding.high)) return "at least " + number(finding.low);
  if (finding.low == 0) return "at most " + number(finding.high);
  return number(finding.low) + " to " + number(finding.high);
}

std::string row_of(const VerifiedNumber& finding) {
  return "<tr><td>" + xml_text(finding.what) + "</td><td class=\"number\">" + number(finding.value) + ' ' +
         xml_text(finding.unit) + "</td><td class=\"number\">" + range_of(finding) + "</td><td class=\"" +
         result_of(finding) + "\">" + result_of(finding) + "</td><td>" + xml_text(finding.truth) + "</td></tr>\n";
}

std::string image_of(const std::filesystem::path& file) {
  const std::string type = file.extension() == ".svg" ? "svg+xml" : "png";
  return "<img alt=\"" + xml_text(file.stem().string()) + "\" src=\"data:image/" + type + ";base64," +
         base64_encoded(read_file(file)) + "\">\n";
}

}  // namespace

void Verification::add(VerifiedNumber finding) {
  bench.say(finding.test + ", " + finding.what + ": " + number(finding.value) +
            (finding.unit.empty() ? "" : " " + finding.unit) +
            (finding.judged ? ", " + range_of(finding) + ": " + result_of(finding) : ""));
  findings_.push_back(std::move(finding));
}

void Verification::draw(const std::string& test, const std::string& name, const Chart& chart) {
  bench.draw(name, chart);
  for (const std::string& ending : bench.options.charts)
    if (const std::filesystem::path file = bench.folder / (name + ending);
        ending != ".pdf" && std::filesystem::exists(file)) {
      charts_.push_back({test, file});
      return;
    }
}

int Verification::failed() const {
  return static_cast<int>(std::count_if(findings_.begin(), findings_.end(),
                                        [](const VerifiedNumber& f) { return f.judged && !f.passed(); }));
}

void Verification::write() const {
  Table table{{}, {"test", "case", "value", "unit", "low", "high", "result", "truth"}, {}};
  const auto quoted = [](std::string text) {
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, 1, '"');
    return '"' + text + '"';
  };
  const auto cell = [](double value) { return std::isfinite(value) ? Cell(value) : Cell(); };
  for (const VerifiedNumber& f : findings_)
    table.rows.push_back({quoted(f.test), quoted(f.what), cell(f.value), f.unit, f.judged ? cell(f.low) : Cell(),
                          f.judged ? cell(f.high) : Cell(), result_of(f), quoted(f.truth)});
  bench.write("verify", table);

  const auto judged =
      std::count_if(findings_.begin(), findings_.end(), [](const VerifiedNumber& f) { return f.judged; });
  std::string text = std::string(
                         "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Verification "
                         "of fascia</title><style>") +
                     kStyle + "</style></head><body>\n<h1>Verification of fascia</h1>\n<p>" +
                     std::to_string(judged - failed()) + " of " + std::to_string(judged) + " passed</p>\n<ul>";
  for (const std::string& note : bench.notes()) text += "<li>" + xml_text(note) + "</li>";
  text += "</ul>\n";
  for (std::size_t begin = 0, end; begin < findings_.size(); begin = end) {
    const std::string& test = findings_[begin].test;
    text += "<h2>" + xml_text(test) +
            "</h2>\n<table><tr><th>case</th><th class=\"number\">measured</th><th "
            "class=\"number\">passes</th><th>result</th><th>truth</th></tr>\n";
    for (end = begin; end < findings_.size() && findings_[end].test == test; ++end) text += row_of(findings_[end]);
    text += "</table>\n";
    for (const Drawn& chart : charts_)
      if (chart.test == test) text += image_of(chart.file);
  }
  write_file(bench.folder / "report.html", text + "</body></html>\n");
}

Series series_of(ElementOrder elements, double poisson_ratio, int color) {
  const std::string name = std::string(name_of(elements)) + ", nu = " + number(poisson_ratio);
  return {name, {}, color, elements == ElementOrder::quadratic ? 0 : 1, true, true};
}

}  // namespace fascia

#include "app/fit/fit_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/charts/gnuplot.h"
#include "app/check/xml_text.h"
#include "app/fit/fit_charts.h"
#include "app/fit/fit_text.h"
#include "base/byte_text.h"
#include "base/error.h"
#include "base/file.h"
#include "base/number_text.h"
#include "base/text.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;

constexpr const char* kStyle =
    "body{font:15px/1.5 sans-serif;margin:2em "
    "auto;max-width:1100px;color:#222}table{border-collapse:collapse;margin:1em "
    "0}th,td{padding:.2em .8em;border-bottom:1px solid #ccc;text-align:left}.n{text-align:right;white-space:nowrap}"
    ".bad{color:#b00020}img{max-width:49%}pre{white-space:pre-wrap;background:#f6f6f6;padding:.6em}";

/// The residuals of one curve or shape, in SI units.
struct Part {
  std::string file, name, unit;
  std::size_t count = 0;
  double rms = 0, largest = 0, noise = 0;
};

std::vector<Part> parts_of(const Experiment& experiment, const Eigen::VectorXd& simulated) {
  const Eigen::VectorXd differences = experiment.residuals(simulated).cwiseQuotient(experiment.scales());
  std::vector<Part> parts;
  Index row = 0;
  const auto add = [&](const Measurement& m, const std::string& name, const char* unit, std::size_t count,
                       double noise) {
    const auto own = differences.segment(row, static_cast<Index>(count));
    row += static_cast<Index>(count);
    parts.push_back({m.file.filename().string(), name, unit, count,
                     std::sqrt(own.squaredNorm() / static_cast<double>(count)), own.cwiseAbs().maxCoeff(), noise});
  };
  for (const Measurement& m : experiment.measurements()) {
    for (const MeasuredCurve& curve : m.curves)
      add(m, curve.name, si_unit(curve.dimension), curve.values.size(), curve.noise);
    for (const MeasuredShape& shape : m.shapes)
      add(m, shape.vertices.empty() ? "surface" : "vertices", "m", shape.value_count(), shape.noise);
  }
  return parts;
}

std::string row_of(const std::vector<std::string>& cells, const char* cell = "td") {
  std::string row = "<tr>";
  for (std::size_t c = 0; c < cells.size(); ++c)
    row += std::string("<") + cell + (c == 0 ? ">" : " class=\"n\">") + xml_text(cells[c]) + "</" + cell + ">";
  return row + "</tr>\n";
}

std::string parameter_table(const FitResult& result) {
  std::string text = "<table>\n" + row_of({"parameter", "value", "95 %", "unit"}, "th");
  for (const Estimate& e : result.estimates.parameters)
    text += row_of({e.key, number(e.value), interval_text(e), unit_of(e.key)});
  return text + "</table>\n";
}

std::string correlation_table(const FitResult& result) {
  if (result.estimates.parameters.size() < 2) return "";
  std::vector<std::string> head{""};
  for (const Estimate& e : result.estimates.parameters) head.push_back(e.key);
  std::string text = "<h2>Correlations</h2>\n<table>\n" + row_of(head, "th");
  for (Index a = 0; a < result.estimates.correlation.rows(); ++a) {
    std::vector<std::string> cells{result.estimates.parameters[static_cast<std::size_t>(a)].key};
    for (Index b = 0; b < result.estimates.correlation.cols(); ++b)
      cells.push_back(number(result.estimates.correlation(a, b)));
    text += row_of(cells);
  }
  return text + "</table>\n";
}

std::string residual_table(const std::vector<Part>& parts) {
  std::string text =
      "<h2>Residuals</h2>\n<table>\n" +
      row_of({"measurement", "quantity", "values", "root mean square", "largest", "noise taken", "unit"}, "th");
  for (const Part& p : parts)
    text +=
        row_of({p.file, p.name, std::to_string(p.count), number(p.rms), number(p.largest), number(p.noise), p.unit});
  return text + "</table>\n";
}

// Charts are files beside the report, and part of it.
std::string drawn(const fs::path& folder, const std::vector<NamedChart>& charts) {
  std::string text;
  for (const NamedChart& named : charts) {
    const fs::path file = folder / (named.name + ".svg");
    write_chart(file, named.chart);
    text += "<img alt=\"" + xml_text(named.chart.title) + "\" src=\"data:image/svg+xml;base64," +
            base64_encoded(read_file(file)) + "\">\n";
  }
  return text;
}

std::string html(const fs::path& folder, const FitResult& result, const FitSubject& subject) {
  std::string text =
      std::string("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Fit of ") +
      xml_text(result.scene.title) + "</title><style>" + kStyle +
      "</style></head><body>\n<h1>Fit: " + xml_text(result.scene.title) + "</h1>\n<p>fascia " + FASCIA_VERSION + ": " +
      (result.converged ? "converged" : "<span class=\"bad\">not converged: " + xml_text(result.reason) + "</span>") +
      "; residual " + misfit_text(result.misfit, subject.noise_known) + "; " + effort_text(result) + "</p>\n";
  text += parameter_table(result);
  if (!result.estimates.warnings.empty()) text += "<ul class=\"bad\">";
  for (const std::string& warning : result.estimates.warnings) text += "<li>" + xml_text(warning) + "</li>";
  if (!result.estimates.warnings.empty()) text += "</ul>\n";
  const bool draws = gnuplot_installed();
  if (draws) {
    const std::string curves = drawn(folder, curve_charts(subject.experiment, result.simulated));
    if (!curves.empty()) text += "<h2>Measured and simulated</h2>\n" + curves;
  }
  text += residual_table(parts_of(subject.experiment, result.simulated)) + correlation_table(result);
  if (draws && !result.profiles.empty())
    text +=
        std::string("<h2>Misfit around the minimum</h2>\n<p>Up to ") +
        (result.profiles.front().of_errors
             ? "three standard errors at either side"
             : "a tenth of the value or of its range at either side, since the residuals say nothing of the noise") +
        "; the other parameters follow as the covariance says.</p>\n" +
        drawn(folder, profile_charts(result, subject.noise_known));
  if (!draws) text += "<p>no gnuplot: the report has no charts</p>\n";
  return text + "<h2>Command line</h2>\n<pre>" + xml_text(subject.command_line) + "</pre>\n</body></html>\n";
}

std::string json(const FitResult& result, const FitSubject& subject) {
  nlohmann::ordered_json document = {{"converged", result.converged},
                                     {"reason", result.reason},
                                     {"misfit", result.misfit},
                                     {"noise_known", subject.noise_known},
                                     {"simulations", result.simulations},
                                     {"profile_simulations", result.profile_simulations},
                                     {"parameters", nlohmann::ordered_json::array()},
                                     {"correlation", nlohmann::ordered_json::array()},
                                     {"warnings", result.estimates.warnings}};
  for (const Estimate& e : result.estimates.parameters) {
    nlohmann::ordered_json parameter = {{"key", e.key}, {"value", e.value}, {"unit", unit_of(e.key)}};
    if (e.determined && std::isfinite(e.low)) parameter["interval_95"] = {e.low, e.high};
    document["parameters"].push_back(std::move(parameter));
  }
  for (Index a = 0; a < result.estimates.correlation.rows(); ++a) {
    const Eigen::VectorXd row = result.estimates.correlation.row(a);
    document["correlation"].push_back(std::vector<double>(row.begin(), row.end()));
  }
  return document.dump(2) + "\n";
}

// A row per measured value.
std::string table(const Experiment& experiment, const Eigen::VectorXd& simulated) {
  NumberText out;
  out.add("file,quantity,time_s,measured,simulated\n");
  Index row = 0;
  for (const Measurement& m : experiment.measurements()) {
    for (const MeasuredCurve& curve : m.curves)
      for (std::size_t i = 0; i < curve.values.size(); ++i) {
        out.add(m.file.filename().string()).add(',').add(curve.name).add('_').add(si_unit(curve.dimension)).add(',');
        if (!curve.times.empty()) out.add(curve.times[i]);
        out.add(',').add(curve.values[i]).add(',').add(simulated[row++]).add('\n');
      }
    for (const MeasuredShape& shape : m.shapes)
      for (std::size_t i = 0; i < shape.value_count(); ++i)
        out.add(m.file.filename().string()).add(",distance_m,,0,").add(simulated[row++]).add('\n');
  }
  return out.take();
}

}  // namespace

void make_fit_folder(const fs::path& folder) {
  std::error_code ec;
  fs::create_directories(folder, ec);
  if (ec) throw Error(folder.string(), "cannot be made: " + ec.message(), "expected a folder for the output");
  require_writable(folder / "report.html");
}

void write_fit(const fs::path& folder, const FitResult& result, const FitSubject& subject) {
  write_file(folder / "scene.json", scene_to_json(result.scene, folder));
  write_file(folder / "fit.json", json(result, subject));
  write_file(folder / "values.csv", table(subject.experiment, result.simulated));
  write_file(folder / "report.html", html(folder, result, subject));
}

}  // namespace fascia

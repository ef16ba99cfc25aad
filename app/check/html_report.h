// The results of a check as one self-contained HTML file: a table, and the pictures of each scene.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace fascia {

struct ReportValue {
  std::string name;
  double measured = 0, allowed = 0;
};

struct ReportCase {
  std::string name, verdict;
  bool good = false;
  double seconds = 0;
  std::vector<ReportValue> values;
  std::vector<std::string> lines;
  std::string caption;            // of the picture
  std::filesystem::path picture;  // PNG; omitted if the file does not exist
};

/// `timestamp` as in 2026-01-31T12:00:00. Pictures are part of the text.
std::string html_report(const std::string& title, const std::string& timestamp, const std::vector<ReportCase>& cases);

}  // namespace fascia

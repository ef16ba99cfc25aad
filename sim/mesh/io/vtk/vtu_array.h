// Decodes the data of a DataArray in a .vtu file: inline base64 or appended, plain or zlib-compressed in blocks.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim/mesh/io/vtk/vtk.h"
#include "sim/mesh/io/xml.h"

namespace fascia {

class VtuArrays {
 public:
  /// Reads byte order, header type, compressor and appended data from the root element.
  VtuArrays(Scanner& in, const XmlElement& root);

  /// "ASCII", "base64", "appended raw" or "appended base64", with ", zlib" if compressed.
  std::string encoding(const XmlElement& array) const;

  /// All values of an array, exactly `expected` of them if that is known. `finite` refuses nan and infinity in text.
  template <class T>
  std::vector<T> values(const XmlElement& array, std::optional<std::size_t> expected, bool finite = false) const;

 private:
  struct Appended {
    std::size_t begin, end;
    bool base64;
  };
  std::string bytes(const XmlElement& array) const;
  std::string plain(const XmlElement& array, std::string_view text, bool base64) const;
  std::string inflated(const XmlElement& array, std::string_view text, bool base64) const;
  std::string decoded(const XmlElement& array, std::string_view text, std::uint64_t size, std::size_t* used) const;
  std::uint64_t header_word(std::string_view words, std::size_t index) const;

  Scanner& in_;
  bool swapped_ = false, deflated_ = false;
  std::size_t header_size_ = 4;
  std::optional<Appended> appended_;
};

extern template std::vector<double> VtuArrays::values(const XmlElement&, std::optional<std::size_t>, bool) const;
extern template std::vector<std::int64_t> VtuArrays::values(const XmlElement&, std::optional<std::size_t>, bool) const;

/// A whole number in an attribute.
std::uint64_t xml_count(Scanner& in, const XmlElement& element, const char* key);

}  // namespace fascia

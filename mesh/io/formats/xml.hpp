// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace leonhard::io {

/// An element of an XML document; views point into the document's bytes.
struct XmlElement {
  std::string_view name;
  std::map<std::string, std::string, std::less<>> attributes;  ///< character references resolved
  std::string_view text;      ///< the first piece of its own text that is not blank
  std::size_t text_line = 1;  ///< line of the document on which text begins
  std::size_t line = 1;       ///< line of the document on which the element begins
  std::vector<XmlElement> children;

  /// The first child of that name, or nullptr.
  [[nodiscard]] const XmlElement* child(std::string_view wanted) const;
  /// An attribute's value, or the given one where it is missing.
  [[nodiscard]] std::string attribute(std::string_view wanted, std::string_view otherwise = {}) const;
};

/// The root element of the subset of XML that VTK writes: elements, attributes, text, comments and
/// declarations, no DTD, no CDATA. An element named opaque (its bytes may be anything) has all bytes up to
/// its last end tag as text. throws InputError with the line of what is not well-formed, and for elements
/// nested deeper than 32
[[nodiscard]] XmlElement parse_xml(std::string_view document, const std::string& source,
                                   std::string_view opaque);

/// Text as an attribute's value: & < > " as character references.
[[nodiscard]] std::string xml_escaped(std::string_view text);

}  // namespace leonhard::io

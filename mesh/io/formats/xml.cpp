// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/xml.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::io {

namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::array<std::pair<std::string_view, char>, 5> references{
    {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};

std::string unescaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto reference = std::find_if(references.begin(), references.end(), [&](const auto& candidate) {
      return text.starts_with(candidate.first);
    });
    const bool found = reference != references.end();
    result += found ? reference->second : text.front();
    text.remove_prefix(found ? reference->first.size() : 1);
  }
  return result;
}

class XmlParser {
 public:
  XmlParser(std::string_view document, const std::string& source, std::string_view opaque)
      : text_(document), source_(source), opaque_(opaque) {}

  XmlElement parse() {
    skip_to_tag();
    if (at_ >= text_.size()) fail("found no XML element", "is this a VTK XML file?");
    return parse_element(0);
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy = {}) {
    throw InputError(at_line(source_, line_at(at_)), problem, remedy);
  }

  /// Offsets only grow, so lines are counted once.
  std::size_t line_at(std::size_t offset) {
    const auto from = text_.begin() + static_cast<std::ptrdiff_t>(counted_);
    const auto to = text_.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text_.size()));
    if (from < to) {
      line_ += static_cast<std::size_t>(std::count(from, to, '\n'));
      counted_ = offset;
    }
    return line_;
  }

  [[nodiscard]] bool looking_at(std::string_view what) const { return text_.substr(at_).starts_with(what); }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); }

  void skip_past(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    if (found == std::string_view::npos) fail("the file ends before " + std::string(end), "it was cut short");
    at_ = found + end.size();
  }

  /// Over text, comments and declarations to the next tag.
  void skip_to_tag() {
    while (true) {
      at_ = std::min(text_.find('<', at_), text_.size());
      if (looking_at("<!--")) {
        skip_past("-->");
      } else if (looking_at("<?") || looking_at("<!")) {
        skip_past(">");
      } else {
        return;
      }
    }
  }

  std::string_view parse_name() {
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n=/><\"'", at_), text_.size());
    if (end == at_) fail("a name was expected");
    const std::string_view name = text_.substr(at_, end - at_);
    at_ = end;
    return name;
  }

  void parse_attribute(XmlElement& element) {
    const std::string name(parse_name());
    skip_blanks();
    if (!looking_at("=")) fail("attribute " + name + " has no value");
    ++at_;
    skip_blanks();
    const char quote = at_ < text_.size() ? text_[at_] : '\0';
    if (quote != '"' && quote != '\'') fail("the value of attribute " + name + " is not in quotation marks");
    const std::size_t begin = ++at_;
    skip_past(std::string_view(&quote, 1));
    element.attributes.insert_or_assign(name, unescaped(text_.substr(begin, at_ - 1 - begin)));
  }

  void keep_text(XmlElement& element, std::size_t begin, std::size_t end) {
    const std::string_view piece = text_.substr(begin, end - begin);
    if (!element.text.empty() || piece.find_first_not_of(blanks) == std::string_view::npos) return;
    element.text = piece;
    element.text_line = line_at(begin);
  }

  XmlElement parse_element(int depth) {
    if (depth > 32) fail("elements are nested deeper than 32");
    XmlElement element;
    element.line = line_at(at_);
    ++at_;
    element.name = parse_name();
    while (true) {
      skip_blanks();
      if (looking_at("/>")) {
        at_ += 2;
        return element;
      }
      if (looking_at(">")) break;
      if (at_ >= text_.size())
        fail("the file ends inside the tag " + std::string(element.name), "it was cut short");
      parse_attribute(element);
    }
    ++at_;
    parse_content(element, depth);
    return element;
  }

  void parse_content(XmlElement& element, int depth) {
    const std::string end_tag = "</" + std::string(element.name);
    if (element.name == opaque_) {
      const std::size_t end = text_.rfind(end_tag);
      if (end == std::string_view::npos || end < at_)
        fail("the file ends before " + end_tag + ">", "it was cut short");
      keep_text(element, at_, end);
      at_ = end;
    }
    while (true) {
      const std::size_t begin = at_;
      skip_to_tag();
      keep_text(element, begin, at_);
      if (at_ >= text_.size()) fail("the file ends before " + end_tag + ">", "it was cut short");
      if (looking_at("</")) break;
      element.children.push_back(parse_element(depth + 1));
    }
    if (!looking_at(end_tag)) fail("the end tag " + end_tag + "> was expected");
    skip_past(">");
  }

  std::string_view text_;
  const std::string& source_;
  std::string_view opaque_;
  std::size_t at_ = 0;
  std::size_t counted_ = 0;
  std::size_t line_ = 1;
};

}  // namespace

const XmlElement* XmlElement::child(std::string_view wanted) const {
  const auto found =
      std::find_if(children.begin(), children.end(), [&](const XmlElement& c) { return c.name == wanted; });
  return found == children.end() ? nullptr : &*found;
}

std::string XmlElement::attribute(std::string_view wanted, std::string_view otherwise) const {
  const auto found = attributes.find(wanted);
  return found == attributes.end() ? std::string(otherwise) : found->second;
}

XmlElement parse_xml(std::string_view document, const std::string& source, std::string_view opaque) {
  return XmlParser(document, source, opaque).parse();
}

std::string xml_escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto reference = std::find_if(references.begin(), references.end(),
                                        [&](const auto& candidate) { return candidate.second == c; });
    if (reference == references.end()) {
      result += c;
    } else {
      result += reference->first;
    }
  }
  return result;
}

}  // namespace leonhard::io

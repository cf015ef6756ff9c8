// SPDX-License-Identifier: MIT
#include "leonhard/app/report/html.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string_view>

#include "leonhard/app/console.hpp"

namespace leonhard::app {
namespace {

constexpr std::string_view style = R"css(
:root { --ink:#1c2530; --soft:#5b6b7b; --line:#dde3e9; --ground:#ffffff; --band:#f5f7f9; --good:#1a7f4b; --bad:#b3261e;
        --accent:#24527a; }
* { box-sizing:border-box }
body { font:15px/1.5 system-ui,-apple-system,"Segoe UI","DejaVu Sans",sans-serif; color:var(--ink); background:var(--ground);
       margin:0 auto; padding:2.2rem 1.5rem 4rem; max-width:1180px }
h1 { font-size:1.75rem; margin:0 0 .2rem; letter-spacing:-.01em }
h2 { font-size:1.15rem; margin:2.6rem 0 .8rem; padding-bottom:.3rem; border-bottom:2px solid var(--line); color:var(--accent) }
p.lead { color:var(--soft); margin:.2rem 0 1.4rem }
.verdict { display:inline-block; padding:.1rem .6rem; border-radius:1rem; color:#fff; font-weight:600; font-size:.85rem;
           background:var(--good); vertical-align:middle }
.verdict.bad { background:var(--bad) }
.cards { display:grid; grid-template-columns:repeat(auto-fit,minmax(122px,1fr)); gap:.7rem; margin:1rem 0 }
.card { background:var(--band); border-radius:.5rem; padding:.7rem .9rem }
.card b { display:block; font-size:1.35rem; font-variant-numeric:tabular-nums }
.card span { color:var(--soft); font-size:.82rem }
figure { margin:0 } figure img { width:100%; border:1px solid var(--line); border-radius:.4rem; display:block }
figcaption { color:var(--soft); font-size:.86rem; margin:.35rem 0 0 } figcaption b { color:var(--ink) }
.pictures { display:grid; grid-template-columns:repeat(auto-fill,minmax(480px,1fr)); gap:1.4rem }
.pictures .wide { grid-column:1/-1 }
table { border-collapse:collapse; width:100%; font-variant-numeric:tabular-nums }
th,td { text-align:right; padding:.32rem .7rem; border-bottom:1px solid var(--line) }
th:first-child,td:first-child { text-align:left } thead th { color:var(--soft); font-weight:600; font-size:.85rem }
td.words { text-align:left } .two { display:grid; grid-template-columns:1fr 1fr; gap:2rem }
.ok { color:var(--good); font-weight:600 } .no { color:var(--bad); font-weight:600 }
pre { background:var(--band); padding:1rem; border-radius:.5rem; overflow:auto; font-size:.84rem; line-height:1.45 }
code { font-size:.9em } ul.warnings li { color:var(--bad) }
footer { margin-top:3rem; color:var(--soft); font-size:.82rem; border-top:1px solid var(--line); padding-top:.8rem }
@media (max-width:760px) { .two,.pictures { grid-template-columns:1fr } }
@media print { body { max-width:none } figure,table { break-inside:avoid } }
)css";

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      group = group << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      out += at + i <= bytes.size() ? digits[group >> (18 - 6 * i) & 63U] : '=';
    }
  }
  return out;
}

/// A number as the page shows it: counts in groups of three, the rest with the given digits.
std::string shown(const Json& value, int digits = 4) {
  if (value.is_null()) return "–";
  if (value.is_string()) return escaped(value.get<std::string>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_unsigned()) return grouped(value.get<std::uint64_t>());
  if (value.is_number_integer()) {
    const auto n = value.get<std::int64_t>();
    return (n < 0 ? "−" : "") + grouped(static_cast<std::uint64_t>(n < 0 ? -n : n));
  }
  const auto x = value.get<double>();
  return fmt::format("{}{:.{}f}", std::signbit(x) ? "−" : "", std::abs(x), digits);
}

std::string card(const std::string& value, std::string_view name) {
  return fmt::format("<div class=card><b>{}</b><span>{}</span></div>\n", value, name);
}

std::string row(std::initializer_list<std::string> cells) {
  std::string out = "<tr>";
  for (const std::string& cell : cells) out += "<td>" + cell + "</td>";
  return out + "</tr>\n";
}

std::string mark(bool good, std::string_view yes, std::string_view no) {
  return fmt::format("<span class={}>{}</span>", good ? "ok" : "no", good ? yes : no);
}

std::string head_section(const Json& r) {
  const bool good = r["outcome"] == "converged" || r["outcome"] == "settled";
  std::string out = fmt::format(
      "<h1>{}</h1>\n<p class=lead>Mach {:g}, α = {:g}°, γ = {:g} &nbsp; <span "
      "class=\"verdict{}\">{}</span><br>{}</p>\n",
      escaped(r["title"].get<std::string>()), r["flow"]["mach"].get<double>(),
      r["flow"]["alpha_deg"].get<double>(), r["flow"]["gamma"].get<double>(), good ? "" : " bad",
      escaped(r["outcome"].get<std::string>()), escaped(r["words"].get<std::string>()));
  out += "<div class=cards>\n";
  out += card(shown(r["cl"], 5), "lift coefficient C<sub>L</sub>") +
         card(shown(r["cd"], 5), "drag coefficient C<sub>D</sub>") +
         card(shown(r["cm"], 5), "moment coefficient C<sub>M</sub>") +
         card(shown(r["residual_drop_orders"], 1), "orders of residual drop") +
         card(shown(r["iterations"]), "iterations") + card(shown(r["mesh"]["vertices"]), "vertices") +
         card(shown(r["mesh"]["triangles"]), "triangles") +
         card(fmt::format("{:.1f} s", r["seconds"]["total"].get<double>()), "in all");
  return out + "</div>\n";
}

std::string warnings_section(const Json& r) {
  if (r["warnings"].empty()) return {};
  std::string out = "<h2>Warnings</h2>\n<ul class=warnings>\n";
  for (const auto& warning : r["warnings"]) out += "<li>" + escaped(warning.get<std::string>()) + "</li>\n";
  return out + "</ul>\n";
}

std::string pictures_section(const std::vector<ReportPicture>& pictures) {
  std::string out = "<h2>Pictures</h2>\n<div class=pictures>\n";
  bool first = true;
  for (const ReportPicture& picture : pictures) {
    out += fmt::format(
        "<figure{}><a href=\"{}\"><img alt=\"{}\" src=\"data:image/png;base64,{}\"></a>"
        "<figcaption><b>{}.</b> {}</figcaption></figure>\n",
        first ? " class=wide" : "", escaped(picture.file), escaped(picture.title), base64(picture.png),
        escaped(picture.title), escaped(picture.caption));
    first = false;
  }
  return out + "</div>\n";
}

std::string forces_section(const Json& r) {
  std::string out =
      "<h2>Forces</h2>\n<table><thead><tr><th>body</th><th>C<sub>L</sub></th><th>C<sub>D</sub></"
      "th><th>C<sub>M</sub></th>"
      "</tr></thead>\n";
  for (const auto& body : r["bodies"]) {
    out += row({shown(body["name"]), shown(body["cl"], 6), shown(body["cd"], 6), shown(body["cm"], 6)});
  }
  out += row({"<b>all</b>", "<b>" + shown(r["cl"], 6) + "</b>", "<b>" + shown(r["cd"], 6) + "</b>",
              "<b>" + shown(r["cm"], 6) + "</b>"});
  return out + fmt::format(
                   "</table>\n<p class=lead>Referred to a length of {:g}; moment about ({:g}, {:g}), nose up "
                   "positive.</p>\n",
                   r["reference"]["length"].get<double>(), r["reference"]["moment_centre"][0].get<double>(),
                   r["reference"]["moment_centre"][1].get<double>());
}

std::string euler_section(const Json& r) {
  const Json& euler = r["euler"];
  std::string out =
      "<h2>Euler's "
      "account</h2>\n<table><thead><tr><th>formula</th><th>left</th><th>right</th><th></th></tr></thead>\n";
  for (const auto& formula : euler["formulas"]) {
    out += row({escaped(formula["words"].get<std::string>()), shown(formula["left"]), shown(formula["right"]),
                mark(formula["left"] == formula["right"], "balances", "does not balance")});
  }
  out += "</table>\n<p class=lead>";
  out += fmt::format("{} component(s), {} hole(s), {} boundary loop(s) with {} edges. ",
                     shown(euler["components"]), shown(euler["holes"]), shown(euler["boundary_loops"]),
                     shown(euler["boundary_edges"]));
  if (r.contains("area")) {
    out += fmt::format("Area of the mesh {:.15g}: {} the polygon's in exact rational arithmetic.",
                       r["area"]["mesh"].get<double>(),
                       mark(r["area"]["equal"].get<bool>(), "equal to", "differs from"));
  }
  return out + "</p>\n";
}

std::string mesh_section(const Json& r) {
  const Json& q = r["mesh"];
  std::string out = "<div class=two><div><h2>Mesh</h2>\n<table>\n";
  for (const char* count : {"vertices", "edges", "triangles"}) out += row({count, shown(q[count])});
  out += row({"smallest angle", shown(q["min_angle_deg"], 2) + "°"}) +
         row({"largest angle", shown(q["max_angle_deg"], 2) + "°"}) +
         row({"largest aspect ratio", shown(q["max_aspect_ratio"], 2)}) +
         row({"largest size growth", shown(q["max_size_growth"], 2)});
  if (r.contains("refinement")) {
    out += row({"refinement", shown(r["refinement"]["outcome"])}) +
           row({"points inserted", shown(r["refinement"]["inserted"])}) +
           row({"segment splits", shown(r["refinement"]["segment_splits"])});
  }
  out += row({"fingerprint", "<code>" + shown(q["fingerprint"]) + "</code>"});
  return out + "</table></div>\n";
}

std::string graph_section(const Json& r) {
  std::string out =
      "<div><h2>Ordering and "
      "partition</h2>\n<table><thead><tr><th>numbering</th><th>bandwidth</th><th>envelope</th>"
      "<th>fill</th></tr></thead>\n";
  for (const auto& numbering : r["ordering"]) {
    out += row({shown(numbering["method"]), shown(numbering["bandwidth"]), shown(numbering["envelope"]),
                shown(numbering["fill"])});
  }
  const Json& p = r["partition"];
  out += "</table>\n<table>\n" + row({"partition", shown(p["method"])}) + row({"parts", shown(p["parts"])}) +
         row({"edges cut", shown(p["cut"])}) + row({"imbalance", shown(p["imbalance"], 4)}) +
         row({"triangles in a part", shown(p["smallest"]) + " to " + shown(p["largest"])}) +
         row({"most pieces of a part", shown(p["max_components"])}) +
         row({"most neighbours of a part", shown(p["max_neighbours"])});
  return out + "</table></div></div>\n";
}

std::string time_section(const Json& r) {
  std::string out = "<div class=two><div><h2>Time</h2>\n<table>\n";
  for (const auto& [stage, seconds] : r["seconds"].items()) {
    out += row(
        {stage == "total" ? "<b>total</b>" : escaped(stage), fmt::format("{:.3f} s", seconds.get<double>())});
  }
  out += row({"peak memory", fmt::format("{:.0f} MiB", r["peak_memory_bytes"].get<double>() / 1048576.0)}) +
         row({"threads", shown(r["threads"])});
  out += "</table></div>\n<div><h2>Versions</h2>\n<table>\n";
  for (const auto& [name, version] : r["versions"].items()) out += row({escaped(name), shown(version)});
  return out + "</table></div></div>\n";
}

}  // namespace

std::string report_html(const Json& report, const std::vector<ReportPicture>& pictures,
                        const std::string& case_text) {
  std::string page =
      "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n<meta name=viewport "
      "content=\"width=device-width,initial-scale=1\">\n<title>" +
      escaped(report["title"].get<std::string>()) + " · Leonhard</title>\n<style>" + std::string(style) +
      "</style></head><body>\n";
  page += head_section(report) + warnings_section(report) + pictures_section(pictures) +
          forces_section(report) + euler_section(report) + mesh_section(report) + graph_section(report) +
          time_section(report);
  page += "<h2>Case</h2>\n<pre>" + escaped(case_text) + "</pre>\n";
  page += "<footer>Beside this page: ";
  for (const auto& file : report["files"]) {
    page += fmt::format("<a href=\"{0}\">{0}</a> ", escaped(file.get<std::string>()));
  }
  return page + "</footer>\n</body></html>\n";
}

}  // namespace leonhard::app

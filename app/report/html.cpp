// SPDX-License-Identifier: MIT
#include "leonhard/app/report/html.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <string_view>

#include "leonhard/app/console.hpp"
#include "leonhard/app/report/mesh_json.hpp"

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
std::string shown(double x, int digits) {
  return fmt::format("{}{:.{}f}", std::signbit(x) ? "−" : "", std::abs(x), digits);
}
std::string shown(std::int64_t n) {
  return (n < 0 ? "−" : "") + grouped(static_cast<std::uint64_t>(n < 0 ? -n : n));
}
std::string shown(std::uint64_t n) { return grouped(n); }
std::string shown(std::uint32_t n) { return grouped(n); }
std::string shown(int n) { return shown(std::int64_t{n}); }

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

std::string head_section(const SolveRun& run) {
  const FlowCase& flow = run.the_case.flow;
  std::string out = fmt::format(
      "<h1>{}</h1>\n<p class=lead>Mach {:g}, α = {:g}°, γ = {:g} &nbsp; <span "
      "class=\"verdict{}\">{}</span><br>{}</p>\n",
      escaped(run.the_case.title), flow.mach, flow.alpha_deg, flow.gamma, run.goal_met() ? "" : " bad",
      escaped(to_string(run.flow.verdict)), escaped(run.flow.words));
  const Iteration last = run.flow.history.empty() ? Iteration{} : run.flow.history.back();
  out += "<div class=cards>\n";
  out += card(shown(run.flow.forces.cl, 5), "lift coefficient C<sub>L</sub>") +
         card(shown(run.flow.forces.cd, 5), "drag coefficient C<sub>D</sub>") +
         card(shown(run.flow.forces.cm, 5), "moment coefficient C<sub>M</sub>") +
         card(shown(last.residual_drop_orders, 1), "orders of residual drop") +
         card(shown(last.number), "iterations") + card(shown(run.mesh.vertex_count()), "vertices") +
         card(shown(run.mesh.triangle_count()), "triangles") +
         card(fmt::format("{:.1f} s", run.total_seconds), "in all");
  return out + "</div>\n";
}

std::string warnings_section(const SolveRun& run) {
  if (run.warnings.empty()) return {};
  std::string out = "<h2>Warnings</h2>\n<ul class=warnings>\n";
  for (const std::string& warning : run.warnings) out += "<li>" + escaped(warning) + "</li>\n";
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

std::string forces_section(const SolveRun& run) {
  std::string out =
      "<h2>Forces</h2>\n<table><thead><tr><th>body</th><th>C<sub>L</sub></th><th>C<sub>D</sub></"
      "th><th>C<sub>M</sub></th>"
      "</tr></thead>\n";
  for (const auto& [marker, forces] : run.flow.forces_by_marker) {
    out += row({escaped(run.conditions.at(marker).name), shown(forces.cl, 6), shown(forces.cd, 6),
                shown(forces.cm, 6)});
  }
  const Forces& all = run.flow.forces;
  out += row({"<b>all</b>", "<b>" + shown(all.cl, 6) + "</b>", "<b>" + shown(all.cd, 6) + "</b>",
              "<b>" + shown(all.cm, 6) + "</b>"});
  const ReferenceCase& reference = run.the_case.reference;
  return out + fmt::format(
                   "</table>\n<p class=lead>Referred to a length of {:g}; moment about ({:g}, {:g}), nose up "
                   "positive.</p>\n",
                   reference.length, reference.moment_centre.x, reference.moment_centre.y);
}

std::string euler_section(const SolveRun& run) {
  const EulerAccount& euler = run.euler;
  std::string out =
      "<h2>Euler's "
      "account</h2>\n<table><thead><tr><th>formula</th><th>left</th><th>right</th><th></th></tr></thead>\n";
  for (const auto& formula : euler.formulas) {
    out += row({escaped(formula.words), shown(formula.lhs), shown(formula.rhs),
                mark(formula.holds(), "balances", "does not balance")});
  }
  out += "</table>\n<p class=lead>";
  out +=
      fmt::format("{} component(s), {} hole(s), {} boundary loop(s) with {} edges. ", shown(euler.components),
                  shown(euler.holes), shown(euler.boundary_loops), shown(euler.boundary_edges));
  if (run.area) {
    out += fmt::format("Area of the mesh {:.15g}: {} the polygon's in exact rational arithmetic.",
                       run.area->mesh, mark(run.area->equal, "equal to", "differs from"));
  }
  return out + "</p>\n";
}

std::string mesh_section(const SolveRun& run) {
  const MeshQuality& quality = run.quality;
  std::string out = "<div class=two><div><h2>Mesh</h2>\n<table>\n";
  out += row({"vertices", shown(run.mesh.vertex_count())}) + row({"edges", shown(run.edges.ends.size())}) +
         row({"triangles", shown(run.mesh.triangle_count())});
  out += row({"smallest angle", shown(quality.min_angle_deg, 2) + "°"}) +
         row({"largest angle", shown(quality.max_angle_deg, 2) + "°"}) +
         row({"largest aspect ratio", shown(quality.max_aspect_ratio, 2)}) +
         row({"largest size growth", shown(quality.max_size_growth, 2)});
  if (run.refinement) {
    out += row({"refinement", escaped(to_string(run.refinement->outcome))}) +
           row({"points inserted", shown(run.refinement->inserted)}) +
           row({"segment splits", shown(run.refinement->segment_splits)});
  }
  out += row({"fingerprint", "<code>" + run.fingerprint.hex() + "</code>"});
  return out + "</table></div>\n";
}

std::string graph_section(const SolveRun& run) {
  std::string out =
      "<div><h2>Ordering and "
      "partition</h2>\n<table><thead><tr><th>numbering</th><th>bandwidth</th><th>envelope</th>"
      "<th>fill</th></tr></thead>\n";
  for (const Numbering& numbering : run.numberings) {
    out += row({escaped(numbering.name), shown(numbering.cost.bandwidth), shown(numbering.cost.envelope),
                shown(numbering.fill)});
  }
  const graph::PartitionCost& cost = run.partition_cost;
  out += "</table>\n<table>\n" + row({"partition", escaped(to_string(run.the_case.partitioning))}) +
         row({"parts", shown(run.triangle_parts.parts)}) + row({"edges cut", shown(cost.cut)}) +
         row({"imbalance", shown(cost.imbalance, 4)}) +
         row({"triangles in a part", shown(cost.smallest) + " to " + shown(cost.largest)}) +
         row({"most pieces of a part", shown(cost.max_components)}) +
         row({"most neighbours of a part", shown(cost.max_neighbours)});
  return out + "</table></div></div>\n";
}

std::string time_section(const SolveReport& report) {
  std::string out = "<div class=two><div><h2>Time</h2>\n<table>\n";
  for (const StageTime& stage : report.run.stages)
    out += row({escaped(stage.name), fmt::format("{:.3f} s", stage.seconds)});
  out += row({"<b>total</b>", fmt::format("{:.3f} s", report.run.total_seconds)});
  out += row({"peak memory",
              fmt::format("{:.0f} MiB", static_cast<double>(report.peak_memory_bytes) / 1048576.0)}) +
         row({"threads", shown(report.run.threads)});
  out += "</table></div>\n<div><h2>Versions</h2>\n<table>\n";
  for (const auto& [name, version] : versions()) out += row({escaped(name), escaped(version)});
  return out + "</table></div></div>\n";
}

}  // namespace

std::string report_html(const SolveReport& report, const std::vector<ReportPicture>& pictures) {
  const SolveRun& run = report.run;
  std::string page =
      "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n<meta name=viewport "
      "content=\"width=device-width,initial-scale=1\">\n<title>" +
      escaped(run.the_case.title) + " · Leonhard</title>\n<style>" + std::string(style) +
      "</style></head><body>\n";
  page += head_section(run) + warnings_section(run) + pictures_section(pictures) + forces_section(run) +
          euler_section(run) + mesh_section(run) + graph_section(run) + time_section(report);
  page += "<h2>Case</h2>\n<pre>" + escaped(run.the_case.text) + "</pre>\n";
  page += "<footer>Beside this page: ";
  for (const std::string& file : report.files) page += fmt::format("<a href=\"{0}\">{0}</a> ", escaped(file));
  return page + "</footer>\n</body></html>\n";
}

}  // namespace leonhard::app

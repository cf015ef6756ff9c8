// SPDX-License-Identifier: MIT
#include "leonhard/app/report/page.hpp"

#include <fmt/core.h>

#include <cmath>

#include "leonhard/app/console.hpp"
#include "leonhard/app/report/flow_json.hpp"

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

std::string cell_row(const char* tag, const std::vector<std::string>& cells) {
  std::string out = "<tr>";
  for (const std::string& cell : cells) out += fmt::format("<{0}>{1}</{0}>", tag, cell);
  return out + "</tr>\n";
}

/// Where there is friction the parts of the force follow.
std::vector<std::string> force_cells(const std::string& name, const Forces& forces, bool viscous, bool of_space) {
  std::vector<std::string> cells{name, shown(forces.cl, 6), shown(forces.cd, 6), shown(forces.cm, 6)};
  const auto add = [&](std::initializer_list<double> values) {
    for (const double value : values) cells.push_back(shown(value, 6));
  };
  if (of_space) add({forces.cy, forces.roll, forces.yaw});
  if (viscous)
    add({forces.cl - forces.cl_friction, forces.cl_friction, forces.cd - forces.cd_friction, forces.cd_friction});
  return cells;
}

std::string coordinates(const std::vector<double>& point, std::size_t dim) {
  std::string words;
  for (std::size_t i = 0; i < dim; ++i) words += fmt::format("{}{:g}", i > 0 ? ", " : "", point[i]);
  return words;
}

}  // namespace

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

std::string shown(double x, int digits) {
  return fmt::format("{}{:.{}f}", std::signbit(x) ? "−" : "", std::abs(x), digits);
}
std::string shown(std::int64_t n) {
  return (n < 0 ? "−" : "") + grouped(static_cast<std::uint64_t>(n < 0 ? -n : n));
}
std::string shown(std::uint64_t n) { return grouped(n); }

std::string card(const std::string& value, std::string_view name) {
  return fmt::format("<div class=card><b>{}</b><span>{}</span></div>\n", value, name);
}

std::string row(const std::vector<std::string>& cells) { return cell_row("td", cells); }
std::string head_row(const std::vector<std::string>& cells) { return "<thead>" + cell_row("th", cells) + "</thead>\n"; }

std::string mark(bool good, std::string_view yes, std::string_view no) {
  return fmt::format("<span class={}>{}</span>", good ? "ok" : "no", good ? yes : no);
}

template <int dim>
std::string head_section(const FlowRun<dim>& run, const std::string& cell_cards) {
  const FlowCase& flow = run.the_case.flow;
  std::string words = fmt::format("Mach {:g}, α = {:g}°", flow.mach, flow.alpha_deg);
  if (dim == 3) words += fmt::format(", β = {:g}°", flow.beta_deg);
  words += fmt::format(", γ = {:g}", flow.gamma);
  if (flow.reynolds) words += fmt::format(", Re = {:g}, Pr = {:g}", *flow.reynolds, flow.prandtl);
  std::string out = fmt::format(
      "<h1>{}</h1>\n<p class=lead>{} &nbsp; <span class=\"verdict{}\">{}</span><br>{}</p>\n",
      escaped(run.the_case.title), words, run.goal_met() ? "" : " bad", escaped(to_string(run.flow.verdict)),
      escaped(run.flow.words));
  const Iteration last = run.flow.history.empty() ? Iteration{} : run.flow.history.back();
  out += "<div class=cards>\n";
  out += card(shown(run.flow.forces.cl, 5), "lift coefficient C<sub>L</sub>") +
         card(shown(run.flow.forces.cd, 5), "drag coefficient C<sub>D</sub>") +
         card(shown(run.flow.forces.cm, 5), "moment coefficient C<sub>M</sub>") +
         card(shown(last.residual_drop_orders, 1), "orders of residual drop") +
         card(shown(std::int64_t{last.number}), "iterations") + cell_cards +
         card(fmt::format("{:.1f} s", run.total_seconds), "in all");
  return out + "</div>\n";
}

std::string warnings_section(const RunCommon& run) {
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

namespace {

template <int dim>
std::string mass_flows(const FlowRun<dim>& run) {
  std::string out = "<h2>Mass flow</h2>\n<table>" + head_row({"boundary", "kind", "out"});
  double sum = 0;
  for (const auto& [marker, flow] : run.flow.mass_flow) {
    out += row({escaped(run.conditions.at(marker).name), std::string(to_string(run.conditions.at(marker).kind)),
                fmt::format("{:.9g}", flow / run.the_case.flow.mach)});
    sum += flow / run.the_case.flow.mach;
  }
  return out + row({"<b>all</b>", "", fmt::format("<b>{:.2g}</b>", sum)}) +
         "</table>\n<p class=lead>In units of the free stream’s density, speed and the mesh’s length, by the scheme’s own "
         "fluxes.</p>\n";
}

}  // namespace

template <int dim>
std::string forces_section(const FlowRun<dim>& run) {
  const bool viscous = run.the_case.flow.reynolds.has_value();
  std::vector<std::string> names{"body", "C<sub>L</sub>", "C<sub>D</sub>", "C<sub>M</sub>"};
  if (dim == 3) names.insert(names.end(), {"C<sub>Y</sub>", "roll", "yaw"});
  if (viscous)
    names.insert(names.end(), {"C<sub>L</sub> of pressure", "of friction", "C<sub>D</sub> of pressure", "of friction"});
  std::string out = "<h2>Forces</h2>\n<table>" + head_row(names);
  for (const auto& [marker, forces] : run.flow.forces_by_marker)
    out += row(force_cells(escaped(run.conditions.at(marker).name), forces, viscous, dim == 3));
  std::vector<std::string> all = force_cells("all", run.flow.forces, viscous, dim == 3);
  for (std::string& cell : all) cell = "<b>" + cell + "</b>";
  const ReferenceCase& reference = run.the_case.reference;
  out += row(all) + fmt::format("</table>\n<p class=lead>Referred to a length of {:g}", reference.length);
  if (dim == 3) out += fmt::format(" and an area of {:g}", reference.area);
  return out + fmt::format("; moment about ({}), nose up positive.</p>\n", coordinates(reference.moment_centre, dim)) +
         mass_flows(run);
}

std::string numberings_table(const RunCommon& run) {
  std::string out = "<table>" + head_row({"numbering", "bandwidth", "envelope", "fill"});
  for (const Numbering& numbering : run.numberings)
    out += row({escaped(numbering.name), shown(numbering.cost.bandwidth), shown(numbering.cost.envelope),
                shown(numbering.fill)});
  return out + "</table>\n";
}

std::string time_section(const RunCommon& run, std::uint64_t peak_memory_bytes) {
  std::string out = "<div class=two><div><h2>Time</h2>\n<table>\n";
  for (const StageTime& stage : run.stages)
    out += row({escaped(stage.name), fmt::format("{:.3f} s", stage.seconds)});
  out += row({"<b>total</b>", fmt::format("{:.3f} s", run.total_seconds)});
  out += row({"peak memory",
              fmt::format("{:.0f} MiB", static_cast<double>(peak_memory_bytes) / 1048576.0)}) +
         row({"threads", shown(std::int64_t{run.threads})});
  out += "</table></div>\n<div><h2>Versions</h2>\n<table>\n";
  for (const auto& [name, version] : versions()) out += row({escaped(name), escaped(version)});
  return out + "</table></div></div>\n";
}

std::string whole_page(const RunCommon& run, const std::string& sections, const std::set<std::string>& files) {
  std::string page =
      "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n<meta name=viewport "
      "content=\"width=device-width,initial-scale=1\">\n<title>" +
      escaped(run.the_case.title) + " · Leonhard</title>\n<style>" + std::string(style) +
      "</style></head><body>\n" + sections;
  page += "<h2>Case</h2>\n<pre>" + escaped(run.the_case.text) + "</pre>\n";
  page += "<footer>Beside this page: ";
  for (const std::string& file : files) page += fmt::format("<a href=\"{0}\">{0}</a> ", escaped(file));
  return page + "</footer>\n</body></html>\n";
}

template std::string head_section(const FlowRun<2>&, const std::string&);
template std::string head_section(const FlowRun<3>&, const std::string&);
template std::string forces_section(const FlowRun<2>&);
template std::string forces_section(const FlowRun<3>&);

}  // namespace leonhard::app

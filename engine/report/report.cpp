#include "report/report.hpp"

#include "draw/results/results_picture.hpp"
#include "report/sections.hpp"

namespace trilith::report {

std::string report_page(const results::ResultsReader& reader, const std::vector<std::filesystem::path>& record_folders,
                        const ReportProgress& progress, const results::TimeOrigin& origin, const UnitSystem& units) {
  const ReportSource source{reader,
                            reader.header(),
                            reader.events(),
                            draw::events_of_note(reader),
                            reader.stages(),
                            reader.notes(),
                            record_folders,
                            origin,
                            units};
  HtmlText html(source.units);
  html.raw("<!DOCTYPE html>\n").open("html", R"(lang="en")").open("head");
  html.raw(R"(<meta charset="utf-8"/>)")
      .raw(R"(<meta name="viewport" content="width=device-width, initial-scale=1"/>)");
  html.open("title").verbatim("Report: " + reader.title()).close().open("style").raw(report_style()).close().close();
  html.open("body").open("main");
  write_head(source, html);
  write_model(source, html);
  write_parameters(source, html);
  write_motions(source, html);
  write_stages(source, html);
  write_pictures(source, html);
  write_fields(source, html);
  write_events(source, html);
  write_damage(source, html);
  write_members(source, html);
  write_histories(source, html);
  write_energy(source, html);
  write_seal(source, progress, html);
  write_reproduction(source, html);
  html.close().close().close();
  return html.take();
}

}  // namespace trilith::report

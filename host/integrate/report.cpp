#include "integrate/report.h"

#include "integrate/findings.h"
#include "integrate/text_table.h"

namespace capcon::integrate {

Report make_report(const Settings& settings) {
  const Experiment experiment = run_experiment(settings);
  const Analysis analysis = analyse(experiment);
  const std::vector<GeneratorEnergy> plane = energy_plane(kPlanePoints, experiment.settings.seed);
  const std::vector<std::string> findings = make_findings(experiment, analysis, plane);
  return {text_tables(experiment, analysis, findings), html_page(experiment, analysis, plane, findings),
          to_json(experiment, analysis, plane)};
}

}  // namespace capcon::integrate

#include "study/report_csv.h"

namespace capcon {

Csv cells_csv(const Figures& figures) {
  Csv csv(
      "sampler,samples,sure,mse,mse_low,mse_high,relmse,relmse_low,relmse_high,flip,flip_low,flip_high,mean_"
      "mse,"
      "device_seconds,device_seconds_low,device_seconds_high,wall_seconds,wall_seconds_low,wall_seconds_high,"
      "point_generation_seconds");
  for (const Curve& curve : figures.curves) {
    for (const Cell& c : curve.cells) {
      csv.add(curve.sampler).add(c.samples).add(c.sure ? "yes" : "no").add(c.mse).add(c.relmse).add(c.flip);
      csv.add(c.mean_mse).add(c.device_seconds).add(c.wall_seconds).add(c.point_seconds).end_row();
    }
  }
  return csv;
}

Csv ratios_csv(const Figures& figures, const std::string& baseline) {
  Csv csv(
      "sampler,baseline,samples,mse_ratio,mse_ratio_low,mse_ratio_high,equal_error_samples,equal_error_"
      "samples_low,"
      "equal_error_samples_high,out_of_range,equal_error_time_ratio,equal_error_time_ratio_low,"
      "equal_error_time_ratio_high,equal_time_mse_ratio,equal_time_mse_ratio_low,equal_time_mse_ratio_high");
  for (const Ratio& r : figures.ratios) {
    if (r.baseline != baseline) continue;
    csv.add(r.sampler).add(r.baseline).add(r.samples).add(r.mse).add(r.equal_error);
    csv.add(r.beyond < 0 ? "fewer" : r.beyond > 0 ? "more" : "no");
    csv.add(r.equal_error_time).add(r.equal_time).end_row();
  }
  return csv;
}

}  // namespace capcon

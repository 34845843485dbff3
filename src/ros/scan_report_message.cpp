#include "atom_mapping/ros/scan_report_message.h"

namespace atom_mapping {

ScanReport toMessage(const atom_map::ScanReport& report, const std_msgs::Header& header) {
  ScanReport message;
  message.header = header;
  message.points_in = report.filter.points_in;
  message.dropped_nan = report.filter.nan;
  message.dropped_too_near = report.filter.too_near;
  message.dropped_too_far = report.filter.too_far;
  message.dropped_no_return = report.filter.no_return;
  message.dropped_thinned = report.filter.thinned;
  message.surface_points = report.surface_points;
  message.normals_fallback = report.normals.from_line + report.normals.from_ray;
  message.candidates = report.candidates_interleaved;
  message.candidates_kept = report.candidates_kept;
  message.atoms_inserted = report.merge.inserted;
  message.atom_updates = report.merge.updates;
  message.atoms_refused = report.merge.refused;
  message.atoms_forgotten = static_cast<std::uint32_t>(report.forgotten);
  message.atoms = report.atoms;
  message.map_bytes = report.map_bytes;
  message.seconds_filter = static_cast<float>(report.seconds.filter);
  message.seconds_normals = static_cast<float>(report.seconds.normals);
  message.seconds_rays = static_cast<float>(report.seconds.rays);
  message.seconds_candidate_filter = static_cast<float>(report.seconds.candidate_filter);
  message.seconds_merge = static_cast<float>(report.seconds.merge);
  message.seconds_forget = static_cast<float>(report.seconds.forget);
  message.seconds_total = static_cast<float>(report.seconds.total());
  return message;
}

}  // namespace atom_mapping

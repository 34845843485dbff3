#pragma once

#include <std_msgs/Header.h>

#include "atom_mapping/ScanReport.h"
#include "atom_mapping/map/scan_report.h"

namespace atom_mapping {

// `header`: of the cloud that the report is of.
ScanReport toMessage(const atom_map::ScanReport& report, const std_msgs::Header& header);

}  // namespace atom_mapping

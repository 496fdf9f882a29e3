// report.html of a results folder.
#pragma once

#include "apps/report_pictures.h"
#include "apps/stages.h"

namespace headland {

// The page of the run in the job's folder, from its files alone: what is missing or damaged is left
// out and told on the page. Throws InputError when there is no run at all.
ReportPage run_report(const Job& job);

// Writes it to report.html there.
void report_stage(const Job& job);

}  // namespace headland

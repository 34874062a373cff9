// The progress of a fit (fit.h) and its result.
#pragma once

#include <string>
#include <vector>

#include "adaption/pass_record.h"
#include "adaption/rest_metric.h"

namespace ease {

struct FitPass {
  PassRecord record;
  double area_ratio = 1.0;  // area of the rest shape in this pass over that of the first
};

/// Enough to go on after a pass as if the fit had not stopped there.
struct FitState {
  std::vector<FitPass> passes;
  Positions first_end;          // of the garment at the end of the first pass, m
  int best = 0;                 // the pass with the smallest share over the limit
  double best_share = 1.0;      // share over the limit of the best pass; after a check, the larger of pass and check
  std::vector<Mat2> best_rest;  // flat rest edges of that pass, m
  std::vector<Mat2> next_rest;  // of the next pass, m
  bool over = false;            // no further pass is to be made before the check
  int resumed_after = 0;        // passes that were made before this fit was resumed
};

struct FitResult {
  PassRecord check;     // of the rest shape chosen, from a disturbed start
  Positions check_end;  // of the garment at its end, m
  bool target_met = false;
  std::string reason;     // why the passes ended, in words
  MetricError embedding;  // of the rest shape chosen
};

}  // namespace ease

// Scenes of the benchmarks: square sheets of 1 m and 0.2 kg/m^2, held by pins, without contact, air drag and damping.
//
//   taut       The four edges are pinned to a frame 5 % too wide, which is shaken up and down.  Every triangle is in
//              tension, so that a step has one minimum and positions can be compared.
//   hanging    The two upper corners are pinned 10 % too close to each other and shaken back and forth.  The sheet
//              wrinkles, so that a step may have several minima: energies and residuals can be compared, but positions
//              of two good solvers may differ.
//   thrown     The sheet has no pins and is thrown at 2 m/s: it must fall freely.
//   drape-2pin The sheet is flat and horizontal at first and swings down from two pinned corners.  Results of other
//              codes are known for this scene.
//
//   k  stiffness, N/m.  Woven cloth (taut, hanging, thrown): stretch stiffness, with a shear stiffness of k/4.
//      drape-2pin: stiffness of the isotropic energy density k/2 |F - R|^2.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solver/step/time_step.h"

namespace ease {

struct Sheet {
  std::string name;
  Cloth cloth;
  std::vector<int> ordering;                          // elimination order of its linear systems
  State start;                                        // at time 0
  std::function<void(double time, Pins& pins)> hold;  // sets the pins at a time, s
};

// Each function makes a sheet of `side` x `side` vertices.
std::unique_ptr<Sheet> makeTautSheet(int side, double k);
std::unique_ptr<Sheet> makeHangingSheet(int side, double k);
std::unique_ptr<Sheet> makeThrownSheet(int side, double k);

/// Makes the sheet drape-2pin; results of other codes are for k = 1000 N/m.
std::unique_ptr<Sheet> makeDrape2Pin(int side, double k);

/// Makes the sheet of that name (see above).  Throws InputError for an unknown name.
std::unique_ptr<Sheet> makeSheetNamed(const std::string& name, int side, double k);

/// Finds the contacts of a sheet that touches nothing: clears `contacts`.
void findNoContacts(const Positions& x, Contacts& contacts);

/// Advances the sheet's state from `time` to time + h by one step of the method, which is a TimeStep or another class
/// with the same step().
template <class Method>
StepSummary advance(const Sheet& sheet, Method& method, double time, double h, State& state) {
  Pins pins;
  sheet.hold(time + h, pins);
  StepOptions options;
  options.h = h;
  return method.step(state, options, pins, findNoContacts);
}

}  // namespace ease

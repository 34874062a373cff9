// Scenes of the benches: square sheets of 1 m, 0.2 kg/m^2, held by pins; no contact, no air, no damping.
//
//   taut       its four edges on a frame 5 % too wide, shaken up and down: every triangle is in tension, so that a
//              step has one minimum and positions can be compared
//   hanging    its two upper corners 10 % too near, shaken forth and back: it wrinkles, so that a step may have several
//              minima; energies and residuals can be compared, positions of two good solvers may differ
//   thrown     held nowhere, thrown at 2 m/s: it must fall as a stone does
//   drape-2pin flat and horizontal at first, then swings down from two corners: a scene on which other codes'
//              figures are known
//
//   k  stiffness, N/m: of stretch, with shear k/4 (woven: taut, hanging, thrown); of psi = k/2 |F - R|^2 (drape-2pin)
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
  std::vector<int> ordering;                          // of its systems
  State start;                                        // at time 0
  std::function<void(double time, Pins& pins)> hold;  // fills where the pins are, time in s
};

/// `side` x `side` vertices.
std::unique_ptr<Sheet> makeTautSheet(int side, double k);
std::unique_ptr<Sheet> makeHangingSheet(int side, double k);
std::unique_ptr<Sheet> makeThrownSheet(int side, double k);

/// Other codes' figures are for k = 1000 N/m.
std::unique_ptr<Sheet> makeDrape2Pin(int side, double k);

/// Makes the sheet of that name (see above).  Throws InputError for an unknown name.
std::unique_ptr<Sheet> makeSheetNamed(const std::string& name, int side, double k);

/// Contacts of a sheet that touches nothing: none.
void findNoContacts(const Positions& x, Contacts& contacts);

/// Moves the sheet's state from `time` to time + h by one step of the method: a TimeStep, or what has its step().
template <class Method>
StepSummary advance(const Sheet& sheet, Method& method, double time, double h, State& state) {
  Pins pins;
  sheet.hold(time + h, pins);
  StepOptions options;
  options.h = h;
  return method.step(state, options, pins, findNoContacts);
}

}  // namespace ease

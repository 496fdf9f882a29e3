#include "sim/recorder.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

constexpr double kHullCheckSpacing_m = 0.1;

void raise_peak(Peak& peak, double value, double time_s, const Eigen::Vector2d& p_W) {
  if (std::abs(value) > std::abs(peak.value)) peak = {value, time_s, p_W};
}

double load_transfer_ratio(const PerWheel<WheelContact>& contacts) {
  const double left_n = contacts[0].load_n + contacts[2].load_n;
  const double right_n = contacts[1].load_n + contacts[3].load_n;
  const double total_n = left_n + right_n;
  return total_n > 0.0 ? (left_n - right_n) / total_n : 0.0;
}

void raise_load_transfer(double ratio, bool of_trailer, double time_s, const Eigen::Vector2d& p_W,
                         Peaks& peaks) {
  if (std::abs(ratio) > std::abs(peaks.load_transfer_ratio.value)) {
    peaks.load_transfer_of_trailer = of_trailer;
  }
  raise_peak(peaks.load_transfer_ratio, ratio, time_s, p_W);
}

// Of the vehicle or its trailed implement, whichever is nearer to tipping.
double worst_load_transfer_ratio(const StepReport& report) {
  const double vehicle = load_transfer_ratio(report.contacts);
  const double trailer = report.trailer_load_transfer_ratio;
  return std::abs(trailer) > std::abs(vehicle) ? trailer : vehicle;
}

double worst_driven_slip(const Machine& machine, const PerWheel<double>& slip) {
  double worst = 0.0;
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (machine.wheels[i].driven) worst = std::max(worst, slip[i]);
  }
  return worst;
}

struct Place {
  Eigen::Vector3d p_WB;
  Eigen::Vector3d yaw_pitch_roll;
  Eigen::Vector2d ahead;
  Eigen::Vector2d left;

  Eigen::Vector2d at(double x_m, double y_m) const {
    return p_WB.head<2>() + x_m * ahead + y_m * left;
  }
};

Place place_of(const ChassisState& chassis, const ChassisMass& mass,
               const Eigen::Vector3d& angles) {
  Place place;
  place.p_WB = origin_of(chassis, mass);
  place.yaw_pitch_roll = angles;
  place.ahead = chassis.R_WB.col(0).head<2>().normalized();
  place.left = {-place.ahead.y(), place.ahead.x()};
  return place;
}

Place place_of(const ChassisState& chassis, const ChassisMass& mass) {
  return place_of(chassis, mass, yaw_pitch_roll(chassis.R_WB));
}

void record_belly(Recorder& recorder, const StepReport& report, double time_s) {
  const bool belly_down = !report.belly.empty();
  Peaks& peaks = recorder.record.peaks;
  if (belly_down && !recorder.belly_down) ++peaks.belly_contacts;
  recorder.belly_down = belly_down;
  for (const BellyContact& contact : report.belly) {
    raise_peak(peaks.belly_contact_m, contact.depth_m, time_s,
               (report.chassis.p_WC + contact.arm).head<2>());
  }
}

// Where the implement's working line is.
struct WorkingLine {
  Eigen::Vector2d left_W;
  Eigen::Vector2d right_W;
};

WorkingLine working_line(const Machine& machine, const StepReport& report, const Place& place) {
  const Implement& implement = machine.vehicle.implement;
  const double reach_m = 0.5 * implement.working_width_m;
  if (!machine.trailer) {
    return {place.at(implement.x_B_m, reach_m), place.at(implement.x_B_m, -reach_m)};
  }
  const ChassisMass& mass = machine.trailer->mass;
  const Place axle = place_of(report.trailer, mass);
  const double x_m = (machine.trailer->tool_C + mass.com_B).x();
  return {axle.at(x_m, reach_m), axle.at(x_m, -reach_m)};
}

void raise_overrun(Peaks& peaks, double depth_m, bool in_hole, double time_s,
                   const Eigen::Vector2d& p_W) {
  if (depth_m > peaks.boundary_overrun_m.value) peaks.overrun_in_hole = in_hole;
  raise_peak(peaks.boundary_overrun_m, depth_m, time_s, p_W);
}

// A trailed implement's wheels may be where neither the vehicle nor the tool is.
void check_trailer(Recorder& recorder, const StepReport& report, double time_s) {
  const Trailer& trailer = *recorder.machine.trailer;
  const Place axle = place_of(report.trailer, trailer.mass);
  for (const WheelDefinition& wheel : trailer.own_wheels()) {
    const Eigen::Vector3d hub_T = wheel.hub_C + trailer.mass.com_B;
    const double outer_m = hub_T.y() + std::copysign(0.5 * wheel.tyre.width_m, hub_T.y());
    const Eigen::Vector2d p_W = axle.at(hub_T.x(), outer_m);
    const double depth_m = -field_clearance_m(recorder.field, p_W);
    if (depth_m <= 0.0) continue;
    raise_overrun(recorder.record.peaks, depth_m, inside_ring(recorder.field.boundary, p_W), time_s,
                  p_W);
  }
}

void check_hull(Recorder& recorder, const StepReport& report, const Place& place, double time_s) {
  Peaks& peaks = recorder.record.peaks;
  const Overrun over = overrun(recorder.space, {place.p_WB.head<2>(), place.yaw_pitch_roll.x()});
  // Obstacles are Bullet's: touching one ends the run.
  if (over.limit == Limit::kBoundary || over.limit == Limit::kHole) {
    raise_overrun(peaks, over.depth_m, over.limit == Limit::kHole, time_s, over.p_W);
  }
  if (recorder.machine.trailer) check_trailer(recorder, report, time_s);
  const WorkingLine line = working_line(recorder.machine, report, place);
  for (const Eigen::Vector2d& end : {line.left_W, line.right_W}) {
    if (disc_fits(recorder.space, end, 0.0)) continue;
    raise_peak(peaks.implement_overhang_m, std::max(0.0, -field_clearance_m(recorder.field, end)),
               time_s, end);
  }
}

void leave_footprint(Recorder& recorder, const StepReport& report, const Place& place, bool working,
                     double time_s) {
  // A strip ends with a footprint where the implement leaves the ground, so that its last piece
  // is not lost to the spacing.
  const bool due = recorder.travel_m - recorder.last_footprint_m >= recorder.footprint_spacing_m;
  if (working ? (recorder.strip_open && !due) : !recorder.strip_open) return;
  const WorkingLine line = working_line(recorder.machine, report, place);
  FootprintSample footprint;
  footprint.left_W = line.left_W;
  footprint.right_W = line.right_W;
  footprint.time_s = time_s;
  footprint.travel_m = recorder.travel_m;
  footprint.starts_strip = !recorder.strip_open;
  recorder.record.footprints.push_back(footprint);
  recorder.last_footprint_m = recorder.travel_m;
  recorder.strip_open = working;
}

RunSample make_sample(const Recorder& recorder, const StepReport& report, const MachineState& state,
                      const DriverState& driver, const DriverCommand& command, const Place& place) {
  RunSample sample;
  sample.time_s = static_cast<double>(recorder.step) * recorder.dt_s;
  sample.travel_m = recorder.travel_m;
  sample.p_WB = place.p_WB;
  sample.yaw_rad = place.yaw_pitch_roll.x();
  sample.pitch_rad = place.yaw_pitch_roll.y();
  sample.roll_rad = place.yaw_pitch_roll.z();
  sample.speed_mps = report.chassis.v_W.dot(report.chassis.R_WB.col(0));
  sample.steer_rad = driver.steer_rad;
  sample.slip = worst_driven_slip(recorder.machine, report.slip);
  sample.load_transfer_ratio = worst_load_transfer_ratio(report);
  sample.cross_track_error_m = recorder.cross_track_m;
  sample.motor_torque_nm = report.motor_nm;
  sample.motor_power_w = report.motor_w;
  sample.battery_power_w = report.battery_w;
  sample.battery_voltage_v = report.battery_v;
  sample.soc = state.battery.soc;
  sample.draft_n = report.draft_n;
  sample.hitch_angle_rad = report.hitch_angle_rad;
  sample.segment = command.segment;
  sample.implement_down = command.working;
  for (std::size_t i = 0; i < kWheels; ++i) {
    sample.wheel_load_n[i] = report.contacts[i].load_n;
    sample.wheel_angle_rad[i] = state.wheels[i].angle_rad;
  }
  return sample;
}

void raise_peaks(Recorder& recorder, const StepReport& report, const DriverCommand& command,
                 const Place& place, double time_s) {
  Peaks& peaks = recorder.record.peaks;
  const Eigen::Vector2d p_W = place.p_WB.head<2>();
  raise_peak(peaks.slip, recorder.slip.add(worst_driven_slip(recorder.machine, report.slip)),
             time_s, p_W);
  raise_load_transfer(recorder.load_transfer.add(load_transfer_ratio(report.contacts)), false,
                      time_s, p_W, peaks);
  if (recorder.machine.trailer) {
    const double ratio = recorder.trailer_load_transfer.add(report.trailer_load_transfer_ratio);
    raise_load_transfer(ratio, true, time_s, report.trailer.p_WC.head<2>(), peaks);
  }
  raise_peak(command.working ? peaks.cross_track_working_m : peaks.cross_track_turning_m,
             recorder.cross_track_m, time_s, p_W);
  raise_peak(peaks.battery_power_w, report.battery_w, time_s, p_W);
  raise_peak(peaks.pitch_rad, place.yaw_pitch_roll.y(), time_s, p_W);
  raise_peak(peaks.roll_rad, place.yaw_pitch_roll.z(), time_s, p_W);
  if (recorder.step == 0 || report.battery_v < peaks.min_voltage_v.value) {
    peaks.min_voltage_v = {report.battery_v, time_s, p_W};
  }
  if (report.clipped) peaks.motor_clipped_s += recorder.dt_s;
}

void charge_stores(EnergyBalance& balance, const StoredEnergy& before, const StoredEnergy& after) {
  const auto charge = [&balance](EnergyCause cause, double energy_j) {
    balance.cause_j[static_cast<std::size_t>(cause)] += energy_j;
  };
  charge(EnergyCause::kGrade, after.grade_j - before.grade_j);
  charge(EnergyCause::kKinetic, after.kinetic_j - before.kinetic_j);
  charge(EnergyCause::kStored, after.spring_j - before.spring_j);
}

}  // namespace

double SlidingMean::add(double value) {
  sum += value - values[next];
  values[next] = value;
  next = (next + 1) % values.size();
  filled = std::min(filled + 1, values.size());
  if (next == 0) {
    // Summed anew once a window: the running sum would gather rounding over a long run.
    sum = 0.0;
    for (const double v : values) sum += v;
  }
  return filled == values.size() ? sum / static_cast<double>(filled) : 0.0;
}

Recorder make_recorder(const Machine& machine, const Field& field, double rate_hz, double record_hz,
                       double footprint_spacing_m) {
  Recorder recorder{machine, field};
  recorder.space = free_space(field, hull_of(machine.vehicle));
  recorder.dt_s = 1.0 / rate_hz;
  recorder.sample_every = std::max(1, static_cast<int>(std::lround(rate_hz / record_hz)));
  recorder.footprint_spacing_m = footprint_spacing_m;
  const auto window = static_cast<std::size_t>(std::max(1L, std::lround(kSustained_s * rate_hz)));
  recorder.slip.values.assign(window, 0.0);
  recorder.load_transfer.values.assign(window, 0.0);
  recorder.trailer_load_transfer.values.assign(window, 0.0);
  return recorder;
}

void record_step(Recorder& recorder, const StepReport& report, const MachineState& state,
                 const DriverState& driver, const DriverCommand& command, const DriverView& truth,
                 double cross_track_m) {
  RunRecord& record = recorder.record;
  const double time_s = static_cast<double>(recorder.step) * recorder.dt_s;
  const Place place = place_of(report.chassis, recorder.machine.mass,
                               {truth.yaw_rad, truth.pitch_rad, truth.roll_rad});
  recorder.cross_track_m = cross_track_m;

  if (recorder.step > 0) {
    charge_stores(record.segments.back().energy, recorder.stored_before, report.stored);
  }
  recorder.stored_before = report.stored;
  if (record.segments.empty() || record.segments.back().segment != command.segment) {
    SegmentRecord segment;
    segment.segment = command.segment;
    segment.start_time_s = time_s;
    record.segments.push_back(segment);
  }

  const double step_m = report.chassis.v_W.head<2>().norm() * recorder.dt_s;
  SegmentRecord& segment = record.segments.back();
  segment.duration_s += recorder.dt_s;
  segment.distance_m += step_m;
  segment.cross_track_sum_m3 += cross_track_m * cross_track_m * step_m;
  segment.scuffed_m2 += report.scuffing_m2_per_s * recorder.dt_s;
  segment.slip_sum_m += worst_driven_slip(recorder.machine, report.slip) * step_m;
  segment.peak_power_w = std::max(segment.peak_power_w, report.battery_w);
  add(segment.energy, report.energy);

  raise_peaks(recorder, report, command, place, time_s);
  record_belly(recorder, report, time_s);
  if (recorder.travel_m >= recorder.next_hull_check_m) {
    check_hull(recorder, report, place, time_s);
    recorder.next_hull_check_m = recorder.travel_m + kHullCheckSpacing_m;
  }
  leave_footprint(recorder, report, place, command.working, time_s);
  if (recorder.step % recorder.sample_every == 0) {
    record.samples.push_back(make_sample(recorder, report, state, driver, command, place));
  }
  recorder.travel_m += step_m;
  ++recorder.step;
}

void finish_record(Recorder& recorder, const StepReport& report, const StoredEnergy& stored,
                   const MachineState& state, const DriverState& driver,
                   const DriverCommand& command) {
  RunRecord& record = recorder.record;
  if ((recorder.step - 1) % recorder.sample_every != 0) {
    const Place place = place_of(report.chassis, recorder.machine.mass);
    record.samples.push_back(make_sample(recorder, report, state, driver, command, place));
  }
  charge_stores(record.segments.back().energy, recorder.stored_before, stored);
  for (SegmentRecord& segment : record.segments) {
    segment.energy.cause_j[static_cast<std::size_t>(EnergyCause::kResidual)] =
        unaccounted_j(segment.energy);
    add(record.energy, segment.energy);
  }
  const Battery& battery = recorder.machine.vehicle.battery;
  record.duration_s = static_cast<double>(recorder.step) * recorder.dt_s;
  record.distance_m = recorder.travel_m;
  record.soc_end = state.battery.soc;
  record.rested_voltage_start_v = open_circuit_voltage_v(battery, record.soc_start);
  record.rested_voltage_end_v = open_circuit_voltage_v(battery, record.soc_end);
}

}  // namespace headland

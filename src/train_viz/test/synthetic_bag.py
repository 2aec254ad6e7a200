"""Writes bags as LTD does, from a train that is one rigid body: plausible to look at, exact in its sums.

`python3 synthetic_bag.py DIR` writes full-length bags like the paper's three simulations, to look at the figures.
"""
import sys
from typing import Dict, Optional, Sequence

import genpy
import numpy as np
import rosbag
from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage
from train_msgs.msg import Adhesion, AxleAdhesion, ContactAdhesion, RunConfiguration, TrainEnergy, TrainState

PERIOD_S = 0.02  # telemetry at 50 Hz of simulation time
LOCO_KG, WAGON_KG = 134e3, 120e3
AXLES, WHEEL_RADIUS_M, SLIP_LIMIT = 6, 0.5335, 0.07

RESOLVED = '''
name: %(scenario)s
control: {law: pi, slip_limit: 0.07}
train:
  groups:
    - {count: %(locos)d, vehicle: {mass_kg: 134000, adhesion_limit: 0.35}}
    - {count: %(wagons)d, vehicle: {mass_kg: 120000}}
track:
  name: flat with one curve
  start_km: 0
  end_km: 10
  curves:
    - {start_km: 3.3, radius_m: 300, direction: left, transition_in_m: 50, circular_m: 200, transition_out_m: 50}
'''


def simulate(locos: int, wagons: int, end_km: float = 4.5, limit_N: float = 460.1e3, slip: float = 0.0,
             duration_s: float = 1e9, period_s: float = PERIOD_S, brake_from_s: float = 1e9) -> Dict[str, np.ndarray]:
    """Rows of a run from 3.0 km and 5 km/h; `slip` is the share of the work at the rail lost while the limit acts, or in
    braking. From brake_from_s on the motors brake with 200 kN each and the wagons' shoes with 10 kN each."""
    mass = locos * LOCO_KG + wagons * WAGON_KG
    s, v, t, force, row = 3000.0, 5.0 / 3.6, 0.0, 0.0, []
    work = rim = resistance_work = taken = recovered = slipped = air = 0.0
    while s <= 1000.0 * end_km and t <= duration_s + 1e-9 and v > 0.5:
        braking = t >= brake_from_s
        notch = -5.0 if braking else min(8.0, 1.0 + t // 10.0)
        row.append((t, s, v, notch, force, work, rim, resistance_work, taken, recovered, slipped, air))
        wanted = -200e3 if braking else min(notch / 8.0 * 560e3, (notch / 8.0) ** 2 * 4.1e6 / v, limit_N)
        force += np.clip(wanted - force, -160e3 * period_s, 40e3 * period_s)
        resistance, shoes = mass / 1000.0 * (6.0 + 0.03 * v * 3.6), 10e3 * wagons * braking
        new_v = v + (locos * force - resistance - shoes) / mass * period_s
        step = (v + new_v) / 2.0 * period_s
        resistance_work, air = resistance_work + resistance * step, air + shoes * step
        lost = slip * abs(force) * step if force < 0.0 or force >= 0.99 * limit_N else 0.0
        if force >= 0.0:
            work, rim, slipped = work + force * step, rim + force * step + lost, slipped + 0.9 * lost
        else:
            taken, recovered, slipped = taken - force * step, recovered - force * step - lost, slipped + lost
        s, v, t = s + step, new_v, t + period_s
    return dict(zip(('time', 'location', 'speed', 'notch', 'traction', 'work', 'rim', 'resistance_work', 'taken', 'recovered',
                     'slipped', 'air'), np.array(row).T))


def coupler_forces(time: np.ndarray, traction: np.ndarray, locos: int, wagons: int) -> np.ndarray:
    """Every coupler pulls the vehicles behind it; a damped wave runs back through the train at every notch."""
    number = np.arange(1, locos + wagons)
    share = np.where(number <= locos, number * (1.0 - number / (locos + wagons)), locos * (1.0 - number / (locos + wagons)))
    since_notch = np.maximum(np.minimum(time % 10.0, time) - number[:, None] / 40.0, 0.0)
    wave = 120e3 * np.exp(-since_notch / 1.5) * np.sin(2.0 * np.pi * since_notch) * np.exp(-time / 40.0)
    return (share[:, None] * traction + wave).T


def state_message(rows: Dict[str, np.ndarray], i: int, couplers: np.ndarray, locos: int,
                  air_brake: bool = False) -> TrainState:
    m = TrainState(step=i * 10, time=rows['time'][i], location=rows['location'][i], speed=rows['speed'][i])
    m.notch, m.brake_notch = [max(rows['notch'][i], 0.0)] * locos, [max(-rows['notch'][i], 0.0)] * locos
    m.traction, m.speed_limit = [rows['traction'][i]] * locos, 80.0 / 3.6
    count = couplers.shape[1] + 1
    m.vehicle_location = list(rows['location'][i] - 15.0 * np.arange(count))
    m.vehicle_speed = [rows['speed'][i]] * count
    m.coupler_force = list(couplers[i])
    if air_brake:  # the pipe is empty after 2 s, 250 m/s back; the locomotives have no shoes
        since = np.clip(rows['time'][i] - rows['brake_from'] - 15.0 * np.arange(count) / 250.0, 0.0, 2.0)
        m.pipe_pressure = list(5e5 - 2.5e5 * since)
        m.cylinder_pressure = list(1.9e5 * since * (np.arange(count) >= locos))
        m.shoe_force = [0.0] * count
    return m


def axle_columns(rows: Dict[str, np.ndarray]) -> Dict[str, np.ndarray]:
    """[row, axle] by field of AxleAdhesion: the front axles are lighter, creep rises with adhesion up to the limit."""
    axle = np.arange(AXLES)
    load = np.tile(LOCO_KG * 9.81 / AXLES * (1.0 + 0.02 * (axle - (AXLES - 1) / 2.0)), (len(rows['time']), 1))
    share = rows['traction'][:, None] / AXLES
    adhesion = share / load
    creep = np.copysign(np.minimum(SLIP_LIMIT, 0.7 * adhesion ** 2), adhesion)
    slip_mps = creep * rows['speed'][:, None]
    applied = share * WHEEL_RADIUS_M * np.ones(AXLES)
    taken = np.where(np.abs(creep) >= 0.05, np.copysign(1e3 * (1.0 + axle), creep), 0.0)
    return {'creep': creep, 'adhesion': adhesion, 'friction': 0.35 * (0.6 * np.exp(-0.275 * np.abs(slip_mps)) + 0.4),
            'static_friction': np.full_like(load, 0.35), 'normal_force': load, 'force': share * np.ones(AXLES),
            'torque_demanded': applied + taken, 'torque_applied': applied, 'controller_active': taken != 0.0,
            'frictional_power': share * slip_mps, 't_gamma': share * creep}


def adhesion_message(rows: Dict[str, np.ndarray], axles: Dict[str, np.ndarray], i: int, locomotive: int) -> Adhesion:
    m = Adhesion(location=rows['location'][i] - 22.0 * (locomotive - 1), speed=rows['speed'][i])
    m.axles = [AxleAdhesion(**{name: values[i, axle] for name, values in axles.items()}) for axle in range(AXLES)]
    return m


def add_contacts(m: Adhesion, i: int) -> None:
    """As of the model 3d: the left wheels press 1 kN a wheelset outward, the right ones 2 kN; the first right wheel has two
    contacts in rows 100 to 199, the last left one none from row 300 on."""
    for number, axle in enumerate(m.axles, start=1):
        axle.lateral_force_left, axle.lateral_force_right = -1e3 * number, 2e3 * number
        axle.vertical_force_left = 0.0 if number == AXLES and i >= 300 else 100e3
        axle.vertical_force_right = 80e3
        for right in (False, True):
            count = 2 if number == 1 and right and 100 <= i < 200 else int(right or axle.vertical_force_left > 0.0)
            m.contacts += [ContactAdhesion(axle=number, right=right, longitudinal_force=1e3, creep_x=-0.07,
                                           lateral_force=-2e3, creep_y=0.01)] * count


def poses_message(i: int, stamp: genpy.Time, locomotive: int) -> TFMessage:
    """As on straight track: every wheelset 1 mm farther to the left than the one ahead of it, the first one at i um."""
    message = TFMessage()
    for number in range(1, AXLES + 1):
        pose = TransformStamped(child_frame_id=f'loco_{locomotive}/wheelset_{number}')
        pose.header.frame_id, pose.header.stamp = f'loco_{locomotive}/base_link', stamp
        place = pose.transform.translation
        place.x, place.y, place.z = 10.0 - 3.0 * number, 1e-6 * i + 1e-3 * (number - 1), WHEEL_RADIUS_M
        message.transforms.append(pose)
    return message


def energy_message(rows: Dict[str, np.ndarray], i: int, mass_kg: float, locos: int) -> TrainEnergy:
    m = TrainEnergy()
    m.loco_energy_rail, m.loco_energy_rim = [rows['work'][i]] * locos, [rows['rim'][i]] * locos
    m.loco_energy_slip, m.loco_brake_rail = [rows['slipped'][i]] * locos, [rows['taken'][i]] * locos
    m.loco_recovered_rim = [rows['recovered'][i]] * locos
    supply_lists(rows, i, locos, m)
    m.brake_rail, m.recovered_rim, m.air_brake = sum(m.loco_brake_rail), sum(m.loco_recovered_rim), rows['air'][i]
    m.traction_rail, m.traction_rim, m.slip_loss = (sum(values) for values in
                                                    (m.loco_energy_rail, m.loco_energy_rim, m.loco_energy_slip))
    m.propulsion_resistance, m.curving_resistance = 0.94 * rows['resistance_work'][i], 0.06 * rows['resistance_work'][i]
    m.kinetic = mass_kg / 2.0 * (rows['speed'][i] ** 2 - rows['speed'][0] ** 2)
    m.residual = m.traction_rail - m.brake_rail - m.air_brake - rows['resistance_work'][i] - m.kinetic
    m.residual_relative = m.residual / m.traction_rail if m.traction_rail else 0.0
    return m


def supply_lists(rows: Dict[str, np.ndarray], i: int, locos: int, m: TrainEnergy) -> None:
    """As of SUPPLY: half of what comes from the motors is stored, half heats the resistors; the engine does the rest."""
    for name in (name for name in TrainEnergy.__slots__ if name.startswith('loco_') and not getattr(m, name)):
        setattr(m, name, [0.0] * locos)
    if not rows['supply']:
        return
    rim, recovered = rows['rim'][i], rows['recovered'][i]
    link = rim / 0.9
    shaft = link / 0.8
    m.loco_motored_loss, m.loco_generator, m.loco_generator_loss = [link - rim] * locos, [link] * locos, [shaft - link] * locos
    m.loco_fuel, m.loco_litres = [shaft / 0.4] * locos, [shaft / 0.4 / 36e6] * locos
    m.loco_engine_loss, m.loco_recovered_loss = [shaft / 0.4 - shaft] * locos, [0.1 * recovered] * locos
    m.loco_storage_in = m.loco_to_resistors = [0.45 * recovered] * locos
    m.loco_storage_loss = [0.05 * 0.45 * recovered] * locos
    m.loco_stored, m.loco_stored_start = [1e8 + 0.95 * 0.45 * recovered] * locos, [1e8] * locos


SUPPLY = ('{kind: diesel_storage, drivetrain_efficiency: 0.9, generator_efficiency: 0.8, engine: {rated_power_W: 4.6e6}, '
          'storage: {capacity_J: 1.8e9}}')


def write_bag(path: str, scenario: str = 'synthetic', locos: int = 3, wagons: int = 5, run_id: int = 1,
              resolved: Optional[str] = None, format_version: int = 4, rows_from: int = 0, with_wheels: Sequence[int] = (),
              period_s: float = PERIOD_S, contacts: bool = False, air_brake: bool = False, supply: bool = False,
              **simulation) -> Dict:
    """Writes a bag and returns what it holds: simulate()'s columns, the coupler forces and the axles' columns.

    @param air_brake   the train has one; it is applied as the motors' brakes are
    @param supply      the locomotives have SUPPLY
    @param with_wheels locomotives, from 1, that have an adhesion topic
    @param contacts    they tell of contacts, as the model 3d does, and every tenth row has the first one's wheelsets on /tf
    """
    rows = simulate(locos, wagons, period_s=period_s, **simulation)
    rows.update(brake_from=simulation.get('brake_from_s', 1e9), supply=supply)
    axles = axle_columns(rows)
    couplers = coupler_forces(rows['time'], rows['traction'], locos, wagons)
    configuration = RunConfiguration(format_version=format_version, build_id='test', run_id=run_id, scenario=scenario)
    configuration.resolved = RESOLVED % locals() if resolved is None else resolved
    if supply:
        configuration.resolved = configuration.resolved.replace('0.35}', f'0.35, supply: {SUPPLY}}}')
    mass = locos * LOCO_KG + wagons * WAGON_KG
    with rosbag.Bag(path, 'w') as bag:
        for i in range(rows_from, len(rows['time'])):
            stamp = genpy.Time(nsecs=10**9 + i * round(1e9 * period_s))  # stamps start at 1 s
            if i == rows_from:
                bag.write('/train/configuration', configuration, stamp)
            messages = [('/train/state', state_message(rows, i, couplers, locos, air_brake)),
                        ('/train/energy', energy_message(rows, i, mass, locos))]
            messages += [(f'/loco_{n}/adhesion', adhesion_message(rows, axles, i, n)) for n in with_wheels]
            for _, message in messages[2:] if contacts else ():
                add_contacts(message, i)
            if contacts and i % 10 == 0:
                bag.write('/tf', poses_message(i, stamp, with_wheels[0]), stamp)
            for topic, message in messages:
                message.header.stamp = stamp
                bag.write(topic, message, stamp)
    return dict(rows, coupler_force=couplers, axles=axles)


if __name__ == '__main__':
    write_bag(f'{sys.argv[1]}/1d.bag', 'paper_1d', wagons=105, run_id=1)
    write_bag(f'{sys.argv[1]}/2d.bag', 'paper_2d', wagons=105, run_id=2, limit_N=400e3, slip=0.075, with_wheels=(1, 2, 3))
    write_bag(f'{sys.argv[1]}/3d.bag', 'paper_3d', wagons=105, run_id=3, limit_N=416e3, slip=0.07, with_wheels=(1, 2, 3))

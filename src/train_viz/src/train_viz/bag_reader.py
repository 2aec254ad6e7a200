"""Reads what LTD wrote: a bag becomes a Run. The only file here that knows rosbag and the messages."""
import contextlib
import dataclasses
import os
import re
import struct
from typing import Dict, Iterator, List, Optional, Tuple

import genpy
import numpy as np
import rosbag
from train_msgs.msg import Adhesion as AdhesionMessage
from train_msgs.msg import RunConfiguration, TrainEnergy, TrainState

from train_viz.adhesion import AXLE_COLUMNS, Adhesion, Wheels
from train_viz.pose_reader import read_wheelsets
from train_viz.progress import Progress
from train_viz.row_store import RowStore, slot_width
from train_viz.run import ReportError, Run

FORMAT_VERSION = 4  # of the bag, as in RunConfiguration; with another one fields may mean something else

TOPICS = {
    '/train/configuration': RunConfiguration,
    '/train/state': TrainState,
    '/train/energy': TrainEnergy,
}
ACCOUNT_FIELDS = [name for name, kind in zip(TrainEnergy.__slots__, TrainEnergy._slot_types) if kind == 'float64']
LOCO_FIELDS = [name for name in TrainEnergy.__slots__ if name.startswith('loco_')]
ADHESION_TOPIC = re.compile(r'/loco_([1-9][0-9]*)/adhesion')  # locomotives are counted from 1 at the head
# Of AxleAdhesion, in the order of AXLE_COLUMNS
AXLE_FIELDS = ('creep', 'adhesion', 'friction', 'static_friction', 'normal_force', 'torque_demanded', 'torque_applied',
               'shoe_torque', 'controller_active', 'frictional_power', 't_gamma')
FIRST_STAMP_NS = 10**9  # of a run's start

# What rosbag raises on files that are damaged in one way or another.
UNREADABLE = (rosbag.ROSBagException, genpy.MessageException, struct.error, OSError, ValueError, KeyError, IndexError,
              EOFError)


def read_bag(path: str, locomotive: Optional[int] = None) -> Run:
    """Reads one bag.

    @param locomotive whose values the figures show, from 1 at the head; None: the leading one, and the wheels of the first
                      that has any
    @raise ReportError naming the file and what to do
    """
    with _opened(path) as bag:
        with_wheels = _check_topics(path, bag, locomotive)
        configuration = _read_configuration(path, bag)
        states, energies, wheels, count = _read_rows(path, bag, with_wheels)
        adhesion = _make_adhesion(path, with_wheels, wheels)
        if adhesion is not None and adhesion.wheels is not None:
            adhesion = dataclasses.replace(adhesion, wheelsets=read_wheelsets(bag, adhesion, configuration.resolved))
    run = _make_run(path, configuration, states, energies, count)
    count = run.traction_N.shape[1]
    if locomotive is not None and not 1 <= locomotive <= count:
        raise ReportError(f'{path}: no locomotive {locomotive}: the train has {count}, 1 is the leading one')
    return dataclasses.replace(run, locomotive=locomotive or 1, adhesion=adhesion)


def read_configuration(path: str) -> RunConfiguration:
    """What made a bag's run, without reading its rows; refuses what `read_bag` refuses before it reads them."""
    with _opened(path) as bag:
        _check_topics(path, bag, None)
        return _read_configuration(path, bag)


@contextlib.contextmanager
def _opened(path: str) -> Iterator[rosbag.Bag]:
    if not os.path.isfile(path):
        raise ReportError(f'{path}: no such file: check the path')
    if os.path.getsize(path) == 0:
        raise ReportError(f'{path}: empty file: the run was killed before it wrote anything, simulate again')
    try:
        with rosbag.Bag(path) as bag:
            yield bag
    except rosbag.ROSBagUnindexedException:
        raise ReportError(f'{path}: bag was never closed: wait for the end of the run, or repair a copy of it with '
                          f"'rosbag reindex'") from None
    except UNREADABLE as error:
        raise ReportError(f'{path}: not a readable bag ({_one_line(error)}): record or simulate it again') from None


def _one_line(error: BaseException) -> str:
    return ' '.join(str(error).split()) or type(error).__name__


def _check_topics(path: str, bag: rosbag.Bag, wanted: Optional[int]) -> Optional[int]:
    """Refuses bags without our topics, or with topics whose messages were defined differently.

    @return number of the first locomotive with an adhesion topic, of `wanted` if that is given, or None
    """
    types, topics = bag.get_type_and_topic_info()
    missing = [topic for topic in TOPICS if topic not in topics]
    if missing:
        raise ReportError(f'{path}: no messages on {", ".join(missing)}: give a telemetry bag written by LTD')
    with_wheels = {int(match[1]) for match in map(ADHESION_TOPIC.fullmatch, topics) if match}
    locomotive = min(with_wheels if wanted is None else with_wheels & {wanted}, default=None)
    adhesion = {} if locomotive is None else {_adhesion_topic(locomotive): AdhesionMessage}
    for topic, message in {**TOPICS, **adhesion}.items():
        name = topics[topic].msg_type
        if name != message._type or types[name] != message._md5sum:
            raise ReportError(f'{path}: {topic} has another definition of {message._type}: use the train_viz of the '
                              'build that wrote it')
    return locomotive


def _adhesion_topic(locomotive: int) -> str:
    return f'/loco_{locomotive}/adhesion'


def _read_configuration(path: str, bag: rosbag.Bag) -> RunConfiguration:
    configurations = [message for _, message, _ in bag.read_messages('/train/configuration')]
    versions = sorted({c.format_version for c in configurations} - {FORMAT_VERSION})
    if versions:
        raise ReportError(f'{path}: format_version {versions[0]}, this report reads {FORMAT_VERSION}: use the train_viz '
                          f'of the build that wrote it ({configurations[0].build_id or "build unknown"})')
    return configurations[0]


Rows = Dict[int, Tuple]  # by the stamp in nanoseconds


def _read_rows(path: str, bag: rosbag.Bag, locomotive: Optional[int]) -> Tuple[Rows, Rows, Rows, int]:
    """What we need of TrainState and TrainEnergy messages, and of one locomotive's Adhesion; of a long run not every one.

    Of thinned rows the coupler forces are those farthest from zero, and the wheels are those at the largest creep.
    @return with the number of TrainState messages
    """
    topics = ['/train/state', '/train/energy'] + ([] if locomotive is None else [_adhesion_topic(locomotive)])
    count = bag.get_message_count('/train/state')
    width_ns = slot_width(count, round(1e9 * (bag.get_end_time() - bag.get_start_time())))
    states, energies, wheels = (RowStore(FIRST_STAMP_NS, width_ns) for _ in range(3))
    for topic, m in _with_progress(path, bag, topics):
        stamp = m.header.stamp.to_nsec()
        if topic == '/train/state':
            row = _state_row(m)
            old = states.add(stamp, row)
            if old is not None and old[COUPLERS].shape == row[COUPLERS].shape:
                np.copyto(row[COUPLERS], old[COUPLERS], where=np.abs(old[COUPLERS]) > np.abs(row[COUPLERS]))
        elif topic == '/train/energy':
            energies.add(stamp, (np.array([getattr(m, name) for name in LOCO_FIELDS]),
                                 np.array([getattr(m, name) for name in ACCOUNT_FIELDS])))
        elif m.axles:
            wheels.add(stamp, (m.location, m.speed, [[getattr(axle, name) for name in AXLE_FIELDS] for axle in m.axles],
                               _wheel_values(m)), max(abs(axle.creep) for axle in m.axles) if width_ns > 1 else None)
    return states.rows(), energies.rows(), wheels.rows(), count


COUPLERS = 6  # of _state_row


def _state_row(m: TrainState) -> Tuple:
    return (m.time, m.location, m.speed, np.array(m.notch), np.array(m.brake_notch), np.array(m.traction),
            np.array(m.coupler_force), m.speed_limit, np.array(m.pipe_pressure), np.array(m.cylinder_pressure))


def _wheel_values(m: AdhesionMessage) -> List[List[List[float]]]:
    """By axle and side, left first: vertical and lateral force, T-gamma, number of contacts."""
    values = [[[axle.vertical_force_left, axle.lateral_force_left, 0.0, 0],
               [axle.vertical_force_right, axle.lateral_force_right, 0.0, 0]] for axle in m.axles]
    for c in m.contacts:
        wheel = values[c.axle - 1][int(c.right)]
        wheel[2] += abs(c.longitudinal_force * c.creep_x + c.lateral_force * c.creep_y)
        wheel[3] += 1
    return values


def _with_progress(path: str, bag: rosbag.Bag, topics: List[str]) -> Iterator[Tuple[str, genpy.Message]]:
    progress = Progress(f'report: reading {path}', bag.get_message_count(topics))
    for i, (topic, message, _) in enumerate(bag.read_messages(topics)):
        yield topic, message
        progress.tell(i)
    progress.close()


def _make_run(path: str, configuration: RunConfiguration, states: Rows, energies: Rows, count: int) -> Run:
    stamps = sorted(states.keys() & energies.keys())  # a cut bag may end between the two
    if len(stamps) < 2:
        raise ReportError(f'{path}: {len(stamps)} instant(s) with both /train/state and /train/energy, two are needed: '
                          'let the run go on for longer')
    try:
        s = [np.array(column) for column in zip(*(states[stamp] for stamp in stamps))]
        e = [np.array(column) for column in zip(*(energies[stamp] for stamp in stamps))]
    except ValueError:  # ragged
        raise ReportError(f'{path}: the number of vehicles changes within the bag: simulate again') from None
    if s[3].shape[1:] == (0,) or not s[3].shape == s[4].shape == s[5].shape == e[0][:, 0].shape:
        raise ReportError(f'{path}: no locomotive, or lists of locomotives that differ in length: simulate again')
    if s[8].shape != s[9].shape or s[8].shape[1] not in (0, s[6].shape[1] + 1):
        raise ReportError(f'{path}: brake pressures of another number of vehicles than the train has: simulate again')
    return Run(label=configuration.scenario, files=(path,), run_id=configuration.run_id,
               build_id=configuration.build_id, scenario=configuration.scenario, resolved=configuration.resolved,
               time_s=s[0], location_m=s[1], speed_mps=s[2], notch=s[3], brake_notch=s[4], traction_N=s[5],
               coupler_force_N=s[6], speed_limit_mps=s[7], pipe_pressure_Pa=s[8], cylinder_pressure_Pa=s[9],
               locos={name[len('loco_'):]: e[0][:, i] for i, name in enumerate(LOCO_FIELDS)},
               account={name: e[1][:, i] for i, name in enumerate(ACCOUNT_FIELDS)}, recorded=count)


def _make_adhesion(path: str, locomotive: Optional[int], wheels: Rows) -> Optional[Adhesion]:
    if not wheels:
        return None
    stamps = sorted(wheels)
    try:
        location_m, speed_mps, axles, sides = (np.array(column, dtype=float)
                                               for column in zip(*(wheels[s] for s in stamps)))
    except ValueError:  # ragged
        raise ReportError(f'{path}: the number of axles of locomotive {locomotive} changes within the bag: '
                          'simulate again') from None
    return Adhesion(locomotive=locomotive, time_s=(np.array(stamps) - FIRST_STAMP_NS) / 1e9, location_m=location_m,
                    speed_mps=speed_mps, **{name: axles[:, :, i] for i, name in enumerate(AXLE_COLUMNS)},
                    wheels=Wheels(*np.moveaxis(sides, -1, 0)) if sides[..., 3].any() else None)  # 2d reports no contacts

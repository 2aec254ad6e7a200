#!/usr/bin/env python3
"""What rviz would draw at any moment: the newest frames of /tf and the newest markers, and how far apart they put things.

As a program, while a train is shown: seen_together.py SECONDS prints the largest distances."""

import random
import sys
import threading
import time

import numpy
import rospy
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray


def matrix(translation, q):
    """A pose as a matrix of 4 by 4."""
    x, y, z, w = q.x, q.y, q.z, q.w
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), translation.x],
                        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), translation.y],
                        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), translation.z],
                        [0.0, 0.0, 0.0, 1.0]])


class Picture:
    """Keeps what came last. Markers stay packed until they are looked at: 20 arrays of 430 a second are too much."""

    def __init__(self, locomotive=1):
        self.base, self.frames, self.packed = f'loco_{locomotive}/', {}, None
        self.lock, self.now = threading.Lock(), rospy.Time()
        for topic in ('/tf', '/tf_static'):
            rospy.Subscriber(topic, TFMessage, self.take_frames, tcp_nodelay=True)
        rospy.Subscriber('/clock', Clock, self.take_clock, tcp_nodelay=True)
        rospy.Subscriber('/train_markers/train', rospy.AnyMsg, self.take_markers, tcp_nodelay=True)

    def take_clock(self, msg):
        """Forgets what was there, as rviz does, when time goes back: another run, or the bag again."""
        with self.lock:
            if msg.clock < self.now:
                self.frames = {frame: step for frame, step in self.frames.items() if frame == 'chosen_locomotive'}
                self.packed = None
            self.now = msg.clock

    def take_frames(self, msg):
        with self.lock:
            for t in msg.transforms:
                self.frames[t.child_frame_id] = (t.header.frame_id, matrix(t.transform.translation, t.transform.rotation))

    def take_markers(self, msg):
        with self.lock:
            self.packed = (msg._buff, dict(self.frames))

    def look(self):
        """One instant: the frames, and the markers with the frames that were there when they came."""
        with self.lock:
            return dict(self.frames), self.packed

    @staticmethod
    def in_map(frames, frame):
        pose = numpy.eye(4)
        while frame != 'map':
            frame, step = frames[frame]
            pose = step @ pose
        return pose

    def place(self, marker, frames, at_arrival):
        """Where a marker's middle is drawn; only a locked one follows its frame."""
        carrier = self.in_map(frames if marker.frame_locked else at_arrival, marker.header.frame_id)
        return (carrier @ matrix(marker.pose.position, marker.pose.orientation))[:3, 3]

    def distances(self):
        """Of the first locomotive's axles from their wheelsets' frames, of its box and of the camera from its car body's
        frame; and by how much the first wagon is nearer or farther than half the lengths of both, all in plan [m]."""
        frames, packed = self.look()
        if packed is None or not {self.base + 'wheelset_1', 'chosen_locomotive', 'train'} <= set(frames):
            return None
        buffer, at_arrival = packed
        markers = MarkerArray().deserialize(buffer).markers
        by_name = {(m.ns, m.id): self.place(m, frames, at_arrival) for m in markers
                   if m.action == Marker.ADD and m.type in (Marker.CUBE, Marker.CYLINDER)}
        axles = [by_name['chosen_wheels', 3 * i] for i in range(6)]  # an axle and two wheels each
        wheelsets = [self.in_map(frames, f'{self.base}wheelset_{i + 1}')[:3, 3] for i in range(6)]
        car_body = self.in_map(frames, self.base + 'car_body')[:3, 3]
        camera = self.in_map(frames, 'chosen_locomotive')[:3, 3]
        far = [by_name['bodies', i] for i in (2, 3)]
        return {'wheel from wheelset': max(numpy.linalg.norm((a - b)[:2]) for a, b in zip(axles, wheelsets)),
                'box from car body': numpy.linalg.norm((by_name['bodies', 0] - car_body)[:2]),
                'camera from car body': numpy.linalg.norm((camera - car_body)[:2]),
                'gap of locomotive 3 and wagon': abs(numpy.linalg.norm(far[0] - far[1]) - 18.5)}


def largest(picture, seconds):
    """Looks at random moments; the largest of each distance, and how often it looked."""
    found, looks, end = {}, 0, time.monotonic() + seconds
    while time.monotonic() < end:
        time.sleep(random.uniform(0.0, 0.05))
        for name, value in (picture.distances() or {}).items():
            found[name] = max(found.get(name, 0.0), value)
            looks += name == 'wheel from wheelset'
    return found, looks


if __name__ == '__main__':
    rospy.init_node('seen_together', anonymous=True, disable_rostime=True)
    values, count = largest(Picture(), float(sys.argv[1]))
    print(f'looks: {count}')
    for name, value in values.items():
        print(f'{name}: {value:.3f} m')

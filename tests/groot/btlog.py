"""Reads logs and trees of BehaviorTree.CPP, independently of proskill."""

import struct
import xml.etree.ElementTree

MAGIC = b"BTCPP4-FileLogger2\x01"
IDLE, RUNNING, SUCCESS, FAILURE, SKIPPED = range(5)


class Tree:
    """The nodes of a tree: by uid, their elements."""

    def __init__(self, text):
        root = xml.etree.ElementTree.fromstring(text)
        assert root.get("BTCPP_format") == "4"
        self.name = root.get("main_tree_to_execute")
        self.trees = {it.get("_fullpath"): it for it in root.iter("BehaviorTree")}
        self.models = {it.get("ID"): it.tag for it in root.find("TreeNodesModel")}
        self.nodes = {int(it.get("_uid")): it for tree in self.trees.values() for it in tree.iter() if it.get("_uid")}

    def tagged(self, tag):
        """The uids of a skill's calls."""
        return [uid for uid, it in self.nodes.items() if it.tag == tag or it.tag == "SubTree" and it.get("ID") == tag]


def changes(data):
    """Changes of 9 bytes each: time in microseconds, uid, status."""
    assert len(data) % 9 == 0, len(data)
    for at in range(0, len(data), 9):
        low, high, uid, status = struct.unpack_from("<IHHB", data, at)
        yield low + (high << 32), uid, status


def read(data):
    """\\return tree, start in microseconds, changes"""
    assert data.startswith(MAGIC)
    at = len(MAGIC)
    (size,) = struct.unpack_from("<i", data, at)
    text = data[at + 4:at + 4 + size]
    (start,) = struct.unpack_from("<q", data, at + 4 + size)
    return Tree(text), start, list(changes(data[at + 12 + size:]))


def replay(tree, steps):
    """The last status of each node."""
    last = dict.fromkeys(tree.nodes, IDLE)
    for _, uid, status in steps:
        assert last[uid] != status, f"{uid} is {status} twice"
        last[uid] = status
    return last

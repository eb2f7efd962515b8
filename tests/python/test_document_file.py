"""A FreeCAD document as a file, before FreeCAD opens it."""
import zipfile

import pytest
from advlayers import document_file
from advlayers.errors import InputError


@pytest.fixture
def write(tmp_path):
    def make(kind=zipfile.ZIP_DEFLATED, **members):
        path = tmp_path / "a.FCStd"
        with zipfile.ZipFile(path, "w", kind) as archive:
            for name, text in members.items():
                archive.writestr(name, text)
        return str(path)
    return make


GOOD = {"Document.xml": "<Document/>", "Part.brp": "some shape " * 1000}


def refused(path, words):
    with pytest.raises(InputError, match=words):
        document_file.check(path)


def test_a_sound_one_passes(write):
    document_file.check(write(**GOOD))


def test_every_cut_is_seen(write):
    path = write(**GOOD)
    data = open(path, "rb").read()
    for length in range(len(data)):
        open(path, "wb").write(data[:length])
        refused(path, "a.FCStd")


def test_a_changed_byte_of_a_member_is_seen(write):
    path = write(zipfile.ZIP_STORED, **{**GOOD, "Part.brp": "some shape"})
    data = bytearray(open(path, "rb").read())
    with zipfile.ZipFile(path) as archive:
        member = archive.getinfo("Part.brp")
        begin = member.header_offset + 30 + len("Part.brp")
        places = range(begin, begin + member.compress_size)
    for place in places:
        spoilt = bytearray(data)
        spoilt[place] ^= 0x10
        open(path, "wb").write(spoilt)
        refused(path, "a.FCStd")


def test_no_member_leaves_the_archive(write):
    refused(write(**GOOD, **{"../../outside": ""}), "outside")
    refused(write(**GOOD, **{"/tmp/outside": ""}), "outside")


def test_it_must_be_a_document(write):
    refused(write(**{"Part.brp": "shape"}), "Document.xml")


def test_it_must_not_expand_without_end(write, monkeypatch):
    monkeypatch.setattr(document_file, "_LEAST_EXPANDED", 1000)
    refused(write(**GOOD, bomb="0" * 10 ** 6), "expands")

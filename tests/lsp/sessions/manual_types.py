"""The types of a manual's TypeScript, and whether a value is of one of them: every member that is written down is there, and
no other. Enough of the language for docs/lsp.md."""

import re

WORDS = re.compile(r"//[^\n]*|\s+|('[^']*'|\w+|[{}\[\]():;?|,])")
BASIC = {'string': str, 'number': (int, float), 'boolean': bool}
PROTOCOL = '''
interface Position { line: number; character: number }
interface Range { start: Position; end: Position }
interface Location { uri: string; range: Range }
interface TextDocumentIdentifier { uri: string }
interface TextVersion { uri: string; version: number | null }
'''


class Reader:
    def __init__(self, text):
        self.words = [word for word in (match.group(1) for match in WORDS.finditer(text)) if word]
        self.at = 0

    def peek(self):
        return self.words[self.at] if self.at < len(self.words) else None

    def take(self, wanted=None):
        word = self.words[self.at]
        assert wanted in (None, word), (wanted, self.words[self.at - 5:self.at + 5])
        self.at += 1
        return word

    def took(self, word):
        if self.peek() != word:
            return False
        self.at += 1
        return True

    def interfaces(self):
        found = {}
        while self.peek() == 'interface':
            self.take()
            name = self.take()
            base = self.take() if self.took('extends') else None
            found[name] = (base, self.members())
        assert self.peek() is None, self.words[self.at:]
        return found

    def members(self):
        """By name: whether it is optional, and its type; the type of any other name under `*`."""
        result = {}
        self.take('{')
        while not self.took('}'):
            if self.took('['):
                self.take(), self.take(':'), self.take('string'), self.take(']')
                name, optional = '*', True
            else:
                name, optional = self.take(), self.took('?')
            self.take(':')
            result[name] = (optional, self.type())
            self.took(';')
        return result

    def type(self):
        self.took('|')
        either = [self.list()]
        while self.took('|'):
            either.append(self.list())
        return ('either', either) if len(either) > 1 else either[0]

    def list(self):
        kind = ('members', self.members()) if self.peek() == '{' else ('named', self.take())
        while self.took('['):
            self.take(']')
            kind = ('list', kind)
        return kind


class Types:
    def __init__(self, manual):
        blocks = re.findall(r'```ts\n(.*?)```', manual, re.S)
        self.interfaces = Reader(PROTOCOL + '\n'.join(blocks)).interfaces()
        self.seen = set()  # members that some value had, as `Step.description`

    def members(self, name):
        base, own = self.interfaces[name]
        return {**(self.members(base) if base else {}), **own}

    def unseen(self, name):
        """The members of a type, and of all that it is made of, that must be there and that no value had."""
        found = set()
        self.walk(name, ('members', self.members(name)), found)
        return sorted(found - self.seen)

    def walk(self, place, kind, found):
        if kind[0] == 'members':
            for name, (optional, of) in kind[1].items():
                if optional:
                    continue
                found.add(f'{place}.{name}')
                self.walk(f'{place}.{name}', of, found)
        elif kind[0] == 'named' and kind[1] in self.interfaces:
            self.walk(kind[1], ('members', self.members(kind[1])), found)
        elif kind[0] == 'list':
            self.walk(place, kind[1], found)
        elif kind[0] == 'either':
            for each in kind[1]:
                self.walk(place, each, found)

    def check(self, value, name):
        wrong = self.wrong(value, ('named', name), name)
        assert not wrong, wrong

    def wrong(self, value, kind, place):
        """The errors in a value; empty if there are none."""
        form, of = kind
        if form == 'either':
            found = [self.wrong(value, each, place) for each in of]
            return '' if '' in found else '; '.join(found)
        if form == 'list':
            if not isinstance(value, list):
                return f'{place} is no list: {value!r}'
            return next((wrong for each in value if (wrong := self.wrong(each, of, place))), '')
        if form == 'members':
            return self.wrong_members(value, of, place)
        if of in self.interfaces:
            return self.wrong_members(value, self.members(of), of)
        if of.startswith("'"):
            return '' if value == of[1:-1] else f'{place} is not {of}: {value!r}'
        if of == 'null':
            return '' if value is None else f'{place} is not null: {value!r}'
        fits = isinstance(value, BASIC[of]) and (of == 'boolean' or not isinstance(value, bool))
        return '' if fits else f'{place} is no {of}: {value!r}'

    def wrong_members(self, value, members, place):
        if not isinstance(value, dict):
            return f'{place} has no members: {value!r}'
        for name, (optional, of) in members.items():
            if name != '*' and name not in value and not optional:
                return f'{place} lacks `{name}`: {sorted(value)}'
        for name, each in value.items():
            of = members.get(name) or members.get('*')
            if not of:
                return f'{place} has a member `{name}` that is not written down'
            known = name if name in members else '*'
            self.seen.add(f'{place}.{known}')
            if wrong := self.wrong(each, of[1], f'{place}.{known}'):
                return wrong
        return ''

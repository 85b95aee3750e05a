export type TokenKind = 'plain' | 'comment' | 'string' | 'number' | 'keyword' | 'form' | 'parameter' | 'paren';
export interface Token {
  text: string;
  kind: TokenKind;
}

const forms = new Set(
  'defconst defsv defevent defskill defresource defproperty defenvironment defplatform include if case while do do-until break label goto race set printf success failure emit choose elseif else until'.split(' '),
);
const pattern = /;.*|"(?:\\.|[^"\\\n])*"?|:[A-Za-z_]\w*|\$[A-Za-z_]\w*|-?\d+(?:\.\d+)?|[A-Za-z_][\w.-]*|[()[\]]|\s+|./gsu;

function kindOf(text: string, afterParen: boolean): TokenKind {
  const first = text[0]!;
  if (first === ';') return 'comment';
  if (first === '"') return 'string';
  if (first === ':' && text.length > 1) return 'keyword';
  if (first === '$') return 'parameter';
  if (/^-?\d/.test(text)) return 'number';
  if ('()[]'.includes(first)) return 'paren';
  const isForm = forms.has(text) && (afterParen || text === 'else' || text === 'elseif' || text === 'until' || text === 'break');
  return isForm ? 'form' : 'plain';
}

/** The tokens of a line. Simpler than the grammar that editors use. */
export function highlight(text: string): Token[][] {
  return text.split(/\r?\n/).map((line) => {
    const out: Token[] = [];
    let afterParen = false;
    for (const [token] of line.matchAll(pattern)) {
      const kind = kindOf(token, afterParen);
      const last = out.at(-1);
      if (last && last.kind === kind) last.text += token;
      else out.push({ text: token, kind });
      afterParen = token === '(';
    }
    return out;
  });
}

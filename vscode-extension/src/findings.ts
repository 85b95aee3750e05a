import type { panel } from './protocol';

export interface Findings {
  errors: number;
  warnings: number;
  inconclusive: number;
}

/** The findings, in the words of the command line: `1 bad, 9 warnings`; empty if there are none. */
export function inWords({ errors, warnings, inconclusive }: Findings): string {
  return [errors && `${errors} bad`, warnings && `${warnings} warning${warnings === 1 ? '' : 's'}`, inconclusive && `${inconclusive} inconclusive`]
    .filter((part) => part).join(', ');
}

export function count(verdicts: panel.Verdict[]): Findings {
  const open = verdicts.filter(({ verdict, pending }) => verdict === 'inconclusive' && !pending).length;
  const bad = verdicts.filter(({ good, verdict }) => !good && verdict !== 'inconclusive');
  const errors = bad.filter(({ severity }) => severity === 'error').length;
  return { errors, warnings: bad.length - errors, inconclusive: open };
}

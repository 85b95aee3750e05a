/** Light or dark: as VS Code's theme says, else as the user chose here, else as the system does. */
type Theme = 'light' | 'dark';

const system = (): MediaQueryList => matchMedia('(prefers-color-scheme: dark)');
let chosen: Theme | null = null;

export const inVsCode = (): boolean => !!document.body.dataset['vscodeThemeKind'];

export function isDark(): boolean {
  const kind = document.body.dataset['vscodeThemeKind'];
  if (kind) return kind === 'vscode-dark' || kind === 'vscode-high-contrast';
  return chosen ? chosen === 'dark' : system().matches;
}

/** The style sheets look at this alone. */
function apply(): void {
  document.documentElement.dataset['theme'] = isDark() ? 'dark' : 'light';
}

/** From light to dark and back; where that is what the system says, it is followed again. */
export function switchTheme(): void {
  const dark = !isDark();
  chosen = dark === system().matches ? null : dark ? 'dark' : 'light';
  apply();
}

/** Begins to follow the theme, and tells of each change. */
export function followTheme(changed: () => void): void {
  apply();
  system().addEventListener('change', apply);
  new MutationObserver(apply).observe(document.body, { attributeFilter: ['data-vscode-theme-kind'] });
  let before = isDark();
  new MutationObserver(() => {
    if (isDark() === before) return;
    before = isDark();
    changed();
  }).observe(document.documentElement, { attributeFilter: ['data-theme'] });
}

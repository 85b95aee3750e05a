/** Light or dark: the theme of VS Code, else the user's choice, else the setting of the system. */
type Theme = 'light' | 'dark';

const system = (): MediaQueryList => matchMedia('(prefers-color-scheme: dark)');
let chosen: Theme | null = null;

export const inVsCode = (): boolean => !!document.body.dataset['vscodeThemeKind'];

export function isDark(): boolean {
  const kind = document.body.dataset['vscodeThemeKind'];
  if (kind) return kind === 'vscode-dark' || kind === 'vscode-high-contrast';
  return chosen ? chosen === 'dark' : system().matches;
}

/** The only attribute that the style sheets use. */
function apply(): void {
  document.documentElement.dataset['theme'] = isDark() ? 'dark' : 'light';
}

/** Toggles light and dark; if the result equals the system's setting, that is followed again. */
export function switchTheme(): void {
  const dark = !isDark();
  chosen = dark === system().matches ? null : dark ? 'dark' : 'light';
  apply();
}

/** Follows the theme, and reports each change. */
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

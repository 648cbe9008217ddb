// The browsers of the distribution, and pages in them as users open them: with every rule of the page's own security policy.
//
// What differs from a user's browser: as root, Chromium runs without its sandbox. Without a graphics card, Chromium draws by
// SwiftShader, which it does not use unless asked. Firefox draws by Mesa, for which it needs a display: Xvfb is one without a screen.
import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import playwright from 'playwright-core';

const kChromium = process.env.CHROMIUM ?? '/usr/bin/chromium', kFirefox = process.env.FIREFOX ?? '/usr/bin/firefox-esr';
const kXvfb = '/usr/bin/Xvfb';
const kSoftware = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
export const kNoDrawing = ['--disable-3d-apis'];

/** What is missing, in words, or null. */
export function find_missing() {
  const missing = [kChromium, kFirefox, kXvfb].filter((path) => !existsSync(path));
  return missing.length ? `no ${missing.join(', no ')} (apt-get install chromium firefox-esr xvfb; CHROMIUM and FIREFOX name others)` : null;
}

export function launch_chromium(drawing = kSoftware) {
  const as_root = process.getuid() === 0 ? ['--no-sandbox'] : [];
  return playwright.chromium.launch({ executablePath: kChromium, chromiumSandbox: !as_root.length, args: [...as_root, ...drawing] });
}

// The number of the display comes through the descriptor 3.
async function start_display() {
  const server = spawn(kXvfb, ['-displayfd', '3', '-screen', '0', '1600x1200x24', '-nolisten', 'tcp'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
  const number = await new Promise((done, fail) => {
    server.stdio[3].once('data', (data) => done(String(data).trim()));
    server.once('exit', (code) => fail(new Error(`Xvfb ended with ${code}`)));
  });
  return { name: `:${number}`, stop: () => server.kill() };
}

async function launch_firefox() {
  const display = await start_display();
  // The protocol's client turns this rule off, which keeps pages of a disk apart; users have it.
  const firefoxUserPrefs = { 'security.fileuri.strict_origin_policy': true };
  const env = { ...process.env, DISPLAY: display.name, MOZ_ENABLE_WAYLAND: '0' };
  try {
    const browser = await playwright._bidiFirefox.launch({ executablePath: kFirefox, headless: false, env, firefoxUserPrefs });
    browser.on('disconnected', display.stop);
    return browser;
  } catch (error) {
    display.stop();
    throw error;
  }
}

export const launchers = { Chromium: () => launch_chromium(), Firefox: launch_firefox };

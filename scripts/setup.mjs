// SPDX-License-Identifier: GPL-3.0-or-later
// Installs what the project needs and this machine lacks: Debian packages, and the npm packages of the lock file.
// Plain Node: it runs before anything is installed.
import { spawnSync } from 'node:child_process'
import { createHash } from 'node:crypto'
import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { isMain, main, ROOT, run } from './run.mjs'

/**
 * The purposes of an installation. Each includes all before it and names its Debian packages and the C++ libraries in
 * them.
 */
const PURPOSES = {
  page: {
    packages: [
      'emscripten',
      'cmake',
      'ninja-build',
      'g++',
      'libeigen3-dev',
      'libcli11-dev',
      'libdragonbox-dev',
      'libfast-float-dev',
      'librange-v3-dev',
      'mandoc',
    ],
    libraries: ['Eigen 3.4', 'CLI11', 'Dragonbox', 'fast_float', 'range-v3'],
  },
  tests: {
    packages: [
      'clang',
      'clang-format',
      'gcovr',
      'libboost-dev',
      'libcgal-dev',
      'libgtest-dev',
      'libbenchmark-dev',
      'libgmp-dev',
      'libmpfr-dev',
      'librsvg2-bin',
      'mkdocs',
      'mypy',
      'nlohmann-json3-dev',
      'pkgconf',
      'pybind11-dev',
      'python3-dev',
      'python3-distributed',
      'python3-geopandas',
      'python3-matplotlib',
      'python3-pybind11',
      'python3-pytest',
      'python3-scipy',
      'python3-shapely',
      'python3-skbuild',
      'python3-venv',
    ],
    libraries: ['CGAL 5.5', 'Boost', 'GMP', 'MPFR', 'GoogleTest', 'Google Benchmark', 'nlohmann/json', 'pybind11'],
  },
}

/** Names of the same packages on systems where this script installs nothing. */
const ELSEWHERE = {
  fedora: {
    install: 'sudo dnf install',
    page: 'emscripten cmake ninja-build gcc-c++ eigen3-devel cli11-devel fast_float-devel range-v3-devel mandoc',
    tests:
      'clang clang-tools-extra gcovr boost-devel CGAL-devel gtest-devel google-benchmark-devel gmp-devel mpfr-devel ' +
      'librsvg2-tools mkdocs json-devel pkgconf pybind11-devel python3-devel python3-mypy python3-geopandas ' +
      'python3-matplotlib python3-pytest python3-scipy python3-shapely chromium firefox xorg-x11-server-Xvfb',
  },
  darwin: {
    install: 'brew install',
    page: 'emscripten cmake ninja eigen cli11 fast_float range-v3 mandoc',
    tests:
      'clang-format gcovr boost cgal googletest google-benchmark gmp mpfr librsvg mkdocs nlohmann-json pkgconf pybind11 ' +
      'mypy chromium firefox',
  },
}

/** The browsers for tests and their tools: programs, Debian packages, and names. */
const BROWSERS = [
  [chromiumPath(), 'chromium', 'Chromium (set CHROMIUM_PATH to its program)'],
  [
    chromiumShellPath(),
    'chromium-headless-shell',
    'the headless shell of Chromium (set CHROMIUM_SHELL_PATH to its program, or to Chromium)',
  ],
  [process.env.FIREFOX_PATH ?? '/usr/bin/firefox-esr', 'firefox-esr', 'Firefox (set FIREFOX_PATH to its program)'],
  ['/usr/bin/WebKitWebDriver', 'webkit2gtk-driver', 'WebKitGTK and its WebDriver (WebKitWebDriver)'],
  ['/usr/bin/Xvfb', 'xvfb', 'a screen in memory (Xvfb)'],
]

/**
 * Installs packages. `purpose` is `page` (everything in WebAssembly) or `tests` (the native build and all tests).
 * `meanwhile` runs during the download of npm packages, once the system's packages are installed.
 */
export async function setup(purpose, meanwhile) {
  const tests = purpose === 'tests'
  const wanted = tests ? Object.values(PURPOSES) : [PURPOSES.page]
  const browsers = tests ? BROWSERS.filter(([program]) => !existsSync(program)) : []
  const system = systemOf()
  if (system === 'debian' || system === 'ubuntu') {
    const packages = wanted.flatMap((part) => part.packages)
    // Ubuntu has no browsers under these names, or others.
    const own = system === 'debian' ? browsers : browsers.filter(([, name]) => /^(xvfb|webkit2gtk-driver)$/.test(name))
    await installDebianPackages([...packages.filter((name) => !isInstalled(name)), ...own.map(([, name]) => name)])
    const others = browsers.filter((browser) => !own.includes(browser))
    if (others.length > 0) throw new Error(`Install for the tests:\n${listed(others)}`)
  } else {
    checkOtherSystem(
      system,
      purpose,
      wanted.flatMap((part) => part.libraries),
      browsers,
    )
  }
  await Promise.all([installNpmPackages(), meanwhile?.()])
}

/** The path of Chromium for tests. */
export function chromiumPath() {
  return process.env.CHROMIUM_PATH ?? '/usr/bin/chromium'
}

/** The headless shell of Chromium, for tests of a page alone. Chromium itself can take its place. */
export function chromiumShellPath() {
  return process.env.CHROMIUM_SHELL_PATH ?? process.env.CHROMIUM_PATH ?? '/usr/bin/chromium-headless-shell'
}

/** Returns `debian` (12 or later), `ubuntu` (24.04 or later), `fedora`, `darwin`, or `undefined` for other systems. */
function systemOf() {
  if (process.platform === 'darwin') return 'darwin'
  if (!existsSync('/etc/os-release')) return undefined
  const release = readFileSync('/etc/os-release', 'utf8')
  // The testing branch of Debian has no number.
  const version = Number(/^VERSION_ID="?(\d+)/m.exec(release)?.[1] ?? Infinity)
  const id = /^ID="?(\w+)/m.exec(release)?.[1] ?? ''
  const first = { debian: 12, ubuntu: 24, fedora: 0 }[id]
  return version >= first ? id : undefined
}

function listed(browsers) {
  return browsers.map(([, , what]) => `  ${what}`).join('\n')
}

function isInstalled(name) {
  const query = spawnSync('dpkg-query', ['--status', name], { encoding: 'utf8' })
  return /^Status: install ok installed$/m.test(query.stdout)
}

async function installDebianPackages(missing) {
  if (missing.length === 0) return
  const install = ['apt-get', 'install', '-y', '--no-install-recommends', ...missing]
  const privilege = process.getuid() === 0 ? [] : ['sudo']
  if (privilege.length > 0 && spawnSync('sudo', ['-n', 'true']).status !== 0) {
    throw new Error(
      `These packages are missing. Install them, then run the same command again:\n  sudo ${install.join(' ')}`,
    )
  }
  console.log(`Installing Debian packages: ${missing.join(' ')}`)
  const [program, ...before] = [...privilege, 'env', 'DEBIAN_FRONTEND=noninteractive']
  await run(program, [...before, 'apt-get', 'update', '-q'])
  await run(program, [...before, ...install, '-q'])
}

/** On other systems, lists what is missing and changes nothing. */
function checkOtherSystem(system, purpose, libraries, missingBrowsers) {
  const tests = purpose === 'tests'
  const missing = Object.entries({
    emcmake: 'Emscripten 3.1.6 or later',
    cmake: 'CMake 3.25 or later',
    ninja: 'Ninja',
    mandoc: 'mandoc',
    ...(tests && { 'c++': 'a C++20 compiler', 'clang-format': 'clang-format 14' }),
  })
    .filter(([program]) => spawnSync(program, ['--version']).error !== undefined)
    .map(([program, what]) => `  ${what} (${program})`)
  if (missingBrowsers.length > 0) missing.push(listed(missingBrowsers))
  if (missing.length > 0) {
    const { install, ...packages } = ELSEWHERE[system] ?? {}
    const names = tests ? `${packages.page} ${packages.tests}` : packages.page
    const command = install === undefined ? '' : `\nMost of them: ${install} ${names}`
    throw new Error(
      `This script installs packages on Debian 12, Ubuntu 24.04 and later versions only. Install on this system:\n${missing.join('\n')}\n` +
        `and the C++ libraries ${libraries.join(', ')}, then run the same command again.${command}`,
    )
  }
}

/** Installs the packages of the lock file in a folder. */
async function installNpmPackages() {
  const lock = createHash('sha256')
    .update(readFileSync(`${ROOT}package-lock.json`))
    .digest('hex')
  const stamp = `${ROOT}node_modules/.installed-lock`
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === lock) return
  console.log('Installing npm packages')
  await run('npm', ['ci', '--no-audit', '--no-fund'])
  writeFileSync(stamp, lock)
}

if (isMain(import.meta.url)) await main(() => setup(process.argv[2] ?? 'tests'))

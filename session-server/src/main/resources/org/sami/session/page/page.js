// @ts-check
// The page: who joins, the strip with the fleet stop, the map, and the lists in tabs.
import {Chart} from './chart.js';
import {DecisionForm} from './decisions.js';
import {byId, duration, element, hold, isPressed} from './dom.js';
import {Link} from './link.js';
import * as panels from './panels.js';

const THEMES = ['light', 'dark', 'sun'];
const TABS = /** @type {const} */ (['decisions', 'boats', 'missions', 'messages', 'alarms']);
const WORDS = {decisions: 'Decisions', boats: 'Boats', missions: 'Missions', messages: 'Messages', alarms: 'Alarms'};

/** @type {typeof TABS[number]} */
let tab = 'decisions';
/** @type {string | null} */
let selected = null;
/** @type {DecisionForm | null} */
let form = null;
/** @type {Chart | null} */
let chart = null;
let tabbed = ''; // what the tabs were made of
let shown = ''; // what the panel was made of

const link = new Link({changed: () => refresh(), refused: (why) => showLogin(why), news: (text) => say(text, false)});

const actions = {
  /** @param {any} decision */
  open: (decision) => {
    back();
    form = new DecisionForm(decision, link, /** @type {Chart} */ (chart), {say, back: () => {
      back();
      refresh(true);
    }, resized: () => chart?.resized()});
    document.body.classList.add('open');
    refresh(true);
  },
  /** @param {any} command */
  command: async (command) => {
    const reply = await link.ask(command);
    say([reply.text, ...(reply.warnings ?? [])].filter(Boolean).join(' ') || 'Done', reply.t === 'refused');
  },
  /** @param {string} boat */
  select: (boat) => {
    selected = selected === boat ? null : boat;
    refresh(true);
  },
  selected: () => selected,
};

/** @param {string} text @param {boolean} isFault */
function say(text, isFault) {
  const notice = byId('notice');
  notice.textContent = text;
  notice.className = isFault ? 'fault' : '';
  notice.hidden = false;
  clearTimeout(say.timer);
  say.timer = window.setTimeout(() => (notice.hidden = true), isFault ? 10000 : 5000);
}
say.timer = 0;

/** @param {string} why */
function showLogin(why) {
  byId('session').hidden = true;
  byId('login').hidden = false;
  byId('login-fault').textContent = why;
  sessionStorage.removeItem('key');
}

function join() {
  byId('login').hidden = true;
  byId('session').hidden = false;
  chart ??= new Chart((boat) => {
    tab = 'boats';
    back();
    document.body.classList.add('open');
    actions.select(boat);
  });
  chart.resized();
  link.join(sessionStorage.getItem('name') ?? '', sessionStorage.getItem('key') ?? '');
}

function strip() {
  const fleet = link.all('fleet')[0];
  const age = Date.now() - link.heardAt;
  const robots = link.welcome?.robots ?? 'boat';
  const state = link.isOpen
    ? link.all('boats').filter((boat) => boat.link === 'linked').length + ' of ' + (fleet?.boats ?? 0) + ' ' + robots + 's · ' + link.welcome.name + ' (' + link.welcome.role + ')'
    : link.heardAt > 0 ? 'Last seen ' + new Date(link.heardAt).toLocaleTimeString([], {hour: '2-digit', minute: '2-digit'}) + ', ' + duration(age) + ' ago' : 'Connecting…';
  byId('state').textContent = state;
  byId('strip').classList.toggle('lost', !link.isOpen);
  const words = fleet?.stopped ? [fleet.words, fleet.advice].filter(Boolean).join('. ') : '';
  byId('stopped-words').textContent = words;
  byId('stopped').hidden = words === '';
  byId('release').hidden = !link.may('press');
}

function tabs() {
  const counts = {
    decisions: link.all('decisions').length,
    boats: 0,
    missions: link.all('missions').filter((one) => one.state === 'running' && one.parent === undefined).length,
    messages: link.all('messages').filter((one) => !one.acknowledged).length,
    alarms: link.all('alarms').filter((one) => !one.acknowledged).length + link.all('faults').length,
  };
  WORDS.boats = capital(link.welcome?.robots ?? 'boat') + 's';
  const now = JSON.stringify([tab, counts, WORDS.boats]);
  if (now === tabbed || (isPressed() && tabbed !== '')) {
    return;
  }
  tabbed = now;
  byId('tabs').replaceChildren(...TABS.map((name) =>
    element('button', {role: 'tab', 'aria-selected': String(name === tab), onclick: () => {
      const isShown = tab === name && document.body.classList.contains('open');
      if (tab !== name) {
        back();
      }
      tab = name;
      document.body.classList.toggle('open', !isShown);
      tabbed = '';
      refresh(true);
      chart?.resized();
    }}, WORDS[name], counts[name] > 0 ? element('b', {}, String(counts[name])) : null)));
}

/** Leaves the decision that is shown. */
function back() {
  form?.close();
  form = null;
}

/** @param {string} word */
function capital(word) {
  return word.charAt(0).toUpperCase() + word.slice(1);
}

/** The decision that is shown has gone away. */
function isOver() {
  return form !== null && !link.all('decisions').some((one) => one.id === form?.decision.id);
}

function refresh(always = false) {
  if (byId('session').hidden || !chart) {
    return;
  }
  strip();
  chart.show(link, selected);
  if (isOver()) {
    back();
  }
  const isBusy = isPressed() || (byId('panel').contains(document.activeElement) && document.activeElement?.matches('select, input, :focus-visible'));
  tabs();
  if (form) {
    shown = '';
    if (byId('panel').firstChild !== form.node) {
      byId('panel').replaceChildren(form.node);
      byId('panel').scrollTop = 0;
    }
  } else if (always || !isBusy) {
    const nodes = panels[tab](link, actions);
    const text = tab + nodes.map((node) => node.outerHTML).join('');
    if (text !== shown) {
      byId('panel').replaceChildren(...nodes);
      shown = text;
    }
  }
}

function theme() {
  const now = localStorage.getItem('theme') ?? 'light';
  document.documentElement.dataset.theme = now;
}

byId('theme').addEventListener('click', () => {
  const now = document.documentElement.dataset.theme ?? 'light';
  localStorage.setItem('theme', THEMES[(THEMES.indexOf(now) + 1) % THEMES.length]);
  theme();
});
byId('login').addEventListener('submit', (/** @type {Event} */ event) => {
  event.preventDefault();
  sessionStorage.setItem('name', byId('login-name').value);
  sessionStorage.setItem('key', byId('login-key').value);
  join();
});
hold(byId('release'), () => actions.command({t: 'releaseFleet'}));
hold(byId('stop'), () => actions.command({t: 'stopFleet'}));
theme();
if (sessionStorage.getItem('name')) {
  join();
} else {
  showLogin('');
}
if ('serviceWorker' in navigator && window.isSecureContext) {
  navigator.serviceWorker.register('worker.js').catch(() => {}); // a certificate that the browser does not trust: the page works without
}

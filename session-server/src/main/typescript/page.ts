// The page: who joins, the strip with the fleet stop, the map, and the lists in tabs.
import {Chart} from './chart.js';
import {DecisionForm} from './decisions.js';
import {Driving} from './driving.js';
import {Drawing} from './drawing.js';
import {byId, duration, element, hold, isPressed} from './dom.js';
import {Link} from './link.js';
import * as panels from './panels.js';
import {Pictures} from './pictures.js';
import {Readings} from './readings.js';
import type {BoatRow, CallingDecision, Command, DecisionRow, LatLon} from './protocol.js';

const THEMES = ['light', 'dark', 'sun'];
const TABS = ['decisions', 'boats', 'missions', 'messages', 'alarms'] as const;
const WORDS = {decisions: 'Decisions', boats: 'Boats', missions: 'Missions', messages: 'Messages', alarms: 'Alarms'};

let tab: typeof TABS[number] = 'decisions';
let selected: string | null = null;
let form: DecisionForm | null = null;
/** Forms of decisions that were opened, so that what is half filled in stays. */
const forms: Map<string, DecisionForm> = new Map();
let driving: Driving | null = null;
let chart: Chart | null = null;
let readings: Readings | null = null;
let tabbed = ''; // what the tabs were made of
let shown = ''; // what the panel was made of

const link = new Link({changed: () => refresh(), refused: (why) => showLogin(why), news: (text) => say(text, false)});

const pictures = new Pictures(link, () => refresh());

const actions: panels.Actions = {
  open: (decision: DecisionRow) => {
    showForm(decision);
    document.body.classList.add('open');
    refresh(true);
  },
  command: async (command: Command) => {
    const reply = await link.ask(command);
    say([reply.text, ...((reply.t === 'done' && reply.warnings) || [])].filter(Boolean).join(' ') || 'Done', reply.t === 'refused');
    return reply;
  },
  select: (boat: string) => {
    selected = selected === boat ? null : boat;
    refresh(true);
  },
  selected: () => selected,
  /** Whether a decision draws attention: nobody here has opened it. */
  calls: (decision): decision is CallingDecision => decision.attention !== undefined && !forms.has(decision.id),
  refresh: () => refresh(true),
  byHand: (boat: BoatRow) => driving?.node(boat) ?? null,
  /** The newest pictures of a boat. */
  pictures: (boat: string) => pictures.strip(pictures.of(boat)),
  /** The pictures that boats had taken last at a time. */
  lastPictures: (boats: string[], at: number) => pictures.strip(boats.flatMap((boat) => pictures.lastOf(boat, at))),
  /** A note at a place that is touched. */
  noteAt: (text: string) => {
    const points: LatLon[] = [];
    const drawing = new Drawing(chart as Chart, () => chart?.resized());
    drawing.begin({type: 'point', points, changed: () => {}, done: () => {
      chart?.draft(null);
      if (points.length > 0) {
        actions.command({t: 'note', text, lat: points[0][0], lon: points[0][1]});
      }
    }});
  },
};

/** Shows a line over the map for some seconds, under those that are still shown: a reply does not hide the news that came with it. */
function say(text: string, isFault: boolean) {
  const notice = byId('notice');
  const now = Date.now();
  said = said.filter((one) => one.until > now).slice(1 - MOST_SAID);
  said.push({until: now + (isFault ? 10000 : 5000), node: element('p', {class: isFault ? 'fault' : ''}, text)});
  notice.replaceChildren(...said.map((one) => one.node));
  notice.hidden = false;
  clearTimeout(say.timer);
  say.timer = window.setTimeout(() => (notice.hidden = true), Math.max(...said.map((one) => one.until)) - now);
}
say.timer = 0;
const MOST_SAID = 3;
let said: {until: number, node: HTMLElement}[] = [];

function showLogin(why: string) {
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
  driving ??= new Driving(link, chart, {command: actions.command, resized: () => chart?.resized()});
  readings ??= new Readings(link, chart);
  chart.resized();
  link.join(sessionStorage.getItem('name') ?? '', sessionStorage.getItem('key') ?? '');
}

function strip() {
  const fleet = link.all('fleet')[0];
  const age = Date.now() - link.heardAt;
  const robots = link.welcome?.robots ?? 'boat';
  const seen = link.heardAt > 0 ? 'Last seen ' + new Date(link.heardAt).toLocaleTimeString([], {hour: '2-digit', minute: '2-digit'}) + ', ' + duration(age) + ' ago' : 'Connecting…';
  const trying = link.bases.areSeveral() ? '; trying ' + link.bases.names().join(', ') : '';
  const state = link.isQuiet()
    ? seen + ', by ' + link.bases.name()
    : link.isOpen
    ? link.all('boats').filter((boat) => boat.link === 'linked').length + ' of ' + (fleet?.boats ?? 0) + ' ' + robots + 's · ' + link.welcome?.name + ' (' + link.welcome?.role + ')'
    : seen + trying + (link.waits ? '; ' + link.waits : '');
  byId('state').textContent = state;
  byId('strip').classList.toggle('lost', !link.isOpen || link.isQuiet());
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
    }}, WORDS[name], counts[name] > 0 ? element('b', {class: name}, String(counts[name])) : null)));
}

/** Shows the form of a decision, as it was left; the panel is made again later. */
function showForm(decision: DecisionRow) {
  back();
  form = forms.get(decision.id) ?? new DecisionForm(decision, link, chart as Chart, pictures, {say, back: (from) => {
    if (from === form) { // a late reply to one answer leaves the form of another question as it is
      back();
      refresh(true);
    }
  }, resized: () => chart?.resized()});
  forms.set(decision.id, form);
  form.show();
}

/** Leaves the decision that is shown. */
function back() {
  form?.close();
  form = null;
}

function capital(word: string) {
  return word.charAt(0).toUpperCase() + word.slice(1);
}

/** Follows the rows of decisions: forms of those that are gone or ask something else go too, and who has not been opened draws attention. */
function followDecisions() {
  if (!link.isOpen) {
    return; // they may be there again
  }
  for (const [id, one] of forms) {
    const row = link.row('decisions', id);
    if (row && one.asks(row)) {
      one.tick(row);
      continue;
    }
    forms.delete(id);
    called.delete(id);
    if (one === form) {
      back();
      if (row) {
        showForm(row);
      }
    }
  }
  const lit = new Map<string, string>();
  for (const one of link.all('decisions').filter(actions.calls)) {
    const boats = one.attention.target === 'all-proxies' ? link.all('boats').map((boat) => boat.id) : one.attention.target === 'relevant-proxies' ? one.boats : [];
    boats.forEach((boat) => lit.set(boat, one.attention.type));
    if (!called.has(one.id)) {
      called.add(one.id);
      navigator.vibrate?.(200);
    }
  }
  if (chart) {
    chart.attention = lit;
  }
}
const called: Set<string> = new Set();

function refresh(always = false) {
  if (byId('session').hidden || !chart) {
    return;
  }
  strip();
  followDecisions();
  chart.show(link, selected);
  readings?.show(form?.layer() ?? null);
  if (!link.isOpen) {
    pictures.stop();
  }
  pictures.draw();
  const chosen = selected === null ? null : link.row('boats', selected);
  if (chosen && !isPressed()) {
    driving?.node(chosen); // also while the focus is in the list, which is not made again then
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
byId('login').addEventListener('submit', (event) => {
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

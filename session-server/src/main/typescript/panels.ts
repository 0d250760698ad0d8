// The lists of the session: decisions, boats, missions with their interrupts, messages and alarms.
import {Chart} from './chart.js';
import {duration, element, hold} from './dom.js';
import {phases} from './phases.js';
import {readingsOf} from './readings.js';
import type {Link} from './link.js';
import type {BoatRow, ButtonRow, CallingDecision, Command, DecisionRow, MessageRow, MissionRow, Reply} from './protocol.js';

/** What a list asks of the page. */
export interface Actions {
  open(decision: DecisionRow): void;
  command(command: Command): Promise<Reply>;
  select(boat: string): void;
  selected(): string | null;
  /** Whether a decision draws attention: nobody here has opened it. */
  calls(decision: DecisionRow): decision is CallingDecision;
  byHand(boat: BoatRow): HTMLElement | null;
  /** The newest pictures of a boat. */
  pictures(boat: string): HTMLElement | null;
  /** The pictures that boats had taken last at a time. */
  lastPictures(boats: string[], at: number): HTMLElement | null;
  /** A note at a place that is touched. */
  noteAt(text: string): void;
  refresh(): void;
}

export function decisions(link: Link, actions: Actions) {
  const rows = link.all('decisions').map((one) =>
    element('button', {class: 'row ' + one.priority + (actions.calls(one) ? ' ' + one.attention.type : ''), onclick: () => actions.open(one)},
      element('strong', {}, one.title),
      element('small', {}, [one.plan, one.deadline ? 'in ' + duration(one.deadline - link.now()) + ' it ' + one.autonomy : null, one.yours ? null : 'not yours'].filter(Boolean).join(' · '))));
  return rows.length > 0 ? rows : [element('p', {class: 'hint'}, 'Nothing is to be decided.')];
}

export function boats(link: Link, actions: Actions) {
  return link.all('boats').flatMap((boat) => {
    const mark = element('i', {class: 'mark'});
    mark.style.background = Chart.color(link, boat.id);
    const status = link.row('standings', boat.id)?.status;
    const figures = [
      boat.battery === undefined ? null : Math.round(boat.battery) + ' %',
      boat.alt === undefined ? null : Math.round(boat.alt) + ' m up',
      boat.speed === undefined ? null : Math.abs(boat.speed).toFixed(1) + ' m/s',
      boat.heard === undefined ? null : 'heard ' + duration(link.now() - boat.heard) + ' ago',
      boat.driver ? 'driven by ' + boat.driver : null,
      status ?? null,
    ].filter(Boolean).join(' · ');
    const standing = status ? {severe: ' critical', warning: ' high'}[status] : '';
    const node = element('button', {class: 'row' + (boat.alarm ? ' ' + boat.alarm : standing) + (boat.id === actions.selected() ? ' selected' : ''), onclick: () => actions.select(boat.id)},
      element('strong', {}, mark, boat.id), element('span', {class: boat.batteryLevel ?? ''}, figures), element('small', {}, boat.why ?? ''));
    const byHand = boat.id === actions.selected() ? actions.byHand(boat) : null;
    const readings = boat.id === actions.selected() ? readingsOf(link, boat.id) : null;
    const pictures = boat.id === actions.selected() ? actions.pictures(boat.id) : null;
    return [node, pictures, readings, byHand].filter((one) => one !== null);
  });
}

/** The plan that is chosen to be started. */
let plan: string | null = null;

export function missions(link: Link, actions: Actions) {
  const running = link.all('missions').filter((one) => one.state === 'running' && one.parent === undefined);
  const nodes: HTMLElement[] = [];
  for (const mission of running) {
    const buttons = link.all('buttons').filter((one) => one.mission === mission.id);
    nodes.push(element('section', {class: 'mission'},
      element('h2', {}, mission.name),
      element('p', {}, 'Runs for ' + duration(link.now() - mission.since) + (mission.stuck ? '. ' + mission.stuck : '')),
      phases(link.row('phases', mission.id), actions.refresh),
      ...buttons.map((one) => interrupt(link, actions, one)),
      link.may('start') ? abort(actions, mission) : null));
  }
  if (link.may('start')) {
    const plans = (link.welcome?.plans ?? []).map((one) => element('option', {value: one.id}, one.title));
    const list = element('select', {id: 'plans', 'aria-label': 'Plan', onchange: () => (plan = list.value)}, ...plans);
    list.value = plan ?? list.value;
    nodes.push(element('div', {class: 'start'}, list, element('button', {class: 'main', onclick: () => actions.command({t: 'start', plan: list.value})}, 'Start mission')));
  }
  return nodes.length > 0 ? nodes : [element('p', {class: 'hint'}, 'No mission runs.')];
}

/** A button that is held. */
function abort(actions: Actions, mission: MissionRow) {
  const button = element('button', {class: 'danger'}, 'Hold to abort');
  hold(button, () => actions.command({t: 'abort', mission: mission.id}));
  return button;
}

function interrupt(link: Link, actions: Actions, one: ButtonRow) {
  const why = one.whyNot ?? (link.may('press') ? null : 'not yours to press');
  const selected = actions.selected();
  const press = () => actions.command({t: 'press', mission: one.mission, name: one.name, ...(one.boats && selected ? {boats: [selected]} : {})});
  return element('div', {class: 'interrupt'},
    element('button', {disabled: why !== null, onclick: press}, one.name + (one.boats && selected ? ' for ' + selected : '')),
    element('small', {}, [why ?? one.description, one.final].filter(Boolean).join('. ')));
}

/** What a message's keyword begins with: the session's own name each address behind it. */
function group(one: MessageRow) {
  return one.keyword?.split('/')[0];
}

/** The keyword whose messages are shown; null for all. */
let keyword: string | null = null;
/** Always the same, so that a half-typed note stays. */
let bar: HTMLElement | null = null;

export function messages(link: Link, actions: Actions) {
  const all = link.all('messages');
  const keywords = [...new Set(all.map(group).filter((word) => word !== undefined))].sort();
  if (keyword !== null && !keywords.includes(keyword)) {
    keyword = null;
  }
  const chip = (word: string | null) => element('button', {'aria-pressed': String(word === keyword), onclick: () => {
    keyword = word;
    actions.refresh();
  }}, word ?? 'All');
  const chips = keywords.length > 0 ? [element('div', {class: 'chips'}, chip(null), ...keywords.map(chip))] : [];
  const rows = all.filter((one) => keyword === null || group(one) === keyword).map((one) =>
    element('div', {class: 'row ' + one.priority + (one.acknowledged ? ' seen' : '')},
      element('span', {}, one.text + (one.count > 1 ? ' (' + one.count + ' times)' : '')),
      element('small', {}, [group(one), duration(link.now() - one.at) + ' ago'].filter(Boolean).join(' · ')),
      one.pictures ? actions.lastPictures(one.pictures, one.at) : null,
      one.acknowledged || !link.may('answer') ? null : element('button', {onclick: () => actions.command({t: 'acknowledge', message: Number(one.id)})}, 'Seen')));
  return [...chips, ...(rows.length > 0 ? rows : [element('p', {class: 'hint'}, 'No messages.')]), ...(link.may('answer') ? [bar ??= noteBar(actions)] : [])];
}

function noteBar(actions: Actions) {
  const note = element('input', {id: 'note', maxlength: 500, placeholder: 'Note for the log', 'aria-label': 'Note for the log'});
  const taken = () => {
    const text = note.value.trim();
    note.value = '';
    return text;
  };
  const send = () => {
    const text = taken();
    if (text !== '') {
      actions.command({t: 'note', text});
    }
  };
  const place = () => {
    const text = taken();
    if (text !== '') {
      actions.noteAt(text);
    }
  };
  return element('div', {class: 'note'}, note, element('button', {onclick: send}, 'Note'), element('button', {onclick: place}, 'At a place…'));
}

export function alarms(link: Link, actions: Actions) {
  const rows = [
    ...link.all('faults').map((one) => element('div', {class: 'row ' + one.severity}, element('strong', {}, one.text), element('small', {}, one.advice))),
    ...link.all('alarms').map((one) =>
      element('div', {class: 'row ' + one.severity + (one.active ? '' : ' seen')},
        element('strong', {}, one.text),
        element('small', {}, (one.active ? '' : 'over · ') + one.advice),
        one.acknowledged || !link.may('answer') ? null : element('button', {onclick: () => actions.command({t: 'acknowledge', alarm: Number(one.id)})}, 'Acknowledge'))),
  ];
  return rows.length > 0 ? rows : [element('p', {class: 'hint'}, 'No alarms.')];
}

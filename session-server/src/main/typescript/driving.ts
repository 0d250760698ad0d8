// Driving a boat by hand: a claim, a stick to drag, a place to go to.
import {Drawing} from './drawing.js';
import {element} from './dom.js';
import type {Chart} from './chart.js';
import type {Link} from './link.js';
import type {BoatRow, Command, LatLon, Reply} from './protocol.js';

const EVERY_MS = 150; // the server stops the motors after 400 ms without a word

export class Driving {
  link: Link;
  page: {command: (command: Command) => Promise<Reply>, resized: () => void};
  drawing: Drawing;
  chart: Chart;
  boat: string | null;
  /** The connections in which boats were claimed here: the same person may have claimed one on another screen, or before the link was lost. */
  claimed: Map<string, WebSocket | undefined>;
  timer: number;
  thrust: number;
  rudder: number;
  root: HTMLElement;
  knob: HTMLElement;
  stick: HTMLElement;
  keys: Set<string>;
  /** That drags the stick. */
  pointer: number | null;

  constructor(link: Link, chart: Chart, page: {command: (command: Command) => Promise<Reply>, resized: () => void}) {
    this.link = link;
    this.page = page;
    this.drawing = new Drawing(chart, page.resized);
    this.chart = chart;
    this.boat = null;
    this.claimed = new Map();
    this.timer = 0;
    this.thrust = 0;
    this.rudder = 0;
    this.root = element('div', {class: 'by-hand'});
    this.knob = element('i', {class: 'knob'});
    this.stick = element('div', {class: 'stick', role: 'application', tabindex: 0, 'aria-label': 'Drag up to go ahead, down astern, to the sides to turn; or the arrow keys', onpointerdown: (event) => this.press(event), onkeydown: (event) => this.key(event, true), onkeyup: (event) => this.key(event, false), onblur: () => this.release()}, this.knob);
    this.stick.addEventListener('pointermove', (event) => this.move(event));
    this.stick.addEventListener('pointerup', () => this.release());
    this.stick.addEventListener('pointercancel', () => this.release());
    window.addEventListener('blur', () => this.release());
    document.addEventListener('visibilitychange', () => document.hidden && this.release());
    this.keys = new Set();
    this.pointer = null;
  }

  /**
   * What can be done with a boat by hand, always the same element, so that a drag goes on when the list is made again; null where nothing is to
   * be, as with what flies, which nobody drives from here.
   */
  node(boat: BoatRow) {
    if (!this.link.may('drive') || boat.link === 'unreached' || boat.flies) {
      return null;
    }
    const isMe = boat.driver !== undefined && boat.driver === this.link.welcome?.name;
    const mine = isMe && this.claimed.has(boat.id) && this.claimed.get(boat.id) === this.link.socket;
    if (!mine && this.boat === boat.id) {
      this.claimed.delete(boat.id); // it was given back, or the session took it
    }
    const words = [boat.id, boat.driver ?? '', mine].join(' ');
    if (this.root.dataset.words !== words) {
      this.release();
      this.boat = mine ? boat.id : null;
      this.root.dataset.words = words;
      this.root.replaceChildren(...(mine ? this.controls(boat.id) : [boat.driver
        ? element('small', {}, boat.driver + (isMe ? ' drives it on another screen.' : ' drives it.'))
        : element('button', {onclick: () => this.claim(boat.id)}, 'Take ' + boat.id + ' by hand')]));
    }
    return this.root;
  }

  async claim(boat: string) {
    const socket = this.link.socket;
    const reply = await this.page.command({t: 'claim', boat});
    if (reply.t === 'done') {
      this.claimed.set(boat, socket);
    }
  }

  controls(boat: string) {
    return [this.stick, element('div', {class: 'orders'},
      element('button', {onclick: () => this.goHere(boat)}, 'Go here…'),
      element('button', {onclick: () => this.page.command({t: 'holdBoat', boat})}, 'Hold its place'),
      element('button', {class: 'main', onclick: () => this.page.command({t: 'giveBack', boat})}, 'Give back'))];
  }

  goHere(boat: string) {
    const points: LatLon[] = [];
    this.drawing.begin({type: 'point', points, changed: () => {}, done: () => {
      this.chart.draft(null);
      if (points.length > 0) {
        this.page.command({t: 'goTo', boat, lat: points[0][0], lon: points[0][1]});
      }
    }});
  }

  press(event: PointerEvent) {
    event.preventDefault();
    this.stick.setPointerCapture(event.pointerId);
    this.pointer = event.pointerId;
    this.stick.focus({preventScroll: true});
    this.move(event);
    this.begin();
  }

  move(event: PointerEvent) {
    if (!this.stick.hasPointerCapture(event.pointerId)) {
      return;
    }
    const box = this.stick.getBoundingClientRect();
    const unit = (value: number) => Math.max(-1, Math.min(1, value));
    this.set(unit(1 - (2 * (event.clientY - box.top)) / box.height), unit((2 * (event.clientX - box.left)) / box.width - 1));
  }

  key(event: KeyboardEvent, down: boolean) {
    if (!event.key.startsWith('Arrow')) {
      return;
    }
    event.preventDefault();
    if (down) {
      this.keys.add(event.key);
    } else {
      this.keys.delete(event.key);
    }
    const axis = (plus: string, minus: string) => (this.keys.has(plus) ? 0.6 : 0) - (this.keys.has(minus) ? 0.6 : 0);
    if (this.keys.size === 0) {
      this.release();
    } else {
      this.set(axis('ArrowUp', 'ArrowDown'), axis('ArrowRight', 'ArrowLeft'));
      this.begin();
    }
  }

  set(thrust: number, rudder: number) {
    this.thrust = Math.round(thrust * 100) / 100;
    this.rudder = Math.round(rudder * 100) / 100;
    this.knob.style.left = 50 + 50 * rudder + '%';
    this.knob.style.top = 50 - 50 * thrust + '%';
  }

  begin() {
    if (this.timer === 0) {
      this.timer = window.setInterval(() => this.send(), EVERY_MS);
    }
    this.send();
  }

  /** Whether a hand is on the stick. One that was taken out of the page hears neither of a pointer that is lifted nor of a key. */
  isHeld() {
    return this.stick.isConnected
      && ((this.keys.size > 0 && document.activeElement === this.stick) || (this.pointer !== null && this.stick.hasPointerCapture(this.pointer)));
  }

  async send() {
    if (this.timer !== 0 && !this.isHeld()) {
      this.release();
      return;
    }
    const reply = this.boat === null ? {t: 'done'} : await this.link.ask({t: 'drive', boat: this.boat, thrust: this.thrust, rudder: this.rudder});
    if (reply.t === 'refused') {
      this.release();
    }
  }

  /** The hand is off: the motors stop. */
  release() {
    this.keys.clear();
    this.pointer = null;
    if (this.timer !== 0) {
      clearInterval(this.timer);
      this.timer = 0;
      this.set(0, 0);
      this.send();
    }
  }
}

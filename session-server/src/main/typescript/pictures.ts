// Pictures that boats took: small ones in lists, one large over map and lists. They are fetched with the ticket of this login, and kept in memory only.
import {byId, duration, element} from './dom.js';
import type {Link} from './link.js';
import type {PictureOfPanorama, PicturesRow} from './protocol.js';

/** One of a row of the table `pictures`. */
export type Picture = PictureOfPanorama & {row: PicturesRow};

const MOST_KEPT = 80;
const MOST_SHOWN = 6; // in a list
const AGAIN_MS = 5000;
const LONGEST_MS = 120000; // of one that comes, after which the next is fetched

export class Pictures {
  link: Link;
  loaded: () => void;
  /** Addresses of pictures in memory, by what was asked; the one that was used last is the last. */
  kept: Map<string, string>;
  failedAt: Map<string, number>;
  waiting: Set<string>;
  chain: Promise<void>;
  /** Ends the one that comes. */
  coming: AbortController | null;
  open: Picture[];
  at: number;

  /** @param loaded called when a picture has come */
  constructor(link: Link, loaded: () => void) {
    this.link = link;
    this.loaded = loaded;
    this.kept = new Map();
    this.failedAt = new Map();
    this.waiting = new Set();
    this.chain = Promise.resolve();
    this.coming = null;
    this.open = [];
    this.at = 0;
    document.addEventListener('keydown', (event) => this.key(event));
  }

  /** The newest pictures of a boat that are here, the newest panorama first. */
  of(boat: string): Picture[] {
    return this.link.all('pictures').filter((row) => row.boat === boat).flatMap((row) => row.pictures.map((one) => ({...one, row})));
  }

  /** The last panorama of a boat that was there at a time. @param at in ms */
  lastOf(boat: string, at: number): Picture[] {
    const row = this.link.all('pictures').find((one) => one.boat === boat && one.at <= at);
    return row ? row.pictures.map((one) => ({...one, row})) : [];
  }

  /** A line of small pictures; a touch shows one large. */
  strip(pictures: Picture[]): HTMLElement | null {
    const here = pictures.filter((one) => one.state === 'here');
    const coming = pictures.filter((one) => one.state === 'coming').length;
    if (here.length === 0 && coming === 0) {
      return null;
    }
    const shown = here.slice(0, MOST_SHOWN);
    const more = here.length - shown.length;
    const words = [coming > 0 ? coming + ' not here yet' : null, more > 0 ? more + ' more: touch one and turn over' : null].filter(Boolean).join(' · ');
    return element('div', {class: 'strip', role: 'group', 'aria-label': 'Pictures'}, ...shown.map((one) => this.small(one, here)), words ? element('small', {}, words) : null);
  }

  small(one: Picture, all: Picture[]) {
    const address = this.address(one, true);
    const words = one.row.boat + ', ' + duration(this.link.now() - one.row.at) + ' ago';
    return element('button', {class: 'thumb', type: 'button', 'aria-label': 'Picture of ' + words, onclick: () => this.show(all, all.indexOf(one))},
      address ? element('img', {src: address, alt: ''}) : element('span', {}, '…'));
  }

  /** The address in memory of a picture; null until it has come. */
  address(one: Picture, small: boolean): string | null {
    const asked = new URLSearchParams({boat: one.row.boat, panorama: one.row.panorama, name: one.name, ...(small ? {small: '1'} : {})}).toString();
    const known = this.kept.get(asked);
    if (known) {
      this.kept.delete(asked);
      this.kept.set(asked, known);
      return known;
    }
    if (!this.waiting.has(asked) && Date.now() - (this.failedAt.get(asked) ?? 0) > AGAIN_MS) {
      this.waiting.add(asked);
      this.chain = this.chain.then(() => this.fetch(asked));
    }
    return null;
  }

  /** One after the other, as they share the way with what is more urgent. */
  async fetch(asked: string) {
    const coming = new AbortController();
    this.coming = coming;
    const tooLong = window.setTimeout(() => coming.abort(), LONGEST_MS);
    try {
      const answer = await fetch(this.link.bases.web() + 'picture?' + asked, {headers: {Authorization: 'Bearer ' + this.link.welcome?.ticket}, cache: 'no-store', signal: coming.signal});
      if (!answer.ok) {
        throw new Error(String(answer.status));
      }
      this.kept.set(asked, URL.createObjectURL(await answer.blob()));
      while (this.kept.size > MOST_KEPT) {
        const [oldest, address] = this.kept.entries().next().value as [string, string];
        this.kept.delete(oldest);
        URL.revokeObjectURL(address);
      }
    } catch {
      this.failedAt.set(asked, Date.now());
    }
    clearTimeout(tooLong);
    this.coming = null;
    this.waiting.delete(asked);
    this.loaded();
    this.draw();
  }

  /** The link is lost: what was to come from there may never end, and others wait behind it. */
  stop() {
    this.coming?.abort();
  }

  /** Shows one large. */
  show(all: Picture[], at: number) {
    this.open = all;
    this.at = at;
    byId('viewer').hidden = false;
    this.draw();
    byId('viewer').querySelector('button')?.focus();
  }

  close() {
    this.open = [];
    byId('viewer').hidden = true;
    byId('viewer').replaceChildren();
  }

  /** Draws the large picture again, where one is shown. */
  draw() {
    const one = this.open[this.at];
    if (!one) {
      return;
    }
    const whole = this.address(one, false);
    const address = whole ?? this.address(one, true);
    const state = this.at + ' ' + address;
    if (byId('viewer').dataset.shown === state && byId('viewer').firstChild) {
      return;
    }
    byId('viewer').dataset.shown = state;
    const image = element('img', {src: address, class: whole ? '' : 'coming', alt: 'Picture that ' + one.row.boat + ' took', onclick: () => image.classList.toggle('natural')});
    const words = [one.row.boat, (this.at + 1) + ' of ' + this.open.length, duration(this.link.now() - one.row.at) + ' ago', whole ? null : 'coming…'].filter(Boolean).join(' · ');
    byId('viewer').replaceChildren(
      element('div', {class: 'bar-of-viewer'},
        element('button', {type: 'button', 'aria-label': 'The picture before', disabled: this.at === 0, onclick: () => this.turn(-1)}, '‹'),
        element('span', {role: 'status'}, words),
        element('button', {type: 'button', 'aria-label': 'The next picture', disabled: this.at === this.open.length - 1, onclick: () => this.turn(1)}, '›'),
        element('button', {type: 'button', 'aria-label': 'Close', onclick: () => this.close()}, '✕')),
      element('div', {class: 'large'}, address ? image : element('p', {class: 'hint'}, 'The picture is coming…')));
  }

  turn(by: number) {
    this.at = Math.max(0, Math.min(this.open.length - 1, this.at + by));
    this.draw();
  }

  key(event: KeyboardEvent) {
    if (this.open.length === 0) {
      return;
    }
    if (event.key === 'Escape') {
      this.close();
    } else if (event.key === 'ArrowLeft' || event.key === 'ArrowRight') {
      this.turn(event.key === 'ArrowLeft' ? -1 : 1);
      event.preventDefault();
    }
  }
}

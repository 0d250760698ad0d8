// @ts-check
// The map: boats, their ways, areas, and what a decision shows or asks to be drawn.
import * as L from './leaflet/leaflet-src.esm.js';

const COLORS = ['#E69F00', '#56B4E9', '#009E73', '#F0E442', '#0072B2', '#D55E00', '#CC79A7', '#882255', '#999933', '#6A5ACD', '#8C5A2B'];
const SILENT_MS = 5000;

export class Chart {
  /** @param {(boat: string) => void} chosen called with a boat that was touched */
  constructor(chosen) {
    this.chosen = chosen;
    this.map = L.map('map', {zoomControl: false, attributionControl: false, doubleClickZoom: false, maxZoom: 22, preferCanvas: true});
    this.map.setView([0, 0], 2);
    L.control.zoom({position: 'topright'}).addTo(this.map);
    L.control.scale({imperial: false, position: 'topright'}).addTo(this.map);
    this.areas = L.layerGroup().addTo(this.map);
    this.ways = L.layerGroup().addTo(this.map);
    this.question = L.layerGroup().addTo(this.map);
    this.drawing = L.layerGroup().addTo(this.map);
    this.boats = L.layerGroup().addTo(this.map);
    /** @type {Map<string, any>} */
    this.markers = new Map();
    this.drawn = '';
    this.isPlaced = false;
    this.isMoved = false; // by the person
    /** @type {import('./link.js').Link | null} */
    this.link = null;
    this.withPaths = false;
    /** Boats of the decision that is shown. @type {Set<string>} */
    this.stressed = new Set();
    /** Boats to which decisions that nobody here has opened draw attention, and how. @type {Map<string, string>} */
    this.attention = new Map();
    /** @type {((point: [number, number]) => void) | null} */
    this.taking = null;
    this.mapFrom = ''; // the base whose background map is drawn, as Bases.web names it
    /** @type {any[]} */
    this.mapLayers = [];
    this.background('');
    this.watch();
    new ResizeObserver(() => this.resized()).observe(this.map.getContainer());
    this.map.on('click', (/** @type {any} */ event) => this.taking?.([event.latlng.lat, event.latlng.lng]));
  }

  /** Notices when a person moves the map or looks closer: then it is left where it is. */
  watch() {
    const moved = () => (this.isMoved = true);
    this.map.on('dragstart', moved);
    const place = this.map.getContainer();
    place.addEventListener('wheel', moved, {passive: true});
    place.querySelector('.leaflet-control-zoom')?.addEventListener('click', moved);
    place.addEventListener('pointerdown', (/** @type {PointerEvent} */ event) => event.isPrimary || moved(), {passive: true}); // a second finger
  }

  /** Draws the background map of a base below all else, where it has one; else the one that was there stays. @param {string} base as `Bases.web` names it */
  async background(base) {
    this.mapFrom = base;
    const answer = await fetch(base + 'tiles/map.json').catch(() => null);
    if (answer?.status !== 200 || this.mapFrom !== base) {
      return;
    }
    this.mapLayers.forEach((layer) => layer.remove());
    this.mapLayers = [];
    const about = await answer.json();
    this.mapLayers.push(L.tileLayer(base + 'tiles/{z}/{x}/{y}', {minNativeZoom: about.coarsest, maxNativeZoom: about.finest, maxZoom: 22, crossOrigin: true}).addTo(this.map));
    if (about.attribution) {
      const words = document.createElement('span');
      words.textContent = about.attribution;
      this.mapLayers.push(L.control.attribution({prefix: false}).addAttribution(words.innerHTML).addTo(this.map));
    }
  }

  /** Its place in the page has another size. All boats stay in sight until a person moves the map, or a decision shows something. */
  resized() {
    this.map.invalidateSize();
    if (this.link && this.isPlaced && !this.isMoved && this.question.getLayers().length === 0) {
      this.fit(this.link);
    }
  }

  /** The colour of a boat, which it keeps: the same as in windows where all boats came in the order of their names. @param {import('./link.js').Link} link @param {string} id */
  static color(link, id) {
    return COLORS[link.numberOf(id) % COLORS.length];
  }

  /** @param {import('./link.js').Link} link @param {string | null} selected */
  show(link, selected) {
    this.link = link;
    if (link.bases.web() !== this.mapFrom) {
      this.background(link.bases.web());
    }
    const boats = link.all('boats').filter((boat) => boat.lat !== undefined);
    for (const boat of boats) {
      const marks = [
        boat.id === selected ? 'selected' : '',
        link.now() - (boat.heard ?? 0) > SILENT_MS || !link.isOpen ? 'silent' : '',
        boat.alarm || link.row('standings', boat.id)?.status === 'severe' ? 'alarm' : link.row('standings', boat.id) ? 'warned' : '',
        this.stressed.has(boat.id) ? 'stressed' : '',
        this.attention.get(boat.id) ?? '',
      ];
      this.boat(boat, Chart.color(link, boat.id), marks.filter(Boolean).join(' '));
    }
    for (const [id, marker] of this.markers) {
      if (!boats.some((boat) => boat.id === id)) {
        this.boats.removeLayer(marker);
        this.markers.delete(id);
      }
    }
    const shapes = JSON.stringify([link.all('areas'), link.all('paths')]);
    if (shapes !== this.drawn) {
      this.drawn = shapes;
      this.lines(link);
    }
    if (!this.isPlaced && boats.length > 0) {
      this.isPlaced = true;
      this.fit(link);
    }
  }

  /** Shows all boats and areas. @param {import('./link.js').Link} link */
  fit(link) {
    const points = link.all('boats').filter((boat) => boat.lat !== undefined).map((boat) => [boat.lat, boat.lon]);
    for (const area of link.all('areas')) {
      points.push(...(area.shape.area ?? (area.shape.point ? [area.shape.point] : [])));
    }
    if (points.length > 0) {
      this.map.fitBounds(L.latLngBounds(points).pad(0.3), {maxZoom: 18, animate: false});
    }
  }

  /** @param {any} boat @param {string} color @param {string} marks classes of its figure */
  boat(boat, color, marks) {
    const text = JSON.stringify([color, Math.round(boat.heading ?? 0), marks]);
    let marker = this.markers.get(boat.id);
    if (!marker) {
      marker = L.marker([boat.lat, boat.lon], {keyboard: false, icon: L.divIcon({className: 'boat'})}).on('click', (/** @type {any} */ event) => this.touched(boat.id, event));
      this.markers.set(boat.id, marker);
      this.boats.addLayer(marker);
    }
    marker.setLatLng([boat.lat, boat.lon]);
    if (marker.shownText !== text) {
      marker.shownText = text;
      marker.setIcon(L.divIcon({className: 'boat', iconSize: [48, 48], html: Chart.figure(boat, color, marks)}));
    }
  }

  /** A point is drawn over a boat, too. @param {string} boat @param {any} event */
  touched(boat, event) {
    if (this.taking) {
      const at = this.map.mouseEventToLatLng(event.originalEvent);
      this.taking([at.lat, at.lng]);
    } else {
      this.chosen(boat);
    }
  }

  /** @param {any} boat @param {string} color @param {string} marks */
  static figure(boat, color, marks) {
    const figure = document.createElement('div');
    figure.className = 'figure ' + marks;
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    svg.setAttribute('viewBox', '-12 -12 24 24');
    const hull = document.createElementNS(svg.namespaceURI, 'path');
    hull.setAttribute('d', 'M0 -10 6 8 0 5 -6 8Z');
    hull.setAttribute('fill', color);
    hull.setAttribute('transform', 'rotate(' + (boat.heading ?? 0) + ')');
    svg.append(hull);
    const name = document.createElement('span');
    name.textContent = boat.id;
    figure.append(svg, name);
    return figure;
  }

  /** @param {import('./link.js').Link} link */
  lines(link) {
    this.areas.clearLayers();
    this.ways.clearLayers();
    const isThick = (/** @type {string} */ id) => this.withPaths && this.stressed.has(id);
    for (const area of link.all('areas')) {
      this.put(this.areas, area.shape, Chart.style(area.kind), area.name.startsWith('@') ? '' : area.name);
    }
    for (const way of link.all('paths')) {
      L.polyline(way.points, {color: Chart.color(link, way.id), weight: isThick(way.id) ? 5 : 2, dashArray: isThick(way.id) ? null : '6 4', interactive: false}).addTo(this.ways);
    }
  }

  /** @param {string} kind */
  static style(kind) {
    switch (kind) {
      case 'no-go':
        return {color: '#c62828', weight: 2, fillOpacity: 0.2};
      case 'fence':
        return {color: '#2e7d32', weight: 3, fill: false};
      case 'relevant':
        return {color: '#6a1b9a', weight: 2, dashArray: '4 4', fillOpacity: 0.1};
      default:
        return {color: '#1565c0', weight: 2, fillOpacity: 0.1};
    }
  }

  /** @param {any} layer @param {any} shape @param {any} style @param {string} [label] */
  put(layer, shape, style, label) {
    let made;
    if (shape.point) {
      made = L.circleMarker(shape.point, {...style, radius: 7, fill: true, fillOpacity: 0.7, interactive: false});
    } else if (shape.path) {
      made = L.polyline(shape.path, {...style, fill: false, interactive: false});
    } else if (shape.area) {
      made = L.polygon([shape.area, ...(shape.holes ?? [])], {...style, interactive: false});
    } else {
      (shape.many ?? []).forEach((/** @type {any} */ one) => this.put(layer, one.shape, style, one.label));
      return;
    }
    made.addTo(layer);
    if (label) {
      const words = document.createElement('span');
      words.textContent = label;
      made.bindTooltip(words, {permanent: true, direction: shape.point ? 'top' : 'center', offset: [0, shape.point ? -4 : 0], className: 'label'});
    }
  }

  /** Shows what belongs to a decision. @param {any[]} shapes as `{label, shape}` @param {boolean} [isTight] whether the map shows no more than that */
  preview(shapes, isTight = false) {
    this.question.clearLayers();
    const points = [];
    for (const one of shapes) {
      this.put(this.question, one.shape, {color: '#ff6f00', weight: 4, fillOpacity: 0.15}, one.label);
      points.push(...Chart.points(one.shape));
    }
    this.bring(points, isTight);
  }

  /** @param {any[]} points @param {boolean} isTight */
  bring(points, isTight) {
    if (points.length > 0 && (isTight || !this.map.getBounds().contains(L.latLngBounds(points)))) {
      this.map.fitBounds(L.latLngBounds(points).pad(0.3), {maxZoom: 18, animate: false});
    }
  }

  /** Stresses the boats that a decision shows, and brings those that it asks for into view. @param {import('./link.js').Link} link @param {any | null} decision */
  stress(link, decision) {
    this.stressed = new Set(decision?.show?.boats ?? []);
    const placed = (decision?.view?.boats ?? []).map((/** @type {string} */ id) => link.row('boats', id)).filter((/** @type {any} */ boat) => boat?.lat !== undefined);
    this.bring(placed.map((/** @type {any} */ boat) => [boat.lat, boat.lon]), decision?.view?.change === 'reduce');
    this.withPaths = Boolean(decision?.show?.paths);
    this.drawn = ''; // ways are drawn again
  }

  /** @param {any} shape @returns {any[]} */
  static points(shape) {
    return shape.point ? [shape.point] : shape.path ?? shape.area ?? (shape.many ?? []).flatMap((/** @type {any} */ one) => Chart.points(one.shape));
  }

  /** Shows what is being drawn. @param {any | null} shape */
  draft(shape) {
    this.drawing.clearLayers();
    if (shape) {
      this.put(this.drawing, shape, {color: '#d500f9', weight: 4, fillOpacity: 0.2});
      Chart.points(shape).slice(0, 500).forEach((point) => L.circleMarker(point, {radius: 6, color: '#d500f9', interactive: false}).addTo(this.drawing));
    }
  }
}

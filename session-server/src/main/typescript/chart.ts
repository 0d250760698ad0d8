// The map: boats, their ways, areas, and what a decision shows or asks to be drawn.
import * as L from './leaflet/leaflet-src.esm.js';
import type {Link} from './link.js';
import type {AreaRow, BoatRow, DecisionRow, Labelled, LatLon, PlacedBoat, Shape} from './protocol.js';

const COLORS = ['#E69F00', '#56B4E9', '#009E73', '#F0E442', '#0072B2', '#D55E00', '#CC79A7', '#882255', '#999933', '#6A5ACD', '#8C5A2B'];
const SILENT_MS = 5000;
const NAME_PX = 17; // the height of a name
const MOST_ROWS = 6; // of names below one another

export class Chart {
  chosen: (boat: string) => void;
  map: L.Map;
  areas: L.LayerGroup;
  ways: L.LayerGroup;
  question: L.LayerGroup;
  drawing: L.LayerGroup;
  boats: L.LayerGroup;
  markers: Map<string, {marker: L.Marker, shown: string}>;
  drawn: string;
  isPlaced: boolean;
  isMoved: boolean;
  link: Link | null;
  withPaths: boolean;
  /** Boats of the decision that is shown. */
  stressed: Set<string>;
  /** Boats to which decisions that nobody here has opened draw attention, and how. */
  attention: Map<string, string>;
  taking: ((point: LatLon) => void) | null;
  /** The base whose background map is drawn, as `Bases.web` names it. */
  mapFrom: string;
  mapLayers: {remove(): unknown}[];

  /** @param chosen called with a boat that was touched */
  constructor(chosen: (boat: string) => void) {
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
    this.markers = new Map();
    this.drawn = '';
    this.isPlaced = false;
    this.isMoved = false; // by the person
    this.link = null;
    this.withPaths = false;
    this.stressed = new Set();
    this.attention = new Map();
    this.taking = null;
    this.mapFrom = '';
    this.mapLayers = [];
    this.background('');
    this.watch();
    new ResizeObserver(() => this.resized()).observe(this.map.getContainer());
    this.map.on('click', (event) => this.taking?.([event.latlng.lat, event.latlng.lng]));
  }

  /** Notices when a person moves the map or looks closer: then it is left where it is. */
  watch() {
    const moved = () => (this.isMoved = true);
    this.map.on('dragstart', moved);
    this.map.on('zoomend', () => this.spread());
    const place = this.map.getContainer();
    place.addEventListener('wheel', moved, {passive: true});
    place.querySelector('.leaflet-control-zoom')?.addEventListener('click', moved);
    place.addEventListener('pointerdown', (event: PointerEvent) => event.isPrimary || moved(), {passive: true}); // a second finger
  }

  /** Draws the background map of a base below all else, where it has one; else the one that was there stays. @param base as `Bases.web` names it */
  async background(base: string) {
    this.mapFrom = base;
    const answer = await fetch(base + 'tiles/map.json').catch(() => null);
    if (answer?.status !== 200 || this.mapFrom !== base) {
      return;
    }
    this.mapLayers.forEach((layer) => layer.remove());
    this.mapLayers = [];
    const about: {coarsest: number, finest: number, attribution?: string} = await answer.json();
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

  /** The colour of a boat, which it keeps: the same as in windows where all boats came in the order of their names. */
  static color(link: Link, id: string) {
    return COLORS[link.numberOf(id) % COLORS.length];
  }

  show(link: Link, selected: string | null) {
    this.link = link;
    if (link.bases.web() !== this.mapFrom) {
      this.background(link.bases.web());
    }
    const boats = Chart.placed(link.all('boats'));
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
    for (const [id, {marker}] of this.markers) {
      if (!boats.some((boat) => boat.id === id)) {
        this.boats.removeLayer(marker);
        this.markers.delete(id);
      }
    }
    this.spread();
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

  /** Those that have said where they are. */
  static placed(boats: (BoatRow | undefined)[]): PlacedBoat[] {
    return boats.filter((boat): boat is PlacedBoat => boat?.lat !== undefined);
  }

  static at(boat: PlacedBoat): LatLon {
    return [boat.lat, boat.lon];
  }

  /** Shows all boats and areas. */
  fit(link: Link) {
    const points = Chart.placed(link.all('boats')).map(Chart.at);
    for (const area of link.all('areas')) {
      points.push(...(area.shape.area ?? (area.shape.point ? [area.shape.point] : [])));
    }
    if (points.length > 0) {
      this.map.fitBounds(L.latLngBounds(points).pad(0.3), {maxZoom: 19, animate: false});
    }
  }

  /** Sets the names of boats that lie side by side below one another, so that none hides another. */
  spread() {
    const placed: {left: number, right: number, top: number}[] = [];
    for (const {marker} of this.markers.values()) {
      const name = marker.getElement()?.querySelector<HTMLElement>('.figure span');
      if (!name) {
        continue;
      }
      const {lat, lng} = marker.getLatLng();
      const at = this.map.latLngToContainerPoint([lat, lng]);
      const half = name.offsetWidth / 2;
      const isHidden = (row: number) => placed.some((other) => other.left < at.x + half && at.x - half < other.right && Math.abs(other.top - at.y - row * NAME_PX) < NAME_PX);
      let row = 0;
      while (row < MOST_ROWS && isHidden(row)) {
        row++;
      }
      placed.push({left: at.x - half, right: at.x + half, top: at.y + row * NAME_PX});
      name.style.transform = row > 0 ? `translateY(${row * NAME_PX}px)` : '';
    }
  }

  /** @param marks classes of its figure */
  boat(boat: PlacedBoat, color: string, marks: string) {
    const text = JSON.stringify([color, Math.round(boat.heading ?? 0), marks]);
    let known = this.markers.get(boat.id);
    if (!known) {
      const marker = L.marker([boat.lat, boat.lon], {keyboard: false, icon: L.divIcon({className: 'boat'})}).on('click', (event) => this.touched(boat.id, event));
      known = {marker, shown: ''};
      this.markers.set(boat.id, known);
      this.boats.addLayer(marker);
    }
    known.marker.setLatLng([boat.lat, boat.lon]);
    if (known.shown !== text) {
      known.shown = text;
      known.marker.setIcon(L.divIcon({className: 'boat', iconSize: [48, 48], html: Chart.figure(boat, color, marks)}));
    }
  }

  /** A point is drawn over a boat, too. */
  touched(boat: string, event: L.LeafletMouseEvent) {
    if (this.taking) {
      const at = this.map.mouseEventToLatLng(event.originalEvent);
      this.taking([at.lat, at.lng]);
    } else {
      this.chosen(boat);
    }
  }

  static figure(boat: PlacedBoat, color: string, marks: string) {
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

  lines(link: Link) {
    this.areas.clearLayers();
    this.ways.clearLayers();
    const isThick = (id: string) => this.withPaths && this.stressed.has(id);
    for (const area of link.all('areas')) {
      this.put(this.areas, area.shape, Chart.style(area.kind), area.name.startsWith('@') ? '' : area.name);
    }
    for (const way of link.all('paths')) {
      L.polyline(way.points, {color: Chart.color(link, way.id), weight: isThick(way.id) ? 5 : 2, dashArray: isThick(way.id) ? undefined : '6 4', interactive: false}).addTo(this.ways);
    }
  }

  static style(kind: AreaRow['kind']): L.PathOptions {
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

  put(layer: L.LayerGroup, shape: Shape, style: L.PathOptions, label?: string) {
    let made;
    if (shape.point) {
      made = L.circleMarker(shape.point, {...style, radius: 7, fill: true, fillOpacity: 0.7, interactive: false});
    } else if (shape.path) {
      made = L.polyline(shape.path, {...style, fill: false, interactive: false});
    } else if (shape.area) {
      made = L.polygon([shape.area, ...(shape.holes ?? [])], {...style, interactive: false});
    } else {
      (shape.many ?? []).forEach((one) => this.put(layer, one.shape, style, one.label));
      return;
    }
    made.addTo(layer);
    if (label) {
      const words = document.createElement('span');
      words.textContent = label;
      made.bindTooltip(words, {permanent: true, direction: shape.point ? 'top' : 'center', offset: [0, shape.point ? -4 : 0], className: 'label'});
    }
  }

  /** Shows what belongs to a decision. @param shapes as `{label, shape}` @param isTight whether the map shows no more than that */
  preview(shapes: Labelled[], isTight = false) {
    this.question.clearLayers();
    const points: LatLon[] = [];
    for (const one of shapes) {
      this.put(this.question, one.shape, {color: '#ff6f00', weight: 4, fillOpacity: 0.15}, one.label);
      points.push(...Chart.points(one.shape));
    }
    this.bring(points, isTight);
  }

  bring(points: LatLon[], isTight: boolean) {
    if (points.length > 0 && (isTight || !this.map.getBounds().contains(L.latLngBounds(points)))) {
      this.map.fitBounds(L.latLngBounds(points).pad(0.3), {maxZoom: 18, animate: false});
    }
  }

  /** Stresses the boats that a decision shows, and brings those that it asks for into view. */
  stress(link: Link, decision: DecisionRow | null) {
    this.stressed = new Set(decision?.show?.boats ?? []);
    const placed = Chart.placed((decision?.view?.boats ?? []).map((id) => link.row('boats', id)));
    this.bring(placed.map(Chart.at), decision?.view?.change === 'reduce');
    this.withPaths = Boolean(decision?.show?.paths);
    this.drawn = ''; // ways are drawn again
  }

  static points(shape: Shape): LatLon[] {
    return shape.point ? [shape.point] : shape.path ?? shape.area ?? (shape.many ?? []).flatMap((one) => Chart.points(one.shape));
  }

  /** Shows what is being drawn. */
  draft(shape: Shape | null) {
    this.drawing.clearLayers();
    if (shape) {
      this.put(this.drawing, shape, {color: '#d500f9', weight: 4, fillOpacity: 0.2});
      Chart.points(shape).slice(0, 500).forEach((point) => L.circleMarker(point, {radius: 6, color: '#d500f9', interactive: false}).addTo(this.drawing));
    }
  }
}

package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.LongFunction;
import java.util.function.LongSupplier;
import org.sami.boat.link.LookoutReadings;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.markup.MapRelevance.Visualization;
import org.sami.crw.markup.MarkedEvent;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.map.AreaVariables;
import org.sami.crw.operator.map.LayerChoice;
import org.sami.crw.operator.map.LayerState;
import org.sami.crw.operator.map.MapBounds;
import org.sami.crw.operator.map.MapEvents;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.crw.operator.map.MapTracks;
import org.sami.crw.operator.map.MapViews;
import org.sami.crw.operator.map.NamedArea;
import org.sami.crw.operator.map.NewestReading;
import org.sami.crw.operator.map.NewestReadings;
import org.sami.crw.operator.map.SeenVessel;
import org.sami.crw.operator.map.SeenVessels;
import org.sami.crw.operator.map.SensorChannel;
import org.sami.crw.operator.map.SensorFields;
import org.sami.crw.operator.map.SensorLayer;
import org.sami.crw.operator.map.ShownBoat;
import org.sami.crw.operator.map.ShownLayer;
import org.sami.crw.operator.map.ShownPath;
import org.sami.crw.operator.map.ShownPlace;
import org.sami.crw.operator.map.ShownTrack;
import org.sami.crw.operator.map.ShownWayHome;
import org.sami.crw.operator.map.WayAhead;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.Drift;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.GeoPoint;

/**
 * The contents of the operator's map, from the state of boats and missions, from the markups Relevant Area, Relevant Information and Relevant Proxy,
 * and from the operator's choices (thesis 5.2.1, 5.3). Methods for the operator may be called from any thread and take effect a little later.
 */
public final class MapModel extends Model<MapSnapshot> {
    private final Consumer<Runnable> inbox;
    private final CommandModel commands;
    private final AreaVariables variables;
    private MapEvents events;
    private final LongFunction<String> missions;
    private final LayerChoice layers;
    private final LongSupplier nowMillis;
    private final MapViews views;
    private final MapTracks tracks = new MapTracks();
    private final SeenVessels vessels = new SeenVessels();
    private final SensorFields fields;
    private final NewestReadings newest = new NewestReadings();
    private final Map<String, BoatSnapshot> boats = new TreeMap<>();
    private Set<Long> shownMissions = Set.of();
    private Set<String> pointedAt = Set.of();
    private List<SensorLayer> data = List.of();
    private List<SensorChannel> channels = List.of();

    /**
     * An empty map.
     *
     * @param missions names a mission
     * @param computing computes what sensors measured; one after the other, and no window's thread
     */
    MapModel(
            Consumer<Runnable> inbox,
            CommandModel commands,
            AreaVariables variables,
            LongFunction<String> missions,
            Executor computing,
            LongSupplier nowMillis) {
        super(MapSnapshot.EMPTY);
        this.inbox = inbox;
        this.commands = commands;
        this.variables = variables;
        this.missions = missions;
        this.nowMillis = nowMillis;
        events = new MapEvents(nowMillis, missions);
        layers = new LayerChoice(missions);
        views = new MapViews(missions);
        fields = new SensorFields(computing, (known, made) -> inbox.accept(() -> computed(known, made)));
    }

    // ---- what the operator wants to see; from any thread

    /** A layer is on or off from now on, whatever markup says; empty leaves it to markup again. */
    public void show(ShownLayer layer, Optional<Boolean> on) {
        inbox.accept(() -> {
            layers.set(layer, on);
            changed();
        });
    }

    /** What a sensor measured is drawn so from now on; empty leaves it to markup again. */
    public void showData(SensorChannel channel, Optional<Visualization> visualization) {
        inbox.accept(() -> {
            layers.showData(channel, visualization);
            changed();
        });
    }

    /** From which value on cells are drawn with {@link Visualization#THRESHOLD}, in the channel's unit. */
    public void setThreshold(SensorChannel channel, double value) {
        inbox.accept(() -> {
            layers.threshold(channel, value);
            changed();
        });
    }

    /** Only what these missions speak of is drawn from now on, next to what the project draws; none = all missions. */
    public void showMissions(Set<Long> missions) {
        Set<Long> copy = Set.copyOf(missions);
        inbox.accept(() -> {
            shownMissions = copy;
            changed();
        });
    }

    /** Points at boats, as for a message that the operator chose (thesis 6.3.3): the view has them in it. None = at nobody. */
    public void pointAt(List<String> named, String why) {
        Set<String> copy = new LinkedHashSet<>(named);
        inbox.accept(() -> {
            pointedAt = copy;
            views.pointAt(positions(copy), why);
            changed();
        });
    }

    /** What the map shows now, as the operator has moved it, in degrees. */
    public void moved(double southDeg, double westDeg, double northDeg, double eastDeg) {
        inbox.accept(() -> {
            events.touched();
            views.shown(new MapBounds(southDeg, westDeg, northDeg, eastDeg));
        });
    }

    /** The operator has used the map. */
    public void touched() {
        inbox.accept(events::touched);
    }

    /** The operator's focus has come to the map, or left it. */
    public void focus(boolean on) {
        inbox.accept(() -> events.focus(on));
    }

    // ---- what happens; on the owner's thread, but where said

    void seen(BoatSnapshot boat) {
        boolean isNew = boats.put(boat.boat(), boat) == null;
        boat.pose().ifPresent(pose -> tracks.at(boat.boat(), pose.position(), boat.poseAtMillis()));
        if (isNew) {
            changed();
        } else {
            change();
        }
    }

    void gone(String boat) {
        boats.remove(boat);
        newest.remove(boat);
        tracks.remove(boat);
        changed();
    }

    /** Forgets what happened; what the operator wants to see stays. */
    void clear() {
        events = new MapEvents(nowMillis, missions);
        boats.clear();
        tracks.clear();
        vessels.clear();
        fields.clear();
        newest.clear();
        data = List.of();
        channels = List.of();
        changed();
    }

    /** Paths, or areas and places, may have changed. */
    void refresh() {
        change();
    }

    void apply(EngineStep step) {
        for (MarkedEvent event : step.marked()) {
            events.came(event).ifPresent(this::come);
        }
        boolean ended = false;
        for (Effect effect : step.effects()) {
            if (effect instanceof Effect.ActivationEnded over) {
                ended |= events.ended(over.activation());
            } else if (effect instanceof Effect.MissionEnded over && over.outcome() != Outcome.HALTED) {
                ended |= events.missionEnded(over.mission());
            }
        }
        if (ended || !step.marked().isEmpty()) {
            changed();
        }
    }

    /** Takes up the events whose visits go on in a state that was restored. */
    void restore(List<MarkedEvent> open) {
        open.forEach(event -> events.came(event).ifPresent(this::come));
        changed();
    }

    private void come(MarkedEvent event) {
        event.relevance(boats.keySet()).area().ifPresent(area -> views.come(event, area, positions(area.boats())));
    }

    private List<GeoPoint> positions(Collection<String> named) {
        return named.stream().flatMap(boat -> position(boat).stream()).toList();
    }

    private Optional<GeoPoint> position(String boat) {
        return Optional.ofNullable(boats.get(boat)).flatMap(BoatSnapshot::pose).map(BoatPose::position);
    }

    /** Takes up where boats were, and what they measured, in earlier processes of the session. From any thread, before boats are seen. */
    public void restoreHistory(List<ShownTrack> earlier, List<FleetEvent.Measured> readings) {
        readings.stream()
                .filter(one -> !one.reading().sensor().equals(LookoutReadings.SENSOR)) // they have gone on since
                .forEach(one -> fields.measured(one.boat(), one.reading()));
        inbox.accept(() -> {
            earlier.forEach(track ->
                    track.points().forEach(point -> tracks.at(track.boat(), point.position(), point.atMillis())));
            changed();
        });
    }

    /** A boat has measured. From any thread. */
    void measured(FleetEvent.Measured measured) {
        if (measured.reading().sensor().equals(LookoutReadings.SENSOR)) {
            long atMillis = nowMillis.getAsLong();
            SeenVessel.of(measured.reading())
                    .ifPresent(vessel -> inbox.accept(() -> {
                        vessels.seen(vessel, atMillis);
                        change();
                    }));
            return;
        }
        newest.take(measured.boat(), measured.reading(), nowMillis.getAsLong());
        fields.measured(measured.boat(), measured.reading());
    }

    /** What boats measured last since this process began, by boat and channel. From any thread. */
    public List<NewestReading> readings() {
        return newest.all();
    }

    /** Computes a layer of readings, beside those that are shown; as {@link SensorFields#layer}. From any thread. */
    public CompletionStage<Optional<SensorLayer>> layer(String word, Visualization visualization) {
        return fields.layer(word, visualization);
    }

    /** Time has passed. From any thread, often. */
    void look(long nowMillis) {
        fields.look(nowMillis);
    }

    /** Time has passed: changes that waited are made. */
    void tick(long nowMillis) {
        if (vessels.tick(nowMillis)) {
            change();
        }
        if (events.hasWaiting()) {
            events.due(nowMillis).forEach(this::come);
            changed();
        }
    }

    private void computed(List<SensorChannel> known, List<SensorLayer> made) {
        channels = known;
        data = made;
        change();
    }

    /** Which data are needed may have changed as well. */
    private void changed() {
        fields.want(layers.requests(inForce(), boats.keySet()));
        change();
    }

    private List<MarkedEvent> inForce() {
        return events.inForce().stream()
                .filter(event -> isShown(event.mission()))
                .toList();
    }

    private boolean isShown(long mission) {
        return shownMissions.isEmpty() || shownMissions.contains(mission);
    }

    @Override
    MapSnapshot take() {
        List<MarkedEvent> now = inForce();
        List<LayerState> states = layers.states(now, boats.keySet());
        return new MapSnapshot(
                states,
                boatsOnMap(highlighted(now)),
                tracks.snapshots(),
                paths(),
                waysHome(),
                areas(now),
                places(now),
                data,
                channels,
                views.view(),
                events.heldBack());
    }

    private Set<String> highlighted(List<MarkedEvent> now) {
        Set<String> named = new LinkedHashSet<>(pointedAt);
        now.forEach(event -> event.relevance(boats.keySet()).boats().ifPresent(shown -> named.addAll(shown.boats())));
        return named;
    }

    private List<ShownBoat> boatsOnMap(Set<String> highlighted) {
        List<ShownBoat> found = new ArrayList<>();
        for (BoatSnapshot boat : boats.values()) {
            boat.pose()
                    .ifPresent(pose -> found.add(new ShownBoat(
                            boat.boat(),
                            pose.position(),
                            pose.headingRad(),
                            boat.drift()
                                    .filter(Drift::isMoving)
                                    .map(Drift::courseRad)
                                    .orElse(pose.headingRad()),
                            boat.speedMps().orElse(0),
                            boat.poseAtMillis(),
                            boat.battery()
                                    .map(BatteryState::percent)
                                    .map(OptionalDouble::of)
                                    .orElse(OptionalDouble.empty()),
                            boat.link(),
                            highlighted.contains(boat.boat()))));
        }
        return found;
    }

    private List<ShownPath> paths() {
        List<ShownPath> paths = new ArrayList<>();
        for (String boat : boats.keySet()) {
            CommandQueueSnapshot queue = commands.queue(boat);
            queue.current().ifPresent(entry -> add(boat, entry, true, paths));
            queue.waiting().forEach(entry -> add(boat, entry, false, paths));
        }
        return paths;
    }

    private List<ShownWayHome> waysHome() {
        return boats.values().stream()
                .filter(boat -> !boat.wayHome().isEmpty())
                .map(boat -> new ShownWayHome(boat.boat(), boat.wayHome()))
                .toList();
    }

    private void add(String boat, CommandQueueSnapshot.Entry entry, boolean current, List<ShownPath> paths) {
        BoatCommand command = entry.command();
        List<GeoPoint> points = command.points();
        if (!points.isEmpty() && isShown(command.mission())) {
            WayAhead way =
                    WayAhead.of(points, entry.visited(), commands.way(boat, command.commandId()), position(boat));
            paths.add(new ShownPath(boat, command.mission(), command.commandId(), way.points(), way.behind(), current));
        }
    }

    private static Optional<MapRelevance.Area> area(MarkedEvent event) {
        return event.relevance(List.of()).area();
    }

    private List<NamedArea> areas(List<MarkedEvent> now) {
        List<NamedArea> areas = new ArrayList<>(variables.areas());
        now.forEach(event -> area(event)
                .flatMap(MapRelevance.Area::area)
                .ifPresent(area -> areas.add(
                        new NamedArea(ShownLayer.RELEVANT_AREA, event.mission(), event.words(missions), area))));
        areas.removeIf(area -> area.mission() != 0 && !isShown(area.mission()));
        return areas;
    }

    private List<ShownPlace> places(List<MarkedEvent> now) {
        List<ShownPlace> places = new ArrayList<>(variables.places());
        now.forEach(event -> area(event)
                .flatMap(MapRelevance.Area::point)
                .ifPresent(point -> places.add(new ShownPlace(event.mission(), event.words(missions), point))));
        places.addAll(vessels.places());
        places.removeIf(place -> place.mission() != 0 && !isShown(place.mission()));
        return places;
    }
}

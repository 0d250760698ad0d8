package org.sami.uav.handler;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.HandlerModule;
import org.sami.crw.handler.HandlerParts;
import org.sami.crw.handler.planning.BoatDemands;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.spn.host.HostListener;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;

/** The handlers of the aircraft domain. */
public final class UavHandlers implements HandlerModule {
    private static final String WIND = "wind";
    private static final double WIND_LIMIT_MPS = 10;

    @Override
    public String domain() {
        return "uav";
    }

    @Override
    public RobotKind robots() {
        return RobotKind.COPTER;
    }

    @Override
    public Set<String> moves() {
        return UavEvents.MOVES;
    }

    @Override
    public Map<String, BoatDemands.Demand> demands() {
        return UavEvents.DEMANDS;
    }

    @Override
    public void addTo(HandlerParts parts) {
        Flights flights = new Flights(parts.robots(), parts.motion(), parts.fleet());
        parts.listen((Consumer<FleetEvent>) flights);
        parts.listen((HostListener) flights);
        parts.addLater(flights);
        Sightings sightings = new Sightings();
        parts.listen((Consumer<FleetEvent>) sightings);
        addFlights(parts, flights);
        addSearch(parts, flights, sightings);
        addPlanning(parts, flights);
        addWatches(parts, sightings);
        AircraftNews news = new AircraftNews(parts.host());
        parts.listen((Consumer<FleetEvent>) news);
        parts.listen((HostListener) news);
    }

    private static void addFlights(HandlerParts parts, Flights flights) {
        TaskFlights tasks = new TaskFlights(
                parts.robots(),
                flights,
                parts.motion(),
                parts.fleet(),
                new LowBatteryTasks(parts.messages()),
                Set.of(UavEvents.SEARCH_AROUND));
        parts.addMotion(UavEvents.FLY_TO, new FlyToHandler(flights, tasks));
        parts.listen((Consumer<FleetEvent>) tasks);
        parts.listen((HostListener) tasks);
        parts.addLater(tasks);
        parts.addMotion(UavEvents.TAKE_OFF, VerticalHandler.climbing(flights, UavEvents.AIRBORNE));
        parts.addMotion(UavEvents.CLIMB_TO, VerticalHandler.climbing(flights, UavEvents.ALTITUDE_REACHED));
        parts.addMotion(UavEvents.LAND, VerticalHandler.landing(flights));
        parts.addMotion(UavEvents.RETURN_HOME, new ReturnHomeHandler(flights));
        parts.addMotion(UavEvents.FLY_PATH, new FlyPathHandler(flights));
        parts.addMotion(UavEvents.HOVER, HoverHandler.staying(parts.motion()));
        parts.addMotion(UavEvents.LOOK_AROUND, HoverHandler.looking(parts.motion()));
    }

    private static void addSearch(HandlerParts parts, Flights flights, Sightings sightings) {
        SearchAroundHandler search = new SearchAroundHandler(flights, sightings);
        parts.addMotion(UavEvents.SEARCH_AROUND, search);
        parts.listen((Consumer<FleetEvent>) search);
        FollowHandler follow =
                new FollowHandler(parts.robots(), flights, parts.motion(), parts.messages(), parts.fleet());
        parts.addMotion(UavEvents.FOLLOW, follow);
        parts.listen((Consumer<FleetEvent>) follow);
        parts.listen((HostListener) follow);
        parts.addLater(follow);
    }

    private static void addPlanning(HandlerParts parts, Flights flights) {
        TaskFailures failures = new TaskFailures(
                parts.fleet(),
                new ImpossibleTasks(parts.host(), parts.robots(), parts.messages()),
                new TaskFailureMemory(parts.host()));
        parts.listen((Consumer<FleetEvent>) failures);
        parts.listen((HostListener) failures);
        TaskDivision division = new TaskDivision(flights, parts.messages(), parts.fleet(), failures);
        parts.add(UavEvents.COMPUTE_ALLOCATIONS, division);
        parts.listen((Consumer<FleetEvent>) division);
        parts.listen((HostListener) division);
        parts.add(UavEvents.GIVE_BACK_TASKS, new GiveBackTasksHandler());
        parts.add(UavEvents.PLAN_LANES, new LanePlanHandler(parts, flights));
    }

    private static void addWatches(HandlerParts parts, Sightings sightings) {
        Watches wind = new Watches(parts.fleet());
        parts.add(UavEvents.WATCH_WIND, wind::begin);
        parts.listen(wind);
        parts.listen((FleetEvent event) -> {
            if (event instanceof FleetEvent.Measured measured) {
                windReported(wind, measured.boat(), measured.reading());
            }
        });
        Watches targets = new Watches(parts.fleet());
        parts.add(UavEvents.WATCH_TARGETS, targets::begin);
        parts.listen(targets);
        sightings.listen((aircraft, number, at) -> targets.observed(
                aircraft,
                "target " + number,
                UavEvents.TARGET_SIGHTED,
                Map.of("at", at, "places", new ListValue(List.of(at))),
                watching -> true));
    }

    private static void windReported(Watches watches, String aircraft, BoatReading reading) {
        List<Double> values = reading.values();
        if (reading.channel().equals(WIND)) {
            watches.observed(
                    aircraft,
                    "strong",
                    UavEvents.WIND_STRONG,
                    Map.of("speed", new RealValue(values.get(0))),
                    watching -> values.get(0) > Flights.number(watching, "limit", WIND_LIMIT_MPS));
        }
    }
}

package org.sami.boat.mavlink;

import java.util.List;
import java.util.Optional;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.OnboardModes;
import org.sami.mavlink.onboard.OrderReply;
import org.sami.mavlink.onboard.StationOrder;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Does what a ground station that commands the boat orders. Our boats have no arming: here a boat is armed once a station has armed it, or while it moves or
 * keeps its place for anybody. A mode that is chosen while it is disarmed begins when it is armed, as with ArduPilot. For the boat's thread.
 */
final class BoatVehicle {
    private static final String NO_MISSION = "there is no mission";

    private final String name;
    private final BoatClient boat;
    private final CommandingStation command;
    private final StationStop stop;
    private final BoatMission mission;
    private final BoatParameters parameters;
    private final StationWayCheck ways;
    private int mode = OnboardModes.HOLD; // that a station has chosen
    private boolean armed;
    private Optional<Waypoint> target = Optional.empty(); // in mode GUIDED

    BoatVehicle(
            String name,
            BoatClient boat,
            CommandingStation command,
            BoatMission mission,
            BoatParameters parameters,
            StationWayCheck ways) {
        this.name = name;
        this.boat = boat;
        this.command = command;
        stop = new StationStop(boat, command);
        this.mission = mission;
        this.parameters = parameters;
        this.ways = ways;
        boat.disarmsBy(() -> !armed);
    }

    /** Carries out an order, or says why not. */
    OrderReply order(VehicleId station, StationOrder order, long nowMs) {
        if (order instanceof StationOrder.Disarm) {
            return disarm(station, nowMs);
        } else if (order instanceof StationOrder.Steer sticks) {
            return steer(station, sticks, nowMs);
        }
        Optional<String> wrong = whyWrong(order, nowMs);
        if (wrong.isPresent()) {
            return OrderReply.denied(wrong.get());
        }
        Optional<String> refused = command.take(station, nowMs);
        if (refused.isPresent()) {
            return OrderReply.notNow(refused.get());
        }
        if (order instanceof StationOrder.Arm) {
            return arm(nowMs);
        } else if (order instanceof StationOrder.ChangeMode change) {
            return change((int) change.customMode(), nowMs);
        } else if (order instanceof StationOrder.GoTo place) {
            return goTo(place, nowMs);
        } else if (order instanceof StationOrder.StartMission start) {
            return startMission(start, nowMs);
        } else if (order instanceof StationOrder.GoOnAt at) {
            return goOnAt(at.item(), nowMs);
        } else if (order instanceof StationOrder.Pause) {
            return change(OnboardModes.LOITER, nowMs);
        } else if (order instanceof StationOrder.ChangeSpeed speed) {
            parameters.setSpeedMps(speed.speedMps());
            return drivesMission() || target.isPresent() ? begin(nowMs) : OrderReply.ACCEPTED;
        }
        throw new IllegalStateException("no way to carry out " + order);
    }

    /** What is wrong with an order whoever commands; an order that cannot be carried out takes no command. */
    private Optional<String> whyWrong(StationOrder order, long nowMs) {
        if (order instanceof StationOrder.ChangeMode change && !BoatModes.isKnown(change.customMode())) {
            return Optional.of(name + " has no " + OnboardModes.name(change.customMode())
                    + "; it has MANUAL, HOLD, LOITER, AUTO, RTL, GUIDED");
        } else if (order instanceof StationOrder.GoTo place && !boat.commands() && !place.changesMode()) {
            return Optional.of("choose GUIDED first");
        } else if (drivesMission(order) && mission.isEmpty(home())) {
            return Optional.of(NO_MISSION);
        } else if (order instanceof StationOrder.ChangeSpeed speed) {
            return BoatParameters.whyNoSpeed(speed.speedMps());
        } else if (order instanceof StationOrder.GoTo place) {
            return ways.toPlace(new Position(place.latDeg(), place.lonDeg()), nowMs);
        }
        return Optional.empty();
    }

    private static boolean drivesMission(StationOrder order) {
        return order instanceof StationOrder.StartMission
                || (order instanceof StationOrder.ChangeMode change && change.customMode() == OnboardModes.AUTO);
    }

    private OrderReply disarm(VehicleId station, long nowMs) {
        armed = false;
        mission.pause();
        target = Optional.empty();
        return stop.stop(station, nowMs).map(OrderReply::failed).orElse(OrderReply.ACCEPTED);
    }

    /** An arm that cannot begin releases no stop. */
    private OrderReply arm(long nowMs) {
        Optional<String> held = stop.whyNotReleased();
        if (held.isPresent()) {
            return OrderReply.failed(name + " is stopped " + held.get());
        } else if (armed && !stop.isLatched()) {
            return OrderReply.ACCEPTED;
        }
        Optional<String> cannot = whyNot(mode, nowMs);
        if (cannot.isPresent()) {
            return OrderReply.failed(cannot.get());
        }
        stop.release(nowMs);
        armed = true;
        OrderReply begun = begin(nowMs);
        armed = begun.isAccepted();
        return begun;
    }

    private OrderReply change(int next, long nowMs) {
        Optional<String> cannot = armed ? whyNot(next, nowMs) : Optional.empty();
        if (cannot.isPresent()) {
            return OrderReply.failed(cannot.get());
        }
        if (next != OnboardModes.AUTO) {
            mission.pause();
        }
        target = Optional.empty();
        mode = next;
        return armed ? begin(nowMs) : OrderReply.ACCEPTED;
    }

    /** Why a mode cannot begin now; looks only, so that what cannot begin ends nothing. */
    private Optional<String> whyNot(int next, long nowMs) {
        if (next == OnboardModes.RETURN) {
            return home().isPresent() ? whyNoReturn(nowMs) : Optional.of("it has no home");
        } else if (next == OnboardModes.MANUAL) {
            return ways.byHand();
        } else if (next != OnboardModes.AUTO) {
            return Optional.empty();
        } else if (mission.isEmpty(home())) {
            return Optional.of(NO_MISSION);
        }
        return ways.along(mission.ahead(home()), nowMs);
    }

    /** Has the boat do what the mode says. */
    private OrderReply begin(long nowMs) {
        Optional<String> refused = switch (mode) {
            case OnboardModes.AUTO -> mission.start(parameters.speedMps(), BoatParameters.MOST_MPS, home(), nowMs);
            case OnboardModes.RETURN ->
                home().map(at -> drive(new Waypoint(at.latDeg(), at.lonDeg(), parameters.speedMps()), nowMs))
                        .orElse(Optional.of("it has no home"));
            case OnboardModes.GUIDED ->
                target.map(at -> drive(new Waypoint(at.latDeg(), at.lonDeg(), parameters.speedMps()), nowMs))
                        .orElseGet(() -> boat.send(HoldPosition::new, nowMs));
            case OnboardModes.LOITER -> boat.send(HoldPosition::new, nowMs);
            default -> boat.send(StopMotors::new, nowMs); // HOLD, and MANUAL until sticks come
        };
        return refused.map(OrderReply::failed).orElse(OrderReply.ACCEPTED);
    }

    private Optional<String> drive(Waypoint to, long nowMs) {
        String id = boat.newListId();
        Optional<String> refused = boat.send(command -> new UploadWaypoints(command, id, List.of(to)), nowMs);
        return refused.isPresent() ? refused : boat.send(command -> new StartWaypoints(command, id, 0), nowMs);
    }

    private OrderReply goTo(StationOrder.GoTo place, long nowMs) {
        if (!armed) {
            return OrderReply.notNow(name + " is not armed");
        } else if (mode != OnboardModes.GUIDED && !place.changesMode()) {
            return OrderReply.notNow("choose GUIDED first");
        }
        place.speedMps().ifPresent(parameters::setSpeedMps);
        Waypoint next = new Waypoint(place.latDeg(), place.lonDeg(), parameters.speedMps());
        if (mode == OnboardModes.GUIDED && target.equals(Optional.of(next))) {
            return OrderReply.ACCEPTED; // stations repeat it; the boat is on its way
        }
        mission.pause();
        mode = OnboardModes.GUIDED;
        target = Optional.of(next);
        return begin(nowMs);
    }

    private OrderReply startMission(StationOrder.StartMission start, long nowMs) {
        if (!armed) {
            return OrderReply.notNow(name + " is not armed");
        }
        OrderReply next = start.item() > 0 ? setItem(start.item(), nowMs) : OrderReply.ACCEPTED;
        return next.isAccepted() ? change(OnboardModes.AUTO, nowMs) : next;
    }

    private OrderReply goOnAt(int item, long nowMs) {
        OrderReply next = setItem(item, nowMs);
        return next.isAccepted() && drivesMission() ? begin(nowMs) : next;
    }

    /** A mission under way that may not go on at an item goes on as before. */
    private OrderReply setItem(int item, long nowMs) {
        Optional<String> cannot = drivesMission() ? ways.along(mission.aheadAt(item, home()), nowMs) : Optional.empty();
        if (cannot.isPresent()) {
            return OrderReply.failed(cannot.get());
        }
        return mission.goOnAt(item, home())
                ? OrderReply.ACCEPTED
                : OrderReply.denied("the mission leads nowhere at item " + item + " or after it");
    }

    /** Sticks take no command: they are only for who has chosen MANUAL. */
    private OrderReply steer(VehicleId station, StationOrder.Steer sticks, long nowMs) {
        if (!armed || mode != OnboardModes.MANUAL || !command.isHolder(station)) {
            return OrderReply.notNow("");
        }
        boat.steer(new Teleoperate(sticks.thrust(), sticks.turn()), nowMs);
        return OrderReply.ACCEPTED;
    }

    /** The command was won or lost: what a station had armed and chosen before counts no longer. */
    void commandChanged(boolean commands) {
        armed = commands && boatMode() != BoatMode.STOPPED && boatMode() != BoatMode.FLEET_STOP;
        mode = BoatModes.shown(boatMode());
        target = Optional.empty();
        mission.pause();
    }

    /** Looks what has happened to the boat by itself, or by others. */
    void watch() {
        if (boatMode() == BoatMode.FLEET_STOP && armed) {
            armed = false;
            mission.pause();
        }
        if (mode == OnboardModes.AUTO && mission.progress().isDone()) {
            mode = OnboardModes.LOITER; // what the boat does at the end of its list
        }
    }

    private BoatMode boatMode() {
        return boat.mode();
    }

    /** Whether it drives a list, for a station or still that of the base that has handed it over on its way. */
    private boolean drivesList() {
        return mode == OnboardModes.AUTO && boat.commands() && boatMode() == BoatMode.PATH;
    }

    /** Whether what it drives is the mission that stations are shown: it was started, or the base's list is shown as it. */
    private boolean drivesMission() {
        return mission.isUnderWay() || (drivesList() && mission.isList(boat.listId()));
    }

    /** The number of the mode that stations are shown. */
    int mode() {
        return boat.commands() && boatMode() != BoatMode.FLEET_STOP ? mode : BoatModes.shown(boatMode());
    }

    /** Whether the motors may turn. */
    boolean isArmed() {
        return boat.commands() ? armed : boatMode() != BoatMode.STOPPED && boatMode() != BoatMode.FLEET_STOP;
    }

    /** Where the boat returns to. */
    Optional<Waypoint> home() {
        return boat.settings().flatMap(SettingsReport::home);
    }

    /** A mission came; one that is under way does not go on by itself with other items. */
    Optional<String> missionChanged(List<MissionItem> items, long nowMs) {
        boolean stops = (mission.isUnderWay() || drivesList()) && boat.commands();
        mission.replace(items);
        if (!stops) {
            return Optional.empty();
        }
        keepPlace(nowMs);
        return Optional.of("the mission is another: " + name + " keeps its place until AUTO is chosen again");
    }

    /** The boat keeps its place in place of what it drives to; whether it keeps it, as not with its motors off. */
    boolean keepPlace(long nowMs) {
        if (!armed || mode == OnboardModes.HOLD) {
            return false;
        }
        return change(OnboardModes.LOITER, nowMs).isAccepted();
    }

    /** Another fence came; why the boat does not go on where that does not let it. */
    Optional<String> fenceChanged(long nowMs) {
        Optional<String> why = target.isPresent()
                ? ways.toPlace(new Position(target.get().latDeg(), target.get().lonDeg()), nowMs)
                : drivesMission() || mode == OnboardModes.RETURN ? whyNot(mode, nowMs) : Optional.empty();
        return why.isPresent() && boat.commands() && keepPlace(nowMs)
                ? Optional.of("the fence is another, and " + why.get() + ": " + name + " keeps its place")
                : Optional.empty();
    }

    /** Why the fence does not let it return; empty where it does. */
    Optional<String> whyNoReturn(long nowMs) {
        return home().flatMap(at -> ways.toHome(at, nowMs));
    }
}

package org.sami.boat.mavlink;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.Executor;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.Progress;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.Telemetry;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.tcp.BoatCompanion;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.OnboardHost;
import org.sami.mavlink.onboard.OnboardLink;
import org.sami.mavlink.onboard.OnboardParameter;
import org.sami.mavlink.onboard.OnboardState;
import org.sami.mavlink.onboard.OnboardState.BatteryState;
import org.sami.mavlink.onboard.OnboardState.Place;
import org.sami.mavlink.onboard.OrderReply;
import org.sami.mavlink.onboard.StationOrder;
import org.sami.mavlink.vehicle.TextSeverity;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * A boat of ours in ground stations that speak MAVLink. It works in the boat's process, as a client of the boat's server: it reports the boat as a surface boat, and
 * carries out what a station orders while no base of ours commands. To be attached to the boat's server, and closed once it is detached.
 */
public final class GroundStationLink implements BoatCompanion, AutoCloseable {
    private static final int MOST_ITEMS = 5_000;

    private final String name;
    private final int system;
    private final MavlinkAddress address;
    private final SteadyClock clock;
    private volatile Optional<Attachment> attachment = Optional.empty();
    private volatile boolean closed;
    private volatile long heardMs = Long.MIN_VALUE;

    /**
     * A link that is not begun yet.
     *
     * @param name of the boat
     * @param system its system id, 1 to 254, another for each boat
     * @param clock the boat's clock
     * @throws IllegalArgumentException if the system id is not one
     */
    public GroundStationLink(String name, int system, MavlinkAddress address, SteadyClock clock) {
        OnboardLink.checkSystem(system);
        this.name = Objects.requireNonNull(name, "name");
        this.system = system;
        this.address = Objects.requireNonNull(address, "address");
        this.clock = Objects.requireNonNull(clock, "clock");
    }

    /** The boat. */
    public String boat() {
        return name;
    }

    /** Its system id. */
    public int system() {
        return system;
    }

    /** How the link is; empty before it has begun. For any thread. */
    public Optional<MavlinkLinkReport> report() {
        return attachment.map(now -> now.link.report());
    }

    /** How long ago a ground station was heard, in ms; empty where none was. For any thread. */
    public OptionalLong heardAgoMs() {
        long last = heardMs;
        return last == Long.MIN_VALUE ? OptionalLong.empty() : OptionalLong.of(clock.getAsLong() - last);
    }

    @Override
    public void begin(BoatServer boat, Executor boatThread, long nowMs) {
        Attachment now = new Attachment(boat, boatThread, nowMs);
        attachment = Optional.of(now);
        if (!closed) {
            now.link.start();
        }
    }

    @Override
    public void tick(long nowMs) {
        attachment.ifPresent(now -> now.tick(nowMs));
    }

    @Override
    public void end(long nowMs) {
        attachment.ifPresent(now -> now.boat.close(nowMs));
    }

    /** Closes the link to ground stations and waits for its threads; not for the boat's thread. */
    @Override
    public void close() {
        closed = true;
        attachment.ifPresent(now -> now.link.close());
    }

    /** The parts that work while it is attached. For the boat's thread. */
    private final class Attachment implements OnboardHost {
        private final OnboardLink link;
        private final BoatClient boat;
        private final CommandingStation command;
        private final BoatMission mission;
        private final BoatParameters parameters;
        private final BoatVehicle vehicle;
        private final BoatFence fence = new BoatFence();
        private final FenceGuard guard;
        private final StationLists lists;
        private BatteryLevel level = BatteryLevel.NOMINAL;
        private String shownList = "";

        Attachment(BoatServer server, Executor boatThread, long nowMs) {
            link = new OnboardLink(name, system, address, MOST_ITEMS, this, boatThread, clock);
            boat = new BoatClient(server, nowMs);
            command = new CommandingStation(boat, name, link::say, this::commandChanged, nowMs);
            mission = new BoatMission(boat);
            parameters = new BoatParameters(boat, system);
            StationWayCheck ways = new StationWayCheck(name, boat, fence);
            vehicle = new BoatVehicle(name, boat, command, mission, parameters, ways);
            guard = new FenceGuard(name, boat, fence, vehicle, link::say, link::fenceChanged);
            lists = new StationLists(name, command, vehicle, fence, guard, link, clock);
        }

        private void commandChanged(boolean commands) {
            vehicle.commandChanged(commands);
        }

        void tick(long nowMs) {
            command.watch(nowMs);
            boat.takeProgress().forEach(progress -> moved(progress, nowMs));
            boat.takeReadings().forEach(this::measured);
            mission.tick(nowMs);
            vehicle.watch();
            guard.tick(nowMs);
            boat.battery().map(BatteryReport::level).filter(now -> now != level).ifPresent(this::battery);
            link.tick(nowMs);
        }

        private void moved(Progress progress, long nowMs) {
            mission.take(progress, nowMs).ifPresent(link::reached);
            boolean ofBase =
                    !boat.isOwnList(progress.listId()) && boat.otherCommander().isPresent();
            if (ofBase && !progress.listId().isEmpty() && !progress.listId().equals(shownList)) {
                shownList = progress.listId();
                List<MissionItem> shown = MissionPath.missionOf(boat.waypoints(), vehicle.home());
                mission.show(shown, shownList);
                link.hold(shown);
                mission.take(progress, nowMs);
            }
        }

        private void measured(SensorReport reading) {
            if (reading.values().size() == 1) {
                link.measured(reading.channel(), reading.values().get(0));
            }
        }

        private void battery(BatteryLevel now) {
            level = now;
            if (now != BatteryLevel.NOMINAL) {
                link.say(
                        now == BatteryLevel.LOW ? TextSeverity.WARNING : TextSeverity.CRITICAL,
                        "battery of " + name + (now == BatteryLevel.LOW ? " low" : " critical"));
            }
        }

        @Override
        public OnboardState state() {
            Optional<Telemetry> here = boat.telemetry(clock.getAsLong());
            return new OnboardState(
                    here.map(at -> new Place(at.latDeg(), at.lonDeg(), at.headingRad(), at.speedMps())),
                    vehicle.home().map(home -> new Place(home.latDeg(), home.lonDeg(), 0, 0)),
                    boat.batteryPercent(),
                    switch (level) {
                        case NOMINAL -> BatteryState.OK;
                        case LOW -> BatteryState.LOW;
                        case CRITICAL -> BatteryState.CRITICAL;
                    },
                    vehicle.mode(),
                    vehicle.isArmed(),
                    boat.isLost() && vehicle.isArmed(),
                    mission.progress(),
                    fence.state());
        }

        @Override
        public void heard(VehicleId station) {
            heardMs = clock.getAsLong();
            command.heard(station, heardMs);
        }

        @Override
        public OrderReply order(VehicleId station, StationOrder order) {
            return vehicle.order(station, order, clock.getAsLong());
        }

        @Override
        public List<OnboardParameter> parameters() {
            return parameters.all();
        }

        @Override
        public OrderReply setParameter(VehicleId station, String parameter, double value) {
            Optional<String> wrong = BoatParameters.whyWrong(parameter, value);
            if (wrong.isPresent()) {
                return OrderReply.denied(wrong.get());
            }
            long nowMs = clock.getAsLong();
            Optional<String> refused = BoatParameters.needsCommand(parameter)
                    ? command.take(station, nowMs)
                    : command.whyNot(station, nowMs);
            return refused.map(OrderReply::notNow).orElseGet(() -> parameters.set(parameter, value, nowMs));
        }

        @Override
        public Optional<Refusal> whyNoList(VehicleId station, HeldKind kind, int items) {
            return lists.whyNoList(station, kind, items);
        }

        @Override
        public Optional<Refusal> whyNot(HeldKind kind, MissionItem item) {
            return lists.whyNot(kind, item);
        }

        @Override
        public Optional<Refusal> whyNotWhole(HeldKind kind, List<MissionItem> items) {
            return lists.whyNotWhole(kind, items);
        }

        @Override
        public void unreadable(HeldKind kind, String why) {
            lists.unreadable(kind, why);
        }

        @Override
        public void changed(HeldKind kind, List<MissionItem> items) {
            if (kind == HeldKind.MISSION) {
                shownList = ""; // a base that goes on with its list has it shown again
            }
            lists.changed(kind, items);
        }
    }
}

package org.sami.crw.sim.run.world;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.fleet.FleetConfig;
import org.sami.crw.sim.fleet.SimulatedBoat;
import org.sami.crw.sim.fleet.SimulatedFleet;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.crw.sim.run.record.BoatState;
import org.sami.crw.sim.run.record.RunHash;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.vessel.VesselState;
import org.sami.spn.value.GeoPoint;

/** The simulated part of the world that is not the base: the area, the boats on it, and their time. */
public final class SimulatedWater {
    private static final double SPACING_M = 5;
    private static final double COPTERS_NORTH_M = 10;

    private final VirtualClock clock;
    private final LocalFrame plane;
    private final GeoPoint quay;
    private final SimulatedFleet fleet;
    private final FleetSettings settings;

    /** Water with boats in a line from west to east, whose middle is the quay; copters of the same fleet stand north of them. */
    public SimulatedWater(
            VirtualClock clock, FleetSettings settings, Function<String, Consumer<FleetEvent>> listeners) {
        this.clock = clock;
        this.settings = settings;
        GeoPoint centre = settings.site().centreInProcess();
        plane = new LocalFrame(centre.latDeg(), centre.lonDeg());
        quay = settings.site().quayInProcess(settings.areaM());
        double eastM = plane.eastM(quay.latDeg(), quay.lonDeg()) - (boats(settings) - 1) * SPACING_M / 2;
        double northM = plane.northM(quay.latDeg(), quay.lonDeg());
        fleet = new SimulatedFleet(
                clock,
                settings.seed(),
                boats(settings),
                plane.latDeg(eastM, northM),
                plane.lonDeg(eastM, northM),
                listeners,
                FleetConfig.DEFAULT
                        .withHull(hull(settings))
                        .withoutTracks()
                        .withConditions(settings.inProcess().conditions().of(settings.robots()))
                        .withRadio(settings.inProcess().radio())
                        .withVessels(settings.inProcess().vessels())
                        .withLayers(settings.inProcess().layers()));
        for (int i = boats(settings); i < settings.boats(); i++) {
            String copter = settings.boatNames().get(i);
            fleet.join(copter, (i - boats(settings)) * SPACING_M, COPTERS_NORTH_M, HullConfig.COPTER);
        }
        for (int i = 0; i < settings.boats(); i++) {
            fleet.boats()
                    .get(i)
                    .hull()
                    .setBatteryPercent(settings.inProcess().charges().of(i));
        }
    }

    /** How many of the fleet lie in the line; all where there is one kind. */
    private static int boats(FleetSettings settings) {
        return settings.boats() - settings.copters();
    }

    private static HullConfig hull(FleetSettings settings) {
        HullConfig usual = HullConfig.of(settings.robots());
        HullConfig ranging = settings.inProcess().rangeM().isPresent()
                ? usual.withRangeM(settings.inProcess().rangeM().getAsDouble())
                : usual;
        return ranging.with(settings.inProcess().energy());
    }

    public VirtualClock clock() {
        return clock;
    }

    /** The hull of a robot that joins, by its name. */
    HullConfig hullOf(String name) {
        return settings.robots() == RobotKind.ROBOT && settings.robots().ofName(name) == RobotKind.COPTER
                ? HullConfig.COPTER
                : hull(settings);
    }

    /** The middle of the quay, where the boats lie at the start. */
    public GeoPoint quay() {
        return quay;
    }

    public SimulatedFleet fleet() {
        return fleet;
    }

    /** In metres around the area's centre. */
    public LocalFrame plane() {
        return plane;
    }

    /** All boats as they truly are, in order. */
    public List<BoatState> boats() {
        List<BoatState> states = new ArrayList<>();
        fleet.boats().forEach(boat -> states.add(state(boat, boat.position())));
        return states;
    }

    /** All boats that have reported a position, each with its last one. */
    public List<BoatState> reportedBoats() {
        List<BoatState> states = new ArrayList<>();
        fleet.boats()
                .forEach(boat -> boat.proxy()
                        .status()
                        .pose()
                        .map(BoatPose::position)
                        .ifPresent(position -> states.add(state(boat, position))));
        return states;
    }

    /** The foreign vessels as they are now, on this plane. */
    public List<VesselState> vessels() {
        double originEastM =
                plane.eastM(fleet.frame().originLatDeg(), fleet.frame().originLonDeg());
        double originNorthM =
                plane.northM(fleet.frame().originLatDeg(), fleet.frame().originLonDeg());
        return settings
                .inProcess()
                .vessels()
                .at(clock.nowMs() / 1000.0, settings.inProcess().conditions())
                .stream()
                .map(vessel -> vessel.movedBy(originEastM, originNorthM))
                .toList();
    }

    private BoatState state(SimulatedBoat boat, GeoPoint position) {
        return new BoatState(
                boat.id(),
                plane.eastM(position.latDeg(), position.lonDeg()),
                plane.northM(position.latDeg(), position.lonDeg()),
                position.latDeg(),
                position.lonDeg(),
                boat.hull().speedMps(),
                boat.batteryPercent(),
                boat.distanceM(),
                boat.recharges(),
                position.altM());
    }

    /** A short hash of the true positions and batteries, to the last bit: what a world is compared by. */
    public String fingerprint() {
        MessageDigest digest = RunHash.sha256();
        for (SimulatedBoat boat : fleet.boats()) {
            String state = boat.id() + " " + boat.hull().eastM() + " "
                    + boat.hull().northM() + " " + boat.hull().headingRad() + " " + boat.batteryPercent() + "\n";
            digest.update(state.getBytes(StandardCharsets.UTF_8));
        }
        return HexFormat.of().formatHex(digest.digest(), 0, 8);
    }
}

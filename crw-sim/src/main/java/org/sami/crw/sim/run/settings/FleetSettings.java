package org.sami.crw.sim.run.settings;

import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Energy;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.crw.sim.link.Radio;
import org.sami.crw.sim.vessel.ForeignVessels;
import org.sami.spn.value.GeoPoint;

/**
 * The robots of a run and what they are sent to.
 *
 * @param boats how many robots in all, of whatever kind; those of boats are named boats in this record
 * @param locations how many
 * @param areaM side of the square in which locations lie, in metres
 * @param seed of all that is drawn
 * @param site where on earth that is
 * @param robots what they are
 * @param copters how many of them, the last ones, are copters where both kinds are together; 0 otherwise
 * @param inProcess how they fare where they are simulated in this process
 */
public record FleetSettings(
        int boats,
        int locations,
        double areaM,
        long seed,
        Site site,
        RobotKind robots,
        int copters,
        InProcessBoats inProcess) {
    /** The greatest number of boats. */
    public static final int MOST_BOATS = 250;

    /** The greatest number of locations. */
    public static final int MOST_LOCATIONS = 10_000;

    /** The shortest side of the area, in metres. */
    public static final double SHORTEST_AREA_M = 10;

    /** The longest side of the area, in metres: the plane of the simulated water is exact to there. */
    public static final double LONGEST_AREA_M = 20_000;

    /**
     * A fleet within the limits.
     *
     * @throws IllegalArgumentException for what is out of its limits, or does not go together
     */
    public FleetSettings {
        within("boats", boats, 1, MOST_BOATS);
        within("locations", locations, 1, MOST_LOCATIONS);
        if (!(areaM >= SHORTEST_AREA_M && areaM <= LONGEST_AREA_M)) {
            throw new IllegalArgumentException("the area's side is 10 to 20000 m, not " + areaM);
        }
        if (!inProcess.charges().fit(boats)) {
            throw new IllegalArgumentException("the batteries of " + boats
                    + " boats have one charge for all or one for each, not " + inProcess.charges());
        }
        Objects.requireNonNull(site, "site");
        Objects.requireNonNull(robots, "robots");
        inProcess.requireFor(robots);
        within("copters", copters, 0, robots == RobotKind.ROBOT ? boats : 0);
    }

    /** A fleet of boats at the usual site, with full batteries in calm water. */
    public FleetSettings(int boats, int locations, double areaM, long seed) {
        this(boats, locations, areaM, seed, Site.USUAL, RobotKind.BOAT, 0, InProcessBoats.CALM);
    }

    /** The same fleet with more or fewer boats. */
    FleetSettings of(int otherBoats) {
        return new FleetSettings(otherBoats, locations, areaM, seed, site, robots, 0, inProcess);
    }

    /** The same fleet, with other locations, batteries and all else that is drawn. */
    public FleetSettings drawnFrom(long otherSeed) {
        return new FleetSettings(boats, locations, areaM, otherSeed, site, robots, copters, inProcess);
    }

    /** The same fleet elsewhere. */
    public FleetSettings at(Site other) {
        return new FleetSettings(boats, locations, areaM, seed, other, robots, copters, inProcess);
    }

    /** The same fleet of other robots of one kind. */
    public FleetSettings of(RobotKind others) {
        return new FleetSettings(boats, locations, areaM, seed, site, others, 0, inProcess);
    }

    /** A fleet of boats and copters together, the rest the same. */
    public FleetSettings team(int ofBoats, int ofCopters) {
        return new FleetSettings(
                ofBoats + ofCopters, locations, areaM, seed, site, RobotKind.ROBOT, ofCopters, inProcess);
    }

    /** The same fleet on other water. */
    public FleetSettings on(Conditions water) {
        return faring(inProcess.on(water));
    }

    /** The same fleet with other charges. */
    public FleetSettings with(InitialCharges others) {
        return faring(inProcess.with(others));
    }

    /** The same fleet with batteries that last for so many metres on average when they are full. */
    public FleetSettings withRangeM(double metres) {
        return faring(inProcess.withRangeM(metres));
    }

    /** The same fleet with links over another radio. */
    public FleetSettings over(Radio other) {
        return faring(inProcess.over(other));
    }

    /** The same fleet, whose boats use their batteries so. */
    public FleetSettings with(Energy other) {
        return faring(inProcess.with(other));
    }

    /** The same fleet on water with other vessels. */
    public FleetSettings among(ForeignVessels others) {
        return faring(inProcess.among(others));
    }

    /** The same fleet on water that differs by place. */
    public FleetSettings on(WaterLayers layers) {
        return faring(inProcess.on(layers));
    }

    private FleetSettings faring(InProcessBoats other) {
        return new FleetSettings(boats, locations, areaM, seed, site, robots, copters, other);
    }

    /** The names of the robots, in order: boat1, boat2, ..., copter1, ... where both kinds are together. */
    public List<String> boatNames() {
        return IntStream.range(0, boats).mapToObj(this::nameOf).toList();
    }

    private String nameOf(int index) {
        int first = boats - copters;
        return kindOf(index).nameOf(robots == RobotKind.ROBOT && index >= first ? index - first : index);
    }

    /**
     * Where robots of this process lie at the start: in a line from west to east, whose middle is the quay.
     *
     * @param count how many
     * @param spacingM between two of them, in metres
     */
    public List<GeoPoint> berths(int count, double spacingM) {
        GeoPoint quay = site.quayInProcess(areaM);
        return IntStream.range(0, count)
                .mapToObj(i -> Geodesy.offset(quay, (i - (count - 1) / 2.0) * spacingM, 0))
                .toList();
    }

    /** What a robot is, counted from 0. */
    public RobotKind kindOf(int index) {
        return robots.of(index >= boats - copters);
    }

    private static void within(String what, int value, int least, int most) {
        if (value < least || value > most) {
            throw new IllegalArgumentException(what + " are " + least + " to " + most + ", not " + value);
        }
    }
}

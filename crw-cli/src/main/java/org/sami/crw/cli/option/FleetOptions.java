package org.sami.crw.cli.option;

import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Energy;
import org.sami.crw.sim.link.Radio;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Site;
import org.sami.spn.value.GeoPoint;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options that say which robots a run has, where they lie, and how simulated boats fare. */
final class FleetOptions {
    private static final int DEFAULT_BOATS = 3;
    private static final int DEFAULT_COPTERS = 2;

    @Option(
            names = "--boats",
            paramLabel = "N",
            description =
                    "How many simulated boats, named boat1, boat2, ...; 1 to 250 (default 3; with --connect none).")
    private @Nullable Integer boats;

    @Option(
            names = "--copters",
            paramLabel = "N",
            description = "How many copters, named copter1, copter2, ..., in addition to the boats; with --domain team "
                    + "(default 2 there).")
    private @Nullable Integer copters;

    @Option(
            names = "--locations",
            paramLabel = "N",
            defaultValue = "12",
            description = "How many locations the simulated operator gives; 1 to 10000 (default ${DEFAULT-VALUE}).")
    private int locations;

    @Option(
            names = "--area",
            paramLabel = "METRES",
            defaultValue = "600",
            description = "Side of the square in which they lie; 10 to 20000 (default ${DEFAULT-VALUE}).")
    private double areaM;

    @Option(
            names = "--at",
            paramLabel = "LAT,LON",
            converter = PositionConverter.class,
            description =
                    "Where its centre lies, in degrees (default 45.7,10.72; with --connect the middle of the boats). "
                            + "Nothing else moves it.")
    private @Nullable GeoPoint centre;

    @Option(
            names = "--quay",
            paramLabel = "LAT,LON",
            converter = PositionConverter.class,
            description =
                    "Where the boats of this process lie at the start and get full batteries, the middle of their "
                            + "line (default 20 m south of the square).")
    private @Nullable GeoPoint quay;

    @Option(
            names = "--battery",
            paramLabel = "PERCENT[,PERCENT...]",
            description = "Charge of the boats' batteries at the start, one for all or one for each (default: full).")
    private @Nullable String battery;

    @Option(
            names = "--range",
            paramLabel = "METRES",
            description =
                    "How far a full battery takes each boat of this process on average; 100 to 1000000 (default 3500).")
    private @Nullable Double rangeM;

    @Option(
            names = "--energy",
            paramLabel = "drag,hotel=WATTS,battery=WH|MPS:WATTS,...,battery=WH",
            description = "What boats of this process use: drag for a metre that costs four times as much at twice the"
                    + " speed, with a hotel load while afloat; or their own curve of power by speed, from 0 m/s"
                    + " (default: a metre costs the same at any speed, rest nothing; a battery has 148 Wh).")
    private @Nullable String energy;

    @Option(
            names = "--radio",
            paramLabel = "loss=PERCENT,range=METRES,lost-link=ACTION",
            description = "The radio of the boats of this process, all of it or parts: how many messages are lost, how"
                    + " far from the quay it reaches, and what boats do without a link: hold, return, continue or"
                    + " drift (default: nothing is lost, it reaches everywhere, hold).")
    private @Nullable String radio;

    @Option(
            names = "--vessels",
            paramLabel = "FILE",
            description = "Other vessels and drifting objects on the water of the boats of this process (JSON; see"
                    + " docs/command-line.md). Boats that see one give way to it (default: none).")
    private @Nullable Path vessels;

    @Mixin
    private LayerOptions layers = new LayerOptions();

    /**
     * The fleet of a run.
     *
     * @param connected how many boats are connected; 0 where the run simulates all
     * @param seed of all that is drawn
     * @param water of boats in this process
     * @param folder that the files of vessels and layers are looked for in
     * @throws UsageFault for an option out of its limits
     * @throws IllegalArgumentException if options do not go together
     */
    FleetSettings fleet(int connected, long seed, Conditions water, Path folder) {
        int simulated = Optional.ofNullable(boats).orElse(connected > 0 ? 0 : DEFAULT_BOATS);
        UsageFault.unlessWithin("--boats", simulated, boats == null ? 0 : 1, FleetSettings.MOST_BOATS - connected);
        int count = connected + simulated;
        int more = connected == 0 && copters != null ? copters : 0;
        UsageFault.unlessWithin("--copters", more, 0, FleetSettings.MOST_BOATS - count);
        UsageFault.unlessWithin("--locations", locations, 1, FleetSettings.MOST_LOCATIONS);
        UsageFault.unlessWithin("--area", areaM, FleetSettings.SHORTEST_AREA_M, FleetSettings.LONGEST_AREA_M);
        FleetSettings fleet = new FleetSettings(count + more, locations, areaM, seed)
                .on(water)
                .with(charges())
                .at(site());
        FleetSettings ranging = rangeM == null ? fleet : fleet.withRangeM(rangeM);
        FleetSettings using = energy == null ? ranging : ranging.with(energy(energy));
        FleetSettings linked = radio == null ? using : using.over(radio(radio));
        FleetSettings layered = linked.on(layers.layers(folder));
        return vessels == null ? layered : layered.among(VesselsFile.read(folder.resolve(vessels), "--vessels"));
    }

    private static Energy energy(String text) {
        try {
            return Energy.parse(text);
        } catch (IllegalArgumentException e) {
            throw new UsageFault("--energy: " + e.getMessage());
        }
    }

    private static Radio radio(String text) {
        try {
            return Radio.parse(text);
        } catch (IllegalArgumentException e) {
            throw new UsageFault("--radio: " + e.getMessage());
        }
    }

    /**
     * A fleet of what a domain commands.
     *
     * @throws UsageFault for copters where the domain has none, or not in addition
     */
    RunSettings withRobots(RunSettings settings, RobotKind robots) {
        if (copters != null && (robots != RobotKind.ROBOT || settings.isConnected())) {
            throw new UsageFault(
                    settings.isConnected()
                            ? "--copters is for simulated copters, not for robots that are connected"
                            : "--copters is for --domain team; with one kind of robots --boats says how many");
        }
        if (robots != RobotKind.ROBOT || settings.isConnected()) {
            return settings.withFleet(settings.fleet().of(robots));
        }
        FleetSettings fleet = settings.fleet();
        int ofBoats = fleet.boats() - (copters == null ? 0 : copters);
        try {
            return settings.withFleet(fleet.team(ofBoats, copters == null ? DEFAULT_COPTERS : copters));
        } catch (IllegalArgumentException e) {
            throw new UsageFault(String.valueOf(e.getMessage()));
        }
    }

    private Site site() {
        return new Site(Optional.ofNullable(centre), Optional.ofNullable(quay));
    }

    private InitialCharges charges() {
        return battery == null ? InitialCharges.FULL : InitialCharges.parse(battery);
    }

    /** Whether the number of boats was given. */
    boolean hasBoats() {
        return boats != null;
    }

    /** Whether it was given where the boats lie. */
    boolean hasQuay() {
        return quay != null;
    }

    /** Whether it was given where the area lies. */
    boolean hasCentre() {
        return centre != null;
    }
}

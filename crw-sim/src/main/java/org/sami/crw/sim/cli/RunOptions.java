package org.sami.crw.sim.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.run.InitialCharges;
import org.sami.crw.sim.run.RunSettings;
import org.sami.crw.sim.run.Site;
import org.sami.crw.sim.run.Speed;
import org.sami.spn.value.GeoPoint;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options that decide a run. */
final class RunOptions {
    private static final int DEFAULT_BOATS = 3;
    private static final Speed DEFAULT_SPEED = new Speed(20);

    @Option(
            names = "--boats",
            paramLabel = "N",
            description = "How many boats, named boat1, boat2, ...; 1 to 250 (default 3).")
    private Integer boats;

    @Option(
            names = "--connect",
            paramLabel = "HOST:PORT,...",
            description =
                    "Instead of boats in this process those whose servers listen there, over TCP and in real time "
                            + "('crw boat'). The area lies around them.")
    private String connect;

    @Option(
            names = "--connect-within",
            paramLabel = "SECONDS",
            defaultValue = "30",
            converter = SecondsConverter.class,
            description = "How long such boats may take to answer at the start (default ${DEFAULT-VALUE}).")
    private long connectWithinMillis;

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
    private GeoPoint centre;

    @Option(
            names = "--quay",
            paramLabel = "LAT,LON",
            converter = PositionConverter.class,
            description =
                    "Where the boats of this process lie at the start and get full batteries, the middle of their "
                            + "line (default 20 m south of the square).")
    private GeoPoint quay;

    @Option(
            names = "--seed",
            paramLabel = "S",
            defaultValue = "1",
            description =
                    "Where chance comes from; equal seeds give equal runs at any speed (default ${DEFAULT-VALUE}).")
    private long seed;

    @Option(
            names = "--speed",
            paramLabel = "X|max",
            converter = SpeedConverter.class,
            description = "Simulated seconds in one second; 1 is real time, max waits for nothing "
                    + "(default 20; with --connect 1, and nothing else).")
    private Speed speed;

    @Option(
            names = "--for",
            paramLabel = "SECONDS",
            converter = SecondsConverter.class,
            description = "Stop after so much simulated time, whether or not the mission is over (default one day).")
    private Long limitMillis;

    @Option(
            names = "--set",
            paramLabel = "NAME=VALUE",
            description =
                    "A value for what the plan would ask at its start: a field (event.field, or field where that is "
                            + "unique) or a variable (@name). May be given several times. 'crw plans' names them.")
    private Map<String, String> parameters = new LinkedHashMap<>();

    @Option(
            names = "--answer-after",
            paramLabel = "SECONDS",
            defaultValue = "5",
            converter = SecondsConverter.class,
            description = "Simulated seconds after which the simulated operator answers (default ${DEFAULT-VALUE}).")
    private long answerAfterMillis;

    @Option(
            names = "--answers",
            paramLabel = "FILE",
            description =
                    "What the simulated operator answers (JSON; see docs/answers-file.md). Without it: all boats, "
                            + "drawn locations, the first option, yes, and default values.")
    private Path answers;

    @Option(
            names = "--interrupt",
            paramLabel = "NAME[:BOAT]@SECONDS",
            description = "Press an interrupt so many simulated seconds after the mission's start; BOAT is a boat's "
                    + "name or counts from 1. One that nobody can take is pressed again until somebody does. With "
                    + "'battery' for SECONDS it is pressed for each boat whose battery turns critical. May be given "
                    + "several times. 'crw plans' names a plan's interrupts.")
    private List<String> interrupts = new ArrayList<>();

    @Option(
            names = "--battery",
            paramLabel = "PERCENT[,PERCENT...]",
            description = "Charge of the boats' batteries at the start, one for all or one for each (default: full).")
    private String battery;

    @Mixin
    private ConditionsOptions conditions;

    RunSettings settings(String plan, String mission) {
        List<BoatAddress> addresses = addresses(connect);
        int count = addresses.isEmpty() ? Optional.ofNullable(boats).orElse(DEFAULT_BOATS) : addresses.size();
        within("--boats", count, 1, RunSettings.Fleet.MOST_BOATS);
        within("--locations", locations, 1, RunSettings.Fleet.MOST_LOCATIONS);
        within("--area", areaM, RunSettings.Fleet.SHORTEST_AREA_M, RunSettings.Fleet.LONGEST_AREA_M);
        try {
            Conditions water = addresses.isEmpty() ? conditions.conditions() : conditions.stated();
            return new RunSettings(
                    plan,
                    mission,
                    new RunSettings.Fleet(count, locations, areaM, seed, water, charges(), site()),
                    Optional.ofNullable(speed).orElse(addresses.isEmpty() ? DEFAULT_SPEED : Speed.REAL),
                    Optional.ofNullable(limitMillis).map(OptionalLong::of).orElse(OptionalLong.empty()),
                    parameters,
                    answerAfterMillis,
                    answersText(),
                    addresses,
                    interrupts);
        } catch (IllegalArgumentException e) {
            throw new UsageFault(e.getMessage());
        }
    }

    private Site site() {
        return new Site(Optional.ofNullable(centre), Optional.ofNullable(quay));
    }

    private InitialCharges charges() {
        return battery == null ? InitialCharges.FULL : InitialCharges.parse(battery);
    }

    /** How long boats behind TCP may take to answer at the start. */
    long connectWithinMillis() {
        return connectWithinMillis;
    }

    private List<BoatAddress> addresses(String text) {
        List<BoatAddress> addresses = addressesOf(text);
        if (!addresses.isEmpty() && boats != null) {
            throw new UsageFault("--boats and --connect exclude each other: the boats are those that are connected");
        }
        if (!addresses.isEmpty() && quay != null) {
            throw new UsageFault("with --connect the boats lie where they were started: see 'crw boat --help'");
        }
        if (!addresses.isEmpty() && speed != null && !speed.equals(Speed.REAL)) {
            throw new UsageFault("--speed: boats that are connected run at speed 1, not " + speed);
        }
        return addresses;
    }

    /** Reads {@code --connect}; none for an option that was not given. */
    static List<BoatAddress> addressesOf(String text) {
        if (text == null) {
            return List.of();
        }
        try {
            List<BoatAddress> addresses = BoatAddress.parseAll(text);
            within("--connect: the number of boats", addresses.size(), 1, RunSettings.Fleet.MOST_BOATS);
            return addresses;
        } catch (IllegalArgumentException e) {
            throw new UsageFault("--connect: " + e.getMessage());
        }
    }

    private static void within(String option, double value, double least, double most) {
        if (!(value >= least && value <= most)) {
            throw new UsageFault(option + " is " + number(least) + " to " + number(most) + ", not " + number(value));
        }
    }

    private static String number(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
    }

    /** The answers file as it was named; the option's name where there is none. */
    String answersFile() {
        return answers == null ? "--answers" : answers.toString();
    }

    private String answersText() {
        if (answers == null) {
            return "";
        }
        try {
            return Files.readString(answers);
        } catch (IOException e) {
            throw new UsageFault("--answers: cannot read " + answers);
        }
    }
}

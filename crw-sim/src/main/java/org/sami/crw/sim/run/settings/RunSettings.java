package org.sami.crw.sim.run.settings;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.fleet.SimulatedFleet;
import org.sami.crw.sim.hull.Conditions;

/**
 * Everything that decides a run, beside its plans and its vocabulary. A run in process is a function of these; of the speed only
 * how long it takes.
 *
 * @param plan id of the plan
 * @param mission name of the mission
 * @param fleet how many boats and locations, in what area, drawn from which seed
 * @param speed of simulated time
 * @param limitMillis simulated time after which it stops, in milliseconds; empty = {@link #LONGEST_MILLIS}
 * @param parameters values for what the plan asks at its start, as they were given, by name
 * @param answerAfterMillis after how long the simulated operator answers, in simulated milliseconds
 * @param answers text of the answers file; empty text where there is none
 * @param connect where the boats' servers listen, as many as the fleet has boats; empty = the boats are in this process
 * @param interrupts which interrupts are pressed, as they were given ({@link PlanInterrupts}), in order
 * @param also which missions are started beside the first, as they were given ({@link PlannedMission#parse}), in order
 */
public record RunSettings(
        String plan,
        String mission,
        Fleet fleet,
        Speed speed,
        OptionalLong limitMillis,
        Map<String, String> parameters,
        long answerAfterMillis,
        String answers,
        List<BoatAddress> connect,
        List<String> interrupts,
        List<String> also) {
    /** A run that is not told when to stop gives up after one simulated day. */
    public static final long LONGEST_MILLIS = 86_400_000;

    private static final String PARAMETER = "set.";
    private static final String BATTERY = "battery";
    private static final String CONNECT = "connect";
    private static final String INTERRUPT = "interrupt.";
    private static final String ALSO = "also.";

    /**
     * The boats and what they are sent to.
     *
     * @param areaM side of the square in which locations lie, in metres
     * @param conditions on the water of boats in this process; others have their own, and where they do not say how they fare in it, these are
     *     planned with
     * @param charges of the batteries of boats in this process; others have their own
     * @param site where on earth that is
     */
    public record Fleet(
            int boats,
            int locations,
            double areaM,
            long seed,
            Conditions conditions,
            InitialCharges charges,
            Site site) {
        /** The greatest number of boats. */
        public static final int MOST_BOATS = 250;

        /** The greatest number of locations. */
        public static final int MOST_LOCATIONS = 10_000;

        /** The shortest side of the area, in metres. */
        public static final double SHORTEST_AREA_M = 10;

        /** The longest side of the area, in metres: the plane of the simulated water is exact to there. */
        public static final double LONGEST_AREA_M = 20_000;

        /** A fleet within the limits. */
        public Fleet {
            within("boats", boats, 1, MOST_BOATS);
            within("locations", locations, 1, MOST_LOCATIONS);
            if (!(areaM >= SHORTEST_AREA_M && areaM <= LONGEST_AREA_M)) {
                throw new IllegalArgumentException("the area's side is 10 to 20000 m, not " + areaM);
            }
            Objects.requireNonNull(conditions, "conditions");
            if (!charges.fit(boats)) {
                throw new IllegalArgumentException(
                        "the batteries of " + boats + " boats have one charge for all or one for each, not " + charges);
            }
            Objects.requireNonNull(site, "site");
        }

        /** A fleet with full batteries in calm water. */
        public Fleet(int boats, int locations, double areaM, long seed) {
            this(boats, locations, areaM, seed, Conditions.CALM, InitialCharges.FULL, Site.USUAL);
        }

        /** The same fleet on other water. */
        public Fleet on(Conditions water) {
            return new Fleet(boats, locations, areaM, seed, water, charges, site);
        }

        /** The same fleet, with other locations, batteries and all else that is drawn. */
        public Fleet drawnFrom(long otherSeed) {
            return new Fleet(boats, locations, areaM, otherSeed, conditions, charges, site);
        }

        /** The same fleet with other charges. */
        public Fleet with(InitialCharges others) {
            return new Fleet(boats, locations, areaM, seed, conditions, others, site);
        }

        /** The same fleet elsewhere. */
        public Fleet at(Site other) {
            return new Fleet(boats, locations, areaM, seed, conditions, charges, other);
        }

        /** The names of the boats, in order. */
        public List<String> boatNames() {
            return IntStream.range(0, boats).mapToObj(SimulatedFleet::idOf).toList();
        }

        private static void within(String what, int value, int least, int most) {
            if (value < least || value > most) {
                throw new IllegalArgumentException(what + " are " + least + " to " + most + ", not " + value);
            }
        }
    }

    public RunSettings {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(mission, "mission");
        Objects.requireNonNull(fleet, "fleet");
        Objects.requireNonNull(speed, "speed");
        Objects.requireNonNull(limitMillis, "limitMillis");
        parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
        Objects.requireNonNull(answers, "answers");
        interrupts = List.copyOf(interrupts);
        also = List.copyOf(also);
        if (answerAfterMillis < 0) {
            throw new IllegalArgumentException("the operator answers after 0 s or more, not " + answerAfterMillis);
        }
        connect = List.copyOf(connect);
        if (!connect.isEmpty() && (speed.factor() != 1 || connect.size() != fleet.boats())) {
            throw new IllegalArgumentException("boats behind TCP run at speed 1, not " + speed + "; " + connect.size()
                    + " addresses for " + fleet.boats() + " boats");
        }
        if (!connect.isEmpty() && !fleet.conditions().sensors().isEmpty()) {
            throw new IllegalArgumentException(
                    "boats behind TCP have their own water and sensors: see crw boat --help");
        }
        if (!connect.isEmpty() && !fleet.charges().equals(InitialCharges.FULL)) {
            throw new IllegalArgumentException("boats behind TCP have their own batteries: see crw boat --help");
        }
        if (!connect.isEmpty() && fleet.site().quay().isPresent()) {
            throw new IllegalArgumentException("boats behind TCP lie where they were started: see crw boat --help");
        }
    }

    /** A run on boats in this process, in which nobody presses an interrupt. */
    public RunSettings(
            String plan,
            String mission,
            Fleet fleet,
            Speed speed,
            OptionalLong limitMillis,
            Map<String, String> parameters,
            long answerAfterMillis,
            String answers) {
        this(
                plan,
                mission,
                fleet,
                speed,
                limitMillis,
                parameters,
                answerAfterMillis,
                answers,
                List.of(),
                List.of(),
                List.of());
    }

    /** A run of one mission. */
    public RunSettings(
            String plan,
            String mission,
            Fleet fleet,
            Speed speed,
            OptionalLong limitMillis,
            Map<String, String> parameters,
            long answerAfterMillis,
            String answers,
            List<BoatAddress> connect,
            List<String> interrupts) {
        this(
                plan,
                mission,
                fleet,
                speed,
                limitMillis,
                parameters,
                answerAfterMillis,
                answers,
                connect,
                interrupts,
                List.of());
    }

    /** The same run on boats behind TCP, in real time. */
    public RunSettings connectedTo(List<BoatAddress> addresses) {
        return new RunSettings(
                plan,
                mission,
                new Fleet(
                        addresses.size(),
                        fleet.locations(),
                        fleet.areaM(),
                        fleet.seed(),
                        fleet.conditions(),
                        fleet.charges(),
                        fleet.site()),
                Speed.REAL,
                limitMillis,
                parameters,
                answerAfterMillis,
                answers,
                addresses,
                interrupts,
                also);
    }

    /** Whether the boats are other processes, behind TCP. */
    public boolean isConnected() {
        return !connect.isEmpty();
    }

    /** The same run with other interrupts. */
    public RunSettings withInterrupts(List<String> others) {
        return new RunSettings(
                plan,
                mission,
                fleet,
                speed,
                limitMillis,
                parameters,
                answerAfterMillis,
                answers,
                connect,
                others,
                also);
    }

    /** The same run with these missions beside the first. */
    public RunSettings withAlso(List<String> others) {
        return new RunSettings(
                plan,
                mission,
                fleet,
                speed,
                limitMillis,
                parameters,
                answerAfterMillis,
                answers,
                connect,
                interrupts,
                others);
    }

    /** The same run with other boats. */
    public RunSettings withFleet(Fleet other) {
        return new RunSettings(
                plan,
                mission,
                other,
                speed,
                limitMillis,
                parameters,
                answerAfterMillis,
                answers,
                connect,
                interrupts,
                also);
    }

    /** The same run at another speed. */
    public RunSettings withSpeed(Speed other) {
        return new RunSettings(
                plan,
                mission,
                fleet,
                other,
                limitMillis,
                parameters,
                answerAfterMillis,
                answers,
                connect,
                interrupts,
                also);
    }

    /** The same run with another end. */
    public RunSettings withLimit(OptionalLong other) {
        return new RunSettings(
                plan, mission, fleet, speed, other, parameters, answerAfterMillis, answers, connect, interrupts, also);
    }

    /** When it stops at the latest, in simulated milliseconds. */
    public long stopMillis() {
        return limitMillis.orElse(LONGEST_MILLIS);
    }

    /** As text by name, for the header of a journal. */
    public Map<String, String> toMap() {
        Map<String, String> map = new TreeMap<>();
        map.put("plan", plan);
        map.put("mission", mission);
        map.put("boats", String.valueOf(fleet.boats()));
        map.put("locations", String.valueOf(fleet.locations()));
        map.put("areaM", String.valueOf(fleet.areaM()));
        map.put("seed", String.valueOf(fleet.seed()));
        map.put("speed", speed.toString());
        limitMillis.ifPresent(limit -> map.put("limitMillis", String.valueOf(limit)));
        map.put("answerAfterMillis", String.valueOf(answerAfterMillis));
        map.put("answers", answers);
        if (isConnected()) {
            map.put(CONNECT, connect.stream().map(BoatAddress::toString).collect(Collectors.joining(",")));
        }
        map.putAll(fleet.conditions().toMap());
        map.putAll(fleet.site().toMap());
        if (!fleet.charges().equals(InitialCharges.FULL)) {
            map.put(BATTERY, fleet.charges().toString());
        }
        parameters.forEach((name, value) -> map.put(PARAMETER + name, value));
        for (int i = 0; i < interrupts.size(); i++) {
            map.put(INTERRUPT + i, interrupts.get(i));
        }
        for (int i = 0; i < also.size(); i++) {
            map.put(ALSO + i, also.get(i));
        }
        return map;
    }

    /**
     * Reads what {@link #toMap} wrote; names that it does not know are left alone.
     *
     * @throws IllegalArgumentException where something is missing or makes no sense
     */
    public static RunSettings fromMap(Map<String, String> map) {
        Map<String, String> parameters = new TreeMap<>();
        map.forEach((name, value) -> {
            if (name.startsWith(PARAMETER)) {
                parameters.put(name.substring(PARAMETER.length()), value);
            }
        });
        Fleet fleet = new Fleet(
                Integer.parseInt(needed(map, "boats")),
                Integer.parseInt(needed(map, "locations")),
                Double.parseDouble(needed(map, "areaM")),
                Long.parseLong(needed(map, "seed")),
                Conditions.fromMap(map),
                map.containsKey(BATTERY) ? InitialCharges.parse(map.get(BATTERY)) : InitialCharges.FULL,
                Site.fromMap(map));
        String limit = map.get("limitMillis");
        return new RunSettings(
                needed(map, "plan"),
                needed(map, "mission"),
                fleet,
                Speed.parse(needed(map, "speed")),
                limit == null ? OptionalLong.empty() : OptionalLong.of(Long.parseLong(limit)),
                parameters,
                Long.parseLong(needed(map, "answerAfterMillis")),
                needed(map, "answers"),
                map.containsKey(CONNECT) ? BoatAddress.parseAll(map.get(CONNECT)) : List.of(),
                numbered(map, INTERRUPT),
                numbered(map, ALSO));
    }

    private static List<String> numbered(Map<String, String> map, String name) {
        List<String> values = new ArrayList<>();
        for (String next = map.get(name + 0); next != null; next = map.get(name + values.size())) {
            values.add(next);
        }
        return values;
    }

    private static String needed(Map<String, String> map, String name) {
        String value = map.get(name);
        if (value == null) {
            throw new IllegalArgumentException("the setting '" + name + "' is missing");
        }
        return value;
    }
}

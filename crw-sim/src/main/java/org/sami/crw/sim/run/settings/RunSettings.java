package org.sami.crw.sim.run.settings;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.stream.IntStream;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Energy;
import org.sami.crw.sim.link.Radio;

/**
 * Everything that determines a run, in addition to its plans and its vocabulary. A run in process is a function of these; of the speed only
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
 * @param also which missions are started in addition to the first, as they were given ({@link PlannedMission#parse}), in order
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
    /** A run without an end stops after one simulated day. */
    public static final long LONGEST_MILLIS = 86_400_000;

    /** After how long the simulated operator answers unless somebody says otherwise, in simulated milliseconds. */
    public static final long STANDARD_ANSWER_MILLIS = 5_000;

    /**
     * The boats and what they are sent to.
     *
     * @param areaM side of the square in which locations lie, in metres
     * @param conditions on the water of boats in this process; others have their own, and where they do not say how they fare in it, these are
     *     planned with
     * @param charges of the batteries of boats in this process; others have their own
     * @param site where on earth that is
     * @param boats how many robots in all, of whatever kind
     * @param robots what they are; those of boats are named boats in this record
     * @param rangeM how far a full battery takes boats in this process on average, in metres; empty for the usual range
     * @param copters how many of them, the last ones, are copters where both kinds are together; 0 otherwise
     * @param energy what decides how much charge boats in this process use
     * @param radio between base and boats in this process; the base's is in the middle of the quay
     */
    public record Fleet(
            int boats,
            int locations,
            double areaM,
            long seed,
            Conditions conditions,
            InitialCharges charges,
            Site site,
            RobotKind robots,
            OptionalDouble rangeM,
            int copters,
            Radio radio,
            Energy energy) {
        /** The greatest number of boats. */
        public static final int MOST_BOATS = 250;

        /** The greatest number of locations. */
        public static final int MOST_LOCATIONS = 10_000;

        /** The shortest side of the area, in metres. */
        public static final double SHORTEST_AREA_M = 10;

        /** The longest side of the area, in metres: the plane of the simulated water is exact to there. */
        public static final double LONGEST_AREA_M = 20_000;

        /** The shortest range, in metres. */
        public static final double SHORTEST_RANGE_M = 100;

        /** The longest range, in metres. */
        public static final double LONGEST_RANGE_M = 1_000_000;

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
            Objects.requireNonNull(robots, "robots");
            Objects.requireNonNull(radio, "radio");
            Objects.requireNonNull(energy, "energy");
            double metres = rangeM.orElse(SHORTEST_RANGE_M);
            if (!(metres >= SHORTEST_RANGE_M && metres <= LONGEST_RANGE_M)) {
                throw new IllegalArgumentException("a full battery lasts for 100 to 1000000 m, not " + metres);
            }
            if (rangeM.isPresent() && robots == RobotKind.COPTER) {
                throw new IllegalArgumentException("only boats have a range; copters fly for a time");
            }
            if (!energy.isPerMetre() && robots == RobotKind.COPTER) {
                throw new IllegalArgumentException(
                        "only boats use their battery by their speed; copters fly for a time");
            }
            if (energy.isCurve() && rangeM.isPresent()) {
                throw new IllegalArgumentException("a range follows from the boats' curve: give one of the two");
            }
            within("copters", copters, 0, robots == RobotKind.ROBOT ? boats : 0);
        }

        /** A fleet of boats. */
        public Fleet(
                int boats,
                int locations,
                double areaM,
                long seed,
                Conditions conditions,
                InitialCharges charges,
                Site site) {
            this(boats, locations, areaM, seed, conditions, charges, site, RobotKind.BOAT, OptionalDouble.empty());
        }

        /** A fleet of robots of one kind, with a perfect radio. */
        public Fleet(
                int boats,
                int locations,
                double areaM,
                long seed,
                Conditions conditions,
                InitialCharges charges,
                Site site,
                RobotKind robots,
                OptionalDouble rangeM) {
            this(
                    boats,
                    locations,
                    areaM,
                    seed,
                    conditions,
                    charges,
                    site,
                    robots,
                    rangeM,
                    0,
                    Radio.PERFECT,
                    Energy.PER_METRE);
        }

        /** A fleet with full batteries in calm water. */
        public Fleet(int boats, int locations, double areaM, long seed) {
            this(boats, locations, areaM, seed, Conditions.CALM, InitialCharges.FULL, Site.USUAL);
        }

        /** The same fleet with more or fewer boats. */
        Fleet of(int otherBoats) {
            return new Fleet(
                    otherBoats, locations, areaM, seed, conditions, charges, site, robots, rangeM, 0, radio, energy);
        }

        /** The same fleet on other water. */
        public Fleet on(Conditions water) {
            return new Fleet(
                    boats, locations, areaM, seed, water, charges, site, robots, rangeM, copters, radio, energy);
        }

        /** The same fleet, with other locations, batteries and all else that is drawn. */
        public Fleet drawnFrom(long otherSeed) {
            return new Fleet(
                    boats,
                    locations,
                    areaM,
                    otherSeed,
                    conditions,
                    charges,
                    site,
                    robots,
                    rangeM,
                    copters,
                    radio,
                    energy);
        }

        /** The same fleet with other charges. */
        public Fleet with(InitialCharges others) {
            return new Fleet(
                    boats, locations, areaM, seed, conditions, others, site, robots, rangeM, copters, radio, energy);
        }

        /** The same fleet with batteries that last for so many metres on average when they are full. */
        public Fleet withRangeM(double metres) {
            return new Fleet(
                    boats,
                    locations,
                    areaM,
                    seed,
                    conditions,
                    charges,
                    site,
                    robots,
                    OptionalDouble.of(metres),
                    copters,
                    radio,
                    energy);
        }

        /** The same fleet with links over another radio. */
        public Fleet over(Radio other) {
            return new Fleet(
                    boats, locations, areaM, seed, conditions, charges, site, robots, rangeM, copters, other, energy);
        }

        /** The same fleet, whose boats use their batteries so. */
        public Fleet with(Energy other) {
            return new Fleet(
                    boats, locations, areaM, seed, conditions, charges, site, robots, rangeM, copters, radio, other);
        }

        /** The same fleet elsewhere. */
        public Fleet at(Site other) {
            return new Fleet(
                    boats, locations, areaM, seed, conditions, charges, other, robots, rangeM, copters, radio, energy);
        }

        /** The same fleet of other robots of one kind. */
        public Fleet of(RobotKind others) {
            return new Fleet(
                    boats, locations, areaM, seed, conditions, charges, site, others, rangeM, 0, radio, energy);
        }

        /** A fleet of boats and copters together, the rest the same. */
        public Fleet team(int ofBoats, int ofCopters) {
            return new Fleet(
                    ofBoats + ofCopters,
                    locations,
                    areaM,
                    seed,
                    conditions,
                    charges,
                    site,
                    RobotKind.ROBOT,
                    rangeM,
                    ofCopters,
                    radio,
                    energy);
        }

        /** The names of the robots, in order: boat1, boat2, ..., copter1, ... where both kinds are together. */
        public List<String> boatNames() {
            return IntStream.range(0, boats).mapToObj(this::nameOf).toList();
        }

        private String nameOf(int index) {
            int first = boats - copters;
            return kindOf(index).nameOf(robots == RobotKind.ROBOT && index >= first ? index - first : index);
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
        if (!connect.isEmpty() && fleet.rangeM().isPresent()) {
            throw new IllegalArgumentException("boats behind TCP say their range themselves: see crw boat --help");
        }
        if (!connect.isEmpty() && !fleet.energy().isPerMetre()) {
            throw new IllegalArgumentException("boats behind TCP say what they use themselves: see crw boat --help");
        }
        if (!connect.isEmpty() && !fleet.radio().isPerfect()) {
            throw new IllegalArgumentException("boats behind TCP have a network of their own, and no simulated radio");
        }
        if (!connect.isEmpty() && fleet.site().quay().isPresent()) {
            throw new IllegalArgumentException("boats behind TCP lie where they were started: see crw boat --help");
        }
    }

    /** A run as fast as the machine can, without limit, of one mission, on boats in this process, in which nobody presses an interrupt. */
    public static Builder of(String plan, String mission, Fleet fleet) {
        return new Builder(plan, mission, fleet);
    }

    /** The same run, for something of it to be changed. */
    public Builder change() {
        return of(plan, mission, fleet)
                .speed(speed)
                .limit(limitMillis)
                .parameters(parameters)
                .answerAfterMillis(answerAfterMillis)
                .answers(answers)
                .connect(connect)
                .interrupts(interrupts)
                .also(also);
    }

    /** The same run on boats behind TCP, in real time. */
    public RunSettings connectedTo(List<BoatAddress> addresses) {
        return change().fleet(fleet.of(addresses.size()))
                .speed(Speed.REAL)
                .connect(addresses)
                .build();
    }

    /** Whether the boats are other processes, behind TCP. */
    public boolean isConnected() {
        return !connect.isEmpty();
    }

    /** The same run with other interrupts. */
    public RunSettings withInterrupts(List<String> others) {
        return change().interrupts(others).build();
    }

    /** The same run with these missions in addition to the first. */
    public RunSettings withAlso(List<String> others) {
        return change().also(others).build();
    }

    /** The same run with other boats. */
    public RunSettings withFleet(Fleet other) {
        return change().fleet(other).build();
    }

    /** The same run at another speed. */
    public RunSettings withSpeed(Speed other) {
        return change().speed(other).build();
    }

    /** The same run with another end. */
    public RunSettings withLimit(OptionalLong other) {
        return change().limit(other).build();
    }

    /** When it stops at the latest, in simulated milliseconds. */
    public long stopMillis() {
        return limitMillis.orElse(LONGEST_MILLIS);
    }

    /** Collects what differs from a run as {@link #of} has it; what each is, the components of {@link RunSettings} say. */
    public static final class Builder {
        private final String plan;
        private final String mission;
        private Fleet fleet;
        private Speed speed = Speed.MAX;
        private OptionalLong limitMillis = OptionalLong.empty();
        private Map<String, String> parameters = Map.of();
        private long answerAfterMillis = STANDARD_ANSWER_MILLIS;
        private String answers = "";
        private List<BoatAddress> connect = List.of();
        private List<String> interrupts = List.of();
        private List<String> also = List.of();

        private Builder(String plan, String mission, Fleet fleet) {
            this.plan = plan;
            this.mission = mission;
            this.fleet = fleet;
        }

        public Builder fleet(Fleet value) {
            fleet = value;
            return this;
        }

        public Builder speed(Speed value) {
            speed = value;
            return this;
        }

        public Builder limit(OptionalLong millis) {
            limitMillis = millis;
            return this;
        }

        public Builder limitMillis(long value) {
            return limit(OptionalLong.of(value));
        }

        public Builder parameters(Map<String, String> value) {
            parameters = value;
            return this;
        }

        public Builder answerAfterMillis(long value) {
            answerAfterMillis = value;
            return this;
        }

        public Builder answers(String text) {
            answers = text;
            return this;
        }

        public Builder connect(List<BoatAddress> value) {
            connect = value;
            return this;
        }

        public Builder interrupts(List<String> value) {
            interrupts = value;
            return this;
        }

        public Builder also(List<String> value) {
            also = value;
            return this;
        }

        /**
         * The settings.
         *
         * @throws IllegalArgumentException where two of them do not go together
         */
        public RunSettings build() {
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
                    also);
        }
    }
}

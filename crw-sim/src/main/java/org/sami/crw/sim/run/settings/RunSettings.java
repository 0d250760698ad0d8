package org.sami.crw.sim.run.settings;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalLong;
import org.sami.crw.proxy.tcp.BoatAddress;

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
 * @param connect where the boats' servers listen; the boats that the fleet has besides are simulated in this process. Empty = all are
 * @param interrupts which interrupts are pressed, as they were given ({@link PlanInterrupts}), in order
 * @param also which missions are started in addition to the first, as they were given ({@link PlannedMission#parse}), in order
 */
public record RunSettings(
        String plan,
        String mission,
        FleetSettings fleet,
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
        if (!connect.isEmpty()) {
            requireConnectable(fleet, speed, connect.size());
        }
    }

    private static void requireConnectable(FleetSettings fleet, Speed speed, int addresses) {
        if (speed.factor() != 1 || addresses > fleet.boats()) {
            throw new IllegalArgumentException("boats behind TCP run at speed 1, not " + speed + "; " + addresses
                    + " addresses for " + fleet.boats() + " boats");
        }
        fleet.inProcess().requireUnset(addresses < fleet.boats());
        Site site = fleet.site();
        if (addresses == fleet.boats() && site.quay().isPresent()) {
            throw new IllegalArgumentException("boats behind TCP lie where they were started: see crw boat --help");
        }
        if (addresses < fleet.boats() && site.centre().isEmpty()) {
            throw new IllegalArgumentException(
                    "simulated boats besides boats behind TCP need a place: say by --at where"
                            + " the area lies, and by --quay where they lie, if not 20 m south of it");
        }
    }

    /** A run as fast as the machine can, without limit, of one mission, on boats in this process, in which nobody presses an interrupt. */
    public static Builder of(String plan, String mission, FleetSettings fleet) {
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

    /** The same run on boats behind TCP, in real time; simulated boats beside them stay. */
    public RunSettings connectedTo(List<BoatAddress> addresses) {
        return change().fleet(fleet.of(addresses.size() + simulatedBesides().size()))
                .speed(Speed.REAL)
                .connect(addresses)
                .build();
    }

    /** The names of the boats that are simulated in this process beside those behind TCP; empty where none is behind TCP. */
    public List<String> simulatedBesides() {
        return connect.isEmpty() ? List.of() : fleet.boatNames().subList(0, fleet.boats() - connect.size());
    }

    /** Whether boats are other processes, behind TCP. */
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
    public RunSettings withFleet(FleetSettings other) {
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
        private FleetSettings fleet;
        private Speed speed = Speed.MAX;
        private OptionalLong limitMillis = OptionalLong.empty();
        private Map<String, String> parameters = Map.of();
        private long answerAfterMillis = STANDARD_ANSWER_MILLIS;
        private String answers = "";
        private List<BoatAddress> connect = List.of();
        private List<String> interrupts = List.of();
        private List<String> also = List.of();

        private Builder(String plan, String mission, FleetSettings fleet) {
            this.plan = plan;
            this.mission = mission;
            this.fleet = fleet;
        }

        public Builder fleet(FleetSettings value) {
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

package org.sami.crw.sim.hull;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.boat.link.TrackingError;
import org.sami.boat.server.ServerConfig;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.service.water.CrossTrackError;

/**
 * What makes simulated water less than ideal, and what boats measure in it; the same for all boats of a run.
 *
 * @param gpsNoiseM standard deviation of the position that a boat knows, east and north each, in metres
 * @param gpsJumpM how far that position jumps at most, now and then; the jump fades as the noise does
 * @param compassNoiseDeg standard deviation of the heading that a boat knows, in degrees
 * @param current how the water flows; its direction is the one it flows to
 * @param wind how the wind blows; its direction is the one it comes from
 * @param sensors what boats measure, each kind at most once
 * @param dischargeIntervalS for how many seconds the cost of a metre stays the same for a boat before its random part is drawn again, the interval τ
 *     of thesis 7.1.1; 0 = with each step
 * @param receiver when boats get new positions, and how their compasses begin
 */
public record Conditions(
        double gpsNoiseM,
        double gpsJumpM,
        double compassNoiseDeg,
        Flow current,
        Flow wind,
        List<SensorSetting> sensors,
        double dischargeIntervalS,
        Receiver receiver) {
    /** The largest standard deviation of a position: with more no boat finds a waypoint. */
    public static final double MOST_GPS_NOISE_M = 100;

    /** The largest standard deviation of a heading. */
    public static final double MOST_COMPASS_NOISE_DEG = 90;

    /** About the duration of a leg, so that unmodelled effects make one boat's leg dearer and another's cheaper. */
    public static final double USUAL_DISCHARGE_INTERVAL_S = 600;

    /** The longest such interval, a day: one draw for each battery. */
    public static final double LONGEST_DISCHARGE_INTERVAL_S = 86_400;

    /** Still water, exact instruments, no sensors. */
    public static final Conditions CALM = new Conditions(0, 0, Flow.NONE, Flow.NONE, List.of());

    /**
     * A lake on an ordinary day: position with the deviation that a log of 2016 shows within a minute (1.4 m along each axis) and jumps to 2.1 m, the
     * compass of a phone, a light current and breeze. {@link #LOGGED} is closer to that log.
     */
    public static final Conditions FIELD = new Conditions(
            1.4, 2.1, 4, Flow.parse("0.15@90"), Flow.parse("3@270"), List.of(), USUAL_DISCHARGE_INTERVAL_S);

    /** About the worst in which a boat of 3 m/s is still sent out: a receiver under trees, a river, a fresh wind. */
    public static final Conditions ROUGH =
            new Conditions(2.5, 4, 8, Flow.parse("0.4@60"), Flow.parse("7@300"), List.of(), USUAL_DISCHARGE_INTERVAL_S);

    /**
     * Positions as in the logs, on the water of {@link #FIELD}. A boat at rest for 57 s showed 1.4 m along each axis within a window of 6.5 by 7 m,
     * which an error of 1.9 m that wanders within 20 s does in a minute; jumps of 12 m.
     */
    public static final Conditions LOGGED = new Conditions(
            1.9,
            12,
            4,
            Flow.parse("0.15@90"),
            Flow.parse("3@270"),
            List.of(),
            USUAL_DISCHARGE_INTERVAL_S,
            Receiver.LOGGED);

    private static final String GPS = "gpsNoiseM";
    private static final String GPS_JUMP = "gpsJumpM";
    private static final String COMPASS = "compassNoiseDeg";
    private static final String CURRENT = "current";
    private static final String WIND = "wind";
    private static final String SENSORS = "sensors";
    private static final String RECEIVER = "receiver";
    private static final List<SensorSetting> OF_TEAMS = List.of(new SensorSetting(SensorKind.TEMPERATURE, 1));
    private static final String DISCHARGE_INTERVAL = "dischargeIntervalS";

    /** Conditions under which positions come at any time. */
    public Conditions(
            double gpsNoiseM,
            double gpsJumpM,
            double compassNoiseDeg,
            Flow current,
            Flow wind,
            List<SensorSetting> sensors,
            double dischargeIntervalS) {
        this(gpsNoiseM, gpsJumpM, compassNoiseDeg, current, wind, sensors, dischargeIntervalS, Receiver.STEADY);
    }

    /** Conditions under which positions do not jump and a battery is drawn on as usual. */
    public Conditions(double gpsNoiseM, double compassNoiseDeg, Flow current, Flow wind, List<SensorSetting> sensors) {
        this(gpsNoiseM, 0, compassNoiseDeg, current, wind, sensors, USUAL_DISCHARGE_INTERVAL_S);
    }

    /** Conditions under which positions do not jump. */
    public Conditions(
            double gpsNoiseM,
            double compassNoiseDeg,
            Flow current,
            Flow wind,
            List<SensorSetting> sensors,
            double dischargeIntervalS) {
        this(gpsNoiseM, 0, compassNoiseDeg, current, wind, sensors, dischargeIntervalS);
    }

    /** Refuses noise without bounds and two sensors of a kind. */
    public Conditions {
        within("the GPS noise in metres", gpsNoiseM, MOST_GPS_NOISE_M);
        within("the GPS jumps in metres", gpsJumpM, MOST_GPS_NOISE_M);
        within("the compass noise in degrees", compassNoiseDeg, MOST_COMPASS_NOISE_DEG);
        within("the discharge interval in seconds", dischargeIntervalS, LONGEST_DISCHARGE_INTERVAL_S);
        Objects.requireNonNull(current, "current");
        Objects.requireNonNull(wind, "wind");
        Objects.requireNonNull(receiver, "receiver");
        sensors = List.copyOf(sensors);
        if (sensors.stream().map(SensorSetting::kind).distinct().count() < sensors.size()) {
            throw new IllegalArgumentException("each kind of sensor is there once, not " + sensors);
        }
    }

    private static void within(String what, double value, double most) {
        if (!(value >= 0 && value <= most)) {
            throw new IllegalArgumentException(what + " is 0 to " + most + ", not " + value);
        }
    }

    /** The same for a kind of fleet: boats of a team measure temperature where no sensors are named, as somebody there has to sample. */
    public Conditions of(RobotKind robots) {
        return robots == RobotKind.ROBOT && sensors.isEmpty() ? measuring(OF_TEAMS) : this;
    }

    /** The same water, in which boats measure something. */
    public Conditions measuring(List<SensorSetting> others) {
        return new Conditions(
                gpsNoiseM, gpsJumpM, compassNoiseDeg, current, wind, others, dischargeIntervalS, receiver);
    }

    /** Whether boats know where they are. */
    public boolean hasExactPositions() {
        return gpsNoiseM == 0 && gpsJumpM == 0 && receiver == Receiver.STEADY;
    }

    /** The cross-track error of boats in it, for planners. */
    public CrossTrackError crossTrackError() {
        TrackingError error = trackingError();
        return CrossTrackError.of(error.positionM(), error.driftMps());
    }

    private TrackingError trackingError() {
        double jumpM = gpsJumpM / 3; // as a deviation: a jump is rare, of any size up to its largest, and fades
        return new TrackingError(Math.hypot(gpsNoiseM, jumpM), current.speedMps() + Weather.LEEWAY * wind.speedMps());
    }

    /** What a boat server in it knows of it. */
    public ServerConfig.Builder describeTo(ServerConfig.Builder server) {
        return server.trackingError(trackingError());
    }

    /** As text by name, for the header of a journal; what is as in calm water is left out. */
    public Map<String, String> toMap() {
        Map<String, String> map = new TreeMap<>();
        if (gpsNoiseM != 0) {
            map.put(GPS, String.valueOf(gpsNoiseM));
        }
        if (gpsJumpM != 0) {
            map.put(GPS_JUMP, String.valueOf(gpsJumpM));
        }
        if (compassNoiseDeg != 0) {
            map.put(COMPASS, String.valueOf(compassNoiseDeg));
        }
        if (!current.isNone()) {
            map.put(CURRENT, current.toString());
        }
        if (!wind.isNone()) {
            map.put(WIND, wind.toString());
        }
        if (!sensors.isEmpty()) {
            map.put(SENSORS, sensors.stream().map(SensorSetting::toString).collect(Collectors.joining(",")));
        }
        if (dischargeIntervalS != USUAL_DISCHARGE_INTERVAL_S) {
            map.put(DISCHARGE_INTERVAL, String.valueOf(dischargeIntervalS));
        }
        if (receiver != Receiver.STEADY) {
            map.put(RECEIVER, receiver.toString());
        }
        return map;
    }

    /**
     * Reads what {@link #toMap} wrote; names that it does not know are left alone.
     *
     * @throws IllegalArgumentException where something makes no sense
     */
    public static Conditions fromMap(Map<String, String> map) {
        return new Conditions(
                read(map, GPS, Double::parseDouble, 0.0),
                read(map, GPS_JUMP, Double::parseDouble, 0.0),
                read(map, COMPASS, Double::parseDouble, 0.0),
                read(map, CURRENT, Flow::parse, Flow.NONE),
                read(map, WIND, Flow::parse, Flow.NONE),
                read(map, SENSORS, Conditions::sensors, List.of()),
                read(map, DISCHARGE_INTERVAL, Double::parseDouble, USUAL_DISCHARGE_INTERVAL_S),
                read(map, RECEIVER, Receiver::parse, Receiver.STEADY));
    }

    private static <T> T read(Map<String, String> map, String name, Function<String, T> reader, T absent) {
        return map.containsKey(name) ? reader.apply(map.get(name)) : absent;
    }

    private static List<SensorSetting> sensors(String text) {
        return List.of(text.split(",")).stream().map(SensorSetting::parse).toList();
    }
}

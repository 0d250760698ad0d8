package org.sami.crw.sim.board;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.sami.boat.hull.nmea.NmeaSentence;
import org.sami.boat.hull.settings.BatteryCurve;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Sensor;
import org.sami.crw.sim.hull.Instruments;
import org.sami.crw.sim.hull.SimulatedHull;

/**
 * The control board of the boats of 2013 to 2017, with a simulated hull: its lines of JSON, its watchdog and its arming. It commands 0 after
 * {@link #WATCHDOG_MS} without a command, disarms after as long without a cable, and arms again {@link #ARMING_MS} after commands have come back. A state
 * machine without threads; one thread.
 */
public final class SimulatedBoard {
    /** Without a command for so long the motors stop; without a cable for so long the board disarms. */
    public static final long WATCHDOG_MS = 500;

    /** How long motor controllers take to arm. */
    public static final long ARMING_MS = 1000;

    /** The longest line that it reads. */
    public static final int MAX_LINE_BYTES = 512;

    /** The most that its parser takes of one object. */
    public static final int MAX_OBJECT_BYTES = 200;

    private static final long LINE_MS = 100;
    private static final long BATTERY_MS = 1000;
    private static final double FULL_CURRENT_A = 9;
    private static final ObjectMapper JSON = new ObjectMapper();

    private final HullKind kind;
    private final SimulatedHull hull;
    private final Instruments instruments;
    private final BatteryCurve battery =
            HullSettings.of(HullKind.DIFFERENTIAL).build().battery();
    private final List<Channel> channels = new ArrayList<>();
    private final List<String> errors = new ArrayList<>();
    private double first; // as commanded
    private double second;
    private long commandMs = Long.MIN_VALUE / 2;
    private long cableMs = Long.MIN_VALUE / 2;
    private long armedMs = Long.MAX_VALUE; // when the controllers are armed
    private long lineMs = Long.MIN_VALUE / 2;
    private long batteryMs = Long.MIN_VALUE / 2;
    private long lastMs = Long.MIN_VALUE;

    /** A board at rest. */
    public SimulatedBoard(BoardSettings settings) {
        kind = settings.kind();
        LocalFrame frame = new LocalFrame(settings.at().latDeg(), settings.at().lonDeg());
        hull = new SimulatedHull(settings.hull(), settings.conditions(), frame, 0, 0, settings.seed());
        instruments = new Instruments(hull, settings.conditions(), settings.seed() ^ 0x67707320L, settings.fieldSeed());
        for (Sensor sensor : instruments.sensors()) {
            channels.add(new Channel(sensor));
        }
    }

    /** One of the hull's sensors, and when it is read next. */
    private static final class Channel {
        private final Sensor sensor;
        private long dueMs = Long.MIN_VALUE;

        Channel(Sensor sensor) {
            this.sensor = sensor;
        }
    }

    /** The hull behind it. */
    public SimulatedHull hull() {
        return hull;
    }

    /** What GPS and compass on the hull show. */
    public Instruments instruments() {
        return instruments;
    }

    /** Whether the motor controllers are armed. */
    public boolean isArmed(long nowMs) {
        return nowMs >= armedMs;
    }

    /** A line has come over the cable. */
    public void take(String line, long nowMs) {
        cableMs = nowMs;
        if (line.length() > MAX_OBJECT_BYTES) {
            error("buffer overflow", String.valueOf(line.length()));
            return;
        }
        try {
            JsonNode object = JSON.readTree(line);
            if (object == null || !object.isObject()) {
                error("no object", "");
                return;
            }
            command(object, nowMs);
        } catch (JsonProcessingException damaged) {
            error("cannot parse", "");
        }
    }

    private void error(String error, String arguments) {
        if (errors.size() < 8) {
            errors.add("{\"error\":\"" + error + "\",\"args\":\"" + arguments + "\"}");
        }
    }

    private void command(JsonNode object, long nowMs) {
        JsonNode one = object.path("m0").path("v");
        JsonNode other = kind == HullKind.RUDDER
                ? object.path("s0").path("p")
                : object.path("m1").path("v");
        if (!one.isNumber() && !other.isNumber()) {
            return; // a command for something else
        }
        if (armedMs == Long.MAX_VALUE) {
            armedMs = nowMs + ARMING_MS;
        }
        commandMs = nowMs;
        first = one.isNumber() ? clip(one.asDouble()) : first;
        second = other.isNumber() ? clip(other.asDouble()) : second;
    }

    private static double clip(double effort) {
        return Math.max(-1, Math.min(1, effort));
    }

    /** The cable is in now. */
    public void powered(long nowMs) {
        cableMs = nowMs;
    }

    /** Lets time pass, and moves the hull. */
    public void pass(long nowMs) {
        if (nowMs - commandMs > WATCHDOG_MS) {
            first = 0;
            second = 0;
        }
        if (nowMs - cableMs > WATCHDOG_MS) {
            armedMs = Long.MAX_VALUE;
        }
        boolean armed = isArmed(nowMs);
        drive(armed ? first : 0, armed ? second : 0);
        double seconds = lastMs == Long.MIN_VALUE ? 0 : Math.min(1, (nowMs - lastMs) / 1000.0);
        lastMs = nowMs;
        if (seconds > 0) {
            hull.step(seconds);
            instruments.step(seconds);
        }
    }

    /** A rudder turns the hull by the stream of its motor, to port where its servo goes up, as it is mounted reversed. */
    private void drive(double one, double other) {
        if (kind == HullKind.RUDDER) {
            double thrust = Math.max(0, one);
            double turn = -other * Math.min(1, 2 * thrust) * 0.7;
            hull.setMotors(thrust + turn, thrust - turn);
        } else {
            hull.setMotors(one, other);
        }
    }

    /** The lines that are due, in their order, without their ends. */
    public List<String> lines(long nowMs) {
        List<String> due = new ArrayList<>(errors);
        errors.clear();
        if (nowMs - lineMs >= LINE_MS) {
            lineMs = nowMs;
            due.add(motors(nowMs));
        }
        if (nowMs - batteryMs >= BATTERY_MS) {
            batteryMs = nowMs;
            double volts = battery.voltsAt(hull.batteryPercent());
            due.add(sensor("s4", "battery", text("%.3f %.3f %.3f", volts, power(first, volts), power(second, volts))));
        }
        measure(due, nowMs);
        return due;
    }

    private static double power(double effort, double volts) {
        return Math.abs(effort) * volts;
    }

    private String motors(long nowMs) {
        boolean armed = isArmed(nowMs);
        double one = armed ? first : 0;
        double other = armed && kind == HullKind.DIFFERENTIAL ? second : 0;
        return text(
                "{\"m0\":{\"v\":%.3f,\"c\":%.2f},\"m1\":{\"v\":%.3f,\"c\":%.2f}}",
                one, Math.abs(one) * FULL_CURRENT_A, other, Math.abs(other) * FULL_CURRENT_A);
    }

    private void measure(List<String> due, long nowMs) {
        double conductivity = Double.NaN;
        double temperature = Double.NaN;
        for (Channel channel : channels) {
            if (nowMs < channel.dueMs) {
                continue;
            }
            channel.dueMs = nowMs + channel.sensor.periodMs();
            double value = channel.sensor.read().get(0);
            switch (channel.sensor.channel()) {
                case "conductivity" -> conductivity = value;
                case "temperature" -> temperature = value;
                case "oxygen" -> due.add(sensor("s2", "atlas_do", text("%.2f", value)));
                case "ph" -> due.add(sensor("s3", "atlas_ph", text("%.2f", value)));
                default -> throw new IllegalStateException("no board measures " + channel.sensor.channel());
            }
        }
        if (!Double.isNaN(conductivity)) {
            String both = Double.isNaN(temperature) ? "%.2f" : "%.2f %.2f";
            due.add(sensor("s1", "es2", text(both, conductivity, temperature)));
        } else if (!Double.isNaN(temperature)) { // a sounder's thermometer
            due.add(sensor(
                    "s1",
                    "hds",
                    NmeaSentence.line(text("SDMTW,%.2f,C", temperature)).trim()));
        }
    }

    private static String sensor(String slot, String type, String data) {
        return "{\"" + slot + "\":{\"type\":\"" + type + "\",\"data\":\"" + data + "\"}}";
    }

    private static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}

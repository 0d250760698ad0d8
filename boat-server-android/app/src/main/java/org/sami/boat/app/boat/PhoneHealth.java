package org.sami.boat.app.boat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.DoubleSupplier;
import org.sami.boat.link.PhoneReadings;
import org.sami.boat.server.log.LogFaults;
import org.sami.boat.server.vehicle.Sensor;

/**
 * How the phone is: its charge, heat and storage, and by how much its date was set. The base gets it as readings of the instrument {@code phone}. Safe for use
 * by several threads.
 */
public final class PhoneHealth {
    /** Charge in percent below which a phone has little. */
    public static final double LITTLE_CHARGE_PERCENT = 15;

    private volatile double batteryPercent = Double.NaN;
    private volatile double temperatureC = Double.NaN;
    private volatile double freeMegabytes = Double.NaN;
    private volatile double clockSetByS = Double.NaN;
    private volatile boolean logBroken;
    private volatile boolean logOversized;
    private volatile boolean dateLost;

    /** The phone's battery. */
    public void setBattery(double percent, double celsius) {
        batteryPercent = percent;
        temperatureC = celsius;
    }

    /** The storage that is left. */
    public void setFreeMegabytes(double megabytes) {
        freeMegabytes = megabytes;
    }

    /** The phone's date was set; reported to the base once. */
    public void clockSet(double bySeconds) {
        clockSetByS = bySeconds;
    }

    /** Whether the phone has lost its date: it shows one before this app was made. */
    public void setDateLost(boolean lost) {
        dateLost = lost;
    }

    /** Learns there when the boat's log cannot be kept as it should be. */
    LogFaults logFaults() {
        return new LogFaults() {
            @Override
            public void unwritable(IOException cause) {
                logBroken = true;
            }

            @Override
            public void oversized(IOException cause) {
                logOversized = true;
            }

            @Override
            public void mended() {
                logBroken = false;
                logOversized = false;
            }
        };
    }

    /** Charge of the phone's battery in percent; NaN if unknown. */
    public double batteryPercent() {
        return batteryPercent;
    }

    /** Temperature of the phone's battery in °C; NaN if unknown. */
    public double temperatureC() {
        return temperatureC;
    }

    /** What is not well, in words for people; empty if all is. */
    public List<String> troubles() {
        List<String> troubles = new ArrayList<>();
        if (batteryPercent < LITTLE_CHARGE_PERCENT) {
            troubles.add("phone battery " + Math.round(batteryPercent) + " %: charge it");
        }
        if (temperatureC >= PhoneReadings.HOT_C) {
            troubles.add("phone is hot, " + Math.round(temperatureC) + " °C: shade it");
        }
        if (freeMegabytes < PhoneReadings.LITTLE_STORAGE_MB) {
            troubles.add("phone storage is nearly full, " + Math.round(freeMegabytes) + " MB left: delete something");
        }
        if (dateLost) {
            troubles.add("the phone has lost its date: set it; the boat drives all the same");
        }
        if (logBroken) {
            troubles.add("the log cannot be written: after a restart the boat will not know its last commands");
        }
        if (logOversized) {
            troubles.add("the log grows beyond its size, as no new file of it can be written: free some storage");
        }
        return troubles;
    }

    /** What the base gets. */
    public List<Sensor> sensors() {
        List<Sensor> sensors = new ArrayList<>();
        sensors.add(new Channel(PhoneReadings.BATTERY, "%", () -> batteryPercent));
        sensors.add(new Channel(PhoneReadings.TEMPERATURE, "°C", () -> temperatureC));
        sensors.add(new Channel(PhoneReadings.FREE_STORAGE, "MB", () -> freeMegabytes));
        sensors.add(new Channel(PhoneReadings.LOG_BROKEN, "", () -> logBroken ? 1 : Double.NaN));
        sensors.add(new Channel(PhoneReadings.LOG_TOO_LARGE, "", () -> logOversized ? 1 : Double.NaN));
        sensors.add(new Channel(PhoneReadings.DATE_LOST, "", () -> dateLost ? 1 : Double.NaN));
        sensors.add(new Channel(PhoneReadings.DATE_SET_BY, "s", this::takeClockSet));
        return sensors;
    }

    private double takeClockSet() {
        double by = clockSetByS;
        clockSetByS = Double.NaN;
        return by;
    }

    /** One channel of the instrument; it says nothing while its value is unknown. */
    private static final class Channel implements Sensor {
        private final String channel;
        private final String unit;
        private final DoubleSupplier value;

        Channel(String channel, String unit, DoubleSupplier value) {
            this.channel = channel;
            this.unit = unit;
            this.value = value;
        }

        @Override
        public String name() {
            return PhoneReadings.SENSOR;
        }

        @Override
        public String channel() {
            return channel;
        }

        @Override
        public String unit() {
            return unit;
        }

        @Override
        public long periodMs() {
            return PhoneReadings.PERIOD_MS;
        }

        @Override
        public List<Double> read() {
            double now = value.getAsDouble();
            return Double.isNaN(now) ? Collections.emptyList() : Sensor.single(now);
        }
    }
}

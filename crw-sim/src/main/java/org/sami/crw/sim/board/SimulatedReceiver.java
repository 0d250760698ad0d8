package org.sami.crw.sim.board;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.sami.boat.hull.nmea.NmeaSentence;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.sim.hull.Instruments;

/**
 * A GPS receiver with a compass on a simulated hull, as NMEA 0183: RMC and GGA five times a second, HDT ten times. Course and speed are those of the positions
 * that it shows, smoothed over about half a second. One thread.
 */
final class SimulatedReceiver {
    private static final long FIX_MS = 200;
    private static final long COMPASS_MS = 100;
    private static final double KNOT_MPS = 1852.0 / 3600;
    private static final double MEAN = 0.4; // part of a new motion in the one that is shown

    private final Instruments instruments;
    private final boolean hasCompass;
    private long fixMs = Long.MIN_VALUE / 2;
    private long compassMs = Long.MIN_VALUE / 2;
    private double lastLatDeg = Double.NaN;
    private double lastLonDeg;
    private double eastMps;
    private double northMps;

    SimulatedReceiver(Instruments instruments, boolean hasCompass) {
        this.instruments = instruments;
        this.hasCompass = hasCompass;
    }

    /** The sentences that are due, with their ends. */
    List<String> sentences(long nowMs) {
        List<String> due = new ArrayList<>();
        if (hasCompass && nowMs - compassMs >= COMPASS_MS) {
            compassMs = nowMs;
            double deg = (Math.toDegrees(instruments.headingRad()) + 360) % 360;
            due.add(line("GPHDT,%.1f,T", deg));
        }
        if (nowMs - fixMs >= FIX_MS) {
            double seconds = (nowMs - fixMs) / 1000.0;
            fixMs = nowMs;
            fix(due, nowMs, seconds);
        }
        return due;
    }

    private void fix(List<String> due, long nowMs, double seconds) {
        double lat = instruments.latDeg();
        double lon = instruments.lonDeg();
        if (!Double.isNaN(lastLatDeg)) {
            LocalFrame before = new LocalFrame(lastLatDeg, lastLonDeg);
            eastMps += MEAN * (before.eastM(lat, lon) / seconds - eastMps);
            northMps += MEAN * (before.northM(lat, lon) / seconds - northMps);
        }
        lastLatDeg = lat;
        lastLonDeg = lon;
        double knots = Math.hypot(eastMps, northMps) / KNOT_MPS;
        double course = (Math.toDegrees(StrictMath.atan2(eastMps, northMps)) + 360) % 360;
        String where = angle(lat, 2, "N", "S") + "," + angle(lon, 3, "E", "W");
        String time = String.format(
                Locale.ROOT, "%02d%02d%05.2f", nowMs / 3_600_000 % 24, nowMs / 60_000 % 60, nowMs % 60_000 / 1000.0);
        due.add(line("GPGGA,%s,%s,1,09,0.9,0.0,M,0.0,M,,", time, where));
        due.add(line("GPRMC,%s,A,%s,%.2f,%.1f,010120,,,A", time, where, knots, course));
    }

    private static String angle(double deg, int digits, String positive, String negative) {
        double size = Math.abs(deg);
        long tenThousandths = Math.round(size * 60 * 100_000);
        long whole = tenThousandths / 6_000_000;
        double minutes = tenThousandths % 6_000_000 / 100_000.0;
        String pattern = "%0" + digits + "d%08.5f,%s";
        return String.format(Locale.ROOT, pattern, whole, minutes, deg < 0 ? negative : positive);
    }

    private static String line(String pattern, Object... values) {
        return NmeaSentence.line(String.format(Locale.ROOT, pattern, values));
    }
}

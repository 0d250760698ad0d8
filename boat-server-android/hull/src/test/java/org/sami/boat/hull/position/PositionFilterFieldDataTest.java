package org.sami.boat.hull.position;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.server.vehicle.LocalFrame;

/**
 * A log of a boat of 2013: its phone's fixes, one a second, and its compass. Nobody measured where the boat truly was, so each fix is the truth for the
 * estimate made just before it came.
 */
class PositionFilterFieldDataTest {
    private static final Path LOG =
            Path.of("..", "..", "..", "shared", "field-data", "platypus-airboat_20130807_063622.txt");
    private static final Pattern GPS = Pattern.compile("^(\\d+) \\S+ GPS: \\[([0-9.]+) m, ([0-9.]+) m\\].*");
    private static final Pattern COMPASS = Pattern.compile("^(\\d+) \\S+ COMPASS: (\\S+).*");
    private static final Pattern POSE = Pattern.compile("^(\\d+) \\S+ POSE: \\{([0-9.]+), ([0-9.]+),.*");
    private static final LocalFrame FRAME = new LocalFrame(40.49, -79.92); // where zone 17 has such metres

    /** At the beginning the phone repeats old positions for seconds; then it has a new one every second. */
    private static final int REPEATED_FIXES = 10;

    private List<String> lines = new ArrayList<>();

    @BeforeEach
    void readsTheLog() throws IOException {
        assumeTrue(Files.exists(LOG), "skipped: there is no " + LOG);
        lines = Files.readAllLines(LOG);
    }

    /** A fix at metres of the log's grid: over some hundred metres the grid is a plane. */
    private static GpsFix fix(double eastM, double northM) {
        double lat = FRAME.latDeg(eastM - 591_760, northM - 4_482_760);
        return GpsFix.at(lat, FRAME.lonDegOn(lat, eastM - 591_760));
    }

    private static double offM(Pose pose, GpsFix fix) {
        return new LocalFrame(fix.latDeg(), fix.lonDeg()).distanceM(pose.latDeg(), pose.lonDeg());
    }

    @Test
    void filterForetellsTheNextFixBetterThanTheLastFixDoes() {
        PositionFilter filter = new PositionFilter();
        GpsFix last = GpsFix.at(0, 0);
        double raw = 0;
        double filtered = 0;
        int compared = 0;
        int fixes = 0;
        for (String line : lines) {
            Matcher gps = GPS.matcher(line);
            if (gps.matches()) {
                long ms = Long.parseLong(gps.group(1));
                GpsFix fix = fix(Double.parseDouble(gps.group(2)), Double.parseDouble(gps.group(3)));
                fixes++;
                if (fixes > REPEATED_FIXES) {
                    double off = offM(filter.pose(ms), fix);
                    double held = new LocalFrame(fix.latDeg(), fix.lonDeg()).distanceM(last.latDeg(), last.lonDeg());
                    filtered += off * off;
                    raw += held * held;
                    compared++;
                }
                filter.gps(fix, ms);
                last = fix;
            }
        }
        double rawM = Math.sqrt(raw / compared);
        double filteredM = Math.sqrt(filtered / compared);
        System.out.printf(
                Locale.ROOT,
                "log of 2013, %d fixes: the next one is %.2f m off the last fix, %.2f m off the filter%n",
                compared,
                rawM,
                filteredM);

        assertThat(compared).isEqualTo(9);
        assertThat(filteredM).isLessThan(rawM * 0.8);
    }

    @Test
    void phonesFirstPositionInAnotherCountyIsGivenUpForTheRealOne() {
        PositionFilter filter = new PositionFilter();
        long ms = 0;
        double farthestM = 0;
        GpsFix last = GpsFix.at(0, 0);
        for (String line : lines) {
            Matcher pose = POSE.matcher(line);
            Matcher compass = COMPASS.matcher(line);
            if (compass.matches()) {
                filter.compass(-Double.parseDouble(compass.group(2)), Long.parseLong(compass.group(1)));
            } else if (pose.matches()) {
                ms = Long.parseLong(pose.group(1));
                last = fix(Double.parseDouble(pose.group(2)), Double.parseDouble(pose.group(3)));
                filter.gps(last, ms);
                if (ms > 2_490_000) { // five seconds after the jump of 220 km
                    farthestM = Math.max(farthestM, offM(filter.pose(ms), last));
                }
            }
        }

        assertThat(filter.refusedFixes()).isBetween(5L, 40L);
        assertThat(offM(filter.pose(ms), last)).isLessThan(5);
        assertThat(farthestM).isLessThan(12);
    }
}

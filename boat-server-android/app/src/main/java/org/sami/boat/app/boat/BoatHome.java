package org.sami.boat.app.boat;

import java.io.IOException;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.boat.server.vehicle.LocalFrame;

/**
 * Where the boat returns to. A boat that was begun again in the middle of a mission keeps the home that it had; far from it, it was carried to other water, and
 * its home is where it is.
 */
final class BoatHome {
    /** A boat further than this from its home, in m, was carried elsewhere. */
    static final double FAR_M = 3000;

    private static final Pattern TEXT = Pattern.compile("(-?\\d{1,2}\\.\\d{7}) (-?\\d{1,3}\\.\\d{7})\n");

    private BoatHome() {}

    /** The home of a boat at a position, which is kept. */
    static LocalFrame of(AppFiles files, double latDeg, double lonDeg) throws IOException {
        Optional<LocalFrame> kept = read(files);
        if (kept.isPresent() && kept.get().distanceM(latDeg, lonDeg) <= FAR_M) {
            return kept.get();
        }
        AppFiles.write(files.home(), String.format(Locale.ROOT, "%.7f %.7f\n", latDeg, lonDeg));
        return new LocalFrame(latDeg, lonDeg);
    }

    private static Optional<LocalFrame> read(AppFiles files) throws IOException {
        Matcher text = TEXT.matcher(AppFiles.text(files.home()).orElse(""));
        if (!text.matches()) {
            return Optional.empty();
        }
        double latDeg = Double.parseDouble(text.group(1));
        double lonDeg = Double.parseDouble(text.group(2));
        boolean onEarth = Math.abs(latDeg) <= 85 && Math.abs(lonDeg) <= 180;
        return onEarth ? Optional.of(new LocalFrame(latDeg, lonDeg)) : Optional.empty();
    }
}

package org.sami.boat.hull.nmea;

import java.util.Optional;
import org.sami.boat.hull.position.GpsFix;

/**
 * Reads positions and headings from NMEA 0183: RMC and GGA for positions, HDT, HDG and HDM for a compass. A receiver that sends both RMC and GGA is taken at
 * its RMC, with the accuracy of the GGA before. Sentences without a fitting checksum are left out and counted. One thread.
 */
public final class NmeaReader {
    private static final double KNOT_MPS = 1852.0 / 3600;
    private static final double METRES_PER_HDOP = 2.5;
    private static final int RMC_LASTS = 10; // so many positions by GGA alone, and the receiver sends no RMC any more

    /** Receives what was read. */
    public interface Sink {
        /** A position. */
        void fix(GpsFix fix);

        /** A heading from magnetic north in radians. */
        void magneticHeading(double rad);

        /** A heading from true north in radians. */
        void trueHeading(double rad);

        /** The magnetic declination in radians, positive to the east. */
        void declination(double rad);
    }

    private final Sink sink;
    private double accuracyM = Double.NaN;
    private int ggaSinceRmc = RMC_LASTS;
    private long unread;

    /** A reader that passes on what it reads. */
    public NmeaReader(Sink sink) {
        this.sink = sink;
    }

    /** Reads a line. */
    public void line(String line) {
        Optional<NmeaSentence> sentence = NmeaSentence.read(line, true);
        if (sentence.isPresent()) {
            take(sentence.get());
        } else {
            unread++;
        }
    }

    private void take(NmeaSentence in) {
        switch (in.type()) {
            case "RMC":
                recommended(in);
                break;
            case "GGA":
                fixData(in);
                break;
            case "HDT":
                trueHeading(in.number(1));
                break;
            case "HDM":
                magnetic(in.number(1));
                break;
            case "HDG":
                declination(signed(in.number(4), in.text(5)));
                magnetic(in.number(1) + orZero(signed(in.number(2), in.text(3))));
                break;
            default:
                break; // what else a receiver says is not needed
        }
    }

    private void recommended(NmeaSentence in) {
        declination(signed(in.number(10), in.text(11)));
        if (!in.text(2).equals("A")) {
            return; // no fix
        }
        ggaSinceRmc = 0;
        sink.fix(new GpsFix(
                angle(in, 3, 2, 90),
                angle(in, 5, 3, 180),
                accuracyM,
                in.number(7) * KNOT_MPS,
                Math.toRadians(in.number(8))));
    }

    private void fixData(NmeaSentence in) {
        double quality = in.number(6);
        if (!(quality > 0)) {
            return;
        }
        accuracyM = in.number(8) * METRES_PER_HDOP;
        ggaSinceRmc++;
        if (ggaSinceRmc > RMC_LASTS) {
            sink.fix(new GpsFix(angle(in, 2, 2, 90), angle(in, 4, 3, 180), accuracyM, Double.NaN, Double.NaN));
        }
    }

    /** Degrees and minutes in one number, and a letter for the side. */
    private static double angle(NmeaSentence in, int index, int degreeDigits, double most) {
        String text = in.text(index);
        int point = text.indexOf('.');
        int whole = point < 0 ? text.length() : point;
        if (whole != degreeDigits + 2) {
            return Double.NaN;
        }
        double number = in.number(index);
        double degrees = Math.floor(number / 100);
        double minutes = number - degrees * 100;
        double value = degrees + minutes / 60;
        return minutes < 60 && value <= most ? signed(value, in.text(index + 1)) : Double.NaN;
    }

    private static double signed(double value, String side) {
        switch (side) {
            case "N":
            case "E":
                return value;
            case "S":
            case "W":
                return 0 - value;
            default:
                return Double.NaN;
        }
    }

    private static double orZero(double value) {
        return Double.isNaN(value) ? 0 : value;
    }

    private void trueHeading(double deg) {
        if (Math.abs(deg) <= 360) {
            sink.trueHeading(Math.toRadians(deg));
        }
    }

    private void magnetic(double deg) {
        if (Math.abs(deg) <= 360) {
            sink.magneticHeading(Math.toRadians(deg));
        }
    }

    private void declination(double deg) {
        if (Math.abs(deg) <= 180) {
            sink.declination(Math.toRadians(deg));
        }
    }

    /** How many lines were no whole sentences. */
    public long unread() {
        return unread;
    }
}

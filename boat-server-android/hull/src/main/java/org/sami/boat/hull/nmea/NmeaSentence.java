package org.sami.boat.hull.nmea;

import java.util.Optional;

/** A sentence of NMEA 0183, as {@code $GPRMC,...*hh}: its talker, its type and its fields. Immutable. */
public final class NmeaSentence {
    /** The longest sentence that is read; the standard's 82 are exceeded by some receivers. */
    public static final int MAX_BYTES = 120;

    private final String type;
    private final String[] fields;

    private NmeaSentence(String type, String[] fields) {
        this.type = type;
        this.fields = fields;
    }

    /**
     * Reads a line. Empty if it is no sentence, too long, or its checksum does not fit.
     *
     * @param checksumNeeded whether a sentence without a checksum is refused
     */
    public static Optional<NmeaSentence> read(String line, boolean checksumNeeded) {
        int start = line.lastIndexOf('$'); // of a line that was cut, the last beginning counts
        int star = line.indexOf('*', Math.max(0, start));
        boolean summed = star >= 0;
        if (start < 0 || line.length() - start > MAX_BYTES || (!summed && checksumNeeded)) {
            return Optional.empty();
        }
        String body = line.substring(start + 1, summed ? star : line.length());
        if (summed && checksum(body) != hex(line.substring(star + 1).trim())) {
            return Optional.empty();
        }
        String[] parts = body.split(",", -1);
        if (parts[0].length() < 5) {
            return Optional.empty();
        }
        return Optional.of(new NmeaSentence(parts[0].substring(2), parts));
    }

    private static int hex(String digits) {
        try {
            return digits.length() == 2 ? Integer.parseInt(digits, 16) : -1;
        } catch (NumberFormatException e) {
            return -1;
        }
    }

    /** The exclusive or of all characters between dollar and star. */
    public static int checksum(String body) {
        int sum = 0;
        for (int i = 0; i < body.length(); i++) {
            sum ^= body.charAt(i);
        }
        return sum;
    }

    /** A line with dollar, star, checksum, CR and LF of what stands between dollar and star. */
    public static String line(String body) {
        return String.format("$%s*%02X\r\n", body, checksum(body));
    }

    /** Its type without the talker, as {@code RMC}. */
    public String type() {
        return type;
    }

    /** A field, the first after the type being 1; empty text if there is none. */
    public String text(int index) {
        return index < fields.length ? fields[index].trim() : "";
    }

    /** A field as a number; NaN if it is none. */
    public double number(int index) {
        String text = text(index);
        if (text.isEmpty() || text.length() > 20) {
            return Double.NaN;
        }
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }
}

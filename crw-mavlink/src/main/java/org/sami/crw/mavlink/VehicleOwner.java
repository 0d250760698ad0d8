package org.sami.crw.mavlink;

import java.util.List;

/**
 * Whose the files of a system id are: ids are given again, most vehicles have 1.
 *
 * @param number of its autopilot; empty text where it says none
 * @param flies whether it is a copter
 * @param vehicles how many vehicles had the id before it, as far as this machine knows
 */
record VehicleOwner(String number, boolean flies, int vehicles) {
    private static final String COPTER = "copter";
    private static final String BOAT = "boat";
    private static final int LINES = 3;

    /** Whether it is another vehicle: of another kind, or with another number. One that says no number may be the one with it. */
    boolean isAnother(VehicleOwner other) {
        boolean differ = !number.isEmpty() && !other.number.isEmpty() && !number.equals(other.number);
        return differ || flies != other.flies;
    }

    /** A name for what is kept of it while another one has its id. */
    String key() {
        return kind() + (number.isEmpty() ? "" : "-" + number);
    }

    /** One word, for files and their names. */
    String kind() {
        return flies ? COPTER : BOAT;
    }

    List<String> lines() {
        return List.of(number, kind(), String.valueOf(vehicles));
    }

    /**
     * Reads {@link #lines}.
     *
     * @throws IllegalArgumentException where they are damaged
     */
    static VehicleOwner of(List<String> lines) {
        boolean isWhole = lines.size() == LINES
                && lines.get(0).matches("[0-9a-f]*")
                && List.of(COPTER, BOAT).contains(lines.get(1))
                && lines.get(2).matches("[0-9]{1,6}");
        if (!isWhole) {
            throw new IllegalArgumentException("no number, kind and count of vehicles: " + lines);
        }
        return new VehicleOwner(lines.get(0), lines.get(1).equals(COPTER), Integer.parseInt(lines.get(2)));
    }
}

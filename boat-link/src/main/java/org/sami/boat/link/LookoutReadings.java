package org.sami.boat.link;

import java.util.List;

/**
 * The readings in which a boat reports a vessel that it sees and that is not of its base. They are ordinary {@link SensorReport}s of the instrument {@link #SENSOR},
 * each of one vessel. Only simulated boats have that instrument.
 */
public final class LookoutReadings {
    /** Names the lookout among the instruments of its boat. */
    public static final String SENSOR = "lookout";

    /**
     * Channel: a vessel. Its values: number of the vessel, WGS 84 latitude and longitude of its middle in degrees, course in degrees clockwise from north, speed in
     * m/s, length and width in metres.
     */
    public static final String VESSEL = "vessel";

    private static final int VALUES = 7;

    private LookoutReadings() {}

    /** Whether a reading is one of these, with all its values. */
    public static boolean isVessel(String sensor, List<Double> values) {
        return sensor.equals(SENSOR)
                && values.size() >= VALUES
                && Math.abs(values.get(1)) <= 90
                && Math.abs(values.get(2)) <= 180;
    }
}

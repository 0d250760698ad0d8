package org.sami.boat.link;

/**
 * The readings in which a boat's phone reports how it is itself, and the limits that its screen and bases use alike. They are ordinary {@link SensorReport}s of
 * the instrument {@link #SENSOR}. {@code crw defaults} prints the limits.
 */
public final class PhoneReadings {
    /** Names the phone among the instruments of its boat. */
    public static final String SENSOR = "phone";

    /** Channel: charge of the phone's battery in percent. */
    public static final String BATTERY = "battery";

    /** Channel: temperature of the phone's battery in °C. */
    public static final String TEMPERATURE = "temperature";

    /** Channel: free storage in MB. */
    public static final String FREE_STORAGE = "free storage";

    /** Channel: 1 while the boat's log cannot be written. */
    public static final String LOG_BROKEN = "log broken";

    /** Channel: 1 while the boat's log takes more room than it should. */
    public static final String LOG_TOO_LARGE = "log too large";

    /** Channel: 1 while the phone's date is before the app was made. */
    public static final String DATE_LOST = "date lost";

    /** Channel: by how many seconds the phone's date was set; sent once. */
    public static final String DATE_SET_BY = "date set by";

    /** Time in ms between two readings of a channel. */
    public static final long PERIOD_MS = 5000;

    /** From this temperature in °C on, phones slow down or switch off. */
    public static final double HOT_C = 45;

    /** With less free storage than this, in MB, logs will soon fail. */
    public static final double LITTLE_STORAGE_MB = 100;

    private PhoneReadings() {}
}

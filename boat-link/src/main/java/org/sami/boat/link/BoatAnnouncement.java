package org.sami.boat.link;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;

/**
 * What a boat announces on the local network by DNS-SD (RFC 6763), as a service of {@link #SERVICE_TYPE}: the entries of its TXT record, which announcers and
 * bases read and write here alone. Anybody on the network can announce anything: it is where to look for a boat, and proves nothing. Immutable.
 */
public final class BoatAnnouncement {
    /** The type of the service, without a domain. */
    public static final String SERVICE_TYPE = "_sami-boat._tcp";

    /** The most bytes that an entry of a TXT record has, with its key. */
    public static final int MOST_ENTRY_BYTES = 255;

    private static final String ID = "id";
    private static final String NAME = "name";
    private static final String KEY = "key";
    private static final String ACCESS = "access";
    private static final String LINK = "link";
    private static final String BATTERY = "battery";
    private static final String HULL = "hull";
    private static final int MOST_PERCENT = 100;
    private static final int MOST_LINK = 1_000_000;

    /** Who may command a boat. */
    public enum Access {
        /** Whoever reaches it: its links are plain. */
        OPEN,
        /** Bases that are paired with it. */
        PAIRED,
        /** Bases that are paired with it, and it waits for one to be paired. */
        PAIRING
    }

    private final String boatId;
    private final String name;
    private final String key;
    private final Access access;
    private final int linkVersion;
    private final OptionalInt batteryPercent;
    private final String hull;

    /**
     * An announcement.
     *
     * @param boatId the boat's id, as in its hello
     * @param name the boat's name for people
     * @param key the first digits of its key's fingerprint; empty if it has none
     * @param access who may command it
     * @param linkVersion the version of the link that it speaks
     * @param batteryPercent its charge, if known
     * @param hull its kind of hull, such as {@code simulated}, {@code differential} or {@code rudder}
     * @throws IllegalArgumentException if something does not fit a TXT record
     */
    public BoatAnnouncement(
            String boatId,
            String name,
            String key,
            Access access,
            int linkVersion,
            OptionalInt batteryPercent,
            String hull) {
        this.boatId = text(ID, boatId, false);
        this.name = text(NAME, name, false);
        this.key = text(KEY, key, true);
        this.access = Objects.requireNonNull(access, "access");
        this.linkVersion = within(LINK, linkVersion, MOST_LINK);
        this.batteryPercent = Objects.requireNonNull(batteryPercent, "batteryPercent");
        batteryPercent.ifPresent(percent -> within(BATTERY, percent, MOST_PERCENT));
        this.hull = text(HULL, hull, true);
    }

    /** Of a boat that speaks this version, whose charge is not known yet. */
    public static BoatAnnouncement of(String boatId, String key, Access access, String hull) {
        return new BoatAnnouncement(boatId, boatId, key, access, LinkCodec.VERSION, OptionalInt.empty(), hull);
    }

    /** The same boat with other access. */
    public BoatAnnouncement with(Access now) {
        return new BoatAnnouncement(boatId, name, key, now, linkVersion, batteryPercent, hull);
    }

    /** The same boat with another charge. */
    public BoatAnnouncement withBattery(int percent) {
        return new BoatAnnouncement(boatId, name, key, access, linkVersion, OptionalInt.of(percent), hull);
    }

    /**
     * Reads the entries of a TXT record; unknown ones are ignored.
     *
     * @throws IllegalArgumentException naming what is missing or wrong
     */
    public static BoatAnnouncement parse(Map<String, String> entries) {
        String id = entry(entries, ID);
        String battery = entries.getOrDefault(BATTERY, "");
        return new BoatAnnouncement(
                id,
                entries.getOrDefault(NAME, id),
                entries.getOrDefault(KEY, ""),
                accessOf(entry(entries, ACCESS)),
                number(LINK, entry(entries, LINK)),
                battery.isEmpty() ? OptionalInt.empty() : OptionalInt.of(number(BATTERY, battery)),
                entries.getOrDefault(HULL, ""));
    }

    /** The entries of the TXT record, in the order in which they are written. */
    public Map<String, String> entries() {
        Map<String, String> entries = new LinkedHashMap<>();
        entries.put("txtvers", "1");
        entries.put(ID, boatId);
        entries.put(NAME, name);
        if (!key.isEmpty()) {
            entries.put(KEY, key);
        }
        entries.put(ACCESS, access.name().toLowerCase(Locale.ROOT));
        entries.put(LINK, Integer.toString(linkVersion));
        batteryPercent.ifPresent(percent -> entries.put(BATTERY, Integer.toString(percent)));
        if (!hull.isEmpty()) {
            entries.put(HULL, hull);
        }
        return entries;
    }

    /** The boat's id. */
    public String boatId() {
        return boatId;
    }

    /** The boat's name for people. */
    public String name() {
        return name;
    }

    /** The first digits of its key's fingerprint; empty if it has none. */
    public String key() {
        return key;
    }

    /** Who may command it. */
    public Access access() {
        return access;
    }

    /** The version of the link that it speaks. */
    public int linkVersion() {
        return linkVersion;
    }

    /** Whether this program speaks the same version of the link. */
    public boolean sameLink() {
        return linkVersion == LinkCodec.VERSION;
    }

    /** Its charge in percent, if known. */
    public OptionalInt batteryPercent() {
        return batteryPercent;
    }

    /** Its kind of hull; empty if not announced. */
    public String hull() {
        return hull;
    }

    private static String entry(Map<String, String> entries, String key) {
        String value = entries.get(key);
        if (value == null) {
            throw new IllegalArgumentException("the announcement has no '" + key + "'");
        }
        return value;
    }

    private static Access accessOf(String text) {
        for (Access access : Access.values()) {
            if (access.name().equalsIgnoreCase(text)) {
                return access;
            }
        }
        throw new IllegalArgumentException(
                "'" + ACCESS + "' is open, paired or pairing, not '" + shortened(text) + "'");
    }

    private static int number(String key, String text) {
        try {
            return Integer.parseInt(text);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + key + "' is no whole number: '" + shortened(text) + "'", e);
        }
    }

    private static int within(String key, int value, int most) {
        if (value < 0 || value > most) {
            throw new IllegalArgumentException("'" + key + "' is not in 0 to " + most + ": " + value);
        }
        return value;
    }

    private static String text(String key, String value, boolean mayBeEmpty) {
        Objects.requireNonNull(value, key);
        if (value.isEmpty() && !mayBeEmpty) {
            throw new IllegalArgumentException("the announcement's '" + key + "' is empty");
        }
        if ((key + "=" + value).getBytes(StandardCharsets.UTF_8).length > MOST_ENTRY_BYTES) {
            throw new IllegalArgumentException("'" + key + "' is too long to be announced: " + shortened(value));
        }
        if (value.codePoints().anyMatch(BoatAnnouncement::unfit)) {
            throw new IllegalArgumentException(
                    "'" + key + "' has control characters or such as turn the direction of text");
        }
        return value;
    }

    /** Not shown to people: control characters, and formatting ones, which turn the direction of text or are not seen. */
    private static boolean unfit(int codePoint) {
        int type = Character.getType(codePoint);
        return type == Character.CONTROL
                || type == Character.FORMAT
                || type == Character.LINE_SEPARATOR
                || type == Character.PARAGRAPH_SEPARATOR
                || type == Character.SURROGATE;
    }

    private static String shortened(String text) {
        return text.length() > 40 ? text.substring(0, 40) + "…" : text;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof BoatAnnouncement
                && ((BoatAnnouncement) other).entries().equals(entries());
    }

    @Override
    public int hashCode() {
        return entries().hashCode();
    }

    @Override
    public String toString() {
        return entries().toString();
    }
}

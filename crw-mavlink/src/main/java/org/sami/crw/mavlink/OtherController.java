package org.sami.crw.mavlink;

import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * Names who controls a vehicle instead of the base: its own failsafe if the vehicle reports one, else a person. For the gateway's thread.
 *
 * <p>Source: ArduPilot's boats and copters say why they change their mode just before they do. Their heartbeats are critical only while radio, ground station or the
 * filter fails; a battery failsafe stands in {@code SYS_STATUS}, where the battery is not healthy from then on, and a crash in a text alone.
 */
final class OtherController {
    private static final long WORDS_MS = 4_000; // between a failsafe's words and its mode

    private static final long BATTERY_MS = 30_000; // until its status has come, also over a slow link

    private static final Pattern BATTERY = Pattern.compile("battery \\d+ is (low|critical)|battery failsafe");
    private static final Pattern ACTS = Pattern.compile("failsafe|breach|ekf variance|^crash: |" + BATTERY);

    /** A failsafe that ends, that changes nothing, or that a check before arming names. */
    private static final Pattern DOES_NOTHING = Pattern.compile("cleared|continuing|^(pre)?arm: ");

    /** Into this mode a copter also goes by itself, where its filter fails. */
    private static final String ALT_HOLD = "ALT_HOLD";

    /** In these modes it obeys sticks only. */
    private static final Set<String> BY_STICKS = Set.of("MANUAL", "ACRO", "STEERING", "SIMPLE");

    private static final Set<String> COPTER_BY_STICKS =
            Set.of("STABILIZE", "ACRO", ALT_HOLD, "LOITER", "POSHOLD", "DRIFT", "SPORT", "FLIP");

    private final RadioControl radio;
    private final RadioOrStation person;
    private String named = ""; // the person named last, with the vehicle's state
    private String namedPerson = "";
    private String words = ""; // of its last failsafe
    private long saidMs;
    private long batterySaidMs = Long.MIN_VALUE / 2;
    private long batteryFailedMs = Long.MIN_VALUE / 2;

    OtherController(RadioControl radio) {
        this.radio = radio;
        person = new RadioOrStation(radio);
    }

    /** A base has come, or somebody has taken the vehicle: reads what its radio control does. */
    void read() {
        radio.read();
    }

    /** Something happened to the vehicle; whether it tells more of which person controls it. */
    boolean happened(VehicleEvent event, long atMs) {
        if (event instanceof VehicleEvent.Said said) {
            said(said.text(), atMs);
        }
        return person.happened(event, atMs);
    }

    /** The autopilot said something. */
    private void said(StatusText text, long atMs) {
        String lower = text.text().toLowerCase(Locale.ROOT);
        if (ACTS.matcher(lower).find() && !DOES_NOTHING.matcher(lower).find()) {
            words = text.text();
            saidMs = atMs;
            batterySaidMs = BATTERY.matcher(lower).find() ? atMs : batterySaidMs;
        }
    }

    /** It reports itself in another way than before. */
    void reported(VehicleSnapshot before, VehicleSnapshot now, long atMs) {
        person.reported(before, now, atMs);
        if (isBatteryFailing(now) && !isBatteryFailing(before)) {
            batteryFailedMs = atMs;
        }
    }

    /** Its autopilot has started again: no failsafe of before is in force. */
    void restarted() {
        radio.restarted();
        words = "";
        batterySaidMs = Long.MIN_VALUE / 2;
        batteryFailedMs = Long.MIN_VALUE / 2;
    }

    private static boolean isBatteryFailing(VehicleSnapshot vehicle) {
        return vehicle.health().failing().contains("battery");
    }

    /** Whether its battery has been low or critical by its own limits since its autopilot started, so that its failsafe has acted. */
    boolean isBatteryFailsafe(VehicleSnapshot vehicle, long atMs) {
        return isBatteryFailing(vehicle) || atMs - batterySaidMs < BATTERY_MS;
    }

    /** Who drives a vehicle by hand that no base of this process has commanded yet; empty if nobody does. */
    String driver(VehicleSnapshot vehicle, long atMs) {
        return isBySticks(vehicle) ? who(vehicle, atMs) : "";
    }

    private static boolean isBySticks(VehicleSnapshot vehicle) {
        Set<String> modes = vehicle.kind() == VehicleKind.COPTER ? COPTER_BY_STICKS : BY_STICKS;
        return vehicle.armed() && modes.contains(vehicle.mode());
    }

    /** Who has changed its state, in words for the operator. */
    String who(VehicleSnapshot vehicle, long atMs) {
        String state = state(vehicle);
        if (vehicle.health().outsideFence()) {
            return "its own failsafe, outside of its fence (" + state + ")";
        }
        if (isBySticks(vehicle) && !vehicle.mode().equals(ALT_HOLD)) { // no failsafe goes there
            return person(vehicle, state, atMs);
        }
        if (!words.isEmpty() && (atMs - saidMs < WORDS_MS || vehicle.health().failsafe())) {
            return "its own failsafe \"" + words + "\" (" + state + ")";
        }
        if (vehicle.health().failsafe()) {
            return "its own failsafe (" + state + ")";
        }
        return atMs - batteryFailedMs < WORDS_MS
                ? "its own failsafe, for its battery (" + state + ")"
                : person(vehicle, state, atMs);
    }

    /**
     * Who has changed its state, as far as it is known better by now than it was.
     *
     * @param before who was named last, in words of {@link #who}
     */
    Optional<String> better(String before, VehicleSnapshot vehicle, long atMs) {
        if (person.isCertain() || !before.equals(named)) {
            return Optional.empty();
        }
        String now = person.who(vehicle, atMs);
        return now.equals(namedPerson) ? Optional.empty() : Optional.of(person(vehicle, state(vehicle), atMs));
    }

    private static String state(VehicleSnapshot vehicle) {
        return vehicle.armed() ? vehicle.mode() : vehicle.mode() + ", disarmed";
    }

    private String person(VehicleSnapshot vehicle, String state, long atMs) {
        namedPerson = person.who(vehicle, atMs);
        named = namedPerson + " (" + state + ")";
        return named;
    }
}

package org.sami.crw.mavlink;

import java.util.Locale;
import java.util.Set;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** Names who controls a vehicle instead of the base: its own failsafe if the vehicle reports one, else a person. For the gateway's thread. */
final class OtherController {
    private static final long WORDS_MS = 4_000; // between a failsafe's words and its mode

    /** In these modes it obeys sticks only. */
    private static final Set<String> BY_STICKS = Set.of("MANUAL", "ACRO", "STEERING", "SIMPLE");

    private static final Set<String> COPTER_BY_STICKS =
            Set.of("STABILIZE", "ACRO", "ALT_HOLD", "LOITER", "POSHOLD", "DRIFT", "SPORT", "FLIP");

    private String words = ""; // of its last failsafe
    private long saidMs;

    /** The autopilot said something. */
    void said(StatusText text, long atMs) {
        String lower = text.text().toLowerCase(Locale.ROOT);
        if (lower.contains("failsafe") || lower.contains("breach") || lower.contains("ekf variance")) {
            words = text.text();
            saidMs = atMs;
        }
    }

    /** Whether it carries out a failsafe for a low battery. */
    boolean isBatteryFailsafe(VehicleSnapshot vehicle) {
        return vehicle.health().failsafe() && words.toLowerCase(Locale.ROOT).contains("batt");
    }

    /** Who drives a vehicle by hand that no base of this process has commanded yet; empty if nobody does. */
    String driver(VehicleSnapshot vehicle, long atMs) {
        Set<String> modes = vehicle.kind() == VehicleKind.COPTER ? COPTER_BY_STICKS : BY_STICKS;
        return vehicle.armed() && modes.contains(vehicle.mode()) ? who(vehicle, atMs) : "";
    }

    /** Who has changed its state, in words for the operator. */
    String who(VehicleSnapshot vehicle, long atMs) {
        String state = vehicle.armed() ? vehicle.mode() : vehicle.mode() + ", disarmed";
        boolean justSaid = !words.isEmpty() && atMs - saidMs < WORDS_MS;
        if (vehicle.health().outsideFence()) {
            return "its own failsafe, outside of its fence (" + state + ")";
        }
        if (!vehicle.health().failsafe() && !justSaid) {
            return "a pilot or another ground station (" + state + ")";
        }
        return "its own failsafe" + (words.isEmpty() ? "" : " \"" + words + "\"") + " (" + state + ")";
    }
}

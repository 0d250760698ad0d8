package org.sami.crw.mavlink;

import java.util.Locale;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** Names who has taken a vehicle from the base: its own failsafe if the vehicle reports one, else a person. For the gateway's thread. */
final class OtherHands {
    private static final long WORDS_MS = 4_000; // between a failsafe's words and its mode

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

    /** Whether it carries out a failsafe for want of charge. */
    boolean isBatteryFailsafe(VehicleSnapshot vehicle) {
        return vehicle.health().failsafe() && words.toLowerCase(Locale.ROOT).contains("batt");
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

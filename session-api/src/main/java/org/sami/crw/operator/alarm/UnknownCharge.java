package org.sami.crw.operator.alarm;

import java.util.Optional;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BoatCapabilities;
import org.sami.crw.operator.boat.BoatSnapshot;

/** Boats that report no charge in percent, at most that their battery is critical: the percentages that the base holds of them are none that anybody measured. */
public final class UnknownCharge {
    private UnknownCharge() {}

    /** Why a boat reports no charge; empty for one that does, or that does not say. */
    public static Optional<String> why(BoatSnapshot boat) {
        return boat.settings()
                .map(own -> own.capabilities().cannot())
                .map(cannot -> cannot.get(BoatCapabilities.CHARGE));
    }

    /** What is known of the charge of such a boat, in a word; empty for one that reports its charge, or does not say. */
    public static Optional<String> word(BoatSnapshot boat) {
        return why(boat).map(text -> isCritical(boat) ? "critical" : "unknown");
    }

    /** Whether a boat reports that its battery is critical. */
    static boolean isCritical(BoatSnapshot boat) {
        return boat.battery()
                .filter(battery -> battery.level() == BatteryLevel.CRITICAL)
                .isPresent();
    }
}

package org.sami.crw.proxy.gateway;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * One of the links on which a gateway reaches a vehicle.
 *
 * @param link its address, as users write it
 * @param used whether the vehicle is commanded over it; the others are ready
 * @param lost the part of the vehicle's messages that did not come there lately, 0 to 1
 * @param silentMs time since the vehicle was heard there
 * @param fault why the link is broken, or what is wrong with what comes; empty where all is well
 * @param signalHere the radio's strength of signal here, 0 to 254 as the radio counts; empty where no radio reports it
 * @param signalThere the same at the vehicle
 * @param askedBytesPerSecond what the vehicle is asked to send there; 0 where it is not asked, as the link is not used
 * @param filledPart the part of the link that all vehicles on it fill, 0 to 1 and more; empty on networks, where it does not matter
 */
public record LinkStatus(
        String link,
        boolean used,
        double lost,
        long silentMs,
        Optional<String> fault,
        Optional<Integer> signalHere,
        Optional<Integer> signalThere,
        double askedBytesPerSecond,
        OptionalDouble filledPart) {
    private static final long SILENT_MS = 5_000;
    private static final double MUCH = 0.2;
    private static final double PERCENT = 100;
    private static final double MS = 1_000;

    /** A link of a vehicle. */
    public LinkStatus {
        Objects.requireNonNull(link, "link");
        Objects.requireNonNull(fault, "fault");
        Objects.requireNonNull(signalHere, "signalHere");
        Objects.requireNonNull(signalThere, "signalThere");
        Objects.requireNonNull(filledPart, "filledPart");
    }

    /** Whether the vehicle is heard there without much loss, and the link can carry what is asked of all. */
    public boolean isGood() {
        return fault.isEmpty() && silentMs <= SILENT_MS && lost < MUCH && filledPart.orElse(0) <= 1;
    }

    /** How it is, such as {@code in use, 0.4 % lost, radio 180 here and 172 there, 449 bytes/s asked, 8 % of the link}. */
    public String words() {
        List<String> words = new ArrayList<>();
        words.add(used ? "in use" : "ready");
        fault.ifPresent(words::add);
        if (silentMs > SILENT_MS) {
            words.add(format("silent for %.0f s", silentMs / MS));
        } else {
            words.add(format("%.1f %% lost", lost * PERCENT));
        }
        if (signalHere.isPresent() || signalThere.isPresent()) {
            words.add("radio " + number(signalHere) + " here and " + number(signalThere) + " there");
        }
        if (used) {
            words.add(format("%.0f bytes/s asked", askedBytesPerSecond));
            filledPart.ifPresent(part ->
                    words.add(format("%.0f %% of the link%s", part * PERCENT, part > 1 ? ": too many vehicles" : "")));
        }
        return String.join(", ", words);
    }

    private static String number(Optional<Integer> strength) {
        return strength.map(Object::toString).orElse("-");
    }

    private static String format(String form, Object... values) {
        return String.format(Locale.ROOT, form, values);
    }
}

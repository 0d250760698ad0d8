package org.sami.mavlink.format;

import io.dronefleet.mavlink.ardupilotmega.ArdupilotmegaDialect;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/** The kinds of messages that ArduPilot's dialect of the library has, those that all autopilots share among them. Safe for use by several threads. */
public final class MessageFormats {
    private static final ArdupilotmegaDialect DIALECT = new ArdupilotmegaDialect();
    private static final Map<Integer, MessageFormat> KNOWN = new ConcurrentHashMap<>();

    private MessageFormats() {}

    /** The kind with a number (MAVLink message id); empty where the dialect has none. */
    public static Optional<MessageFormat> of(int number) {
        Optional<MessageFormat> known = Optional.ofNullable(KNOWN.get(number));
        return known.isPresent()
                ? known
                : Optional.ofNullable(DIALECT.resolve(number))
                        .map(kind -> KNOWN.computeIfAbsent(number, unknown -> new MessageFormat(kind)));
    }
}

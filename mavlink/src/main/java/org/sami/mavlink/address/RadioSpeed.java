package org.sami.mavlink.address;

import java.util.OptionalInt;

/** The speed of a radio behind a network's port, as it stands after the port: {@code ?baud=57600}. */
final class RadioSpeed {
    static final String OPTION = "?baud=";

    private RadioSpeed() {}

    /** As it is written; empty where none is known. */
    static String text(OptionalInt speedBaud) {
        return speedBaud.isPresent() ? OPTION + speedBaud.getAsInt() : "";
    }
}

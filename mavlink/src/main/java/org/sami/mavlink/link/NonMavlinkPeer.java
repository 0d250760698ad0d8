package org.sami.mavlink.link;

import java.io.EOFException;
import java.io.IOException;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;

/** Words for the other end of a link that is no vehicle, or has ended the link: what answered, and what to do. */
final class NonMavlinkPeer {
    static final String NOISE = "what comes is no MAVLink: is it the right port, and the right baud rate?";

    private static final String LOOK = "look at host and port (ArduPilot's simulator listens on TCP 5760)";

    private NonMavlinkPeer() {}

    /** What answers, by the first characters that came; empty where they tell nothing. */
    static Optional<String> of(String first) {
        String start = first.toUpperCase(Locale.ROOT);
        if (start.startsWith("SSH-")) {
            return Optional.of("an SSH server answers there, and no vehicle: " + LOOK);
        } else if (start.startsWith("HTTP/") || start.startsWith("<!DOCTYP") || start.startsWith("<HTML")) {
            return Optional.of("a web server answers there, and no vehicle: " + LOOK);
        }
        return Optional.empty();
    }

    /**
     * Why a link has ended.
     *
     * @param first the first characters that came
     * @param messages how many messages came that could be read
     */
    static String ended(IOException why, String first, long messages) {
        Optional<String> notMavlink = messages > 0 ? Optional.empty() : of(first);
        if (notMavlink.isPresent()) {
            return notMavlink.get();
        } else if (!(why instanceof EOFException)) {
            return "it broke: " + Objects.requireNonNullElse(why.getMessage(), why.toString()) + "; it is opened again";
        } else if (messages > 0) {
            return "the other end closed the link; it is opened again";
        } else if (first.isEmpty()) {
            return "what listens there closes the link without a word: " + LOOK
                    + ", and whether another ground station holds the vehicle's port";
        }
        return "what answers there speaks no MAVLink and closes the link: " + LOOK;
    }
}

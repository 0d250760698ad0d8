package org.sami.crw.report;

import java.util.Objects;
import org.sami.crw.proxy.command.UploadCount;

/**
 * How base and boat were joined, and how that went.
 *
 * @param words the link: {@code in-process}, or {@code tcp HOST:PORT}
 * @param bootId names the last start of the boat's server; empty if it never answered
 * @param lost how often the link was lost
 * @param reconnected how often it came back
 * @param uploads of waypoint lists
 * @param why why the boat moved or did not when the run stopped, in words
 */
public record LinkResult(String words, String bootId, int lost, int reconnected, Uploads uploads, String why) {
    public LinkResult {
        Objects.requireNonNull(words, "words");
        Objects.requireNonNull(bootId, "bootId");
        Objects.requireNonNull(uploads, "uploads");
        Objects.requireNonNull(why, "why");
    }

    /**
     * How many waypoint lists went to the boat.
     *
     * @param sent each counted once, however often it was sent again
     * @param acknowledged whether the boat acknowledged them
     * @param readBackEqual whether the list that the boat read back was equal
     * @param failed given up before that
     */
    public record Uploads(int sent, int acknowledged, int readBackEqual, int failed) {
        /** None. */
        public static final Uploads NONE = new Uploads(0, 0, 0, 0);

        /** As a proxy has counted them. */
        public static Uploads of(UploadCount count) {
            return new Uploads(count.sent(), count.acknowledged(), count.readBackEqual(), count.failed());
        }

        /** These and others. */
        public Uploads and(Uploads others) {
            return new Uploads(
                    sent + others.sent,
                    acknowledged + others.acknowledged,
                    readBackEqual + others.readBackEqual,
                    failed + others.failed);
        }
    }
}

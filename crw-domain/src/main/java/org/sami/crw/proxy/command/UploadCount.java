package org.sami.crw.proxy.command;

/**
 * How many waypoint lists have gone to a boat since its proxy was made.
 *
 * @param sent each counted once, however often it was sent again
 * @param acknowledged the boat has said that it took them whole
 * @param readBackEqual the boat has said what it holds, and that was equal
 * @param failed given up before that, for whatever reason
 */
public record UploadCount(int sent, int acknowledged, int readBackEqual, int failed) {
    /** None. */
    public static final UploadCount NONE = new UploadCount(0, 0, 0, 0);

    /** These and others. */
    public UploadCount and(UploadCount others) {
        return new UploadCount(
                sent + others.sent,
                acknowledged + others.acknowledged,
                readBackEqual + others.readBackEqual,
                failed + others.failed);
    }

    /** The same after one more upload has reached that state. */
    public UploadCount oneMore(Upload.State reached) {
        return switch (reached) {
            case SENT -> new UploadCount(sent + 1, acknowledged, readBackEqual, failed);
            case ACKNOWLEDGED -> new UploadCount(sent, acknowledged + 1, readBackEqual, failed);
            case READ_BACK_EQUAL -> new UploadCount(sent, acknowledged, readBackEqual + 1, failed);
            case TAKEN_OVER -> this; // counted by the process that sent it
            case FAILED -> new UploadCount(sent, acknowledged, readBackEqual, failed + 1);
        };
    }
}

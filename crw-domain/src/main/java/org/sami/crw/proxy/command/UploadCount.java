package org.sami.crw.proxy.command;

/**
 * Counts of the waypoint lists sent to a boat since its proxy was made.
 *
 * @param sent lists sent, each counted once, with any repetitions
 * @param acknowledged lists that the boat has acknowledged
 * @param readBackEqual lists that the boat has read back equal
 * @param failed lists given up before that, for any reason
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

package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/** The boat does not give what a {@link FileRequest} asks for. */
public final class FileRefusal extends FileAnswer {
    static final String TYPE = "no-piece";

    /** Why. */
    public enum Reason {
        /** The boat keeps no file of that name; it may have been rotated away. */
        UNKNOWN_FILE,
        /** The offset is past the end of the file. */
        PAST_END,
        /** The file is larger than the link gives. */
        TOO_LARGE,
        /** The client has asked again before the answer came. */
        BUSY,
        /** The boat keeps no files. */
        NO_FILES,
        /** The file cannot be read. */
        UNREADABLE
    }

    private final Reason reason;
    private final String detail;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public FileRefusal(String requestId, Reason reason, String detail) {
        super(requestId);
        this.reason = Objects.requireNonNull(reason, "reason");
        this.detail = Checks.text("detail", detail);
    }

    static FileRefusal read(Fields in) throws LinkException {
        return new FileRefusal(in.text("request"), in.word("reason", Reason.class), in.text("detail"));
    }

    /** Why. */
    public Reason reason() {
        return reason;
    }

    /** The same for people. */
    public String detail() {
        return detail;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeAnswer(JsonGenerator out) throws IOException {
        out.writeStringField("reason", reason.name());
        out.writeStringField("detail", detail);
    }
}

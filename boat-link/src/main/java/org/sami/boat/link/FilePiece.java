package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Arrays;
import java.util.Base64;

/** A piece of a file that a boat keeps. */
public final class FilePiece extends FileAnswer {
    static final String TYPE = "piece";

    /** Most bytes of a piece: an acknowledgement waits for one piece at most, 0.07 s at 1 Mbit/s. */
    public static final int MAX_BYTES = 6000;

    private final String name;
    private final long offset;
    private final byte[] content;

    /**
     * A piece.
     *
     * @param offset of its first byte in the file, counted from 0
     * @param content its bytes; none at the end of the file
     */
    public FilePiece(String requestId, String name, long offset, byte[] content) {
        super(requestId);
        this.name = Checks.fileName("name", name);
        this.offset = Checks.atLeastZero("offset", offset);
        if (content.length > MAX_BYTES) {
            throw new Checks.BadValueException("content", content.length + " bytes are more than " + MAX_BYTES);
        }
        this.content = content.clone();
    }

    static FilePiece read(Fields in) throws LinkException {
        byte[] content;
        try {
            content = Base64.getDecoder().decode(in.text("content"));
        } catch (IllegalArgumentException e) {
            throw new Checks.BadValueException("content", "no Base64");
        }
        return new FilePiece(in.text("request"), in.text("name"), in.integer("offset"), content);
    }

    /** Name of the file. */
    public String name() {
        return name;
    }

    /** Offset of the first byte in the file, counted from 0. */
    public long offset() {
        return offset;
    }

    /** The bytes, as a copy. */
    public byte[] content() {
        return Arrays.copyOf(content, content.length);
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeAnswer(JsonGenerator out) throws IOException {
        out.writeStringField("name", name);
        out.writeNumberField("offset", offset);
        out.writeStringField("content", Base64.getEncoder().encodeToString(content));
    }
}

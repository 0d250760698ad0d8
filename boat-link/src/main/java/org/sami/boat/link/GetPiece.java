package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** Asks for a piece of a file that the boat keeps; {@link FilePiece} or {@link FileRefusal} answers. */
public final class GetPiece extends FileRequest {
    static final String TYPE = "get-piece";

    private final String name;
    private final long offset;
    private final int bytes;

    /**
     * A request for a piece.
     *
     * @param name of the file, as listed
     * @param offset of the first byte, counted from 0
     * @param bytes asked for, at most; 1 to {@link FilePiece#MAX_BYTES}
     */
    public GetPiece(String requestId, String name, long offset, int bytes) {
        super(requestId);
        this.name = Checks.id("name", name); // the boat looks the name up, and opens no other
        this.offset = Checks.atLeastZero("offset", offset);
        this.bytes = (int) Checks.range("bytes", bytes, 1, FilePiece.MAX_BYTES);
    }

    static GetPiece read(Fields in) throws LinkException {
        return new GetPiece(in.text("request"), in.text("name"), in.integer("offset"), in.index("bytes"));
    }

    /** Name of the file. */
    public String name() {
        return name;
    }

    /** Offset of the first byte, counted from 0. */
    public long offset() {
        return offset;
    }

    /** How many bytes are asked for at most. */
    public int bytes() {
        return bytes;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeRequest(JsonGenerator out) throws IOException {
        out.writeStringField("name", name);
        out.writeNumberField("offset", offset);
        out.writeNumberField("bytes", bytes);
    }
}

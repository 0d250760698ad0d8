package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** A file that a boat keeps, as it is listed. Immutable. */
public final class KeptFile {
    /** The kind of the boat's log, and of its earlier parts. */
    public static final String LOG = "log";

    /** The kind of pictures that the boat has taken. */
    public static final String PICTURE = "picture";

    /** Larger files are listed and not given, in bytes. */
    public static final long MAX_BYTES = 64 << 20;

    private final String name;
    private final String kind;
    private final long bytes;
    private final String sha256;

    /**
     * Makes an entry of checked values.
     *
     * @param name a file name without a folder
     * @param bytes length up to which the hash holds: a log grows behind it
     * @param sha256 of so many bytes, as 64 lower-case hexadecimal digits; empty if the file is larger than {@link #MAX_BYTES}
     * @throws IllegalArgumentException if a value is out of its range
     */
    public KeptFile(String name, String kind, long bytes, String sha256) {
        this.name = Checks.fileName("name", name);
        this.kind = Checks.id("kind", kind);
        this.bytes = Checks.atLeastZero("bytes", bytes);
        this.sha256 = bytes > MAX_BYTES ? noHash(sha256) : Checks.proof("sha256", sha256);
    }

    private static String noHash(String sha256) {
        if (!sha256.isEmpty()) {
            throw new Checks.BadValueException("sha256", "not empty, and the file is larger than " + MAX_BYTES);
        }
        return sha256;
    }

    /** Whether a text can be the name of a listed file: one name in a folder, not hidden, the same on all systems. */
    public static boolean isName(String text) {
        try {
            Checks.fileName("name", text);
            return true;
        } catch (Checks.BadValueException e) {
            return false;
        }
    }

    static KeptFile read(Fields in) throws LinkException {
        return new KeptFile(in.text("name"), in.text("kind"), in.integer("bytes"), in.text("sha256"));
    }

    void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeStringField("name", name);
        out.writeStringField("kind", kind);
        out.writeNumberField("bytes", bytes);
        out.writeStringField("sha256", sha256);
        out.writeEndObject();
    }

    /** Name of the file, without a folder. */
    public String name() {
        return name;
    }

    /** What it is, such as {@link #LOG}. */
    public String kind() {
        return kind;
    }

    /** The length in bytes up to which the hash holds. */
    public long bytes() {
        return bytes;
    }

    /** SHA-256 of so many bytes, in lower-case hexadecimal digits; empty of a file that is too large. */
    public String sha256() {
        return sha256;
    }

    /** Whether the boat refuses to give it. */
    public boolean isTooLarge() {
        return bytes > MAX_BYTES;
    }
}

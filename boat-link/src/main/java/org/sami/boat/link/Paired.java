package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/** The boat has paired a base: it keeps the base's key, and proves in turn that it knows the words. */
public final class Paired extends LinkMessage {
    static final String TYPE = "paired";

    private final String boatId;
    private final String proof;
    private final Role role;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Paired(String boatId, String proof, Role role) {
        this.role = Objects.requireNonNull(role, "role");
        this.boatId = Checks.name("boat", boatId);
        this.proof = Checks.proof("proof", proof);
    }

    static Paired read(Fields in) throws LinkException {
        return new Paired(
                in.text("boat"), in.text("proof"), in.has("role") ? in.word("role", Role.class) : Role.COMMANDER);
    }

    /** The boat. */
    public String boatId() {
        return boatId;
    }

    /** Proof of the words and of the keys of this link. */
    public String proof() {
        return proof;
    }

    /** The most that the boat grants the base. */
    public Role role() {
        return role;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("boat", boatId);
        out.writeStringField("proof", proof);
        out.writeStringField("role", role.name());
    }
}

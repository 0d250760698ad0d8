package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/** A base asks to be paired over a protected link: it proves that it knows the words which the boat shows. */
public final class Pair extends LinkMessage {
    static final String TYPE = "pair";

    private final String clientId;
    private final String proof;
    private final Role role;

    /** A base that wishes to command. */
    public Pair(String clientId, String proof) {
        this(clientId, proof, Role.COMMANDER);
    }

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Pair(String clientId, String proof, Role role) {
        this.role = Objects.requireNonNull(role, "role");
        this.clientId = Checks.name("client", clientId);
        this.proof = Checks.proof("proof", proof);
    }

    static Pair read(Fields in) throws LinkException {
        return new Pair(
                in.text("client"), in.text("proof"), in.has("role") ? in.word("role", Role.class) : Role.COMMANDER);
    }

    /** The name under which the boat keeps the base's key, for people. */
    public String clientId() {
        return clientId;
    }

    /** Proof of the words and of the keys of this link. */
    public String proof() {
        return proof;
    }

    /** The most that the base wishes to be granted, now and later. */
    public Role role() {
        return role;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("client", clientId);
        out.writeStringField("proof", proof);
        if (role != Role.COMMANDER) {
            out.writeStringField("role", role.name());
        }
    }
}

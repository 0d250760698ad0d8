package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/** A boat's answer to {@link Hello}: its name, its start, and the client's role. */
public final class Welcome extends LinkMessage {
    static final String TYPE = "welcome";

    private final String boatId;
    private final String bootId;
    private final Role role;
    private final String term;
    private final String auth;
    private final boolean takesTraffic;

    /** A welcome that names no term: of an observer. */
    public Welcome(String boatId, String bootId, Role role, String auth) {
        this(boatId, bootId, role, "", auth, false);
    }

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Welcome(String boatId, String bootId, Role role, String term, String auth, boolean takesTraffic) {
        this.boatId = Checks.name("boat", boatId);
        this.bootId = Checks.id("boot", bootId);
        this.role = Objects.requireNonNull(role, "role");
        this.term = Checks.text("newTerm", term);
        this.auth = Checks.text("auth", auth);
        this.takesTraffic = takesTraffic;
    }

    static Welcome read(Fields in) throws LinkException {
        return new Welcome(
                in.text("boat"),
                in.text("boot"),
                in.word("role", Role.class),
                in.text("newTerm"),
                in.text("auth"),
                in.flagOrFalse("traffic"));
    }

    /** The boat. */
    public String boatId() {
        return boatId;
    }

    /** Names this start of the boat server; another id means that the server has lost its list and commands. */
    public String bootId() {
        return bootId;
    }

    /** The client's role: an observer if another client commands. */
    public Role role() {
        return role;
    }

    /** The term that a commander names in every frame, so that the boat recognizes older commands; empty for observers. */
    public String term() {
        return term;
    }

    /** Reserved for authentication; empty today. */
    public String auth() {
        return auth;
    }

    /** Whether the boat takes {@link Traffic} to give way; earlier servers do not know that message. */
    public boolean takesTraffic() {
        return takesTraffic;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("boat", boatId);
        out.writeStringField("boot", bootId);
        out.writeStringField("role", role.name());
        out.writeStringField("newTerm", term);
        out.writeStringField("auth", auth);
        if (takesTraffic) {
            out.writeBooleanField("traffic", true);
        }
    }
}

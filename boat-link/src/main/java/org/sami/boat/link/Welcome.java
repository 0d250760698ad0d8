package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;
import java.util.Optional;

/** A boat's answer to {@link Hello}: its name, its start, and the client's role. */
public final class Welcome extends LinkMessage {
    static final String TYPE = "welcome";
    private static final String NO_BASE = "noBase";

    private final String boatId;
    private final String bootId;
    private final Role role;
    private final String term;
    private final String auth;
    private final boolean takesTraffic;
    private final Optional<CommandEpoch> epoch;

    /** A welcome that names no term: of an observer. */
    public Welcome(String boatId, String bootId, Role role, String auth) {
        this(boatId, bootId, role, "", auth, false);
    }

    /** A welcome of the link of before, which names no epoch. */
    public Welcome(String boatId, String bootId, Role role, String term, String auth, boolean takesTraffic) {
        this(boatId, bootId, role, term, auth, takesTraffic, Optional.empty());
    }

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Welcome(
            String boatId,
            String bootId,
            Role role,
            String term,
            String auth,
            boolean takesTraffic,
            Optional<CommandEpoch> epoch) {
        this.boatId = Checks.name("boat", boatId);
        this.bootId = Checks.id("boot", bootId);
        this.role = Objects.requireNonNull(role, "role");
        this.term = Checks.text("newTerm", term);
        this.auth = Checks.text("auth", auth);
        this.takesTraffic = takesTraffic;
        this.epoch = Objects.requireNonNull(epoch, "epoch");
    }

    static Welcome read(Fields in) throws LinkException {
        return new Welcome(
                in.text("boat"),
                in.text("boot"),
                in.word("role", Role.class),
                in.text("newTerm"),
                in.text("auth"),
                in.flagOrFalse("traffic"),
                in.has("epoch") ? Optional.of(epoch(in)) : Optional.empty());
    }

    private static CommandEpoch epoch(Fields in) throws LinkException {
        return new CommandEpoch(
                in.integer("epoch"), in.flagOrFalse(NO_BASE) ? CommandEpoch.NO_BASE : "", in.textOrEmpty("heldBy"));
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

    /**
     * Who was appointed commander last, and the number of that appointment, without the session, but for {@link CommandEpoch#NO_BASE}: a client that takes the command names a
     * higher number.
     * Empty for boats of the link of before.
     */
    public Optional<CommandEpoch> epoch() {
        return epoch;
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
        if (epoch.isPresent()) {
            out.writeNumberField("epoch", epoch.get().number());
            out.writeStringField("heldBy", epoch.get().clientId());
            if (epoch.get().session().equals(CommandEpoch.NO_BASE)) {
                out.writeBooleanField(NO_BASE, true);
            }
        }
    }
}

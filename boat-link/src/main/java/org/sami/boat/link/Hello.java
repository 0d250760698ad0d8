package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/**
 * The first message of a client: the boat that it means to reach, its role, and its rate of telemetry. Sent again, it changes role and rate.
 */
public final class Hello extends LinkMessage {
    static final String TYPE = "hello";

    private final String boatId;
    private final String clientId;
    private final Role role;
    private final double telemetryHz;
    private final String auth;
    private final String session;
    private final long epoch;

    /** A hello without a session, as clients of the link of before say it. */
    public Hello(String boatId, String clientId, Role role, double telemetryHz, String auth) {
        this(boatId, clientId, role, telemetryHz, auth, "", 0);
    }

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Hello(
            String boatId, String clientId, Role role, double telemetryHz, String auth, String session, long epoch) {
        this.boatId = Checks.optionalName("boat", boatId);
        this.clientId = Checks.name("client", clientId);
        this.role = Objects.requireNonNull(role, "role");
        this.telemetryHz = Checks.range("telemetryHz", telemetryHz, 0, 50);
        this.auth = Checks.text("auth", auth);
        this.session = Checks.optionalName("session", session);
        this.epoch = Checks.atLeastZero("epoch", epoch);
    }

    static Hello read(Fields in) throws LinkException {
        return new Hello(
                in.text("boat"),
                in.text("client"),
                in.word("role", Role.class),
                in.number("telemetryHz"),
                in.text("auth"),
                in.textOrEmpty("session"),
                in.integerOrZero("epoch"));
    }

    /** The boat that the client means to reach; any other boat refuses. Empty to reach whichever boat answers. */
    public String boatId() {
        return boatId;
    }

    /** The client's name, for logs and for people who see who commands. */
    public String clientId() {
        return clientId;
    }

    /** The role that the client asks for. */
    public Role role() {
        return role;
    }

    /** Telemetry messages a second; 0 leaves the rate to the boat. */
    public double telemetryHz() {
        return telemetryHz;
    }

    /** Reserved for authentication; empty today, and not looked at. */
    public String auth() {
        return auth;
    }

    /** Id of the client's session; empty for clients of the link of before. */
    public String session() {
        return session;
    }

    /** The number with which the session claims to command, see {@link CommandEpoch}; 0 without a session. */
    public long epoch() {
        return epoch;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("boat", boatId);
        out.writeStringField("client", clientId);
        out.writeStringField("role", role.name());
        out.writeNumberField("telemetryHz", telemetryHz);
        out.writeStringField("auth", auth);
        if (!session.isEmpty()) {
            out.writeStringField("session", session);
            out.writeNumberField("epoch", epoch);
        }
    }
}

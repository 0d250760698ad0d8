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

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Hello(String boatId, String clientId, Role role, double telemetryHz, String auth) {
        this.boatId = Checks.optionalName("boat", boatId);
        this.clientId = Checks.name("client", clientId);
        this.role = Objects.requireNonNull(role, "role");
        this.telemetryHz = Checks.range("telemetryHz", telemetryHz, 0, 50);
        this.auth = Checks.text("auth", auth);
    }

    static Hello read(Fields in) throws LinkException {
        return new Hello(
                in.text("boat"),
                in.text("client"),
                in.word("role", Role.class),
                in.number("telemetryHz"),
                in.text("auth"));
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
    }
}

package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/** Sets what the boat does by itself when the link to its commander is lost. */
public final class SetLostLinkAction extends CommandMessage {
    static final String TYPE = "lost-link";

    private final LostLinkAction action;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public SetLostLinkAction(String commandId, LostLinkAction action) {
        super(commandId);
        this.action = Objects.requireNonNull(action, "action");
    }

    static SetLostLinkAction read(Fields in) throws LinkException {
        return new SetLostLinkAction(in.text("command"), in.word("action", LostLinkAction.class));
    }

    /** The action from now on. */
    public LostLinkAction action() {
        return action;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {
        out.writeStringField("action", action.name());
    }
}

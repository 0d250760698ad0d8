package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** How far the boat is along its waypoint list; sent after the welcome and at each change. */
public final class Progress extends LinkMessage {
    static final String TYPE = "progress";

    private final String listId;
    private final int nextIndex;
    private final boolean completed;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Progress(String listId, int nextIndex, boolean completed) {
        this.listId = Checks.optionalId("list", listId);
        this.nextIndex = Checks.atLeastZero("next", nextIndex);
        this.completed = completed;
    }

    static Progress read(Fields in) throws LinkException {
        return new Progress(in.textOrEmpty("list"), in.index("next"), in.flag("completed"));
    }

    /** The list that the boat holds; empty if it holds none. */
    public String listId() {
        return listId;
    }

    /** The first waypoint not yet reached, counted from 0; the list's size if all are. */
    public int nextIndex() {
        return nextIndex;
    }

    /** Whether the last waypoint has been reached. */
    public boolean completed() {
        return completed;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("list", listId);
        out.writeNumberField("next", nextIndex);
        out.writeBooleanField("completed", completed);
    }
}

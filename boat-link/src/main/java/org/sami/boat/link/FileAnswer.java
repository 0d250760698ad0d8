package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** The boat's answer to a {@link FileRequest}. It waits until the boat has nothing else to say to this client. */
public abstract class FileAnswer extends LinkMessage {
    private final String requestId;

    FileAnswer(String requestId) {
        this.requestId = Checks.id("request", requestId);
    }

    /** The id of the request. */
    public final String requestId() {
        return requestId;
    }

    @Override
    final void write(JsonGenerator out) throws IOException {
        out.writeStringField("request", requestId);
        writeAnswer(out);
    }

    /** Writes the members of this kind of answer, without the id of its request. */
    abstract void writeAnswer(JsonGenerator out) throws IOException;
}

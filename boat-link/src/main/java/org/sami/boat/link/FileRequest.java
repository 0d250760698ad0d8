package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * A client asks for files that the boat keeps. No command: it changes nothing on the boat, and any client that has said hello may ask. A client waits for the answer
 * before it asks again; the answer names the request and waits for everything else that the boat has to say.
 */
public abstract class FileRequest extends LinkMessage {
    private final String requestId;

    FileRequest(String requestId) {
        this.requestId = Checks.id("request", requestId);
    }

    /** The client's own id of this request; the answer repeats it. */
    public final String requestId() {
        return requestId;
    }

    @Override
    final void write(JsonGenerator out) throws IOException {
        out.writeStringField("request", requestId);
        writeRequest(out);
    }

    /** Writes the members of this kind of request, without its id. */
    abstract void writeRequest(JsonGenerator out) throws IOException;
}
